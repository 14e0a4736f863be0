#include "engine/weather/grib_sections.h"

#include <fmt/format.h>

#include <array>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/grib_packing.h"

namespace luftpost::weather {
namespace {
constexpr std::size_t kMostPoints = 8'000'000;  // a global grid of 0.1 degrees has 6.5 million
constexpr std::size_t kMostFields = 20'000;
constexpr double kMicro = 1e-6;  // degrees

/// Where one is in the file, for messages.
struct Where {
    std::string const& file;
    std::string place;
    [[noreturn]] void fail(std::string const& expected) const { throw core::Error(file, place, expected); }
};

/// A number with its sign in the first bit, as GRIB has them.
double signedNumber(std::string_view section, std::size_t octet, std::size_t count) {
    std::size_t const raw = gribNumber(section, octet, count), sign = std::size_t{1} << (8 * count - 1);
    return raw & sign ? -static_cast<double>(raw - sign) : static_cast<double>(raw);
}

core::UtcSeconds timeAt(Where const& where, std::string_view section, std::size_t octet) {
    auto const at = [&](std::size_t i, std::size_t count) { return gribNumber(section, octet + i, count); };
    std::string const text = fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}:{:02}Z", at(0, 2), at(2, 1), at(3, 1), at(4, 1), at(5, 1), at(6, 1));
    auto const time = core::parseUtc(text);
    if (!time || at(0, 2) < 1900 || at(0, 2) > 2100) where.fail(fmt::format("expected a date from 1900 to 2100, found {}", text));
    return *time;
}

/// Table 4.4: seconds of a unit of time.
std::optional<double> secondsOf(std::size_t unit) {
    switch (unit) {
        case 0: return 60.0;
        case 1: return 3600.0;
        case 2: return 86400.0;
        case 10: return 3.0 * 3600.0;
        case 11: return 6.0 * 3600.0;
        case 12: return 12.0 * 3600.0;
        case 13: return 1.0;
        default: return std::nullopt;
    }
}

GribSurface surfaceAt(std::string_view section, std::size_t octet) {
    GribSurface surface{static_cast<int>(gribNumber(section, octet, 1)), 0.0};
    if (gribNumber(section, octet + 2, 4) == 0xFFFFFFFFu) return surface;
    double value = signedNumber(section, octet + 2, 4);
    double scale = std::min(std::abs(signedNumber(section, octet + 1, 1)), 20.0);
    bool const down = signedNumber(section, octet + 1, 1) > 0.0;
    for (; scale > 0.0; scale -= 1.0) value = down ? value / 10.0 : value * 10.0;
    surface.value = value;
    return surface;
}

/// Section 4. False for a product that is not of a moment or a step (templates 0, 1, 8, 11).
bool readProduct(Where const& where, std::string_view section, GribField& field) {
    if (section.size() < 9) where.fail("expected a product section of 9 octets");
    std::size_t const form = gribNumber(section, 8, 2);
    if (form != 0 && form != 1 && form != 8 && form != 11) return false;
    bool const step = form == 8 || form == 11;
    std::size_t const end = form == 11 ? 38 : 35;
    if (section.size() < (step ? end + 12 : 34)) where.fail("expected a longer product section");
    field.category = static_cast<int>(gribNumber(section, 10, 1));
    field.number = static_cast<int>(gribNumber(section, 11, 1));
    auto const unit = secondsOf(gribNumber(section, 18, 1));
    double const ahead = signedNumber(section, 19, 4);
    if (!unit || std::abs(ahead * *unit) > 400.0 * 86400.0) return false;
    field.from = field.time = field.reference + ahead * *unit;
    field.first = surfaceAt(section, 23);
    field.second = surfaceAt(section, 29);
    field.statistic = GribStatistic::Instant;
    if (!step) return true;
    field.time = timeAt(where, section, end);
    std::size_t const process = gribNumber(section, end + 12, 1);
    field.statistic = process <= 3 ? static_cast<GribStatistic>(process) : GribStatistic::Other;
    if (gribNumber(section, end + 7, 1) != 1) field.statistic = GribStatistic::Other;
    if (field.time <= field.from && field.statistic == GribStatistic::Mean) field.statistic = GribStatistic::Instant;
    return true;
}

GribGrid readGrid(Where const& where, std::string_view section) {
    if (section.size() < 14) where.fail("expected a grid section of 14 octets");
    std::size_t const form = gribNumber(section, 13, 2), points = gribNumber(section, 7, 4);
    if (form != 0 || gribNumber(section, 6, 1) != 0 || gribNumber(section, 11, 1) != 0)
        where.fail(fmt::format("expected a regular grid of latitudes and longitudes (template 0), found template {}", form));
    if (section.size() < 72) where.fail("expected a grid section of 72 octets");
    GribGrid grid{gribNumber(section, 31, 4),
                  gribNumber(section, 35, 4),
                  signedNumber(section, 47, 4) * kMicro,
                  signedNumber(section, 51, 4) * kMicro,
                  0,
                  0,
                  false};
    if (grid.columns == 0 || grid.rows == 0 || points > kMostPoints || grid.columns > kMostPoints || grid.rows > kMostPoints ||
        grid.points() != points)
        where.fail(fmt::format("expected a grid of 1 to {} points, found {} x {}", kMostPoints, grid.columns, grid.rows));
    std::size_t const angle = gribNumber(section, 39, 4), scan = gribNumber(section, 72, 1);
    if (angle != 0 && angle != 0xFFFFFFFFu) where.fail("expected angles in millionths of a degree");
    if (scan & 0x3Fu) where.fail("expected rows along the longitudes, one after the other");
    double const lat1 = signedNumber(section, 56, 4) * kMicro, lon1 = signedNumber(section, 60, 4) * kMicro;
    double span = (scan & 0x80u ? -1.0 : 1.0) * (lon1 - grid.lon0);  // the way the columns go
    span -= 360.0 * std::floor(span / 360.0);
    if (!(std::abs(grid.lat0) <= 90.0 && std::abs(lat1) <= 90.0 && std::abs(grid.lon0) <= 360.0 && std::abs(lon1) <= 360.0))
        where.fail("expected latitudes within 90 and longitudes within 360 degrees");
    if (grid.rows > 1) grid.latStep = (lat1 - grid.lat0) / static_cast<double>(grid.rows - 1);
    if (grid.columns > 1) grid.lonStep = (scan & 0x80u ? -1.0 : 1.0) * span / static_cast<double>(grid.columns - 1);
    if ((grid.rows > 1 && std::abs(grid.latStep) < kMicro) || (grid.columns > 1 && std::abs(grid.lonStep) < kMicro))
        where.fail("expected a grid with some extent");
    grid.around = std::abs(std::abs(grid.lonStep) * static_cast<double>(grid.columns) - 360.0) < 0.5 * std::abs(grid.lonStep);
    return grid;
}

/// One message: its sections 1 to 7 as they stand while one walks through it, each with its head.
struct Message {
    Where where;
    std::string_view bytes;
    std::array<std::string_view, 8> sections{};
    std::string_view lastBitmap;  // that carries its own bits

