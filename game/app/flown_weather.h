// The weather of a flight as a recording: what was flown, not what was offered.
#pragma once
#include <string>
#include <vector>

#include "engine/weather/field.h"

namespace luftpost::app {
/// Reports over every site that the flight's fields had: where one field took over from another, every ten minutes between, at the
/// beginning and at the end. A site that came on the way has before what its nearest neighbour had. Main thread.
class FlownWeather {
public:
    static constexpr double kStep = 600.0;  // s between reports

    /// From now on the weather is this field.
    void begin(weather::Field const& field, core::UtcSeconds time);
    /// Until now it was this one: its reports since `begin` are kept. A time that is flown again replaces what was there.
    void end(weather::Field const& field, core::UtcSeconds time);
    /// What was kept; at least one begin and end have been.
    weather::Recording recording() const;

private:
    void keep(weather::Field const& field, core::UtcSeconds time);

    core::UtcSeconds since_ = 0.0;
    std::vector<weather::Site> sites_;  // their reports by time
    std::vector<std::string> providers_, licences_;
    std::string name_;
};
}  // namespace luftpost::app
