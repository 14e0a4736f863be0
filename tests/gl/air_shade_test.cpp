// The clouds' shade in the air: rays stand in haze under broken cloud, whichever way one looks, and nothing changes where no
// cloud is.
#include <fmt/format.h>

#include <cmath>
#include <fstream>
#include <glm/gtc/matrix_transform.hpp>
#include <numeric>
#include <vector>

#include "engine/core/time.h"
#include "engine/render/renderer.h"
#include "engine/sky/light.h"
#include "engine/sky/sky_state.h"
#include "engine/weather/source.h"
#include "tests/gl/gl_fixture.h"
#include "tests/support/scratch.h"

namespace luftpost::test {
namespace {
class AirShadeTest : public GlTest {};

constexpr glm::ivec2 kSize{96, 54};
constexpr char const* kEvening = "2023-06-21T16:30Z";

/// Haze of 9 km under stratocumulus.
std::string hazyWeather() {
    std::string const file = (tests::scratch() / "haze.json").string();
    std::ofstream{file} << R"({"format":"luftpost-weather-1","name":"haze","source":"composed","licence":"as the program's","sites":[{"name":"Basel",
"lat":47.541,"lon":7.584,"elevation_m":316,"reports":[{"time":"2023-06-21T16:30Z","wind":{"speed_mps":4,"from_deg":250},"visibility_m":9000,
"temperature_c":20,"dew_point_c":9,"pressure_hpa":1018,"precipitation":{"kind":"none","rate_mm_h":0},"thunder":false,
"layers":[{"genus":"Sc","cover":0.6,"base_m":1560,"top_m":2160}],"layers_to_m":null}]}]})";
    return file;
}

/// Luminances of a still from 600 m over the ground, level, toward `azimuth_deg`; no land.
std::vector<double> look(std::string const& source, double azimuth_deg, bool shadows) {
    weather::Field const field = weather::loadWeather(source);
    render::Renderer renderer{{.size = kSize}};
    render::Snapshot snapshot;
    snapshot.field = &field;
    snapshot.place = field.place();
    snapshot.time = *core::parseUtc(kEvening);
    snapshot.still = true;
    snapshot.drawTerrain = false;
    snapshot.clouds.shadows = shadows;
    snapshot.weather = field.at(0.0, 0.0, snapshot.time);
    snapshot.sky = sky::skyState(snapshot.place, snapshot.time);
    snapshot.camera.positionWorld = {0.0, snapshot.place.altitude_m + 600.0, 0.0};
    glm::dvec3 const ahead = sky::directionWorld(core::radians(azimuth_deg), 0.0);
    snapshot.camera.worldFromCamera = glm::conjugate(glm::quat_cast(glm::lookAt(glm::dvec3{0.0}, ahead, glm::dvec3{0.0, 1.0, 0.0})));
    renderer.draw(snapshot);
    assets::FloatImage const image = renderer.readHdr();
    std::vector<double> values(image.values.size() / 4);
    for (std::size_t i = 0; i < values.size(); ++i)
        values[i] = static_cast<double>(sky::luminance({image.values[4 * i], image.values[4 * i + 1], image.values[4 * i + 2]}));
    for (double value : values) EXPECT_TRUE(std::isfinite(value) && value >= 0.0);
    return values;
}

/// How uneven the haze under the clouds is along the level: standard deviation over mean of the lower rows, each freed of its slope.
double unevenness(std::vector<double> const& picture) {
    double sum = 0.0;
    int rows = 0;
    for (int y = 34; y < 50; y += 2, ++rows) {
        auto const at = [&](int x) { return picture[static_cast<std::size_t>(y * kSize.x + x)]; };
        double second = 0.0, mean = 0.0;
        for (int x = 8; x < kSize.x - 8; ++x) {
            second += std::abs(at(x) - 0.5 * (at(x - 8) + at(x + 8)));
            mean += at(x);
        }
        sum += second / mean;
    }
    return sum / rows;
}

TEST_F(AirShadeTest, RaysStandInHazeUnderBrokenCloudTowardTheSunAndBesideIt) {
    std::string const haze = hazyWeather();
    for (double azimuth : {272.0, 200.0}) {  // the sun's; across
        double const shaded = unevenness(look(haze, azimuth, true)), open = unevenness(look(haze, azimuth, false));
        fmt::print("toward {:.0f}: {:.4f} with shade, {:.4f} without\n", azimuth, shaded, open);
        EXPECT_GT(shaded, 2.0 * open);
        EXPECT_LT(shaded, 0.2) << "soft";
    }
}

TEST_F(AirShadeTest, NothingChangesWhereThereIsNoCloud) { EXPECT_EQ(look("preset:clear", 272.0, true), look("preset:clear", 272.0, false)); }
}  // namespace
}  // namespace luftpost::test
