// The luminances of a real day, and their ratios, held against pictures as `sky` writes them: each within a factor of 1.5.
// Figures: CIE's clear and overcast skies; an albedo under 100 klx of sun and 15 to 20 klx of sky. Prints ours.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <string>
#include <vector>

#include "engine/assets/image.h"
#include "engine/sky/light.h"
#include "tests/play/program.h"

namespace {
using namespace luftpost;
constexpr double kFactor = 1.5;
constexpr int kSide = 96;

assets::FloatImage drawn(std::string const& name, std::string const& how) {
    auto const file = tests::scratch() / (name + ".exr");
    auto const outcome = tests::run("sky " + how + " -o " + file.string());
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    return assets::readFloatImage(file);
}

/// kcd/m2.
double luminance(assets::FloatImage const& image, int x, int y) {
    auto const at = [&](int channel) { return static_cast<double>(image.at(x, y, channel)); };
    return 1e-3 * sky::kSunIlluminance_lx * (0.2126 * at(0) + 0.7152 * at(1) + 0.0722 * at(2));
}

/// Luminances of the pixels that `in(x, y)` takes, sorted.
template <class In>
std::vector<double> luminances(assets::FloatImage const& image, In&& in) {
    std::vector<double> values;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            if (in(x, y)) values.push_back(luminance(image, x, y));
    std::sort(values.begin(), values.end());
    EXPECT_GT(values.size(), 20u);
    return values;
}
double share(std::vector<double> const& sorted, double part) {
    return sorted.empty() ? 0.0 : sorted[static_cast<std::size_t>(part * static_cast<double>(sorted.size() - 1))];
}

/// Zenith angle of a pixel of an equal-area dome, degrees; over 90 outside.
double zenithAngle(int x, int y) {
    double const middle = 0.5 * (kSide - 1), r = std::hypot(x - middle, y - middle) / (0.5 * kSide);
    return r > 1.0 ? 180.0 : 2.0 * std::asin(r / std::sqrt(2.0)) * 180.0 / 3.14159265358979;
}
auto ring(double from, double to) {
    return [=](int x, int y) { return zenithAngle(x, y) >= from && zenithAngle(x, y) < to; };
}

void expectWithin(char const* what, double ours, double low, double high, double factor = kFactor) {
    fmt::print("| {} | {:.2f} | {:.4g} to {:.4g} |\n", what, ours, low, high);
    EXPECT_GE(ours, low / factor) << what;
    EXPECT_LE(ours, high * factor) << what;
}

std::string const kDome = "--dome --size 96x96 --time 2023-06-21T09:00Z --weather ";

TEST(RealDay, HasAClearSkyAsBrightAsMeasured) {
    auto const dome = drawn("clear_dome", kDome + "preset:clear");
    double const zenith = share(luminances(dome, ring(0.0, 12.0)), 0.5), horizon = share(luminances(dome, ring(80.0, 87.0)), 0.5);
    expectWithin("clear, zenith, kcd/m2", zenith, 2.0, 5.0);
    expectWithin("clear, horizon, kcd/m2", horizon, 6.0, 12.0);
    expectWithin("clear, horizon over zenith", horizon / zenith, 2.0, 4.0, 1.1);
    int const middle = kSide / 2;
    expectWithin("clear, zenith, blue over red", static_cast<double>(dome.at(middle, middle, 2) / dome.at(middle, middle, 0)), 2.0, 3.0, 1.1);
    auto const sun = drawn("clear_sun", "--size 64x64 --fov 24 --look 119,54 --time 2023-06-21T09:00Z --weather preset:clear");
    std::vector<double> const around = luminances(sun, [](int x, int y) {
        double const off = std::hypot(x - 31.5, y - 31.5) * 24.0 / 64.0;
        return off > 3.0 && off < 6.0;
    });
    expectWithin("clear, three to six degrees from the sun, kcd/m2", share(around, 0.5), 20.0, 60.0);
}

TEST(RealDay, HasAnOvercastSkyThreeTimesBrighterAtTheZenith) {
    auto const dome = drawn("overcast_dome", kDome + "preset:overcast");
    double const zenith = share(luminances(dome, ring(0.0, 12.0)), 0.5), horizon = share(luminances(dome, ring(85.5, 88.5)), 0.5);
    expectWithin("overcast, zenith, kcd/m2", zenith, 2.0, 6.0);
    // Three to one; three degrees over the horizon, in the middle of the ring, CIE's overcast is 1 + 2 sin 3 degrees brighter.
    expectWithin("overcast, zenith over horizon", zenith / horizon * (1.0 + 2.0 * std::sin(0.0524)), 0.8 * 3.0, 1.2 * 3.0, 1.0);
}

/// A recording of one clear report but for what `with` replaces.
std::string composed(std::string const& name, std::string const& layers, std::string const& more = "") {
    auto const file = tests::scratch() / (name + ".json");
    tests::writeText(file, R"({"format":"luftpost-weather-1","name":"composed","source":"composed","licence":"as the program's","sites":[{"name":"Basel",
"lat":47.541,"lon":7.584,"elevation_m":316,"reports":[{"time":"2023-06-21T10:30Z","wind":{"speed_mps":4,"from_deg":250},"visibility_m":50000,
"temperature_c":20,"dew_point_c":9,"pressure_hpa":1018,"precipitation":{"kind":"none","rate_mm_h":0},"thunder":false)" +
                               more + R"(,"layers":[)" + layers + R"(],"layers_to_m":null}]}]})");
    return "--weather " + file.string() + " --time 2023-06-21T10:30Z ";
}

TEST(RealDay, HasThickCumulusWhiteInTheSunAndDarkBelow) {
    std::string const thick = composed("thick", R"({"genus":"Cu","cover":0.6,"base_m":1560,"top_m":4560})");
    auto const cloud = [](assets::FloatImage const& image) {
        return luminances(image, [&](int x, int y) { return image.at(x, y, 3) > 0.98f; });
    };
    double const sides = share(cloud(drawn("thick_sides", thick + "--size 96x54 --look 340,-10 --place 47.541,7.584,5200")), 0.9);
    double const bases = share(cloud(drawn("thick_bases", thick + "--size 64x64 --look 0,90 --fov 70")), 0.25);
    expectWithin("sunlit side of a thick cumulus, kcd/m2", sides, 20.0, 30.0);
    expectWithin("its base, kcd/m2", bases, 3.0, 7.0);
    expectWithin("side over base", sides / bases, 4.0, 8.0);
}

TEST(RealDay, HasThinCirrusALittleBrighterThanTheSky) {
    std::string const where = "--size 64x64 --look 300,60 --fov 50";
    auto const all = [](int, int) { return true; };
    auto const veiled = drawn("cirrus", composed("cirrus", R"({"genus":"Ci","cover":0.7,"base_m":8500,"top_m":9500})") + where);
    auto const open = drawn("no_cirrus", composed("no_cirrus", "") + where);
    expectWithin("cirrus over the sky beside it, kcd/m2", share(luminances(veiled, all), 0.6) - share(luminances(open, all), 0.5), 1.0, 5.0);
}

TEST(RealDay, HasLandAsBrightAsGrassForestAndSnow) {
    auto const all = [](int, int) { return true; };
    std::string const where = "--size 96x96 --look 0,-90 --fov 70 --place 47.6,7.7,1500";
    std::vector<double> const land = luminances(drawn("land", composed("land", "") + where), all);
    expectWithin("dark tenth of the land in the sun, forest, kcd/m2", share(land, 0.1), 4.0, 4.0);
    expectWithin("middle of the land in the sun, grass, kcd/m2", share(land, 0.5), 7.0, 7.0);
    std::vector<double> const snow = luminances(drawn("snow", composed("snow", "", R"(,"snow_depth_m":0.3)") + where), all);
    expectWithin("snow in the sun, kcd/m2", share(snow, 0.75), 28.0, 28.0);
}
}  // namespace
