#include "game/app/commands.h"

namespace luftpost::app {
void addCommands([[maybe_unused]] CLI::App& app, [[maybe_unused]] CommonOptions const& common,
                 [[maybe_unused]] Chosen& chosen) {}
}  // namespace luftpost::app
