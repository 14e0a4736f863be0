#include "game/bot/cards.h"

#include <algorithm>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/math.h"

namespace luftpost::bot {
namespace {
constexpr double kFoot = core::kMetresPerFoot;
constexpr double kModesAltitude = 1000.0 * kFoot;     // where the reference model was flown
constexpr double kCeilingAltitude = 10000.0 * kFoot;  // below any ceiling
// Speeds in stalls, power off, clean, as the airframe marks it.
constexpr double kSlow = 1.18, kApproach = 1.25, kCruise = 1.96;

/// m/s at an altitude of the standard atmosphere.
double tasFromCas(double cas, double altitude) {
    return cas / std::sqrt(core::pow(1.0 - 2.25577e-5 * altitude, 4.25588));
}
}  // namespace

CardStart Card::startOnRunway() const {
    return {.runway = true, .eastNorth = ground_.thresholdEastNorth, .heading = ground_.heading};
}

CardStart Card::startInAir(double altitude, double share) const {
    return {.altitude = altitude, .tas = tasFromCas(stalls(share), altitude), .heading = ground_.heading};
}

/// Half a mile before the threshold, on the line, with the lever soon back: the touchdown lies behind the threshold.
CardStart Card::startOnFinal() const {
    constexpr double kOut = 750.0, kUp = 120.0;  // m
    CardStart start = startInAir(ground_.altitude + kUp, kApproach);
    start.eastNorth = ground_.thresholdEastNorth -
                      kOut * glm::dvec2{core::sin(ground_.heading), core::cos(ground_.heading)};
    return start;
}

std::span<Card::Row const> Card::rows() {
    static Row const all[]{
        {"stall", [](Card const& c) { return c.startInAir(c.ground_.clear + 700.0, 1.27); }, &Card::stall},
        {"glide", [](Card const& c) { return c.startInAir(c.ground_.clear + 3600.0, kSlow); }, &Card::glide},
        {"climb", [](Card const& c) { return c.startInAir(c.ground_.clear, 1.45); }, &Card::climb},
        {"level", [](Card const& c) { return c.startInAir(c.ground_.clear, 2.25); }, &Card::level},
        {"ceiling",
         [](Card const& c) { return c.startInAir(std::max(kCeilingAltitude, c.ground_.clearFar), 1.27); },
         &Card::ceiling},
        {"takeoff", [](Card const& c) { return c.startOnRunway(); }, &Card::takeOff},
        {"landing", [](Card const& c) { return c.startOnFinal(); }, &Card::landing},
        {"phugoid",
         [](Card const& c) { return c.startInAir(std::max(kModesAltitude, c.ground_.clear), kCruise); },
         &Card::phugoid},
        {"shortperiod",
         [](Card const& c) { return c.startInAir(std::max(kModesAltitude, c.ground_.clear), kCruise); },
         &Card::shortPeriod},
        {"dutchroll",
         [](Card const& c) { return c.startInAir(std::max(kModesAltitude, c.ground_.clear), kCruise); },
         &Card::dutchRoll},
        {"roll",
         [](Card const& c) { return c.startInAir(std::max(kModesAltitude, c.ground_.clear) + 300.0, kCruise); },
         &Card::roll},
        {"spiral",
         [](Card const& c) { return c.startInAir(std::max(kModesAltitude, c.ground_.clear) + 300.0, kSlow); },
         &Card::spiral},
        {"trim",
         [](Card const& c) { return c.startInAir(std::max(kModesAltitude, c.ground_.clear), kSlow); },
         &Card::trim},
        {"crosswind", [](Card const& c) { return c.startOnFinal(); }, &Card::landing},
        {kCircuit, [](Card const& c) { return c.startOnRunway(); }, &Card::circuit}};
    return all;
}

std::span<std::string_view const> cardNames() {
    static std::vector<std::string_view> const names = [] {
        std::vector<std::string_view> all;
        for (Card::Row const& row : Card::rows())
            if (row.name != kCircuit) all.push_back(row.name);
        return all;
    }();
    return names;
}

Card::Row const& Card::row(std::string_view name) {
    auto const found =
        std::find_if(rows().begin(), rows().end(), [&](Row const& row) { return row.name == name; });
    CHECK(found != rows().end(), "no card {}", name);
    return *found;
}

Card::Card(std::string_view name, flight::Airframe const& airframe, CardGround const& ground,
           flight::AssistLevel assist)
    : name_{name},
      stall_kt_{knots(airframe.stallSpeed)},
      takeoffFlaps_{airframe.takeoffFlaps},
      takeoffStall_{airframe.stallSpeed + airframe.takeoffFlaps * (airframe.stallSpeedFlaps - airframe.stallSpeed)},
      ground_{ground},
      start_{row(name).start(*this)},
      manoeuvre_{(this->*row(name).fly)()},
      after_{afterwards()},
      course_{ground.heading},
      altitude_{start_.altitude} {
    pilot_.assist = assist;
}

void Card::look(flight::AircraftState const& state) {
    pilot_.look(state);
    if (!began_) turn_.begin(manoeuvre_);
    began_ = true;
    bool const crashed = state.crashed() || state.tick < tick_;  // or has begun anew since
    tick_ = state.tick;
    if (!over_ && (manoeuvre_.done() || crashed)) {
        over_ = true;
        finished_ = manoeuvre_.done();
        if (finished_) put("finished_at_s", static_cast<double>(tick_) * core::kTickSeconds);
        turn_.begin(after_);
    }
    turn_.goOn();
}

ui::InputSample Card::decide(ui::HudState const&) {
    flight::Controls const& hands = pilot_.stick;
    ui::InputSample sample;
    sample.direct = ui::DirectStick{hands.throttle, hands.elevator, hands.aileron,
                                    hands.rudder,   hands.flaps,    hands.brakes};
    return sample;
}

double Card::stalls(double share) const { return fromKnots(std::floor(share * stall_kt_ + 0.5)); }

/// What is left of the flight: stopped on the runway, or round and round where nothing is in the way.
Manoeuvre Card::afterwards() {
    bool const landed = now().onGround;
    pilot_.takeOver();
    for (double t = 0.0; t < 20.0 && !landed; t += core::kTickSeconds, co_await nextTick()) {  // out of a stall, too
        pilot_.stick.throttle = 1.0;
        pilot_.stick.flaps = 0.0;
        pilot_.holdSpeed(stalls(1.45));
        pilot_.holdWings();
    }
    double const altitude = std::max(pilot_.state().positionWorld.y, ground_.clear);
    pilot_.takeOver();
    for (;; co_await nextTick()) {
        if (landed) {
            pilot_.stick = flight::Controls{.brakes = 1.0};
            continue;
        }
        pilot_.holdAltitude(altitude);
        pilot_.holdSpeedByPower(stalls(1.7));
        pilot_.holdWings(0.35);
    }
}
}  // namespace luftpost::bot
