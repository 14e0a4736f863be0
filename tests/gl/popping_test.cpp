// Nothing pops on a climb from the ground to 20 km, into layers, out of them and between them: frames of every ray, 20 m of
// height apart near the faces of layers, 100 m elsewhere.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "engine/core/time.h"
#include "engine/render/renderer.h"
#include "engine/sky/light.h"
#include "engine/sky/sky_state.h"
#include "engine/weather/source.h"
#include "tests/gl/gl_fixture.h"

namespace luftpost::test {
namespace {
class Popping : public GlTest {};

constexpr double kTop = 20'000.0;           // m
constexpr double kNear = 20.0, kFar = 100.0;  // m between two pictures
constexpr double kFaceReach = 120.0;        // m: so near to a face steps are short

std::vector<double> heights(weather::Weather const& sky) {
    std::vector<double> result;
    for (double h = 350.0; h < kTop;) {
        result.push_back(h);
        bool near = false;
        for (int i = 0; i < sky.layerCount; ++i) {
            weather::Layer const& layer = sky.layers[static_cast<std::size_t>(i)];
            for (double face : {static_cast<double>(layer.base), static_cast<double>(layer.top)}) near = near || std::abs(h + 50.0 - face) < kFaceReach;
        }
        h += near ? kNear : kFar;
    }
    return result;
}

/// Luminance of each pixel.
std::vector<double> picture(render::Renderer& renderer, render::Snapshot const& snapshot) {
    renderer.draw(snapshot);
    assets::FloatImage const image = renderer.readHdr();
    std::vector<double> values(image.values.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<double>(sky::luminance({image.values[4 * i], image.values[4 * i + 1], image.values[4 * i + 2]}));
    return values;
}

TEST_F(Popping, IsNowhereFromTheGroundToTwentyKilometres) {
    weather::Field const field = weather::loadWeather("preset:fair");
    render::Renderer renderer{{.size = {64, 36}}};
    render::Snapshot snapshot;
    snapshot.field = &field;
    snapshot.place = field.place();
    snapshot.time = *core::parseUtc("2023-06-21T10:30Z");
    snapshot.drawTerrain = false;
    snapshot.dither = false;
    snapshot.clouds.rays = 1.0f;
    snapshot.weather = field.at(0.0, 0.0, snapshot.time);
    snapshot.sky = sky::skyState(snapshot.place, snapshot.time);
    glm::dvec3 const ahead = sky::directionWorld(core::radians(60.0), core::radians(-4.0));
    snapshot.camera.worldFromCamera = glm::conjugate(glm::quat_cast(glm::lookAt(glm::dvec3{0.0}, ahead, glm::dvec3{0.0, 1.0, 0.0})));
    std::vector<double> const at = heights(snapshot.weather);
    std::vector<double> change;  // per metre of height, share of the mean luminance
    std::vector<double> before;
    for (double height : at) {
        snapshot.camera.positionWorld = {0.0, height, 0.0};
        snapshot.still = before.empty();
        std::vector<double> now = picture(renderer, snapshot);
        if (!before.empty()) {
            double sum = 0.0, total = 0.0;
            for (std::size_t i = 0; i < now.size(); ++i) {
                ASSERT_TRUE(std::isfinite(now[i])) << height;
                sum += std::abs(now[i] - before[i]);
                total += 0.5 * (now[i] + before[i]);
            }
            change.push_back(sum / total);
        }
        before = std::move(now);
    }
    double worst = 0.0, where = 0.0;
    for (std::size_t i = 1; i + 1 < change.size(); ++i) {
        double const step = at[i + 1] - at[i], around = std::max(change[i - 1] / (at[i] - at[i - 1]), change[i + 1] / (at[i + 2] - at[i + 1])) * step;
        double const alone = change[i] - around;  // what motion, which goes on before and after, does not explain
        if (alone > worst) worst = alone, where = at[i + 1];
    }
    fmt::print("{} pictures; largest jump {:.2f} % at {:.0f} m\n", at.size(), 100.0 * worst, where);
    EXPECT_LT(worst, 0.035);
    EXPECT_GT(*std::max_element(change.begin(), change.end()), 0.05) << "nothing was passed";
}
}  // namespace
}  // namespace luftpost::test
