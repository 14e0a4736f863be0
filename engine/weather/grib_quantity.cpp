#include "engine/weather/grib_quantity.h"

#include <algorithm>
#include <array>

namespace luftpost::weather {
namespace {
constexpr int kNcep = 7;
constexpr int kGround = 1, kIsothermZero = 4, kPressure = 100, kSea = 101, kAboveSea = 102, kAboveGround = 103, kWhole = 10, kWholeLayer = 200;
constexpr int kAny = -1;

enum class Kind { Instant, Mean, Sum, Maximum };

struct Row {
    int category, number, surface;
    double height;  // m, of a surface above ground; else 0
    Kind kind;
    GribQuantity quantity;
};

/// Discipline 0 (meteorology), tables 4.2-0-*; numbers from 192 on are NCEP's own.
constexpr std::array kRows{
    Row{0, 0, kAboveGround, 2, Kind::Instant, GribQuantity::Temperature},
    Row{0, 6, kAboveGround, 2, Kind::Instant, GribQuantity::DewPoint},
    Row{1, 1, kAboveGround, 2, Kind::Instant, GribQuantity::Humidity},
    Row{2, 2, kAboveGround, 10, Kind::Instant, GribQuantity::EastWind},
    Row{2, 3, kAboveGround, 10, Kind::Instant, GribQuantity::NorthWind},
    Row{2, 22, kGround, 0, Kind::Instant, GribQuantity::Gust},
    Row{2, 22, kGround, 0, Kind::Maximum, GribQuantity::Gust},
    Row{2, 22, kAboveGround, 10, Kind::Instant, GribQuantity::Gust},
    Row{2, 22, kAboveGround, 10, Kind::Maximum, GribQuantity::Gust},
    Row{3, 1, kSea, 0, Kind::Instant, GribQuantity::SeaPressure},
    Row{3, 0, kGround, 0, Kind::Instant, GribQuantity::StationPressure},
    Row{6, 1, kWhole, 0, Kind::Instant, GribQuantity::CoverTotal},
    Row{6, 1, kWhole, 0, Kind::Mean, GribQuantity::CoverTotal},
    Row{6, 1, kWholeLayer, 0, Kind::Instant, GribQuantity::CoverTotal},
    Row{6, 1, kWholeLayer, 0, Kind::Mean, GribQuantity::CoverTotal},
    Row{6, 1, kGround, 0, Kind::Instant, GribQuantity::CoverTotal},
    Row{6, 1, 214, 0, Kind::Instant, GribQuantity::CoverLow},
    Row{6, 1, 214, 0, Kind::Mean, GribQuantity::CoverLow},
    Row{6, 1, 224, 0, Kind::Instant, GribQuantity::CoverMid},
    Row{6, 1, 224, 0, Kind::Mean, GribQuantity::CoverMid},
    Row{6, 1, 234, 0, Kind::Instant, GribQuantity::CoverHigh},
    Row{6, 1, 234, 0, Kind::Mean, GribQuantity::CoverHigh},
    Row{6, 3, kAny, 0, Kind::Instant, GribQuantity::CoverLow},
    Row{6, 3, kAny, 0, Kind::Mean, GribQuantity::CoverLow},
    Row{6, 4, kAny, 0, Kind::Instant, GribQuantity::CoverMid},
    Row{6, 4, kAny, 0, Kind::Mean, GribQuantity::CoverMid},
    Row{6, 5, kAny, 0, Kind::Instant, GribQuantity::CoverHigh},
    Row{6, 5, kAny, 0, Kind::Mean, GribQuantity::CoverHigh},
    Row{3, 0, 212, 0, Kind::Mean, GribQuantity::BaseLow},
    Row{3, 0, 222, 0, Kind::Mean, GribQuantity::BaseMid},
    Row{3, 0, 232, 0, Kind::Mean, GribQuantity::BaseHigh},
    Row{3, 0, 213, 0, Kind::Mean, GribQuantity::TopLow},
    Row{3, 0, 223, 0, Kind::Mean, GribQuantity::TopMid},
    Row{3, 0, 233, 0, Kind::Mean, GribQuantity::TopHigh},
    Row{3, 0, 212, 0, Kind::Instant, GribQuantity::BaseLow},
    Row{3, 0, 222, 0, Kind::Instant, GribQuantity::BaseMid},
    Row{3, 0, 232, 0, Kind::Instant, GribQuantity::BaseHigh},
    Row{3, 0, 213, 0, Kind::Instant, GribQuantity::TopLow},
    Row{3, 0, 223, 0, Kind::Instant, GribQuantity::TopMid},
    Row{3, 0, 233, 0, Kind::Instant, GribQuantity::TopHigh},
    Row{19, 0, kGround, 0, Kind::Instant, GribQuantity::Visibility},
    Row{7, 6, kGround, 0, Kind::Instant, GribQuantity::Cape},
    Row{3, 5, kIsothermZero, 0, Kind::Instant, GribQuantity::FreezingLevel},
    Row{3, 6, kIsothermZero, 0, Kind::Instant, GribQuantity::FreezingLevel},
    Row{1, 11, kGround, 0, Kind::Instant, GribQuantity::SnowDepth},
    Row{3, 5, kGround, 0, Kind::Instant, GribQuantity::Elevation},
    Row{3, 6, kGround, 0, Kind::Instant, GribQuantity::Elevation},
    Row{1, 7, kGround, 0, Kind::Instant, GribQuantity::Rate},
    Row{1, 7, kGround, 0, Kind::Mean, GribQuantity::Rate},
    Row{1, 52, kGround, 0, Kind::Mean, GribQuantity::Rate},
    Row{1, 8, kGround, 0, Kind::Sum, GribQuantity::Water},
    Row{1, 52, kGround, 0, Kind::Sum, GribQuantity::Water},
    Row{1, 33, kGround, 0, Kind::Mean, GribQuantity::Rain},
    Row{1, 34, kGround, 0, Kind::Mean, GribQuantity::FreezingRain},
    Row{1, 35, kGround, 0, Kind::Mean, GribQuantity::IcePellets},
    Row{1, 36, kGround, 0, Kind::Mean, GribQuantity::Snow},
    Row{1, 192, kGround, 0, Kind::Mean, GribQuantity::Rain},
    Row{1, 193, kGround, 0, Kind::Mean, GribQuantity::FreezingRain},
    Row{1, 194, kGround, 0, Kind::Mean, GribQuantity::IcePellets},
    Row{1, 195, kGround, 0, Kind::Mean, GribQuantity::Snow},
    Row{4, 7, kGround, 0, Kind::Mean, GribQuantity::Radiation},
    Row{4, 192, kGround, 0, Kind::Mean, GribQuantity::Radiation},
    Row{5, 3, kGround, 0, Kind::Mean, GribQuantity::Longwave},
    Row{5, 192, kGround, 0, Kind::Mean, GribQuantity::Longwave},
};

struct LevelRow {
    int category, number;
    GribQuantity quantity;
};
constexpr std::array kLevelRows{
    LevelRow{0, 0, GribQuantity::Temperature}, LevelRow{1, 1, GribQuantity::Humidity}, LevelRow{2, 2, GribQuantity::EastWind},
    LevelRow{2, 3, GribQuantity::NorthWind},   LevelRow{3, 5, GribQuantity::Height},   LevelRow{3, 4, GribQuantity::Geopotential},
    LevelRow{6, 1, GribQuantity::Cover},       LevelRow{6, 22, GribQuantity::Cover},
};

std::optional<Kind> kindOf(GribStatistic statistic) {
    switch (statistic) {
        case GribStatistic::Instant: return Kind::Instant;
        case GribStatistic::Mean: return Kind::Mean;
        case GribStatistic::Sum: return Kind::Sum;
        case GribStatistic::Maximum: return Kind::Maximum;
        default: return std::nullopt;
    }
}

/// ICON: cloud between two pressures, low up to 800 hPa, mid to 400, high above.
std::optional<GribQuantity> coverBetween(GribField const& field) {
    if (field.category != 6 || (field.number != 22 && field.number != 1) || field.first.type != kPressure) return std::nullopt;
    if (field.second.type == kGround) return GribQuantity::CoverLow;
    if (field.second.type != kPressure) return std::nullopt;
    return std::max(field.first.value, field.second.value) > 50000.0 ? GribQuantity::CoverMid : GribQuantity::CoverHigh;
}

std::optional<GribLevel> levelOf(GribField const& field) {
    if (field.second.type != 255) return std::nullopt;
    switch (field.first.type) {
        case kPressure: return GribLevel::Pressure;
        case kAboveGround: return GribLevel::AboveGround;
        case kAboveSea: return GribLevel::AboveSea;
        default: return std::nullopt;
    }
}
}  // namespace

std::optional<GribMeaning> gribMeaning(GribField const& field) {
    auto const kind = kindOf(field.statistic);
    if (field.discipline != 0 || !kind || (field.number >= 192 && field.centre != kNcep)) return std::nullopt;
    if (auto const cover = coverBetween(field)) return GribMeaning{*cover, GribLevel::Pressure};
    for (Row const& row : kRows)
        if (row.category == field.category && row.number == field.number && (row.surface == kAny || row.surface == field.first.type) &&
            row.kind == *kind && (row.height == 0.0 || row.height == field.first.value))
            return GribMeaning{row.quantity};
    auto const level = levelOf(field);
    if (!level || *kind != Kind::Instant) return std::nullopt;
    for (LevelRow const& row : kLevelRows)
        if (row.category == field.category && row.number == field.number) return GribMeaning{row.quantity, *level, field.first.value};
    return std::nullopt;
}
}  // namespace luftpost::weather
