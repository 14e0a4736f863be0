// The airfield's end from which one takes off and lands into the wind.
#pragma once
#include "engine/terrain/land.h"
#include "engine/weather/field.h"

namespace luftpost::app {
struct RunwayStart {
    glm::dvec2 thresholdEastNorth{0.0};
    double heading = 0.0;           // rad clockwise from north, into the wind
    glm::dvec2 eastNorth{0.0};      // where an aircraft stands with every wheel on the strip
};
inline RunwayStart runwayStart(terrain::Land const& land, weather::Field const& field, core::UtcSeconds time) {
    terrain::Runway const& runway = land.runway();
    glm::dvec2 const wind = field.at(0.0, 0.0, time).windSurface;
    bool const reversed = wind.x * runway.directionEastNorth.x + wind.y * runway.directionEastNorth.y > 0.0;
    glm::dvec2 const along = runway.directionEastNorth * (reversed ? -1.0 : 1.0);
    glm::dvec2 const threshold = runway.threshold(reversed);
    constexpr double kInside = 10.0;  // m, about a length of the aircraft
    return {threshold, runway.heading + (reversed ? core::kPi : 0.0), threshold + along * kInside};
}
}  // namespace luftpost::app
