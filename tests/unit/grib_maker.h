// Makes small GRIB 2 messages, by WMO's templates: a regular grid, one product, simple packing in 16 bits, a bitmap where values
// are missing.
#pragma once
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <vector>

namespace luftpost::tests {
struct GribMaker {
    int centre = 7, discipline = 0, category = 0, number = 0;
    int surface = 103, secondSurface = 255;
    double level = 2.0, secondLevel = 0.0;
    int hour = 6;                // of validity, after the run of 2023-06-22T00Z
    int statistic = -1;          // table 4.10; an instant without
    int fromHour = 0;            // where a statistic's step begins
    int columns = 3, rows = 3;
    double lat0 = 48.0, lon0 = 7.0, latStep = -1.0, lonStep = 1.0;
    std::vector<std::optional<double>> values;  // rows x columns; one value stands for all

    std::string message() const;

private:
    static void put(std::string& text, std::uint64_t value, int octets) {
        for (int i = octets - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xFF);
    }
    static void putSigned(std::string& text, long long value, int octets) {
        std::uint64_t const sign = value < 0 ? std::uint64_t{1} << (8 * octets - 1) : 0;
        put(text, sign | static_cast<std::uint64_t>(std::llabs(value)), octets);
    }
    static std::string section(int number, std::string const& content) {
        std::string text;
        put(text, content.size() + 5, 4);
        put(text, static_cast<std::uint64_t>(number), 1);
        return text + content;
    }
    std::string identification() const {
        std::string text;
        put(text, static_cast<std::uint64_t>(centre), 2);
        put(text, 0, 2);
        for (int const value : {2, 1, 1}) put(text, static_cast<std::uint64_t>(value), 1);  // tables; the time is the forecast's start
        put(text, 2023, 2);
        for (int const value : {6, 22, 0, 0, 0, 0, 1}) put(text, static_cast<std::uint64_t>(value), 1);
        return section(1, text);
    }
    std::string grid() const {
        std::string text;
        put(text, 0, 1);
        put(text, static_cast<std::uint64_t>(columns * rows), 4);
        put(text, 0, 4);
        put(text, 6, 1);
        text += std::string(15, '\0');
        put(text, static_cast<std::uint64_t>(columns), 4);
        put(text, static_cast<std::uint64_t>(rows), 4);
        text += std::string(8, '\0');
        auto const micro = [](double degrees) { return std::llround(degrees * 1e6); };
        putSigned(text, micro(lat0), 4);
        putSigned(text, micro(lon0), 4);
        put(text, 48, 1);
        putSigned(text, micro(lat0 + latStep * (rows - 1)), 4);
        putSigned(text, micro(lon0 + lonStep * (columns - 1)), 4);
        put(text, static_cast<std::uint64_t>(micro(std::abs(lonStep))), 4);
        put(text, static_cast<std::uint64_t>(micro(std::abs(latStep))), 4);
        put(text, (lonStep < 0 ? 0x80u : 0u) | (latStep > 0 ? 0x40u : 0u), 1);
        return section(3, text);
    }
    void putSurface(std::string& text, int type, double value) const {
        put(text, static_cast<std::uint64_t>(type), 1);
        put(text, type == 255 ? 0xFF : 0, 1);
        if (type == 255) put(text, 0xFFFFFFFF, 4);
        else putSigned(text, std::llround(value), 4);
    }
    std::string product() const {
        std::string text;
        put(text, 0, 2);
        put(text, statistic < 0 ? 0 : 8, 2);
        put(text, static_cast<std::uint64_t>(category), 1);
        put(text, static_cast<std::uint64_t>(number), 1);
        text += std::string(6, '\0');
        put(text, 1, 1);
        putSigned(text, statistic < 0 ? hour : fromHour, 4);
        putSurface(text, surface, level);
        putSurface(text, secondSurface, secondLevel);
        if (statistic < 0) return section(4, text);
        put(text, 2023, 2);
        for (int const value : {6, 22 + hour / 24, hour % 24, 0, 0, 1}) put(text, static_cast<std::uint64_t>(value), 1);
        put(text, 0, 4);
        for (int const value : {statistic, 2, 1}) put(text, static_cast<std::uint64_t>(value), 1);
        put(text, static_cast<std::uint64_t>(hour - fromHour), 4);
        put(text, 1, 1);
        put(text, 0, 4);
        return section(4, text);
    }
};

inline std::string GribMaker::message() const {
    std::vector<std::optional<double>> all = values;
    if (all.size() == 1) all.assign(static_cast<std::size_t>(columns * rows), values[0]);
    std::vector<double> known;
    for (auto const& value : all)
        if (value) known.push_back(*value);
    double const low = known.empty() ? 0.0 : *std::min_element(known.begin(), known.end());
    double const high = known.empty() ? 0.0 : *std::max_element(known.begin(), known.end());
    // The reference value is a float; whole steps of 2^E from it.
    float const reference = static_cast<float>(std::floor(low));
    int scale = 0;
    while ((high - static_cast<double>(reference)) / std::exp2(scale) > 65535.0) ++scale;
    while (scale > -20 && (high - static_cast<double>(reference)) / std::exp2(scale - 1) <= 65535.0) --scale;
    std::string packing, data, bitmap;
    put(packing, known.size(), 4);
    put(packing, 0, 2);
    std::uint32_t bits = 0;
    std::memcpy(&bits, &reference, 4);
    put(packing, bits, 4);
    putSigned(packing, scale, 2);
    put(packing, 0, 2);
    put(packing, 16, 1);
    put(packing, 0, 1);
    bool const holes = known.size() < all.size();
    put(bitmap, holes ? 0 : 255, 1);
    if (holes) bitmap += std::string((all.size() + 7) / 8, '\0');
    for (std::size_t i = 0; i < all.size(); ++i) {
        if (!all[i]) continue;
        if (holes) bitmap[1 + i / 8] = static_cast<char>(static_cast<unsigned char>(bitmap[1 + i / 8]) | (0x80u >> (i % 8)));
        put(data, static_cast<std::uint64_t>(std::llround((*all[i] - static_cast<double>(reference)) / std::exp2(scale))), 2);
    }
    std::string const body = identification() + grid() + product() + section(5, packing) + section(6, bitmap) + section(7, data) + "7777";
    std::string head = "GRIB";
    put(head, 0, 2);
    put(head, static_cast<std::uint64_t>(discipline), 1);
    put(head, 2, 1);
    put(head, body.size() + 16, 8);
    return head + body;
}
}  // namespace luftpost::tests
