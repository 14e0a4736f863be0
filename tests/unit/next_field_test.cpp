// The field that takes over from another: at the change nothing jumps, soon after it is the new weather.
#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/air.h"
#include "engine/weather/presets.h"
#include "engine/weather/source.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
std::string const kBasel = std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/basel_2023-06-21_23.json";
core::UtcSeconds const kChange = *core::parseUtc("2023-06-22T16:13:20Z");
constexpr PlaceWish kPlace{47.541, 7.584, 316.0};

Origin const kByHand{SourceMode::Preset, "by hand", "Luftpost", "", "", 0.0};

Field changed(Field const& before, std::string_view preset, double seconds = 300.0) {
    return nextField(before, *presetRecording(preset, kPlace), kByHand, kChange, seconds);
}

struct Cover {
    double total = 0.0;
    glm::dvec2 drift{0.0};
    double phase = 0.0;
    unsigned pattern = 0;
};
/// The layer of the most cover.
Cover mainLayer(Weather const& w) {
    Cover best;
    for (int i = 0; i < w.layerCount; ++i) {
        Layer const& layer = w.layers[static_cast<std::size_t>(i)];
        if (static_cast<double>(layer.cover) > best.total) best = {static_cast<double>(layer.cover), layer.drift, layer.phase, layer.pattern};
    }
    return best;
}
}  // namespace

TEST(NextField, IsAtTheChangeWhatTheOneBeforeWas) {
    Field const before = loadWeather(kBasel);
    for (std::string_view const preset : {"calm", "fair", "overcast", "storm"}) {
        Field const next = changed(before, preset);
        Weather const a = before.at(0.0, 0.0, kChange), b = next.at(0.0, 0.0, kChange);
        EXPECT_NEAR(a.temperature, b.temperature, 1e-6);
        EXPECT_NEAR(a.dewPoint, b.dewPoint, 1e-6);
        EXPECT_NEAR(a.pressureSea, b.pressureSea, 1e-3);
        EXPECT_NEAR(a.gust, b.gust, 1e-9);
        EXPECT_NEAR(a.visibility / b.visibility, 1.0, 1e-9);
        EXPECT_NEAR(a.precipitationRate, b.precipitationRate, 1e-6);
        EXPECT_NEAR(glm::length(a.windSurface - b.windSurface), 0.0, 1e-9);
        ASSERT_EQ(a.layerCount, b.layerCount);
        for (std::size_t i = 0; i < static_cast<std::size_t>(a.layerCount); ++i) {
            EXPECT_EQ(a.layers[i].pattern, b.layers[i].pattern) << "the same clouds";
            EXPECT_NEAR(a.layers[i].cover, b.layers[i].cover, 0.005);
            EXPECT_NEAR(a.layers[i].base, b.layers[i].base, 0.1);
            EXPECT_NEAR(glm::length(a.layers[i].drift - b.layers[i].drift), 0.0, 1e-6);
            EXPECT_NEAR(a.layers[i].phase, b.layers[i].phase, 1e-9);
        }
        EXPECT_NEAR(glm::length(before.boundaryDrift(kChange) - next.boundaryDrift(kChange)), 0.0, 1e-6);
        for (double const altitude : {330.0, 420.0, 800.0, 1500.0, 3000.0, 6000.0, 9000.0, 13000.0})
            EXPECT_NEAR(glm::length(before.windAt(0, 0, altitude, 316.0, kChange) - next.windAt(0, 0, altitude, 316.0, kChange)), 0.0, 0.15) << altitude;
    }
}

TEST(NextField, IsSoonWhatTheRecordingSays) {
    Field const before = loadWeather(kBasel);
    Field const storm = loadWeather("preset:storm"), next = changed(before, "storm");
    Weather const a = storm.at(0.0, 0.0, kChange), b = next.at(0.0, 0.0, kChange + 700.0);
    EXPECT_NEAR(a.temperature, b.temperature, 1e-6);
    EXPECT_NEAR(a.precipitationRate, b.precipitationRate, 1e-6);
    EXPECT_EQ(b.precipitation, Precipitation::Rain);
    EXPECT_TRUE(b.thunder);
    EXPECT_NEAR(glm::length(a.windSurface - b.windSurface), 0.0, 1e-9);
    ASSERT_EQ(a.layerCount, b.layerCount);
    for (std::size_t i = 0; i < static_cast<std::size_t>(a.layerCount); ++i) {
        EXPECT_EQ(a.layers[i].genus, b.layers[i].genus);
        EXPECT_NEAR(a.layers[i].cover, b.layers[i].cover, 1e-3);
    }
}

TEST(NextField, GoesOverWithoutAJump) {
    Field const before = loadWeather(kBasel);
    for (std::string_view const preset : {"calm", "storm"}) {
        Field const next = changed(before, preset);
        Weather last = before.at(0.0, 0.0, kChange);
        Cover layer = mainLayer(last);
        for (double t = kChange; t < kChange + 800.0; t += 1.0) {
            Weather const now = next.at(0.0, 0.0, t);
            EXPECT_LT(std::abs(now.temperature - last.temperature), 0.2);
            EXPECT_LT(glm::length(now.windSurface - last.windSurface), 0.2);
            EXPECT_LT(std::abs(now.precipitationRate - last.precipitationRate), 0.3);
            EXPECT_TRUE(now.precipitationRate <= 0.0 || now.precipitation != Precipitation::None);
            EXPECT_TRUE(mainLayer(now).pattern != layer.pattern || glm::length(mainLayer(now).drift - layer.drift) < 40.0);
            layer = mainLayer(now);
            last = now;
        }
    }
}

TEST(NextField, OfAFieldThatTookOverGoesOn) {
    Field const first = loadWeather(kBasel);
    Field const second = changed(first, "storm", 2.0), third = nextField(second, *presetRecording("fair", kPlace), kByHand, kChange + 3.0, 2.0);
    Weather const a = second.at(0.0, 0.0, kChange + 3.0), b = third.at(0.0, 0.0, kChange + 3.0);
    EXPECT_NEAR(a.temperature, b.temperature, 1e-6);
    ASSERT_EQ(a.layerCount, b.layerCount);
    for (std::size_t i = 0; i < static_cast<std::size_t>(a.layerCount); ++i) {
        EXPECT_EQ(a.layers[i].pattern, b.layers[i].pattern);
        EXPECT_NEAR(glm::length(a.layers[i].drift - b.layers[i].drift), 0.0, 1e-6);
    }
    EXPECT_EQ(third.start(), first.start()) << "ages count on";
    EXPECT_EQ(mainLayer(third.at(0.0, 0.0, kChange + 60.0)).total > 0.3, true);
}
