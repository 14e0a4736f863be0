// What the weather adds to the picture, measured in pictures: bow, shaft, halo, glory, flash.
#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <map>

#include "engine/core/time.h"
#include "engine/render/renderer.h"
#include "engine/render/weather_light_pass.h"
#include "engine/weather/cloud_pattern.h"
#include "engine/weather/lightning.h"
#include "engine/weather/presets.h"
#include "engine/weather/showers.h"
#include "engine/weather/source.h"
#include "tests/gl/gl_fixture.h"

namespace luftpost::test {
namespace {
class WeatherLight : public GlTest {};

/// A picture without land; the sun may be put anywhere.
struct View {
    explicit View(std::string const& weather, char const* time, glm::ivec2 const& pixels = {128, 72})
        : field{weather::loadWeather(weather)}, size{pixels}, renderer{{.size = pixels}} {
        snapshot.field = &field;
        snapshot.place = field.place();
        snapshot.still = true;
        snapshot.drawTerrain = false;
        at(*core::parseUtc(time));
        stand(snapshot.place.altitude_m + 300.0);
    }
    void at(core::UtcSeconds time) {
        snapshot.time = time;
        snapshot.weather = field.at(0.0, 0.0, time);
        snapshot.sky = sky::skyState(snapshot.place, time);
    }
    void stand(double altitude) { snapshot.camera.positionWorld = {0.0, altitude, 0.0}; }
    /// At the height where it is, m east and south.
    void move(glm::dvec2 const& eastSouth) {
        snapshot.camera.positionWorld.x = eastSouth.x;
        snapshot.camera.positionWorld.z = eastSouth.y;
    }
    /// Azimuth and elevation, rad.
    void look(double azimuth, double elevation, double fov_deg) {
        glm::dvec3 const ahead = sky::directionWorld(azimuth, elevation);
        snapshot.camera.worldFromCamera = glm::conjugate(glm::quat_cast(glm::lookAt(glm::dvec3{0.0}, ahead, glm::dvec3{0.0, 1.0, 0.0})));
        snapshot.camera.horizontalFov = core::radians(fov_deg);
    }
    assets::FloatImage draw() {
        renderer.draw(snapshot);
        return renderer.readHdr();
    }
    /// Of the middle of a pixel, row 0 on top.
    glm::dvec3 direction(int x, int y) const {
        double const tangent = std::tan(0.5 * snapshot.camera.horizontalFov), aspect = static_cast<double>(size.x) / size.y;
        glm::dvec3 const ray{(2.0 * (x + 0.5) / size.x - 1.0) * tangent, (1.0 - 2.0 * (y + 0.5) / size.y) * tangent / aspect, -1.0};
        return glm::normalize(snapshot.camera.worldFromCamera * ray);
    }
    weather::Field field;
    glm::ivec2 size;
    render::Renderer renderer;
    render::Snapshot snapshot;
};

glm::dvec3 colourAt(assets::FloatImage const& image, int x, int y) {
    float const* p = &image.values[4 * static_cast<std::size_t>(y * image.width + x)];
    return {p[0], p[1], p[2]};
}

/// What one picture has more than another, by half degrees of the angle to a direction: mean of a channel.
std::map<int, double> differenceByAngle(View const& view, assets::FloatImage const& with, assets::FloatImage const& without, glm::dvec3 const& about, int channel) {
    std::map<int, std::pair<double, int>> sums;
    for (int y = 0; y < view.size.y; ++y)
        for (int x = 0; x < view.size.x; ++x) {
            int const bin = static_cast<int>(2.0 * core::degrees(std::acos(glm::dot(view.direction(x, y), about))));
            auto& [sum, count] = sums[bin];
            sum += colourAt(with, x, y)[channel] - colourAt(without, x, y)[channel];
            ++count;
        }
    std::map<int, double> means;
    for (auto const& [bin, sum] : sums)
        if (sum.second > 8) means[bin] = sum.first / sum.second;
    return means;
}

/// Where the storms of a view stand, asked of the weather itself: a test needs a storm before the eye, whatever the pattern deals.
class Storms {
public:
    explicit Storms(View const& view)
        : layer_{*std::find_if(view.snapshot.weather.layers.begin(), view.snapshot.weather.layers.end(), [](weather::Layer const& layer) { return layer.genus == weather::Genus::Cb; })},
          pattern_{layer_, view.snapshot.seed} {}