    std::string alone() const;
};

void appendNumber(std::string& text, std::size_t value, int count) {
    for (int i = count - 1; i >= 0; --i) text += static_cast<char>(value >> (8 * i) & 0xFFu);
}

/// The field's sections as a message of its own.
std::string Message::alone() const {
    std::size_t size = 16 + 4;
    for (std::size_t i = 1; i < 8; ++i)
        size += i == 6 && !lastBitmap.empty() && gribNumber(sections[6], 6, 1) == 254 ? lastBitmap.size() : sections[i].size();
    std::string text{bytes.substr(0, 8)};
    appendNumber(text, size, 8);
    for (std::size_t i = 1; i < 8; ++i) text += i == 6 && gribNumber(sections[6], 6, 1) == 254 ? lastBitmap : sections[i];
    return text + "7777";
}

/// What section 7 completes.
void takeField(Message const& message, std::function<bool(GribField const&)> const& wanted, std::function<void(GribField const&)> const& take) {
    Where const& where = message.where;
    for (std::size_t const i : {1u, 3u, 4u, 5u, 6u})
        if (message.sections[i].empty()) where.fail(fmt::format("expected section {} before the data", i));
    if (message.sections[1].size() < 21) where.fail("expected an identification section of 21 octets");
    GribField field;
    field.place = where.place;
    field.discipline = static_cast<int>(gribNumber(message.bytes, 7, 1));
    field.centre = static_cast<int>(gribNumber(message.sections[1], 6, 2));
    field.reference = timeAt(where, message.sections[1], 13);
    if (!readProduct(where, message.sections[4], field) || !wanted(field)) return;
    field.grid = readGrid(where, message.sections[3]);
    if (message.sections[6].size() < 6) where.fail("expected a bitmap section of 6 octets");
    std::size_t const indicator = gribNumber(message.sections[6], 6, 1);
    if (indicator != 0 && indicator != 255 && (indicator != 254 || message.lastBitmap.empty()))
        where.fail("expected a bitmap of the message's own or none");
    auto const misfit =
        gribMisfit(message.sections[5], indicator == 254 ? message.lastBitmap : message.sections[6], message.sections[7], field.grid.points());
    if (misfit) where.fail(*misfit);
    field.message = message.alone();
    take(field);
}

/// Sections from octet 17 on, to the closing "7777".
std::size_t walkSections(Message& message, std::function<bool(GribField const&)> const& wanted, std::function<void(GribField const&)> const& take) {
    Where const& where = message.where;
    std::size_t at = 16, fields = 0;
    while (at + 4 != message.bytes.size()) {
        if (at + 5 > message.bytes.size()) where.fail("expected sections that fill the message");
        std::string_view const rest = message.bytes.substr(at);
        std::size_t const length = gribNumber(rest, 1, 4), number = gribNumber(rest, 5, 1);
        if (length < 5 || length > rest.size() - 4 || number < 1 || number > 7)
            where.fail(fmt::format("expected section 1 to 7 within the message, found number {} of {} octets at octet {}", number, length, at + 1));
        message.sections[number] = rest.substr(0, length);
        if (number == 6 && length >= 6 && gribNumber(rest, 6, 1) == 0) message.lastBitmap = message.sections[6];
        if (number == 7) {
            takeField(message, wanted, take);
            ++fields;
        }
        at += length;
    }
    if (message.bytes.substr(at) != "7777") where.fail("expected \"7777\" at the end of the message");
    return fields;
}
}  // namespace

