// What a closed sky does to the air below it.
#include <algorithm>

#include "engine/weather/source.h"
#include "tests/gl/sky_fixture.h"

namespace {
using namespace luftpost;

class Overcast : public test::GlTest {};

/// The preset-like storm at noon: a closed layer of cumulonimbus, 5 km of visibility, heavy rain.
render::Snapshot stormSnapshot(weather::Field const* field) {
    render::Snapshot snapshot = test::skySnapshot(100.0, 0.0, 0.0, 60.0);
    snapshot.field = field;
    snapshot.weather.layerCount = 1;
    snapshot.weather.layers[0].genus = weather::Genus::Cb;
    snapshot.weather.layers[0].cover = 0.9f;
    snapshot.weather.layers[0].base = 800.0f;
    snapshot.weather.layers[0].top = 10000.0f;
    snapshot.weather.visibility = 5000.0;
    snapshot.weather.precipitation = weather::Precipitation::Rain;
    snapshot.weather.precipitationRate = 20.0;
    return snapshot;
}

TEST_F(Overcast, AirInAStormIsLitByWhatComesThroughTheCloudsNotByTheSun) {
    test::SkyRig rig{{64, 48}};
    weather::Field const field{weather::loadWeather("preset:storm")};
    render::Snapshot storm = stormSnapshot(&field);
    float const dim = sky::luminance(rig.draw(storm, 20000.0f).at(32, 10));  // a black wall: the air before it alone
    render::Snapshot hazy = stormSnapshot(&field);
    hazy.weather.layerCount = 0;
    hazy.weather.precipitation = weather::Precipitation::None;
    float const sunlit = sky::luminance(rig.draw(hazy, 20000.0f).at(32, 10));
    EXPECT_LT(dim, 0.15f * sunlit);
    EXPECT_GT(dim * sky::kSunIlluminance_lx, 200.0f);  // cd/m2: a dark day, not a night
    EXPECT_LT(dim * sky::kSunIlluminance_lx, 2000.0f);
}

TEST_F(Overcast, RainHidesTheLandAtTheReportedVisibilityAndNotBefore) {
    test::SkyRig rig{{64, 48}};
    weather::Field const field{weather::loadWeather("preset:storm")};
    render::Snapshot storm = stormSnapshot(&field);
    auto const airLight = [&](float distance) { return sky::luminance(rig.draw(storm, distance).at(32, 20)); };
    float const all = airLight(30000.0f);
    EXPECT_GT(airLight(5000.0f) / all, 0.9f);  // 5 % of a contrast are left at the visibility
    EXPECT_LT(airLight(1000.0f) / all, 0.55f);
    EXPECT_GT(airLight(1000.0f) / all, 0.35f);  // 1 - 0.05^(1/5) = 0.45
}
}  // namespace
