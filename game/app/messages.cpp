#include "game/app/messages.h"

#include <algorithm>

namespace luftpost::app {
void Messages::say(std::string text, ui::MessageKind kind, double seconds) {
    constexpr std::size_t kMost = 4;
    lines_.push_back({{std::move(text), kind, 0.0}, seconds});
    if (lines_.size() > kMost) lines_.erase(lines_.begin());
}

void Messages::sayEvent(FlightEventAt const& event, double seconds) {
    using ui::MessageKind;
    switch (event.event) {
        case FlightEvent::released:
            return say("Parcel released", MessageKind::info, seconds);
        case FlightEvent::delivered:
            return say(event.text, MessageKind::good, seconds);
        case FlightEvent::lost:
            return say(event.text, MessageKind::bad, seconds);
        case FlightEvent::crashed:
            return say(event.text, MessageKind::bad, seconds);
        case FlightEvent::respawned:
            return say("In the air again, with the same job", MessageKind::info, seconds);
        case FlightEvent::touchdown:
        case FlightEvent::autopilot:
            return say(event.text, MessageKind::info, seconds);
        case FlightEvent::landed:  // shown by the HUD as a whole
        case FlightEvent::chuteOpened:
            return;
    }
}

std::vector<ui::HudMessage> Messages::at(double seconds) {
    std::erase_if(lines_, [&](Line const& line) {  // a flight that began again is before them all
        return seconds < line.since || seconds - line.since > ui::kMessageSeconds;
    });
    std::vector<ui::HudMessage> messages;
    for (Line const& line : lines_) {
        messages.push_back(line.message);
        messages.back().age = seconds - line.since;
    }
    return messages;
}
}  // namespace luftpost::app
