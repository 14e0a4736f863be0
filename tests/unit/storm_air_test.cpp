// The air of a cumulonimbus: downburst and gust front under the rain, cores above, and what falls where.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/outflow.h"
#include "engine/weather/showers.h"
#include "tests/unit/cloud_air_sky.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
core::UtcSeconds noon() { return *core::parseUtc("2023-06-23T12:00Z"); }

struct Storm : luftpost::tests::CloudAirSky {
    explicit Storm(std::string const& preset = "preset:storm") : CloudAirSky{preset, noon()} {}
};
/// Calls `see(effect, east, north)` at points over 80 km.
template <typename See>
void over(Storm const& storm, double height, See const& see, int n = 70, double temperature = 290.0) {
    for (int i = 0; i < n * n; ++i) {
        double const east = (i % n) * 1151.0, north = (i / n) * 1153.0;
        see(storm.at(east, north, height, temperature), east, north);
    }
}
}  // namespace

TEST(Storm, StaysWithinItsBounds) {
    Storm const storm;
    double outflow = 0.0, up = 0.0, down = 0.0;
    for (double const height : {80.0, 400.0, 1200.0, 3000.0, 6000.0})
        over(storm, height, [&](CloudEffect const& e, double, double) {
            outflow = std::max(outflow, glm::length(e.wind));
            up = std::max(up, e.lift);
            down = std::min(down, e.lift);
        });
    EXPECT_GT(outflow, 12.0);
    EXPECT_LT(outflow, 25.0);
    EXPECT_GT(up, 8.0);
    EXPECT_LT(up, 20.0);
    EXPECT_LT(down, -6.0);
    EXPECT_GT(down, -20.0);
}

TEST(Storm, TheDownburstStandsInTheRainAndBlowsOutOfIt) {
    Storm const storm;
    double rainDown = 0.0, rainUp = 0.0, outward = 0.0, speeds = 0.0;
    int downs = 0, ups = 0;
    over(storm, 300.0, [&](CloudEffect const& e, double east, double north) {
        if (e.lift < -3.0) rainDown += e.rain, ++downs;
        if (e.lift > 3.0) rainUp += e.rain, ++ups;
        // Toward less rain, within a kilometre.
        glm::dvec2 const wind = storm.at(east, north, 80.0).wind;
        if (glm::length(wind) < 4.0) return;
        glm::dvec2 const way = 1000.0 * wind / glm::length(wind);
        outward += storm.at(east - way.x, north - way.y, 80.0).rain - storm.at(east + way.x, north + way.y, 80.0).rain;
        speeds += 1.0;
    }, 40);
    ASSERT_GT(downs, 20);
    ASSERT_GT(ups, 20);
    EXPECT_GT(rainDown / downs, 1.5 * rainUp / ups);
    EXPECT_GT(outward / speeds, 3.0) << "mm/h less rain ahead than behind";
}

TEST(Storm, TheUpdraughtStandsBeforeTheRain) {
    Storm const storm;
    glm::dvec2 const wind = storm.clouds.weather.layers[0].wind;
    ASSERT_GT(glm::length(wind), 5.0);
    glm::dvec2 const lead = 1200.0 * wind / glm::length(wind);
    double behind = 0.0, ahead = 0.0;
    int cores = 0;
    over(storm, 4500.0, [&](CloudEffect const& e, double east, double north) {
        if (e.lift < 6.0) return;
        behind += storm.at(east - lead.x, north - lead.y, 200.0).rain;
        ahead += storm.at(east + lead.x, north + lead.y, 200.0).rain;
        ++cores;
    });
    ASSERT_GT(cores, 20);
    EXPECT_GT(behind, 1.2 * ahead);
}

TEST(Storm, NoAirComesFromNowhere) {
    // Divergence of the downburst by differences, over points, heights and places: less than a hundredth of its parts.
    Storm const storm;
    Layer const& layer = storm.clouds.weather.layers[0];
    ASSERT_EQ(layer.genus, Genus::Cb);
    auto const flow = [&](double east, double north, double height) {
        RankHill const hill = storm.ranks.hill(layer, 1.0, 0.5, east, north);
        Outflow const out = downburst(hill, {height, 800.0}, 0.05);  // weak: its bounds do not bend it
        return glm::dvec3{out.wind.x, out.lift, out.wind.y};
    };
    double worst = 0.0, most = 0.0;
    for (int i = 0; i < 300; ++i) {
        double const east = i * 377.0, north = i * 219.0, height = 30.0 + (i % 60) * 50.0, d = 2.0;
        double const de = (flow(east + d, north, height).x - flow(east - d, north, height).x) / (2.0 * d);
        double const dn = (flow(east, north + d, height).z - flow(east, north - d, height).z) / (2.0 * d);
        double const du = (flow(east, north, height + d).y - flow(east, north, height - d).y) / (2.0 * d);
        worst = std::max(worst, std::abs(de + dn + du));
        most = std::max(most, std::abs(du));
    }
    EXPECT_GT(most, 1e-4);
    EXPECT_LT(worst, 0.02 * most);
}

