// The player's own files: settings and career. Read at the start of a window's session, written whole after
// every change.
#pragma once
#include <filesystem>

#include "engine/core/settings.h"
#include "game/app/commands.h"
#include "game/app/simulation.h"
#include "game/delivery/career.h"

namespace luftpost::app {
struct RunOptions;

/// Takes settings and seed from the player's folders for what the
/// command line leaves open, and names the files for writing in `run`. What is wrong in them is said on
/// standard output; the game starts.
void usePlayerFiles(CommonOptions& common, RunOptions& run);

/// What the player's settings file holds, apart from what the command line says for this one flight.
class StoredSettings {
public:
    /// Reads the file as it is; a missing or broken one holds nothing. An empty name: nothing is stored.
    explicit StoredSettings(std::filesystem::path file);
    StoredSettings(StoredSettings const&) = delete;
    StoredSettings& operator=(StoredSettings const&) = delete;
    /// The player chose this value; it is written by `write`.
    void change(std::string_view key, core::SettingValue const& value);
    /// Writes atomically, when something was changed since the last time. Throws core::Error when the disk
    /// refuses.
    void write();

private:
    std::filesystem::path file_;
    Settings settings_;
    core::SettingList list_;
    core::SettingsFileNotes notes_;
    bool changed_ = false;
};

/// Takes a parcel that came down into the career; false when the event was something else.
bool countParcel(delivery::Career& career, Simulation const& simulation, FlightEventAt const& event);

/// The career in a file that the command line names. A missing or empty file is a new career. Throws
/// core::Error.
delivery::Career namedCareer(std::filesystem::path const& file);
/// The player's career. A broken file is set aside as FILE.bad and said so.
delivery::Career loadCareer(std::filesystem::path const& file);
/// Writes atomically. Throws core::Error when the disk refuses.
void saveCareer(std::filesystem::path const& file, delivery::Career const& career);
}  // namespace luftpost::app
