#include <gtest/gtest.h>

#include <fstream>
#include <sstream>

#include "engine/core/error.h"
#include "engine/weather/air.h"
#include "engine/weather/field.h"
#include "tests/fuzz/mutator.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
/// The head and the first reports of a bundled recording: small enough to be broken thousands of times.
std::string sample(std::string const& name, int reports) {
    std::ifstream file{std::string{LUFTPOST_SOURCE_DIR} + "/assets/weather/" + name};
    std::string text, line;
    for (int i = 0; i < reports + 2 && std::getline(file, line); ++i) text += line + "\n";
    text.erase(text.find_last_of(','));
    return text + "]}]}";
}

/// Parses the bytes and says whether they were taken; then they must also carry a field whose answers are numbers.
bool takes(std::string const& bytes) {
    try {
        Recording recording = parseRecording(bytes, "fuzz");
        Field const field = fieldFrom(std::move(recording), {}, {});
        Weather const weather = field.at(100.0, 200.0, 0.5 * (field.start() + field.end()));
        EXPECT_TRUE(std::isfinite(weather.temperature) && std::isfinite(weather.visibility) && std::isfinite(weather.windSurface.x));
        for (std::size_t i = 0; i < static_cast<std::size_t>(weather.layerCount); ++i) {
            EXPECT_TRUE(weather.layers[i].cover >= 0.0f && weather.layers[i].cover <= 1.0f);
            EXPECT_GT(weather.layers[i].top, weather.layers[i].base);
        }
        Air const air{field, [](double, double) { return core::GroundSample{}; }, 1};
        EXPECT_TRUE(std::isfinite(air.at({0.0, 500.0, 0.0}, field.start()).density));
        return true;
    } catch (core::Error const& error) {
        EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos);
        return false;
    }
}
}  // namespace

TEST(FuzzRecording, TruncatedAnywhereItIsRefusedOrReadNeverACrash) {
    std::string const text = sample("basel_2023-06-21_23.json", 3);
    std::size_t taken = 0;
    for (std::size_t length = 0; length < text.size(); ++length) taken += takes(text.substr(0, length));
    EXPECT_TRUE(takes(text));
    EXPECT_LE(taken, 1u) << "all but the last line's end is needed";
}

TEST(FuzzRecording, MutantsAreRefusedOrReadNeverACrash) {
    std::vector<std::string> const samples{sample("basel_2023-06-21_23.json", 4), sample("melbourne_2024-01-16.json", 4)};
    std::vector<std::string> const pieces{"null", "-1", "1e308", "\"\"", "[]", "{}", "true", "0", "1e-300", "\"2024-01-16T09:00Z\"", "999999", ",", "}"};
    for (std::string const& whole : samples) EXPECT_TRUE(takes(whole));
    test::expectBoth(test::fuzz({samples, pieces}, takes), 0.02);
}

TEST(FuzzRecording, DeepNestingIsRefused) {
    EXPECT_FALSE(takes(std::string(200000, '[')));
    EXPECT_FALSE(takes("{\"format\":\"luftpost-weather-1\",\"name\":" + std::string(100000, '[') + std::string(100000, ']') + "}"));
}
