#include "engine/weather/genera.h"

#include "engine/core/check.h"

namespace luftpost::weather {
namespace {
constexpr double kWaterDensity = 1000.0, kIceDensity = 917.0;  // kg/m3

/// Large droplets take out twice their cross-section (Q = 2): 3 Q water / (4 density radius).
constexpr double extinctionOf(double water, double radius, bool ice) {
    return 1.5 * water / ((ice ? kIceDensity : kWaterDensity) * radius);
}
constexpr GenusRow row(std::string_view name, double base, double thickness, double water, double radius, bool ice) {
    return {name, base, thickness, water, radius, ice, extinctionOf(water, radius, ice)};
}
//         base    thick   water   radius    ice
constexpr std::array<GenusRow, kGenera> kRows{
    row("Ci", 8500.0, 1500.0, 1.5e-5, 35e-6, true),
    row("Cc", 7500.0, 300.0, 3.0e-5, 15e-6, true),
    row("Cs", 8000.0, 1500.0, 1.5e-5, 30e-6, true),
    row("Ac", 3500.0, 450.0, 1.5e-4, 8e-6, false),
    row("As", 4000.0, 1500.0, 1.0e-4, 12e-6, false),
    row("Ns", 800.0, 3500.0, 3.5e-4, 12e-6, false),
    row("Sc", 900.0, 500.0, 3.0e-4, 9e-6, false),
    row("St", 300.0, 350.0, 2.5e-4, 8e-6, false),
    row("Cu", 1100.0, 900.0, 5.0e-4, 10e-6, false),
    row("Cb", 900.0, 9000.0, 1.2e-3, 15e-6, false),
    row("fog", 0.0, 150.0, 1.0e-4, 7e-6, false),
};
constexpr std::array<std::string_view, 8> kPrecipitation{"none", "drizzle", "rain", "snow",
                                                         "sleet", "hail", "freezing_rain", "unknown"};
}  // namespace

GenusRow const& genusRow(Genus genus) {
    auto const index = static_cast<std::size_t>(genus);
    CHECK(index < kRows.size(), "genus {} is none of the eleven", index);
    return kRows[index];
}

std::string_view genusName(Genus genus) { return genusRow(genus).name; }

std::optional<Genus> genusFromName(std::string_view name) {
    for (std::size_t i = 0; i < kRows.size(); ++i)
        if (kRows[i].name == name) return static_cast<Genus>(i);
    return std::nullopt;
}

std::string_view precipitationName(Precipitation kind) {
    auto const index = static_cast<std::size_t>(kind);
    CHECK(index < kPrecipitation.size(), "precipitation {} is no kind", index);
    return kPrecipitation[index];
}

std::optional<Precipitation> precipitationFromName(std::string_view name) {
    for (std::size_t i = 0; i < kPrecipitation.size(); ++i)
        if (kPrecipitation[i] == name) return static_cast<Precipitation>(i);
    return std::nullopt;
}

Level levelOf(Genus genus) {
    switch (genus) {
        case Genus::Ci:
        case Genus::Cc:
        case Genus::Cs: return Level::High;
        case Genus::Ac:
        case Genus::As: return Level::Mid;
        default: return Level::Low;
    }
}
}  // namespace luftpost::weather
