// The clouds that the game draws, held against the path tracer's pictures of the same sky (tests/image/reference; its `make`
// makes them). Prints the table of docs/clouds.md.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <ostream>
#include <string>
#include <vector>

#include "engine/assets/image.h"
#include "engine/core/frames.h"
#include "tests/play/program.h"

namespace {
using namespace luftpost;
namespace fs = std::filesystem;
fs::path const kFolder = fs::path{LUFTPOST_SOURCE_DIR} / "tests/image/reference";
constexpr int kBlock = 3;  // pixels each way that are compared as one
constexpr int kRays = 4;   // of the game's, each way, for a pixel of the reference: its pixels are means, a ray is not

struct Scene {
    std::string name, weather, time, look, fov, eye;
    double mean, bias, worst;  // bounds of Agreement that are held: what is asked (0.10, 0.05, 0.30), or what is reached
};

void PrintTo(Scene const& scene, std::ostream* out) { *out << scene.name; }

/// The rows of scenes.csv; a field in quotes may hold commas.
std::vector<Scene> scenes() {
    std::ifstream in{kFolder / "scenes.csv"};
    std::vector<Scene> result;
    std::string line;
    std::getline(in, line);
    while (std::getline(in, line)) {
        std::vector<std::string> fields(1);
        bool quoted = false;
        for (char c : line) {
            if (c == '"') quoted = !quoted;
            else if (c == ',' && !quoted) fields.emplace_back();
            else fields.back() += c;
        }
        fields.resize(9);
        result.push_back({fields[0], fields[1], fields[2], fields[3], fields[4], fields[5], std::stod(fields[6]), std::stod(fields[7]), std::stod(fields[8])});
    }
    return result;
}

/// A picture of the scene, `rays` pixels each way for one of the reference.
assets::FloatImage drawn(Scene const& scene, std::string const& how, int rays) {
    fs::path const file = tests::scratch() / (scene.name + ".exr");
    auto const outcome = tests::run(fmt::format("sky {} --size {}x{} --weather ", how, 96 * rays, 54 * rays) + (kFolder / (scene.weather + ".json")).string() + " --time " + scene.time +
                                    " --look " + scene.look + " --fov " + scene.fov + (scene.eye.empty() ? "" : " --place " + scene.eye) + " -o " + file.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return assets::readFloatImage(file);
}

/// Means over a block: luminance, alpha, and blue over red.
struct Block {
    double luminance = 0.0, alpha = 0.0, blueness = 0.0;
};
Block blockAt(assets::FloatImage const& image, int x, int y, int side) {
    Block sum;
    double red = 0.0, blue = 0.0;
    for (int j = 0; j < side; ++j)
        for (int i = 0; i < side; ++i) {
            auto const at = [&](int channel) { return static_cast<double>(image.at(x + i, y + j, channel)) / (side * side); };
            sum.luminance += 0.2126 * at(0) + 0.7152 * at(1) + 0.0722 * at(2);
            sum.alpha += at(3);
            red += at(0);
            blue += at(2);
        }
    sum.blueness = blue / std::max(red, 1e-9);
    return sum;
}

/// Elevation of the middle of a block in the scene's picture, degrees.
double elevationAt(Scene const& scene, int x, int y, glm::dvec2 const& size) {
    double const tangent = std::tan(0.5 * core::radians(std::stod(scene.fov))), up = core::radians(std::stod(scene.look.substr(scene.look.find(',') + 1)));
    double const middle = 0.5 * kBlock, across = (x + middle - 0.5 * size.x) / (0.5 * size.x) * tangent, above = (0.5 * size.y - y - middle) / (0.5 * size.x) * tangent;
    return core::degrees(std::asin((std::sin(up) + above * std::cos(up)) / std::sqrt(1.0 + across * across + above * above)));
}

struct Agreement {
    double mean = 0.0, bias = 0.0, worst = 0.0;  // of |ours / theirs - 1|: mean, and 95th percentile; of ours / theirs - 1
    double colour = 0.0;                         // of blue over red, ours / theirs - 1, mean
    std::size_t blocks = 0;
};
/// The reference's land is bare and level; from the ground ours, with its trees, hides the lowest clouds.
constexpr double kLandHides = 1.5;  // degrees

/// `ours` has `rays` pixels each way for one of `theirs`.
Agreement agreement(Scene const& scene, assets::FloatImage const& ours, assets::FloatImage const& theirs, int rays) {
    std::vector<double> errors;
    Agreement result;
    for (int y = 0; y + kBlock <= theirs.height; y += kBlock)
        for (int x = 0; x + kBlock <= theirs.width; x += kBlock) {
            Block const reference = blockAt(theirs, x, y, kBlock);
            if (reference.alpha <= 0.5) continue;
            if (scene.eye.empty() && elevationAt(scene, x, y, {theirs.width, theirs.height}) < kLandHides) continue;
            Block const game = blockAt(ours, rays * x, rays * y, rays * kBlock);
            double const off = game.luminance / reference.luminance - 1.0;
            result.colour += game.blueness / reference.blueness - 1.0;
            errors.push_back(std::abs(off));
            result.bias += off;
            result.mean += std::abs(off);
        }
    result.blocks = errors.size();
    if (errors.empty()) return result;
    result.bias /= static_cast<double>(errors.size());
    result.colour /= static_cast<double>(errors.size());
    result.mean /= static_cast<double>(errors.size());
    std::sort(errors.begin(), errors.end());
    result.worst = errors[errors.size() * 95 / 100];
    return result;
}

constexpr double kMostTint = 0.06;  // of blue over red, in the mean over a scene's clouds

class ReferenceScene : public testing::TestWithParam<Scene> {};

TEST_P(ReferenceScene, IsDrawnAsBrightAsItIs) {
    Scene const& scene = GetParam();
    auto const theirs = assets::readFloatImage(kFolder / (scene.name + ".exr"));
    ASSERT_EQ(theirs.width, 96);
    Agreement const a = agreement(scene, drawn(scene, "", kRays), theirs, kRays);
    fmt::print("| {} | {} | {:.1f} % | {:+.1f} % | {:.1f} % | {:+.1f} % |\n", scene.name, a.blocks, 100.0 * a.mean, 100.0 * a.bias, 100.0 * a.worst, 100.0 * a.colour);
    ASSERT_GT(a.blocks, 60u);
    EXPECT_LT(a.mean, scene.mean);
    EXPECT_LT(std::abs(a.bias), scene.bias);
    EXPECT_LT(a.worst, scene.worst);
    EXPECT_LT(std::abs(a.colour), kMostTint);
}
INSTANTIATE_TEST_SUITE_P(Of, ReferenceScene, testing::ValuesIn(scenes()), [](auto const& scene) { return scene.param.name; });

// A stored picture is what the tracer makes: the mean over the clouds' pixels of a new, noisier one lies within three of its own
// standard errors.
TEST(Reference, IsWhatIsTracedToday) {
    Scene const scene = scenes().front();
    auto const stored = assets::readFloatImage(kFolder / (scene.name + ".exr"));
    auto const traced = drawn(scene, "--reference 64", 1);
    double sum = 0.0, squares = 0.0, mean = 0.0;
    int count = 0;
    for (int y = 0; y < stored.height; ++y)
        for (int x = 0; x < stored.width; ++x) {
            Block const then = blockAt(stored, x, y, 1), now = blockAt(traced, x, y, 1);
            if (then.alpha <= 0.5) continue;
            double const off = now.luminance - then.luminance;
            sum += off;
            squares += off * off;
            mean += then.luminance;
            ++count;
        }
    ASSERT_GT(count, 1000);
    double const error = std::sqrt(squares / count - (sum / count) * (sum / count)) / std::sqrt(count);
    fmt::print("mean off by {:.2f} % of itself, standard error {:.2f} %\n", 100.0 * sum / mean, 100.0 * error * count / mean);
    EXPECT_LT(std::abs(sum / count), 3.0 * error);
    EXPECT_LT(error, 0.05 * mean / count);
}
}  // namespace
