// The circuit: off the runway, once round to the left, and down on the line again, in whatever wind there is.
#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "game/bot/cards.h"

namespace luftpost::bot {
namespace {
constexpr double kTick = core::kTickSeconds;
constexpr double kUp = 200.0;          // m over the airfield, of the circuit
constexpr double kOnFinal = 0.012;     // rad of course per m off the line
constexpr double kMostAlpha = core::radians(13.0);
constexpr double kClimb = 2.5;         // m/s, with speed to spare for the turns
constexpr double kAside = 900.0;       // m, the downwind leg beside the runway
constexpr double kBaseTurn = 1300.0;   // m before the threshold
constexpr double kSlope = 0.075;       // of the final approach
constexpr double kAim = 120.0;         // m behind the threshold, where the slope meets the runway
constexpr double kAlign = 6.0;         // m of height, from where one wing is low and the nose along the runway
constexpr double kFlareSeconds = 2.5;  // of the sink that there is, above the ground
constexpr double kTouch = 0.35;        // m/s, the sink that the flare ends with ...
constexpr double kRound = 0.35;        // 1/s, ... and what each metre of height adds to it
constexpr double kCut = 0.8;           // m, from where the lever goes back ...
constexpr double kCutRate = 0.5;       // 1/s, ... so fast; above, a lull is answered with power
constexpr double kLullPower = 0.1;     // of the lever per m/s that a lull takes
}  // namespace

double Card::windAcross() const {
    glm::dvec3 const& wind = now().windWorld;
    return -(wind.x * core::cos(ground_.heading) + wind.z * core::sin(ground_.heading));
}

/// On the wheels along the line, the ailerons into the wind: all the more, the less they bite.
void Card::rollAlong() {
    pilot_.steerAlong(ground_.heading, across());
    double const into = std::clamp(windAcross() / fromKnots(15.0), -1.0, 1.0) *
                        std::clamp(1.2 - now().cas / stalls(1.0), 0.0, 1.0);
    pilot_.stick.aileron = std::clamp(into - 1.5 * now().roll - 0.4 * now().rollRate, -1.0, 1.0);
}

/// Flies `course` over the ground and toward the line at `aside` m to the right of the runway's.
void Card::followLine(double course, double aside, double gain) {
    double const off = (across() - aside) * core::cos(course - ground_.heading);
    pilot_.holdTrack(course - std::clamp(gain * off, -0.7, 0.7));
}

Manoeuvre Card::leaveRunway() {
    pilot_.stick.throttle = 1.0;
    pilot_.stick.flaps = takeoffFlaps_;
    bool up = false;
    for (; now().height < 5.0; co_await nextTick()) {
        up = up || now().cas > stalls(1.15);  // held down until it flies at once, gusts and all
        if (up) pilot_.holdPitch(0.14);
        if (now().onGround)
            rollAlong();
        else
            pilot_.holdWings();  // the nose turns into the wind by itself
    }
    put("liftoff_off_m", std::abs(across()));
    for (; now().height < 60.0; co_await nextTick()) {  // by attitude: the speed jumps with the gusts
        pilot_.holdPitch(0.12);
        followLine(ground_.heading, 0.0);
    }
    pilot_.stick.flaps = 0.0;
    pilot_.takeOver();
}

/// Up, to the left and back beside the runway, to where the base leg begins.
Manoeuvre Card::flyRound() {
    double const altitude = ground_.altitude + kUp;
    for (; across() > -kAside + 250.0; co_await nextTick()) {
        pilot_.holdAltitude(altitude, kClimb);
        pilot_.holdSpeedByPower(stalls(1.6));
        bool const clear = now().height > 100.0;
        if (clear) pilot_.holdTrack(ground_.heading - 0.5 * core::kPi);
        if (!clear) followLine(ground_.heading, 0.0);
    }
    pilot_.takeOver();
    for (; along() > -kBaseTurn + 300.0; co_await nextTick()) {
        pilot_.holdAltitude(altitude);
        pilot_.holdSpeedByPower(stalls(1.6));
        followLine(ground_.heading + core::kPi, -kAside);
    }
}

/// The height over the runway that the slope has here, m.
double Card::slopeHeight() const { return std::max(kSlope * (kAim - along()), 0.0); }

Manoeuvre Card::flyFinal() {
    pilot_.stick.flaps = 1.0 / 3.0;
    bool established = false;
    while (now().height > std::max(-kFlareSeconds * now().climb, 2.0)) {
        double const height = pilot_.state().positionWorld.y - ground_.altitude;
        established = established || across() > -250.0;
        double const wanted = -kSlope * now().groundSpeed + 0.25 * (slopeHeight() - height);
        pilot_.holdClimb(std::clamp(established ? wanted : std::min(wanted, 0.0), -5.0, 1.0));
        pilot_.holdSpeedByPower(finalSpeed(), kLullPower);
        if (!established)
            pilot_.holdTrack(ground_.heading + 0.5 * core::kPi);
        else if (height > kAlign)
            followLine(ground_.heading, 0.0, kOnFinal);
        else
            pilot_.slipAlong(ground_.heading, across(), drift(), windAcross());
        co_await nextTick();
    }
}

/// Down to the wheels; the nose comes along the runway late, one wing low.
void Card::flare() {
    if (now().height < kAlign)
        pilot_.slipAlong(ground_.heading, across(), drift(), windAcross());
    else
        followLine(ground_.heading, 0.0, kOnFinal);
    pilot_.holdSink(-kTouch - kRound * now().height);
    if (now().height > kCut)
        pilot_.holdSpeedByPower(finalSpeed(), kLullPower);
    else
        pilot_.stick.throttle = std::max(pilot_.stick.throttle - kCutRate * kTick, 0.0);
}

Manoeuvre Card::touchDown() {
    for (; !now().onGround; co_await nextTick()) flare();
    double hardest = pilot_.state().touchdownSpeed;
    put("touchdown_kcas", knots(now().cas));
    put("touchdown_along_m", along());
    put("touchdown_off_m", std::abs(across()));
    double off = 0.0;
    for (; now().groundSpeed > 0.5; co_await nextTick()) {
        hardest = std::max(hardest, pilot_.state().touchdownSpeed);
        off = std::max(off, std::abs(across()));
        if (now().height > 0.2) {  // a gust has it up again
            flare();
            continue;
        }
        rollAlong();
        pilot_.stick.throttle = pilot_.stick.flaps = 0.0;
        pilot_.stick.brakes = now().onGround ? 0.5 : 0.0;
        pilot_.stick.elevator = 0.1;
    }
    put("touchdown_mps", hardest);
    put("landing_off_m", off);
    put("stopped_at_m", along());
}

/// Half the gust is added, as pilots do: a lull takes no more away than there is to spare.
double Card::finalSpeed() const { return std::min(stalls(1.3) + 0.5 * ground_.gust, stalls(1.55)); }

Manoeuvre Card::circuit() {
    pilot_.mostAlpha = kMostAlpha;
    co_await leaveRunway();
    co_await flyRound();
    co_await flyFinal();
    co_await touchDown();
    put("wind_mps", std::sqrt(now().windWorld.x * now().windWorld.x + now().windWorld.z * now().windWorld.z));
}
}  // namespace luftpost::bot
