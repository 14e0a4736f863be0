// Lightning of the cumulonimbus clouds of the weather: where and when, the same for the same weather, seed and time. Pure, any thread.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "engine/core/time.h"
#include "engine/weather/weather.h"

namespace luftpost::weather {
inline constexpr double kSoundSpeed = 340.0;   // m/s, of thunder
inline constexpr double kFlashSeconds = 0.45;  // s, after which a flash is dark

struct Flash {
    core::UtcSeconds time = 0.0;    // of its first stroke
    glm::dvec3 sourceWorld{0.0};    // m: middle of its light, inside the cloud
    glm::dvec3 groundWorld{0.0};    // m: under it, at `ground` of the question
    bool toGround = false;
    double power = 0.0;             // 0..1 of a strong one
    unsigned seed = 0;              // of its channel
};

/// The flashes that begin from `from` on and before `to` within `reach` m of a place (m east and north). They strike from a storm's towers,
/// about every 6 s within 30 km of a strong one; none unless the weather thunders. `ground`: m above sea level, where channels end.
std::vector<Flash> flashes(Weather const& weather, unsigned seed, core::UtcSeconds from, core::UtcSeconds to, glm::dvec2 const& eastNorth,
                           double reach, double ground);

/// Share of its greatest light that a flash has `after` s from its first stroke: one to four strokes that each fade within a tenth of a second.
double flashLight(Flash const& flash, double after);

/// When a flash is heard from a place, s after its light: from the nearer of cloud and channel.
double thunderDelay(Flash const& flash, glm::dvec3 const& earWorld);

/// The flashes within 20 km whose thunder reaches an ear after `from` and until `to`.
std::vector<Flash> thunders(Weather const& weather, unsigned seed, core::UtcSeconds from, core::UtcSeconds to, glm::dvec3 const& earWorld, double ground);
}  // namespace luftpost::weather
