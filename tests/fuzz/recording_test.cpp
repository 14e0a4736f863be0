#include <gtest/gtest.h>

#include <fstream>
#include <random>
#include <sstream>

#include "engine/core/error.h"
#include "engine/weather/air.h"
#include "engine/weather/field.h"

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

TEST(FuzzRecording, FlippedBitsAreRefusedOrReadNeverACrash) {
    std::mt19937 random{1};
    for (std::string const name : {"basel_2023-06-21_23.json", "melbourne_2024-01-16.json"}) {
        std::string const text = sample(name, 4);
        int taken = 0;
        for (int i = 0; i < 4000; ++i) {
            std::string broken = text;
            for (auto n = 1 + random() % 3; n-- > 0;) broken[random() % broken.size()] ^= static_cast<char>(1u << (random() % 8));
            taken += takes(broken);
        }
        EXPECT_GT(taken, 100) << "a letter of a name, a digit of a figure";
        EXPECT_LT(taken, 3900);
    }
}

TEST(FuzzRecording, PiecesExchangedAreRefusedOrReadNeverACrash) {
    std::mt19937 random{2};
    std::string const text = sample("melbourne_2024-01-16.json", 4);
    char const* const pieces[] = {"null", "-1", "1e308", "\"\"", "[]", "{}", "true", "0", "1e-300", "\"2024-01-16T09:00Z\"", "999999"};
    int taken = 0, tried = 0;
    for (int i = 0; i < 3000; ++i) {
        std::string broken = text;
        std::size_t const from = random() % broken.size();
        std::size_t const colon = broken.find(':', from), end = broken.find_first_of(",}", colon);
        if (colon == broken.npos || end == broken.npos) continue;
        broken.replace(colon + 1, end - colon - 1, pieces[random() % std::size(pieces)]);
        taken += takes(broken);
        ++tried;
    }
    EXPECT_GT(taken, tried / 20) << "null is what nobody reported";
    EXPECT_LT(taken, tried * 19 / 20);
}

TEST(FuzzRecording, DeepNestingIsRefused) {
    EXPECT_FALSE(takes(std::string(200000, '[')));
    EXPECT_FALSE(takes("{\"format\":\"luftpost-weather-1\",\"name\":" + std::string(100000, '[') + std::string(100000, ']') + "}"));
}
