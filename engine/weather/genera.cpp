#include "engine/weather/genera.h"

#include "engine/core/check.h"

namespace luftpost::weather {
namespace {
constexpr double kWaterDensity = 1000.0, kIceDensity = 917.0;  // kg/m3

/// Large droplets take out twice their cross-section (Q = 2): 3 Q water / (4 density radius).
constexpr double extinctionOf(double water, double radius, bool ice) {
    return 1.5 * water / ((ice ? kIceDensity : kWaterDensity) * radius);
}
constexpr GenusRow row(std::string_view name, double base, double thickness, double water, double radius, bool ice,
                       double patternScale, double shapeType, double roughness, double erosion) {
    return {name,         base,      thickness, water, radius, ice, extinctionOf(water, radius, ice),
            patternScale, shapeType, roughness, erosion};
}
//                                     base  thick    water   radius    ice   scale  type  rough erosion
constexpr std::array<GenusRow, kGenera> kRows{
    row("Ci", 8500.0, 1500.0, 1.5e-5, 35e-6, true, 3500.0, 0.30, 0.60, 0.70),
    row("Cc", 7500.0, 300.0, 3.0e-5, 15e-6, true, 900.0, 0.50, 0.70, 0.50),
    row("Cs", 8000.0, 1500.0, 1.5e-5, 30e-6, true, 6000.0, 0.05, 0.20, 0.25),
    row("Ac", 3500.0, 450.0, 1.5e-4, 8e-6, false, 1500.0, 0.45, 0.60, 0.45),
    row("As", 4000.0, 1500.0, 1.0e-4, 12e-6, false, 5000.0, 0.05, 0.25, 0.20),
    row("Ns", 800.0, 3500.0, 3.5e-4, 12e-6, false, 5000.0, 0.05, 0.30, 0.15),
    row("Sc", 900.0, 500.0, 3.0e-4, 9e-6, false, 2000.0, 0.50, 0.55, 0.40),
    row("St", 300.0, 350.0, 2.5e-4, 8e-6, false, 3000.0, 0.00, 0.25, 0.25),
    row("Cu", 1100.0, 900.0, 5.0e-4, 10e-6, false, 1400.0, 1.00, 0.90, 0.50),
    row("Cb", 900.0, 9000.0, 1.2e-3, 15e-6, false, 6000.0, 1.00, 1.00, 0.35),
    row("fog", 0.0, 150.0, 1.0e-4, 7e-6, false, 4000.0, 0.00, 0.15, 0.20),
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
