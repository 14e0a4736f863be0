// From what devices say to the pilot's stick, tick by tick. Keyboard, gamepad, input file and bot all come
// through here, so that a recorded list of samples is the flight.
#pragma once
#include <optional>

#include "engine/flight/assist.h"
#include "game/ui/input_settings.h"

namespace luftpost::ui {
enum class FlightKey : unsigned {
    thrustUp,
    thrustDown,
    rollLeft,
    rollRight,
    noseDown,
    noseUp,
    yawLeft,
    yawRight,
    brakes,
    drop,
    flapsDown,
    flapsUp,
    respawn,
    thrustStepUp,
    thrustStepDown,
    trimNoseUp,
    trimNoseDown,
    trimYawLeft,
    trimYawRight,
    trimNeutral,
    autopilot,
    count
};

/// A stick that is simply where it is: the input file's and the bot's. Without a throttle the lever stays.
struct DirectStick {
    std::optional<double> throttle;
    double elevator = 0.0, aileron = 0.0, rudder = 0.0, flaps = 0.0, brakes = 0.0;
    bool operator==(DirectStick const&) const = default;
};

/// Axes of gamepads and joysticks as the devices give them, -1..1: roll + right, pitch + nose up, yaw + right, thrust + more;
/// brakes, and the levers where there are such, 0..1.
struct PadAxes {
    float roll = 0.0f, pitch = 0.0f, yaw = 0.0f, thrust = 0.0f, brakes = 0.0f;
    std::optional<float> lever, flaps;
    bool operator==(PadAxes const&) const = default;
};

/// The stick as the mouse holds it, -1..1; it stays where it is put.
struct MouseStick {
    float roll = 0.0f, pitch = 0.0f;  // + right, + nose up
    bool operator==(MouseStick const&) const = default;
};

/// What all devices say at one moment. Held until the next sample.
struct InputSample {
    unsigned keys = 0;  // bit i: FlightKey i is held (or the gamepad's button for it)
    PadAxes pad;
    std::optional<MouseStick> mouse;    // takes the place of the pad's roll and pitch
    std::optional<DirectStick> direct;  // takes the place of keys and pad, but for drop and respawn

    bool held(FlightKey key) const { return (keys >> static_cast<unsigned>(key) & 1u) != 0; }
    void hold(FlightKey key, bool on = true) {
        unsigned const bit = 1u << static_cast<unsigned>(key);
        keys = on ? keys | bit : keys & ~bit;
    }
    bool operator==(InputSample const&) const = default;
};

/// The levers and the stick, advanced once a tick.
class Stick {
public:
    static constexpr double kLeverSeconds = 2.0;  // full travel of the thrust lever by keys
    static constexpr double kTrimSeconds = 4.0;   // from neutral to full trim by keys
    static constexpr double kLeverStep = 0.1;
    static constexpr int kFlapNotches = 3;
    static constexpr double kRespawnSeconds = 0.7;  // how long the key is held

    /// What the pilot's hands do in this tick.
    struct Action {
        flight::Controls controls;
        bool drop = false;     // the key went down in this tick
        bool respawn = false;  // held long enough in this tick
        bool autopilot = false;  // the key went down in this tick
        double leverMoved = 0.0;  // how far keys and axes pushed the thrust lever, past its stops as well
        double trimPitch = 0.0, trimYaw = 0.0;  // the keys of the trim wheels, -1..1: + nose up, + nose right
    };
    /// With `autopilot` on the trim wheels stay where they are: their keys are its knobs.
    Action step(InputSample const& sample, InputSettings const& settings, bool autopilot = false);

    /// The levers of a start or respawn: the trim is solved anew there.
    void begin(double throttle) {
        controls_.throttle = throttle;
        controls_.elevatorTrim = controls_.rudderTrim = 0.0;
    }
    /// Another hand, the autopilot's, moves the lever.
    void setThrottle(double throttle) { controls_.throttle = throttle; }
    flight::Controls const& controls() const { return controls_; }

    template <class Take>
    void forEachNumber(Take&& take) const {
        for (double value : {controls_.throttle, controls_.elevator, controls_.aileron, controls_.rudder,
                             controls_.flaps, controls_.brakes, controls_.elevatorTrim, controls_.rudderTrim})
            take(value);
        take(before_.pad.lever.value_or(-1.0f)), take(before_.pad.flaps.value_or(-1.0f));
        take(static_cast<double>(before_.keys)), take(static_cast<double>(respawnTicks_));
    }

private:
    void follow(DirectStick const& stick);
    void followKeys(InputSample const& sample, InputSettings const& settings, bool autopilot);
    void moveLevers(InputSample const& sample, InputSettings const& settings);
    void moveTrim(InputSample const& sample);
    bool pressed(InputSample const& sample, FlightKey key) const { return sample.held(key) && !before_.held(key); }

    flight::Controls controls_;
    double leverMoved_ = 0.0;  // in this tick
    InputSample before_;
    int respawnTicks_ = 0;
};
}  // namespace luftpost::ui
