#include "game/app/commands.h"

namespace luftpost::app {
void addCommands(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    addPlayCommand(app, common, chosen);
    addReplayCommand(app, common, chosen);
    addSkyCommand(app, common, chosen);
    addReferenceCommand(app, common, chosen);
    addBenchCommand(app, common, chosen);
    addWeatherCommand(app, common, chosen);
    addAirCommand(app, common, chosen);
    addTerrainCommand(app, common, chosen);
    addSettingsCommand(app, common, chosen);
}
}  // namespace luftpost::app