TEST(Storm, TheProfileIsThatOfOsegueraAndBowles) {
    RankHill hill;
    hill.slope = {1e-4, 0.0};
    auto const outward = [&](double height) { return glm::length(downburst(hill, {height, 3000.0}, 1.0).wind); };
    double best = 0.0, most = 0.0;
    for (double z = 5.0; z < 1000.0; z += 1.0)
        if (outward(z) > most) most = outward(z), best = z;
    EXPECT_NEAR(best, 80.0, 5.0) << "z_m = 0.22 z*";
    double const star = 80.0 / 0.22, e = 80.0 / 2.75;
    for (double const z : {20.0, 200.0, 600.0})
        EXPECT_NEAR(outward(z) / most, (std::exp(-z / star) - std::exp(-z / e)) / (std::exp(-0.22) - std::exp(-2.75)), 0.01) << z;
    EXPECT_NEAR(outward(0.0), 0.0, 1e-9);
}

TEST(Rain, FallsAtTheReportsRateInTheMeanAndOnlyUnderItsCloud) {
    Storm const storm, steady{"preset:overcast"};
    double rain = 0.0, dry = 0.0, most = 0.0;
    int n = 0;
    over(storm, 0.0, [&](CloudEffect const& e, double, double) {
        double const fall = e.rain + e.snow + e.hail;
        rain += fall;
        dry += fall < 3.0;
        most = std::max(most, fall);
        ++n;
    });
    EXPECT_NEAR(rain / n, 20.0, 1.0);
    EXPECT_GT(dry / n, 0.12) << "the gaps between storms of 0.85 cover";
    EXPECT_GT(most, 36.0);
    over(steady, 0.0, [&](CloudEffect const& e, double, double) { EXPECT_NEAR(e.rain, 1.2, 1e-3); }, 10);
    over(steady, 400.0, [&](CloudEffect const& e, double, double) { EXPECT_GT(e.rain, 1.2) << "some of it evaporates on its way"; }, 10);
    over(storm, 10600.0, [&](CloudEffect const& e, double, double) { EXPECT_EQ(e.rain + e.snow + e.hail, 0.0); }, 10, 220.0);
    EXPECT_EQ(Storm{"preset:fair"}.at(0.0, 0.0, 500.0).rain, 0.0);
}

TEST(Rain, IsSnowWhereItIsColdHailInTheCoresAndIceWhenItFallsThroughFrost) {
    Storm const storm;
    double warm = 0.0, cold = 0.0, hail = 0.0, hailLow = 0.0;
    over(storm, 1500.0, [&](CloudEffect const& e, double, double) { warm += e.rain, cold += e.snow; }, 30, 285.0);
    EXPECT_GT(warm, 0.0);
    EXPECT_EQ(cold, 0.0);
    over(storm, 4500.0, [&](CloudEffect const& e, double, double) { warm += e.rain, cold += e.snow, hail = std::max(hail, e.hail); }, 30, 262.0);
    EXPECT_GT(cold, 0.0);
    EXPECT_GT(hail, 2.0);
    over(storm, 20.0, [&](CloudEffect const& e, double, double) { hailLow = std::max(hailLow, e.hail); }, 30);
    EXPECT_LT(hailLow, hail);

    Weather freezing;
    freezing.precipitation = Precipitation::FreezingRain;
    freezing.precipitationRate = 2.0;
    Falling const fall = fallingOf(freezing, 2.0, 0.0, 50.0, 350.0, 270.0);
    EXPECT_NEAR(fall.rain, 2.0, 1e-9);
    EXPECT_NEAR(rainWater(2.0), 1.3e-4, 0.1e-4) << "kg/m3";
    freezing.precipitation = Precipitation::Sleet;
    EXPECT_NEAR(fallingOf(freezing, 2.0, 0.0, 10.0, 310.0, 274.0).snow, 1.0, 1e-9) << "half of it";
}
