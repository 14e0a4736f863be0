// What the weather's page offers.
#include "game/app/weather_desk.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "engine/core/file.h"
#include "engine/core/time.h"

using namespace luftpost;
using namespace luftpost::app;

namespace {
Session sessionOver(char const* source) {
    SessionOptions options;
    options.plan.weather.source = source;
    options.plan.place = {47.0, 8.0, 430.0};
    options.plan.simulation.time = *core::parseUtc("2024-05-01T12:00Z");
    options.plan.simulation.start.altitude = 900.0;
    return Session{std::move(options)};
}
}  // namespace

TEST(WeatherDesk, OffersTheFileOfTheCommandLineInWhateverFormatItIs) {
    std::filesystem::path const file = std::filesystem::path{testing::TempDir()} / "luftpost_weather_desk.metar";
    core::writeFileAtomically(file, "2024/05/01 11:50\nLSZH 011150Z 24008KT 9999 FEW030 SCT045 12/08 Q1015\n");
    Session const session = sessionOver("preset:fair");
    auto const offered = [&](std::string const& given) {
        auto const sources = WeatherDesk{given}.menu(session).sources;
        return std::any_of(sources.begin(), sources.end(), [&](auto const& source) { return source.source == given; });
    };
    EXPECT_TRUE(offered("recorded:" + file.string()));
    EXPECT_TRUE(offered("preset:storm"));
    EXPECT_FALSE(offered("recorded:" + file.string() + ".gone"));
}