std::optional<GribGrid::Spot> GribGrid::spotOf(double lat_deg, double lon_deg) const {
    constexpr double kSlack = 1e-6;  // of a step: a place on the edge lies within
    double row = rows > 1 ? (lat_deg - lat0) / latStep : 0.0;
    if (rows == 1 && std::abs(lat_deg - lat0) > 1e-6) return std::nullopt;
    double east = lonStep < 0.0 ? lon0 - lon_deg : lon_deg - lon0;  // the way the columns go
    east -= 360.0 * std::floor(east / 360.0);
    if (east > 360.0 - 1e-9) east = 0.0;
    double column = columns > 1 ? east / std::abs(lonStep) : 0.0;
    if (columns == 1 && east > 1e-6) return std::nullopt;
    double const lastColumn = static_cast<double>(columns) - (around ? 0.0 : 1.0), lastRow = static_cast<double>(rows - 1);
    if (row < -kSlack || row > lastRow + kSlack || column > lastColumn + kSlack) return std::nullopt;
    row = std::min(std::max(row, 0.0), lastRow);
    column = std::min(column, lastColumn);
    return Spot{column, row};
}

double GribGrid::lonOf(std::size_t column) const {
    double const lon = lon0 + lonStep * static_cast<double>(column);
    return lon - 360.0 * std::floor((lon + 180.0) / 360.0);
}

void forEachGribField(std::string_view bytes, std::string const& file, std::function<bool(GribField const&)> const& wanted,
                      std::function<void(GribField const&)> const& take) {
    std::size_t at = 0, fields = 0;
    for (std::size_t count = 1; at < bytes.size(); ++count) {
        Where const where{file, fmt::format("message {} at byte {}", count, at)};
        std::string_view const rest = bytes.substr(at);
        if (rest.size() < 16 || !rest.starts_with("GRIB")) where.fail("expected \"GRIB\" and the length of a message");
        if (gribNumber(rest, 8, 1) != 2) where.fail(fmt::format("expected GRIB edition 2, found {}", gribNumber(rest, 8, 1)));
        if (gribNumber(rest, 9, 4) != 0) where.fail("expected a message of less than 4 GiB");
        std::size_t const length = gribNumber(rest, 13, 4);
        if (length < 20 || length > rest.size()) where.fail(fmt::format("expected a message of {} octets, found {}", length, rest.size()));
        Message message{where, rest.substr(0, length), {}, {}};
        fields += walkSections(message, wanted, take);
        if (fields > kMostFields) where.fail(fmt::format("expected at most {} fields", kMostFields));
        at += length;
    }
}
}  // namespace luftpost::weather
