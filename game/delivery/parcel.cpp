#include "game/delivery/parcel.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::delivery {
namespace {
double dragArea(Parcel const& parcel, ParcelData const& data) {
    return data.boxDragArea + (data.chuteDragArea - data.boxDragArea) * parcel.chute;
}

double chuteAt(double age, ParcelData const& data) {
    double const share = std::clamp((age - data.opensAfter) / data.fillsIn, 0.0, 1.0);
    return share * share * (3.0 - 2.0 * share);
}
}  // namespace

double terminalSpeed(double mass, double area, double density) {
    return std::sqrt(2.0 * mass * core::kGravity / (density * area));
}

void stepParcel(Parcel& parcel, ParcelData const& data, core::AirSample const& air, double seconds) {
    glm::dvec3 const relative = parcel.velocityWorld - air.windWorld;
    double const speed =
        std::sqrt(relative.x * relative.x + relative.y * relative.y + relative.z * relative.z);
    double const rate = 0.5 * air.density * dragArea(parcel, data) * speed / data.mass;  // 1/s
    // Drag implicitly: stable for any length of step, and exact at the terminal speed.
    glm::dvec3 const pulled = relative + glm::dvec3{0.0, -core::kGravity * seconds, 0.0};
    glm::dvec3 const velocity = air.windWorld + pulled / (1.0 + rate * seconds);
    parcel.positionWorld += (parcel.velocityWorld + velocity) * (0.5 * seconds);
    parcel.velocityWorld = velocity;
    parcel.age += seconds;
    parcel.chute = chuteAt(parcel.age, data);
}

Landing predictedLanding(Parcel parcel, ParcelData const& data, core::AirSample const& air,
                         double groundHeight) {
    constexpr double kStep = 0.05, kLongest = 600.0;  // s
    Landing landing{parcel.positionWorld, 0.0};
    while (parcel.positionWorld.y > groundHeight && parcel.age < kLongest) {
        stepParcel(parcel, data, air, kStep);
        landing = {parcel.positionWorld, parcel.age};
        bool const settled = parcel.chute >= 1.0 && parcel.age > data.opensAfter + data.fillsIn + 6.0;
        if (!settled || parcel.velocityWorld.y >= -0.5) continue;
        double const rest = (parcel.positionWorld.y - groundHeight) / -parcel.velocityWorld.y;
        return {parcel.positionWorld + parcel.velocityWorld * rest, parcel.age + rest};
    }
    return landing;
}
}  // namespace luftpost::delivery
