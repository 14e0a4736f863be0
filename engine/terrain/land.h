// The height function: one deterministic land for the eye and for the wheels. Height depends on seed, east, north and
// the base altitude only.
#pragma once
#include <span>

#include "engine/core/environment.h"

namespace luftpost::terrain {
inline constexpr double kSnowLine = 2100.0;  // m above sea level: snow lies above it all year

/// The home airfield: a rectangle centred on the origin, level at the land's base.
struct Runway {
    double heading = 0.0;  // radians from true north, clockwise, 0..pi: of the lower numbered direction
    double length = 900.0, width = 30.0;  // m
    double altitude = 0.0;  // m above sea level

    /// Metres along the heading and to its right, of a point east and north of the origin.
    glm::dvec2 alongAcross(double east, double north) const;
    bool contains(double east, double north) const;
    /// East and north of the threshold where a take-off along the heading (or, `reversed`, against it) begins.
    glm::dvec2 threshold(bool reversed) const;

    glm::dvec2 directionEastNorth{0.0, 1.0};  // unit, along the heading
};

/// Pure and cheap (about a microsecond a call); any thread. The same bits for one point and for many, whatever the
/// processor's vector width: + - x / and sqrt only, every lane on its own.
class Land {
public:
    /// `base` is the altitude of the home airfield above sea level, m.
    Land(unsigned seed, double base);

    /// Height of the solid land above sea level, m: under water the lake's bed.
    double height(double east, double north) const;
    /// Heights at many points: `out[i]` is height(east[i], north[i]) to the bit. All spans have one length.
    void heights(std::span<double const> east, std::span<double const> north, std::span<double> out) const;
    /// What wheels and parcels meet: the water's face where there is water.
    core::GroundSample ground(double east, double north) const;

    /// Every lake of this land stands at this altitude, m above sea level.
    double waterLevel() const { return waterLevel_; }
    Runway const& runway() const { return runway_; }
    /// Where the home airfield lies in the raw land (raw_land.h), m east and north.
    glm::dvec2 homeInRawLand() const { return {homeEast_, homeNorth_}; }
    unsigned seed() const { return seed_; }
    double base() const { return runway_.altitude; }

private:
    void placeHome();
    void capNearHome(double east, double north, double& height) const;

    unsigned seed_;
    double homeEast_ = 0.0, homeNorth_ = 0.0;  // where in the raw land the home airfield lies, m
    double lift_ = 0.0;                        // altitude above sea level of the raw land's zero, m
    double waterLevel_ = 0.0;
    Runway runway_;
};
}  // namespace luftpost::terrain
