// Clouds on the GPU: the noise's twin, the block's layout, and pictures with the properties that skies have.
#include <fmt/format.h>

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>

#include "engine/core/time.h"
#include "engine/gl/draw.h"
#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/render/renderer.h"
#include "engine/sky/light.h"
#include "engine/weather/source.h"
#include "engine/weather/noise_volume.h"
#include "shaders/shared/cloud.glsl.h"
#include "tests/gl/gl_fixture.h"

namespace luftpost::test {
namespace {
class CloudTest : public GlTest {};

/// `Texture`: Texture3D, or Texture2D for a volume one texel high, with the vector of its size.
template <class Texture, class Size>
void expectTwin(gl::ProgramLibrary& programs, char const* name, weather::NoiseVolume const& made, unsigned seed) {
    Texture texture{made.channels() == 1 ? gl::Format::r8 : gl::Format::rgba8, Size{made.size()}, 1, name};
    gl::Program const& program = programs.compute(name);
    program.use();
    program.set("seed", seed);
    texture.bindImage(0, gl::Access::write);
    gl::dispatch({made.size().x / 8, made.size().y / 8, made.size().z});
    gl::barrier(gl::Barrier::all);
    std::vector<std::uint8_t> const drawn = texture.readBytes();
    ASSERT_EQ(drawn.size(), made.texels(0).size());
    int worst = 0;
    for (std::size_t i = 0; i < drawn.size(); ++i) worst = std::max(worst, std::abs(drawn[i] - made.texels(0)[i]));
    EXPECT_LE(worst, 1) << name;
}

TEST_F(CloudTest, NoiseMadeByTheGpuIsWithinOneByteOfTheBuilds) {
    gl::ProgramLibrary programs;
    weather::NoiseVolumes const made = weather::makeNoise(3, 2);
    expectTwin<gl::Texture3D, glm::ivec3>(programs, "noise_shape", made.shape, 3);
    expectTwin<gl::Texture3D, glm::ivec3>(programs, "noise_detail", made.detail, 3);
    expectTwin<gl::Texture2D, glm::ivec2>(programs, "noise_curl", made.curl, 3);
}

TEST_F(CloudTest, BlockLiesInMemoryAsTheDriverSays) {
    gl::ProgramLibrary programs;
    gl::Program const& program = programs.compute("cloud_march");
    EXPECT_EQ(program.uniformOffset("CloudBlock.shapes[1].look"),
              static_cast<int>(offsetof(glsl::CloudBlock, shapes) + sizeof(glsl::LayerShape) + offsetof(glsl::LayerShape, look)));
    EXPECT_EQ(program.uniformOffset("CloudBlock.fields[3].high"),
              static_cast<int>(offsetof(glsl::CloudBlock, fields) + 3 * sizeof(glsl::LayerField) + offsetof(glsl::LayerField, high)));
    EXPECT_EQ(program.uniformOffset("CloudBlock.mapPlaces[0]"), static_cast<int>(offsetof(glsl::CloudBlock, mapPlaces)));
    EXPECT_EQ(program.uniformOffset("CloudBlock.march"), static_cast<int>(offsetof(glsl::CloudBlock, march)));
    EXPECT_EQ(program.uniformOffset("CloudBlock.step"), static_cast<int>(offsetof(glsl::CloudBlock, step)));
}

/// A picture without land, at noon, from a height over the place, m.
struct Shot {
    explicit Shot(std::string const& weather, double elevation_deg, double azimuth_deg = 109.0, double height = 2.0)
        : field{weather::loadWeather(weather)}, renderer{{.size = {96, 54}}} {
        snapshot.field = &field;
        snapshot.place = field.place();
        snapshot.time = *core::parseUtc("2023-06-21T10:30Z");
        snapshot.still = true;
        snapshot.drawTerrain = false;
        snapshot.camera.positionWorld = {0.0, snapshot.place.altitude_m + height, 0.0};
        glm::dvec3 const ahead = sky::directionWorld(core::radians(azimuth_deg), core::radians(elevation_deg));
        snapshot.camera.worldFromCamera = glm::conjugate(glm::quat_cast(glm::lookAt(glm::dvec3{0.0}, ahead, glm::dvec3{0.0, 1.0, 0.0})));
        snapshot.weather = field.at(0.0, 0.0, snapshot.time);
        snapshot.sky = sky::skyState(snapshot.place, snapshot.time);
    }
    assets::FloatImage draw() {
        renderer.draw(snapshot);
        return renderer.readHdr();
    }
    weather::Field field;
    render::Renderer renderer;
    render::Snapshot snapshot;
};

double meanAlpha(assets::FloatImage const& image) {
    double sum = 0.0;
    for (std::size_t i = 3; i < image.values.size(); i += 4) sum += static_cast<double>(image.values[i]);
    return sum / static_cast<double>(image.values.size() / 4);
}

TEST_F(CloudTest, ClearSkyHasNoneAndOvercastSkyIsClosed) {
    EXPECT_EQ(meanAlpha(Shot{"preset:clear", 40.0}.draw()), 0.0);
    EXPECT_GT(meanAlpha(Shot{"preset:overcast", 40.0}.draw()), 0.995);
}

TEST_F(CloudTest, PicturesAreFiniteAndTheSameTwice) {
    Shot shot{"preset:fair", 25.0};
    assets::FloatImage const first = shot.draw();
    for (float value : first.values) ASSERT_TRUE(std::isfinite(value));
    EXPECT_GT(meanAlpha(first), 0.1);
    EXPECT_LT(meanAlpha(first), 0.9);
    EXPECT_EQ(first.values, shot.draw().values);
}

/// Luminances of what is wholly cloud, kcd/m2, sorted.
std::vector<double> cloudLuminances(assets::FloatImage const& image) {
    std::vector<double> values;
    for (std::size_t i = 0; i < image.values.size(); i += 4) {
        auto const v = [&](std::size_t k) { return static_cast<double>(image.values[i + k]); };
        if (v(3) > 0.98) values.push_back(1e-3 * sky::kSunIlluminance_lx * (0.2126 * v(0) + 0.7152 * v(1) + 0.0722 * v(2)));
    }
    std::sort(values.begin(), values.end());
    return values;
}

TEST_F(CloudTest, SunlitSidesAndBasesAreAsBrightAsReal) {
    std::vector<double> const bases = cloudLuminances(Shot{"preset:fair", 65.0, 0.0}.draw());
    ASSERT_GT(bases.size(), 300u);
    // A real thick cumulus has 3 to 7; these are thin, and the path tracer has 17 here.
    EXPECT_GT(bases[bases.size() / 4], 11.0);
    EXPECT_LT(bases[bases.size() / 4], 20.0);
    std::vector<double> const tops = cloudLuminances(Shot{"preset:fair", -15.0, 340.0, 2900.0}.draw());
    ASSERT_GT(tops.size(), 300u);
    fmt::print("tops {:.2f}, bases {:.2f} kcd/m2\n", tops[tops.size() * 9 / 10], bases[bases.size() / 4]);
    EXPECT_GT(tops[tops.size() * 9 / 10], 20.0);
    EXPECT_LT(tops[tops.size() * 9 / 10], 30.0);
}

TEST_F(CloudTest, ASixteenthOfTheRaysComesToThePictureOfAll) {
    Shot shot{"preset:fair", 25.0};
    assets::FloatImage const all = shot.draw();
    shot.snapshot.still = false;
    shot.snapshot.frameSeconds = 0.0;
    for (int frame = 0; frame < 48; ++frame) shot.renderer.draw(shot.snapshot);
    assets::FloatImage const few = shot.renderer.readHdr();
    double difference = 0.0, sum = 0.0;
    for (std::size_t i = 0; i < all.values.size(); ++i) {
        if (i % 4 == 3) continue;
        difference += static_cast<double>(std::abs(all.values[i] - few.values[i]));
        sum += static_cast<double>(all.values[i]);
    }
    EXPECT_LT(difference / sum, 0.002);  // the same rays; half floats
    EXPECT_NEAR(meanAlpha(all), meanAlpha(few), 0.001);
}

// The glow is solved band by band as the eye moves on: it comes to what a still solves at once.
TEST_F(CloudTest, GlowFoundOnTheWayIsThatOfAStill) {
    Shot there{"preset:fair", 25.0};
    there.snapshot.camera.positionWorld.x += 9000.0;
    assets::FloatImage const still = there.draw();
    Shot moved{"preset:fair", 25.0};
    assets::FloatImage const before = moved.draw();
    moved.snapshot.still = false;
    moved.snapshot.frameSeconds = 0.0;
    moved.snapshot.camera.positionWorld.x += 9000.0;
    for (int frame = 0; frame < 16 * 12; ++frame) moved.renderer.draw(moved.snapshot);
    assets::FloatImage const found = moved.renderer.readHdr();
    auto const apart = [](assets::FloatImage const& a, assets::FloatImage const& b) {
        double difference = 0.0, sum = 0.0;
        for (std::size_t i = 0; i < a.values.size(); ++i) {
            if (i % 4 == 3) continue;
            difference += static_cast<double>(std::abs(a.values[i] - b.values[i]));
            sum += static_cast<double>(a.values[i]);
        }
        return difference / sum;
    };
    fmt::print("apart {:.4f}, places {:.4f}\n", apart(still, found), apart(still, before));
    EXPECT_GT(apart(still, before), 0.05);  // another place
    EXPECT_LT(apart(still, found), 0.01);
}
}  // namespace
}  // namespace luftpost::test
