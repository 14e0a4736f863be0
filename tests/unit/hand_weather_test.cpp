// Weather by hand: the controls take over the present weather, nothing impossible is set, and the field is what was set.
#include "game/ui/hand_weather.h"

#include <gtest/gtest.h>

#include <limits>

#include "engine/weather/field.h"
#include "engine/weather/genera.h"
#include "engine/weather/source.h"

namespace {
using namespace luftpost;
using ui::HandWeather;

core::Place const kPlace{47.5, 7.5, 300.0};
constexpr double kTime = 1687545600.0;

weather::Field fieldOf(HandWeather const& hand) {
    weather::Recording recording = weather::parseRecording(weather::recordingText(ui::handRecording(hand, kPlace, kTime)), "hand");
    return weather::fieldFrom(std::move(recording), {}, weather::PlaceWish{kPlace.lat_deg, kPlace.lon_deg, kPlace.altitude_m});
}

HandWeather stormy() {
    HandWeather hand;
    hand.from_deg = 240.0, hand.speed_mps = 9.0, hand.gust_mps = 18.0;
    hand.visibility_km = 4.0, hand.kind = weather::Precipitation::Snow, hand.rate_mm_h = 1.5;
    hand.thunder = true, hand.temperature_c = -2.0, hand.dewPoint_c = -3.0, hand.pressure_hpa = 998.0;
    hand.layers = {{weather::Genus::Sc, 6.0, 900.0, 1400.0}, {weather::Genus::Ci, 2.0, 8000.0, 9000.0}};
    return hand;
}

TEST(HandWeather, IsWhatTheFieldSaysAfterwards) {
    HandWeather const hand = stormy();
    weather::Weather const weather = fieldOf(hand).at(0.0, 0.0, kTime);
    HandWeather const again = ui::handFrom(weather);
    EXPECT_NEAR(again.from_deg, hand.from_deg, 0.1);
    EXPECT_NEAR(again.speed_mps, hand.speed_mps, 0.01);
    EXPECT_NEAR(again.gust_mps, hand.gust_mps, 0.01);
    EXPECT_NEAR(again.visibility_km, hand.visibility_km, 0.01);
    EXPECT_EQ(again.kind, hand.kind);
    EXPECT_NEAR(again.rate_mm_h, hand.rate_mm_h, 0.01);
    EXPECT_TRUE(again.thunder);
    EXPECT_NEAR(again.temperature_c, hand.temperature_c, 0.01);
    EXPECT_NEAR(again.dewPoint_c, hand.dewPoint_c, 0.01);
    EXPECT_NEAR(again.pressure_hpa, hand.pressure_hpa, 0.01);
    ASSERT_EQ(again.layers.size(), 2u);
    for (std::size_t i = 0; i < 2; ++i) {
        EXPECT_EQ(again.layers[i].genus, hand.layers[i].genus);
        EXPECT_NEAR(again.layers[i].eighths, hand.layers[i].eighths, 0.02);
        EXPECT_NEAR(again.layers[i].base_m, hand.layers[i].base_m, 0.5);
        EXPECT_NEAR(again.layers[i].top_m, hand.layers[i].top_m, 0.5);
    }
}

TEST(HandWeather, StartsFromEveryPreset) {
    for (char const* name : {"preset:calm", "preset:clear", "preset:fair", "preset:broken", "preset:overcast", "preset:storm"}) {
        weather::Field const field = weather::loadWeather(name, weather::PlaceWish{kPlace.lat_deg, kPlace.lon_deg, kPlace.altitude_m});
        HandWeather const hand = ui::handFrom(field.at(0.0, 0.0, kTime));
        weather::Weather const before = field.at(0.0, 0.0, kTime), after = fieldOf(hand).at(0.0, 0.0, kTime);
        ASSERT_EQ(after.layerCount, before.layerCount) << name;
        for (int i = 0; i < before.layerCount; ++i) {
            auto const k = static_cast<std::size_t>(i);
            EXPECT_EQ(after.layers[k].genus, before.layers[k].genus) << name;
            EXPECT_NEAR(after.layers[k].cover, before.layers[k].cover, 0.002f) << name;
        }
        EXPECT_NEAR(glm::length(after.windSurface - before.windSurface), 0.0, 0.01) << name;
        EXPECT_NEAR(after.cape, before.cape, 1.0) << name;
    }
}

TEST(HandWeather, CannotBeImpossible) {
    HandWeather hand = stormy();
    hand.gust_mps = 2.0, hand.dewPoint_c = 9.0, hand.kind = weather::Precipitation::None;
    hand.layers[0].top_m = 100.0, hand.layers[1].eighths = 12.0;
    hand.visibility_km = 0.0, hand.temperature_c = std::numeric_limits<double>::quiet_NaN();
    hand.layers.resize(9);
    ui::tidy(hand);
    EXPECT_EQ(hand.gust_mps, hand.speed_mps);
    EXPECT_LE(hand.dewPoint_c, hand.temperature_c);
    EXPECT_EQ(hand.rate_mm_h, 0.0);
    EXPECT_EQ(hand.layers.size(), static_cast<std::size_t>(weather::kMaxLayers));
    EXPECT_GE(hand.layers[0].top_m, hand.layers[0].base_m + ui::kHandThinnest_m);
    EXPECT_EQ(hand.layers[1].eighths, 8.0);
    EXPECT_GT(hand.visibility_km, 0.0);
    EXPECT_NO_THROW(fieldOf(hand));
}

TEST(HandWeather, AddsAGenusThatIsNotThereYetAndCountsHeightsFromTheGround) {
    HandWeather hand;
    for (int i = 0; i < weather::kMaxLayers; ++i) hand.layers.push_back(ui::anotherLayer(hand, 500.0));
    for (std::size_t i = 0; i < hand.layers.size(); ++i) {
        for (std::size_t k = 0; k < i; ++k) EXPECT_NE(hand.layers[i].genus, hand.layers[k].genus);
        EXPECT_NEAR(hand.layers[i].base_m, 500.0 + weather::genusRow(hand.layers[i].genus).base, 0.1);
    }
}
}  // namespace