    /// How deep in a shaft a point under the bases is, 0..1.
    double rain(glm::dvec3 const& world) const {
        if (world.y > static_cast<double>(layer_.base)) return 0.0;
        return weather::showerInside(weather::Genus::Cb, rank(world), static_cast<double>(layer_.cover)).here;
    }
    /// Whether no storm stands between a point and the sun, each taken for a cone.
    bool sunlit(glm::dvec3 const& world, glm::dvec3 const& sun) const {
        for (double way = 500.0; world.y + way * sun.y < static_cast<double>(layer_.top); way += 1500.0) {
            glm::dvec3 const on = world + way * sun;
            double const share = std::max((on.y - static_cast<double>(layer_.base)) / static_cast<double>(layer_.top - layer_.base), 0.0);
            if (rank(on) < static_cast<double>(layer_.cover) * (1.0 - 0.7 * share)) return false;
        }
        return true;
    }

private:
    double rank(glm::dvec3 const& world) const { return static_cast<double>(pattern_.rank(world.x, -world.z)); }
    weather::Layer layer_;
    weather::LayerPattern pattern_;
};

/// Moves the eye to the best place within 36 km. `worth`: of an eye in the world.
template <class Worth>
void findPlace(View& view, Worth const& worth) {
    double best = -1e9;
    glm::dvec2 place{0.0};
    for (int i = 0; i < 25 * 25; ++i) {
        glm::dvec2 const there = 3000.0 * (glm::dvec2{i % 25, i / 25} - 12.0);
        double const here = worth(glm::dvec3{there.x, view.snapshot.camera.positionWorld.y, there.y});
        if (here > best) best = here, place = there;
    }
    view.move(place);
}

double greatestAt(std::map<int, double> const& values, double low, double high) {
    double best = low, most = -1e9;
    for (auto const& [bin, value] : values) {
        double const angle = 0.5 * bin + 0.25;
        if (angle >= low && angle <= high && value > most) most = value, best = angle;
    }
    return best;
}
}  // namespace

TEST_F(WeatherLight, BlockLiesInMemoryAsTheDriverSays) {
    gl::ProgramLibrary programs;
    gl::Program const& program = programs.compute("falling");
    EXPECT_EQ(program.uniformOffset("FallBlock.falls[1].lag"), static_cast<int>(offsetof(glsl::FallBlock, falls) + sizeof(glsl::LayerFall) + offsetof(glsl::LayerFall, lag)));
    EXPECT_EQ(program.uniformOffset("FallBlock.fallAll.melting"), static_cast<int>(offsetof(glsl::FallBlock, fallAll)));
    EXPECT_EQ(program.uniformOffset("FallBlock.optics"), static_cast<int>(offsetof(glsl::FallBlock, optics)));
}

TEST_F(WeatherLight, TheRainbowStandsAt42DegreesAroundTheShadowOfTheEyeAndSnowHasNone) {
    View view{"preset:showers", "2023-06-21T17:00Z", {192, 108}};
    glm::dvec3 const shadow = -view.snapshot.sky.sunDirectionWorld;
    ASSERT_LT(core::degrees(sky::elevation(-shadow)), 35.0);
    view.look(sky::azimuth(shadow), 0.2, 110.0);
    Storms const storms{view};
    findPlace(view, [&](glm::dvec3 const& eye) {  // sunlit rain along the bow
        if (storms.rain(eye) > 0.0) return -1.0;
        double sum = 0.0;
        for (int degrees = -70; degrees <= 70; degrees += 10) {
            glm::dvec3 const right = glm::normalize(glm::cross(shadow, glm::dvec3{0.0, 1.0, 0.0}));
            glm::dvec3 const out = std::sin(core::radians(degrees)) * right + std::cos(core::radians(degrees)) * glm::cross(right, shadow);
            glm::dvec3 const way = std::cos(core::radians(42.0)) * shadow + std::sin(core::radians(42.0)) * out;
            for (double distance = 1000.0; way.y > 0.02 && distance < 8000.0; distance += 1000.0)
                if (double const rain = storms.rain(eye + distance * way); rain > 0.0 && storms.sunlit(eye + distance * way, -shadow)) sum += rain;
        }
        return sum;
    });
    view.snapshot.weather.freezingLevel = 4000.0;
    assets::FloatImage const rain = view.draw();
    view.snapshot.weather.precipitation = weather::Precipitation::Snow;
    view.snapshot.weather.freezingLevel = -1000.0;
    assets::FloatImage const snow = view.draw();
    // The bow's colours: red less blue of the rain, against the same shafts as snow.
    auto const red = differenceByAngle(view, rain, snow, shadow, 0), blue = differenceByAngle(view, rain, snow, shadow, 2);
    std::map<int, double> colour;
    for (auto const& [bin, value] : red) colour[bin] = value - blue.at(bin);
    // Snow hides more of the clouds behind than rain does, whose own colours are broad: the bow is what in one degree stands out of three to both sides.
    auto const meanOf = [&](int bin, int count) {
        double sum = 0.0;
        for (int i = 0; i < count; ++i) sum += colour.at(bin + i) / count;
        return sum;
    };
    std::map<int, double> narrow;
    for (int bin = 2 * 30; bin < 2 * 48; ++bin) narrow[bin] = meanOf(bin, 2) - 0.5 * (meanOf(bin - 6, 3) + meanOf(bin + 5, 3));
    EXPECT_NEAR(greatestAt(narrow, 30.0, 48.0), 42.3, 1.0);
    double const inside = colour.at(2 * 40), outside = colour.at(2 * 42);
    EXPECT_GT(outside, inside) << "red outside, blue inside";
}

TEST_F(WeatherLight, TheHaloStandsAt22DegreesAroundTheSun) {
    View view{"preset:veil", "2023-03-01T09:30Z", {192, 108}};
    glm::dvec3 const sun = view.snapshot.sky.sunDirectionWorld;
    view.look(sky::azimuth(sun), sky::elevation(sun) + 0.1, 75.0);
    assets::FloatImage const veil = view.draw();
    assets::FloatImage const nothing{veil.width, veil.height, 4, std::vector<float>(veil.values.size(), 0.0f)};
    auto const red = differenceByAngle(view, veil, nothing, sun, 0), blue = differenceByAngle(view, veil, nothing, sun, 2);
    std::map<int, double> ratio;
    for (auto const& [bin, value] : red) ratio[bin] = value / std::max(blue.at(bin), 1e-9);
    EXPECT_NEAR(greatestAt(ratio, 18.0, 27.0), 21.9, 0.8) << "its inner edge is red";
    // Brighter than a smooth fall from 18 to 27 degrees would have it.
    double const before = red.at(2 * 18), at = red.at(2 * 22), after = red.at(2 * 27);
    EXPECT_GT(at, 1.03 * std::sqrt(before * after));
}

TEST_F(WeatherLight, ShaftsStandUnderTheStormsAndDimWhatIsBehindThem) {
    // Looking along the level under the bases: dark or bright shafts where the rank says rain, nothing between.
    View view{"preset:showers", "2023-06-21T10:30Z", {192, 108}};
    view.look(0.0, 0.02, 100.0);
    Storms const storms{view};
    findPlace(view, [&](glm::dvec3 const& eye) {  // shafts ahead, none near
        double sum = 0.0;
        for (int degrees = -45; degrees <= 45; degrees += 5) {
            double deepest = 0.0;
            for (double distance = 0.0; distance < 16000.0; distance += 1000.0) {
                double const rain = storms.rain(eye + distance * sky::directionWorld(core::radians(degrees), 0.03));
                if (rain > 0.0 && distance < 4000.0) return -1.0;
                deepest = std::max(deepest, rain);
            }
            sum += deepest;
        }
        return sum;
    });
    assets::FloatImage const wet = view.draw();
    view.snapshot.weather.precipitation = weather::Precipitation::None;
    weather::Recording dry = *weather::presetRecording("showers", std::nullopt);
    dry.sites[0].reports[0].precipitationKind = weather::Precipitation::None;
    dry.sites[0].reports[0].rate_mm_h = 0.0;
    weather::Field const dryField = weather::fieldFrom(std::move(dry), {weather::SourceMode::Preset, "dry", "", "", ""}, std::nullopt);
    view.snapshot.field = &dryField;
    view.snapshot.weather = dryField.at(0.0, 0.0, view.snapshot.time);
    assets::FloatImage const without = view.draw();
    double below = 0.0, above = 0.0;
    int belowCount = 0, aboveCount = 0;
    for (int y = 0; y < view.size.y; ++y)
        for (int x = 0; x < view.size.x; ++x) {
            double const up = core::degrees(std::asin(view.direction(x, y).y));
            double const change = std::abs(colourAt(wet, x, y).y - colourAt(without, x, y).y) / std::max(colourAt(without, x, y).y, 1e-6);
            if (up > 0.3 && up < 4.0) below += change, ++belowCount;
            if (up > 25.0) above += change, ++aboveCount;
        }
    EXPECT_GT(below / belowCount, 0.03);
    EXPECT_LT(above / aboveCount, 0.5 * below / belowCount);
}

TEST_F(WeatherLight, SnowOnTheGroundWhitensTheLandAndRainDarkensIt) {
    View view{"preset:clear", "2023-06-21T10:30Z", {64, 36}};
    view.snapshot.drawTerrain = true;
    view.look(0.0, -0.5, 60.0);
    auto const brightness = [&] {
        assets::FloatImage const image = view.draw();
        double sum = 0.0;
        for (std::size_t i = 1; i < image.values.size(); i += 4) sum += static_cast<double>(image.values[i]);
        return sum;
    };
    double const bare = brightness();
    view.snapshot.weather.snowDepth = 0.25;
    double const white = brightness();
    EXPECT_GT(white, 2.2 * bare) << "albedo 0.8 against 0.2";
    view.snapshot.weather.snowDepth = 0.0;
    view.snapshot.weather.precipitation = weather::Precipitation::Rain;
    view.snapshot.weather.precipitationRate = 2.0;  // no cloud to rain from: the ground alone changes
    EXPECT_LT(brightness(), 0.97 * bare);
}

TEST_F(WeatherLight, AFlashLightsItsCloudAndIsDarkBeforeAndAfter) {
    View view{"preset:storm", "2023-06-21T21:30Z"};
    auto const flashes = weather::flashes(view.snapshot.weather, 1, view.snapshot.time, view.snapshot.time + 600.0, {0.0, 0.0}, 9000.0, view.snapshot.place.altitude_m);
    auto const channel = std::find_if(flashes.begin(), flashes.end(), [](weather::Flash const& f) { return f.toGround; });
    ASSERT_NE(channel, flashes.end());
    glm::dvec3 const way = glm::normalize(channel->sourceWorld - view.snapshot.camera.positionWorld);
    auto const brightness = [&](double after) {
        view.at(channel->time + after);
        view.look(sky::azimuth(way), 0.1, 60.0);
        assets::FloatImage const image = view.draw();
        double sum = 0.0;
        for (std::size_t i = 1; i < image.values.size(); i += 4) sum += static_cast<double>(image.values[i]);
        return sum;
    };
    double const before = brightness(-1.0), during = brightness(0.0), later = brightness(1.5);
    EXPECT_GT(during, 3.0 * before);
    EXPECT_LT(later, 1.2 * before);
}
}  // namespace luftpost::test
