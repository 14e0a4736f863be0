#include "game/app/hangar.h"

#include <fmt/format.h>

#include "engine/platform/paths.h"

namespace luftpost::app {
Hangar loadHangar() {
    Hangar hangar;
    for (std::size_t i = 0; i < hangar.size(); ++i)
        hangar[i] = flight::loadAirframe(platform::dataFile(fmt::format("assets/airframes/{}.json", kAirframeWords[i])));
    return hangar;
}
}  // namespace luftpost::app
