// The eleven rows of the genus table: what a genus looks like where a report does not say.
#pragma once
#include <array>
#include <optional>
#include <string_view>

#include "engine/weather/weather.h"

namespace luftpost::weather {
/// One genus. Heights, thickness, water and droplet sizes are the round figures of the WMO International Cloud Atlas
/// and of Rogers & Yau, "A Short Course in Cloud Physics". What shapes the picture is in cloud_column and cloud_pattern.
struct GenusRow {
    std::string_view name;        // as in reports: "Cu", "fog"
    double base;                  // m above ground, typical
    double thickness;             // m, typical
    double water;                 // kg/m3, condensed water (or ice) in the core
    double radius;                // m, effective radius of droplets or crystals
    bool ice;                     // crystals rather than droplets: halo, no rainbow, no icing
    double extinction;            // 1/m in the core: 3 Q water / (4 density radius) with Q = 2, so as water
};

/// The row of a genus.
GenusRow const& genusRow(Genus genus);

/// "Ci" .. "Cb", "fog": exactly as the contract spells them.
std::string_view genusName(Genus genus);
std::optional<Genus> genusFromName(std::string_view name);

/// "none", "drizzle" .. "unknown": exactly as the contract spells them.
std::string_view precipitationName(Precipitation kind);
std::optional<Precipitation> precipitationFromName(std::string_view name);

/// The three levels in which a model reports cover: low to 3 km (fog included), mid to 8 km, high above.
enum class Level { Low, Mid, High };
Level levelOf(Genus genus);
}  // namespace luftpost::weather
