#include "game/app/run.h"

#include <fmt/format.h>

#include "engine/core/error.h"

namespace luftpost::app {
int run(int, char**) {
    try {
        throw core::Error{"luftpost", "command", "expected play, sky, weather, air, terrain, bench or replay"};
    } catch (core::Error const& error) {
        fmt::print(stderr, "{}\n", error.what());
        return 2;
    }
}
}  // namespace luftpost::app
