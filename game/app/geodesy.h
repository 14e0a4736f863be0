// From the flat world of the flight to latitude and longitude, as the program's contract has it.
#pragma once
#include <glm/glm.hpp>

#include "engine/core/frames.h"
#include "engine/core/math.h"

namespace luftpost::app {
class Geodesy {
public:
    explicit Geodesy(core::Place const& place)
        : place_{place}, lonPerMetre_deg_{core::degrees(1.0 / (core::kEarthRadius * core::cos(core::radians(place.lat_deg))))} {}

    double lat_deg(glm::dvec3 const& positionWorld) const { return place_.lat_deg - positionWorld.z * kLatPerMetre_deg; }
    double lon_deg(glm::dvec3 const& positionWorld) const { return place_.lon_deg + positionWorld.x * lonPerMetre_deg_; }

private:
    static constexpr double kLatPerMetre_deg = core::degrees(1.0 / core::kEarthRadius);
    core::Place place_;
    double lonPerMetre_deg_;
};
}  // namespace luftpost::app
