// A parcel under its parachute: a point of mass in the air that the aircraft flies in.
#pragma once
#include <glm/glm.hpp>

#include "engine/core/environment.h"

namespace luftpost::delivery {
struct ParcelData {
    double mass = 25.0;          // kg
    double boxDragArea = 0.3;    // m2, drag coefficient times area before the chute opens
    double chuteDragArea = 6.0;  // m2, of the open chute
    double opensAfter = 1.0;     // s after release that the chute begins to fill
    double fillsIn = 0.6;        // s
};

struct Parcel {
    glm::dvec3 positionWorld{0.0};
    glm::dvec3 velocityWorld{0.0};
    double age = 0.0;    // s since release
    double chute = 0.0;  // 0 packed .. 1 full
};

/// sqrt(2 m g / (rho CdA)), m/s: 8.17 for 25 kg under 6 m2 at sea level.
double terminalSpeed(double mass, double dragArea, double density);

/// Moves the parcel on by `seconds` (at most about 0.05) through the air at its place: gravity and the drag
/// of the air that passes it, so that it drifts with the wind of every height.
void stepParcel(Parcel& parcel, ParcelData const& data, core::AirSample const& air, double seconds);

/// Where a parcel released now comes down on ground that lies at `groundHeight`, if the wind stays as it is
/// here: what the HUD shows and the bot aims with. `seconds` of fall come back too.
struct Landing {
    glm::dvec3 positionWorld{0.0};
    double seconds = 0.0;
};
Landing predictedLanding(Parcel parcel, ParcelData const& data, core::AirSample const& air,
                         double groundHeight);
}  // namespace luftpost::delivery
