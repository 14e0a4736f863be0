// Drop zones: named sites at random reachable places, the same for the same dice and land.
#pragma once
#include <string>

#include <glm/glm.hpp>

#include "engine/core/environment.h"
#include "engine/core/random.h"

namespace luftpost::delivery {
inline constexpr double kDropZoneRadius = 150.0;                        // m, a parcel inside is delivered
inline constexpr double kFirstZoneAhead = 2000.0;                       // m
inline constexpr double kNearestZone = 1500.0, kFarthestZone = 6000.0;  // m from the last one
inline constexpr double kSteepestZone_deg = 10.0;

struct DropZone {
    std::string name;
    double east = 0.0, north = 0.0;  // m
    double height = 0.0;             // m above sea level, of the ground in its centre
};

/// Metres on the map from the zone's centre.
double distanceFrom(DropZone const& zone, double east, double north);
/// 100 (1 - d / 150) inside the zone, 0 outside.
double pointsFor(double distance);
/// On land, less steep than 10 degrees.
bool isGoodSite(core::GroundSample const& ground);

/// The first zone: 2 km along `headingEastNorth` (a unit vector) from the start, or the nearest good site to
/// that.
DropZone firstDropZone(core::Random& random, glm::dvec2 startEastNorth, glm::dvec2 headingEastNorth,
                       core::GroundFunction const& ground);
/// The next zone: 1.5 to 6 km from the last, on a good site that one can climb to on the way.
DropZone nextDropZone(core::Random& random, DropZone const& last, core::GroundFunction const& ground);
}  // namespace luftpost::delivery
