#include "game/app/flight_log.h"

#include <fmt/format.h>

#include <cmath>
#include <iterator>

#include "engine/core/check.h"

namespace luftpost::app {
namespace {
constexpr char const* kHeader =
    "t_s,lat_deg,lon_deg,altitude_m,height_m,tas_mps,ias_mps,ground_mps,climb_mps,heading_deg,pitch_deg,roll_"
    "deg,"
    "alpha_deg,beta_deg,p_dps,q_dps,r_dps,load_factor,throttle,elevator,aileron,rudder,flaps,rpm,fuel_kg,"
    "mass_kg,"
    "on_ground,wind_east_mps,wind_north_mps,wind_up_mps\n";
}  // namespace

FlightLog::FlightLog(core::Place const& place) : geodesy_{place}, text_{kHeader} {}

void FlightLog::add(double seconds, flight::AircraftState const& state) {
    flight::Readings const& r = state.readings;
    auto const deg = [](double angle) { return core::degrees(angle); };
    double const rpm = state.propellerRate * 60.0 / (2.0 * core::kPi);
    fmt::format_to(std::back_inserter(text_), "{:.1f},{:.8f},{:.8f}", seconds,
                   geodesy_.lat_deg(state.positionWorld), geodesy_.lon_deg(state.positionWorld));
    for (double value : {state.positionWorld.y,
                         r.height,
                         r.tas,
                         r.cas,
                         r.groundSpeed,
                         r.climb,
                         deg(r.heading),
                         deg(r.pitch),
                         deg(r.roll),
                         deg(r.alpha),
                         deg(r.beta),
                         deg(r.rollRate),
                         deg(r.pitchRate),
                         deg(r.yawRate),
                         r.loadFactor,
                         state.commands.throttle,
                         state.commands.elevator,
                         state.commands.aileron,
                         state.commands.rudder,
                         state.commands.flaps,
                         rpm,
                         state.fuel,
                         r.mass}) {
        CHECK(std::isfinite(value), "a value of the log at {} s is not finite", seconds);
        fmt::format_to(std::back_inserter(text_), ",{:.4f}", value);
    }
    fmt::format_to(std::back_inserter(text_), ",{},{:.4f},{:.4f},{:.4f}\n", r.onGround ? 1 : 0, r.windWorld.x,
                   -r.windWorld.z, r.windWorld.y);
}
}  // namespace luftpost::app
