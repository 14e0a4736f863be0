#include "engine/weather/grib_packing.h"

#include <fmt/format.h>

#include <bit>
#include <cstdint>

namespace luftpost::weather {
namespace {
constexpr std::size_t kHead = 5;  // octets of a section's length and number
constexpr std::size_t kMostBits = 32;

std::size_t octets(std::size_t bits) { return (bits + 7) / 8; }

/// Numbers of a few bits each, one after the other.
class Bits {
public:
    Bits(std::string_view bytes, std::size_t each) : bytes_{bytes}, each_{each} {}
    std::size_t at(std::size_t i) const {
        std::size_t value = 0;
        for (std::size_t bit = i * each_; bit < (i + 1) * each_; ++bit)
            value = value << 1 | (static_cast<unsigned char>(bytes_[bit / 8]) >> (7 - bit % 8) & 1u);
        return value;
    }

private:
    std::string_view bytes_;
    std::size_t each_;
};

std::optional<std::string> simpleMisfit(std::string_view packing, std::string_view data, std::size_t values) {
    if (packing.size() < 21) return "expected a packing section of 21 octets";
    std::size_t const bits = gribNumber(packing, 20, 1);
    if (bits > kMostBits) return fmt::format("expected at most {} bits a value, found {}", kMostBits, bits);
    if (data.size() < kHead + octets(values * bits))
        return fmt::format("expected {} octets of data, found {}", octets(values * bits), data.size() - kHead);
    return std::nullopt;
}

/// The numbers of templates 5.2 and 5.3.
struct Groups {
    std::size_t count, referenceBits, widthReference, widthBits, lengthReference, lengthIncrement, lastLength, lengthBits, extra;
};

std::optional<std::string> groupsMisfit(Groups const& g, std::string_view data, std::size_t values) {
    if (g.referenceBits > kMostBits || g.widthBits > kMostBits || g.lengthBits > kMostBits) return "expected groups of at most 32 bits";
    if (g.count > values) return fmt::format("expected at most {} groups, found {}", values, g.count);
    std::size_t const references = kHead + g.extra, widths = references + octets(g.count * g.referenceBits),
                      lengths = widths + octets(g.count * g.widthBits), packed = lengths + octets(g.count * g.lengthBits);
    if (data.size() < packed) return fmt::format("expected {} octets of group heads, found {}", packed - kHead, data.size() - kHead);
    if (g.count == 0) return g.referenceBits == 0 ? std::nullopt : std::optional<std::string>{"expected groups of values"};
    Bits const width{data.substr(widths), g.widthBits}, length{data.substr(lengths), g.lengthBits};
    std::size_t sum = 0, bits = 0;
    for (std::size_t i = 0; i < g.count; ++i) {
        std::size_t const each = g.widthReference + width.at(i);
        std::size_t const count = i + 1 == g.count ? g.lastLength : g.lengthReference + g.lengthIncrement * length.at(i);
        if (each > kMostBits || count > values - sum) return fmt::format("expected group {} within {} bits and {} values", i, kMostBits, values);
        sum += count;
        bits += each * count;
    }
    if (sum != values) return fmt::format("expected groups of {} values together, found {}", values, sum);
    if (data.size() < packed + octets(bits))
        return fmt::format("expected {} octets of data, found {}", packed - kHead + octets(bits), data.size() - kHead);
    return std::nullopt;
}

std::optional<std::string> complexMisfit(std::string_view packing, std::string_view data, std::size_t values, bool differences) {
    if (packing.size() < (differences ? 49u : 47u)) return "expected a longer packing section";
    auto const at = [packing](std::size_t octet, std::size_t count) { return gribNumber(packing, octet, count); };
    if (at(23, 1) > 2) return fmt::format("expected missing values managed in way 0 to 2, found {}", at(23, 1));
    std::size_t extra = 0;
    if (differences) {
        std::size_t const order = at(48, 1), each = at(49, 1);
        if (order < 1 || order > 2 || each < 1 || each > 4 || order > values)
            return fmt::format("expected differences of order 1 or 2 in 1 to 4 octets, found {} in {}", order, each);
        extra = (order + 1) * each;
    }
    return groupsMisfit({at(32, 4), at(20, 1), at(36, 1), at(37, 1), at(38, 4), at(42, 1), at(43, 4), at(47, 1), extra}, data, values);
}

/// The picture's size in a JPEG 2000 codestream (SIZ comes first) must be that of the field.
std::optional<std::string> jpegMisfit(std::string_view packing, std::string_view data, std::size_t values) {
    if (packing.size() < 23) return "expected a packing section of 23 octets";
    if (gribNumber(packing, 20, 1) == 0) return std::nullopt;
    if (data.size() < kHead + 40 || data.substr(kHead, 4) != "\xff\x4f\xff\x51") return "expected a JPEG 2000 codestream";
    auto const at = [data](std::size_t octet) { return gribNumber(data, kHead + octet, 4); };  // octet 1 is the codestream's first
    std::size_t const right = at(9), bottom = at(13), left = at(17), top = at(21), tileWide = at(25), tileHigh = at(29);
    if (right <= left || bottom <= top || (right - left) * (bottom - top) != values || tileWide < right - left || tileHigh < bottom - top)
        return fmt::format("expected a picture of {} values in one tile", values);
    return std::nullopt;
}

std::optional<std::string> ccsdsMisfit(std::string_view packing) {
    if (packing.size() < 25) return "expected a packing section of 25 octets";
    if (gribNumber(packing, 20, 1) > kMostBits) return "expected at most 32 bits a value";
    std::size_t const block = gribNumber(packing, 23, 1), interval = gribNumber(packing, 24, 2);
    if ((block != 8 && block != 16 && block != 32 && block != 64) || interval < 1 || interval > 4096) return "expected blocks of 8 to 64 values";
    return std::nullopt;
}

/// How many points the bitmap keeps; nothing when it is too short.
std::optional<std::size_t> kept(std::string_view bitmap, std::size_t points) {
    if (gribNumber(bitmap, 6, 1) == 255) return points;
    if (bitmap.size() < 6 + octets(points)) return std::nullopt;
    std::size_t count = 0;
    for (std::size_t i = 0; i < points / 8; ++i) count += static_cast<std::size_t>(std::popcount(static_cast<unsigned char>(bitmap[6 + i])));
    for (std::size_t i = points / 8 * 8; i < points; ++i) count += Bits{bitmap.substr(6), 1}.at(i);
    return count;
}
}  // namespace

std::size_t gribNumber(std::string_view section, std::size_t octet, std::size_t count) {
    std::size_t value = 0;
    for (std::size_t i = 0; i < count; ++i) value = value << 8 | static_cast<unsigned char>(section[octet - 1 + i]);
    return value;
}

std::optional<std::string> gribMisfit(std::string_view packing, std::string_view bitmap, std::string_view data, std::size_t points) {
    if (packing.size() < 12 || bitmap.size() < 6) return "expected a packing section and a bitmap section";
    auto const values = kept(bitmap, points);
    if (!values) return fmt::format("expected a bitmap of {} points", points);
    if (gribNumber(packing, 6, 4) != *values) return fmt::format("expected {} values, found {}", *values, gribNumber(packing, 6, 4));
    switch (std::size_t const form = gribNumber(packing, 10, 2); form) {
        case 0: return simpleMisfit(packing, data, *values);
        case 2: return complexMisfit(packing, data, *values, false);
        case 3: return complexMisfit(packing, data, *values, true);
        case 40: return jpegMisfit(packing, data, *values);
        case 42: return ccsdsMisfit(packing);
        default: return fmt::format("expected data representation template 0, 2, 3, 40 or 42, found {}", form);
    }
}
}  // namespace luftpost::weather
