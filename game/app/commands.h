// The commands of the program. Each lives in its own file, adds itself to the command line and, when the
// player chose it, hands over what to run.
#pragma once
#include <filesystem>
#include <functional>
#include <optional>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "game/app/options.h"
#include "game/app/settings.h"

namespace CLI {
class App;
}

namespace luftpost::app {
/// The options that every command takes, read and checked before the chosen command runs (not yet inside a
/// callback of CLI11). `weather` is "recorded:FILE", "live", "preset:NAME", FILE, or empty for the bundled
/// recording.
struct CommonOptions {
    std::string weather;
    std::optional<PlaceOption> place;
    std::optional<core::UtcSeconds> time;
    std::optional<unsigned> seed;
    glm::ivec2 size{1280, 720};
    std::filesystem::path settingsFile;    // empty: none named
    std::vector<std::string> assignments;  // "key=value" of --set, in order
    Settings settings;                     // the defaults, then the file, then the assignments
};

/// What to run when the command line is whole; returns the exit code, throws core::Error for bad input.
using Chosen = std::function<int()>;

// A command: `CLI::App* sky = app.add_subcommand("sky", "one line of help")`, its options, and
// `sky->callback([=, &common, &chosen] { chosen = [=, &common] { return runSky(*options, common); }; })`.
// Texts are read by the functions of options.h inside `chosen`, so that every complaint is one line and
// exit 2.

void addPlayCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);
void addReplayCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);

void addWeatherCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);
void addAirCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);
void addSkyCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);

void addReferenceCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);
void addBenchCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);
void addTerrainCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);
void addSettingsCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen);

/// Adds every command (commands.cpp: one line each).
void addCommands(CLI::App& app, CommonOptions const& common, Chosen& chosen);
}  // namespace luftpost::app
