// Where the sun, the moon and the stars stand over a place at a time: pure functions of date, time and place.
#pragma once
#include <glm/glm.hpp>

#include "engine/core/environment.h"
#include "engine/core/frames.h"

namespace luftpost::sky {
/// The sky over one place at one time. World frame: x east, y up, z south. All directions are unit vectors from the
/// place toward the body, with the place's parallax and the refraction of the standard atmosphere.
struct SkyState {
    glm::dvec3 sunDirectionWorld{0.0, 1.0, 0.0};
    glm::dvec3 moonDirectionWorld{0.0, -1.0, 0.0};
    double sunDistance_au = 1.0;
    double sunAngularRadius = 0.00465;   // rad, seen from the place
    double moonAngularRadius = 0.00452;  // rad, seen from the place
    double moonPhaseAngle = 0.0;         // rad, sun - moon - observer: 0 is full, pi is new
    double moonIlluminated = 1.0;        // share of the moon's disc that is lit, (1 + cos phase) / 2
    glm::dmat3 celestialFromWorld{1.0};  // to GCRS (J2000 right ascension and declination: x toward 0 h, z north)
};

/// The sky's state by ERFA (IAU 2006/2000A precession and nutation, VSOP2000 Earth, ELP/MPP02-like moon of Meeus),
/// UT1 taken as UTC. Good to 0.001 degrees for the sun and 0.01 for the moon from 1960 to 2100; any thread.
SkyState skyState(core::Place const& place, core::UtcSeconds time);

/// Unit vector in the world frame. Azimuth clockwise from true north, elevation upward, both radians.
glm::dvec3 directionWorld(double azimuth, double elevation);
/// Elevation above the horizontal plane of a unit vector of the world frame, radians.
double elevation(glm::dvec3 const& directionWorld);
/// Azimuth 0..2 pi clockwise from true north of a vector of the world frame, radians.
double azimuth(glm::dvec3 const& directionWorld);

/// How much refraction lifts a body, radians, for its airless elevation (Saemundsson 1986, Sky & Telescope 72, 70),
/// pressure in Pa, temperature in K. Fades out from 1 to 4 degrees below the horizon, where nothing is seen of it.
double refraction(double airlessElevation, double pressure, double temperature);
}  // namespace luftpost::sky
