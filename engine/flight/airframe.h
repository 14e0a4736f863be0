// The airframe: everything about an aircraft that a data file says. See assets/airframes and docs/flight.md.
//
// Body frame, kept everywhere in this floor: x forward, y up, z to the right (right-handed), metres, from the
// airframe's datum (the centre of gravity of its reference loading). Turning about +x rolls right, about +z
// lifts the nose, about +y swings the nose to the LEFT: a yaw rate to the right is negative about y.
#pragma once
#include <array>
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::flight {
inline constexpr int kMaxStrips = 20;
inline constexpr int kMaxWheels = 4;
inline constexpr int kMaxStrikes = 12;

/// What sits at a strip's trailing edge; each is moved by one command.
enum class ControlSurface { none, elevator, aileron, rudder, flap };
/// What the air of a strip has passed: the wing meets it first, the tail after the wing.
enum class StripPlace { wing, tail, fin, fuselage };

/// One panel of the aircraft with its own section; see strip.h for the model. SI, angles in radians.
struct StripData {
    std::string name;
    StripPlace place = StripPlace::wing;
    glm::dvec3 position{0.0};  // m, datum frame, quarter chord of the panel's middle
    glm::dvec3 normal{
        0.0, 1.0,
        0.0};           // unit, across x, toward the upper (the fin's: right) side; lift is positive along it
    double area = 1.0;  // m2
    double chord = 1.0;                 // m
    double incidence = 0.0;             // rad, nose up (toward the normal) of the body's x axis
    double liftSlope = 5.0;             // 1/rad, of the finite surface
    double zeroLiftAngle = 0.0;         // rad, angle of attack of no lift
    double stallAngle = 0.28;           // rad, where half of the flow has separated, upright
    double stallAngleNegative = -0.24;  // rad
    double stallWidth = 0.1;            // rad, over which the flow separates
    double dragZero = 0.01;             // drag coefficient at no lift
    double inducedDrag = 0.05;          // drag coefficient per lift coefficient squared
    double momentZero = 0.0;            // moment coefficient about the quarter chord, + nose up
    ControlSurface surface = ControlSurface::none;
    double surfaceLift = 0.0;    // rad of angle of attack per rad of deflection
    double surfaceDrag = 0.0;    // drag coefficient per rad2 of deflection
    double surfaceMoment = 0.0;  // moment coefficient per rad of deflection
    double surfaceStall = 0.0;   // rad of stall angle lost per rad of downward deflection
    double wash = 0.0;           // 0..1, share of the slipstream's speed that the panel meets
    double swirl = 0.0;          // 0..1, share of the slipstream's rotation that the panel meets
};

/// Fixed-pitch propeller and piston engine; see propeller.h.
struct PropellerData {
    glm::dvec3 position{0.0};                    // m, datum frame
    double diameter = 1.9;                       // m
    double inertia = 1.5;                        // kg m2, propeller and crankshaft
    std::vector<double> advance, thrust, power;  // the table: J, Ct, Cp
    double sideForce =
        0.0;  // share of the thrust times the inflow angle that acts across the shaft (P-factor's force)
    double offset =
        0.0;  // share of the radius by which the thrust moves sideways per rad of inflow (P-factor)
};
struct EngineData {
    double power = 1.2e5;          // W at full throttle, sea level, rated speed
    double rate = 280.0;           // rad/s, rated
    double idleShare = 0.05;       // share of full torque with the lever back
    double frictionTorque = 20.0;  // N m at the rated rate, taken from the shaft
    double consumption = 8.0e-8;   // kg/J
    double altitudeLoss = 0.132;   // power falls as (1 + loss) sigma - loss with the density ratio sigma
};

struct WheelData {
    std::string name;
    glm::dvec3 position{0.0};  // m, datum frame, of the tyre's lowest point with the leg unloaded
    double stiffness = 5.0e4;  // N/m
    double damping = 3.0e3;    // N s/m
    double rolling = 0.02, braking = 0.6, side = 0.8;  // friction coefficients; braking at full brakes
    double steering = 0.0;                             // rad at full pedal
    bool skid = false;                                 // a skid slides in every direction
};
/// A point of the hull that must not touch the ground.
struct StrikeData {
    std::string name;  // as in "the left wing tip struck the ground"
    glm::dvec3 position{0.0};
};
struct MassData {
    double mass = 0.0;         // kg; 0 for what a flight chooses (payload, fuel)
    glm::dvec3 position{0.0};  // m, datum frame
};

struct Airframe {
    std::string name;
    double wingArea = 16.0, wingSpan = 11.0, wingChord = 1.5,
           wingHeight = 2.0;  // wingHeight: above the wheels, for ground effect
    MassData empty, pilot, payload, fuel;
    glm::dmat3 emptyInertia{1.0};            // kg m2 about the empty centre of gravity
    double payloadMax = 0.0, fuelMax = 0.0;  // kg
    std::vector<StripData> strips;
    double downwash = 0.4,
           downwashLength = 4.5;  // rad of downwash per unit of wing lift coefficient; m, wing to tail
    double elevatorUp = 0.49, elevatorDown = 0.4, aileronUp = 0.35, aileronDown = 0.26,
           rudder = 0.28;                         // rad of travel
    double flapTravel = 0.52, flapSeconds = 6.0;  // rad, s for the full travel
    double takeoffFlaps = 1.0 / 3.0;              // share of the travel that the handbook takes off with
    double surfaceSeconds = 0.15;                 // time constant of the controls
    PropellerData propeller;
    EngineData engine;
    std::vector<WheelData> wheels;
    std::vector<StrikeData> strikes;
    double touchdownLimit = 3.0;  // m/s across the ground that the wheels stand
    // What the instruments mark and the assist guards, calibrated airspeed in m/s.
    double stallSpeed = 26.0, stallSpeedFlaps = 23.0, flapLimitSpeed = 44.0, cruiseLimitSpeed = 66.0,
           neverExceedSpeed = 84.0;
};

/// Reads and checks an airframe. Throws core::Error naming the file, the key and what was expected.
Airframe loadAirframe(std::filesystem::path const& file);
/// The same from text; `name` stands for the file in errors.
Airframe parseAirframe(std::string const& text, std::string const& name);
}  // namespace luftpost::flight
