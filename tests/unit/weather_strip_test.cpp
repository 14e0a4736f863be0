// The strip of hours over the time slider, and the moments it offers.
#include "game/ui/weather_strip.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/source.h"

namespace {
using namespace luftpost;

weather::Field bundled(char const* name) { return weather::loadWeather(std::string{"recorded:"} + LUFTPOST_SOURCE_DIR + "/assets/weather/" + name); }

bool near(ui::StripMoment const& moment, char const* time, double minutes) { return std::abs(moment.time - *core::parseUtc(time)) <= 60.0 * minutes; }

TEST(WeatherStrip, ShowsTheWholeRecordingInEqualSteps) {
    weather::Field const field = bundled("basel_2023-06-21_23.json");
    ui::WeatherStrip const strip = ui::weatherStrip(field, {0.0, 0.0}, 96);
    ASSERT_EQ(strip.columns.size(), 96u);
    EXPECT_EQ(strip.start, field.start());
    EXPECT_EQ(strip.end, field.end());
    double const step = (strip.end - strip.start) / 96.0;
    for (std::size_t i = 0; i < 96; ++i) {
        ui::StripColumn const& column = strip.columns[i];
        EXPECT_NEAR(column.time, strip.start + (static_cast<double>(i) + 0.5) * step, 1.0);
        for (double cover : {column.low, column.mid, column.high}) EXPECT_TRUE(cover >= 0.0 && cover <= 1.0) << cover;
    }
}

TEST(WeatherStrip, KeepsTheGustTheCloudburstAndTheThunderOfBaselThoughTheyAreShort) {
    ui::WeatherStrip const strip = ui::weatherStrip(bundled("basel_2023-06-21_23.json"), {0.0, 0.0}, 96);
    auto const burst = std::max_element(strip.columns.begin(), strip.columns.end(), [](auto const& a, auto const& b) { return a.rain < b.rain; });
    EXPECT_GT(burst->rain, 50.0);  // 109 mm/h over ten minutes
    EXPECT_TRUE(burst->thunder);
    EXPECT_TRUE(burst->storm);
    EXPECT_NEAR(burst->time, *core::parseUtc("2023-06-22T17:30Z"), 2400.0);
    EXPECT_GT(std::max_element(strip.columns.begin(), strip.columns.end(), [](auto const& a, auto const& b) { return a.gust < b.gust; })->gust, 18.0);
}

TEST(WeatherStrip, TellsNightFromDay) {
    for (ui::StripColumn const& column : ui::weatherStrip(bundled("basel_2023-06-21_23.json"), {0.0, 0.0}, 96).columns) {
        double const hour = std::fmod(column.time / 3600.0, 24.0);  // sunrise 3:30, sunset 19:30 UTC
        if (hour > 4.5 && hour < 18.5) { EXPECT_FALSE(column.night) << hour; }
        if (hour < 2.5 || hour > 20.5) { EXPECT_TRUE(column.night) << hour; }
    }
}

TEST(WeatherStrip, OffersTheFrontOfBaselAndTheThunderOfMelbourne) {
    ui::WeatherStrip const basel = ui::weatherStrip(bundled("basel_2023-06-21_23.json"), {0.0, 0.0}, 96);
    EXPECT_TRUE(std::any_of(basel.moments.begin(), basel.moments.end(), [](auto const& m) { return m.name == "front" && near(m, "2023-06-22T17:25Z", 15.0); }));
    ui::WeatherStrip const melbourne = ui::weatherStrip(bundled("melbourne_2024-01-16.json"), {0.0, 0.0}, 96);
    // It cools by 2.5 K within an hour there: no front by the rule, but its thunder and its gust are offered.
    EXPECT_TRUE(std::any_of(melbourne.moments.begin(), melbourne.moments.end(), [](auto const& m) { return m.name == "thunder" && near(m, "2024-01-16T20:30Z", 45.0); }));
    EXPECT_TRUE(std::any_of(melbourne.moments.begin(), melbourne.moments.end(), [](auto const& m) { return m.name.starts_with("gust") && near(m, "2024-01-16T22:15Z", 60.0); }));
    for (ui::WeatherStrip const* strip : {&basel, &melbourne}) {
        EXPECT_LE(strip->moments.size(), ui::kMostMoments);
        EXPECT_TRUE(std::is_sorted(strip->moments.begin(), strip->moments.end(), [](auto const& a, auto const& b) { return a.time < b.time; }));
    }
}

TEST(WeatherStrip, OfAPresetIsEmpty) { EXPECT_TRUE(ui::weatherStrip(weather::loadWeather("preset:storm"), {0.0, 0.0}, 96).columns.empty()); }
}  // namespace
