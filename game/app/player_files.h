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

/// Takes settings and seed from the player's folders (making them where they are missing) for what the
/// command line leaves open, and names the files for writing in `run`. What is wrong in them is said on
/// standard output; the game starts.
void usePlayerFiles(CommonOptions& common, RunOptions& run);

/// Takes a parcel that came down into the career; false when the event was something else.
bool countParcel(delivery::Career& career, Simulation const& simulation, FlightEventAt const& event);

/// The career in `file`. A missing file is a new career; a broken one is set aside as FILE.bad and said so.
delivery::Career loadCareer(std::filesystem::path const& file);
/// Writes atomically. A disk that refuses is said so on standard output, once a call; never throws.
void saveCareer(std::filesystem::path const& file, delivery::Career const& career);
}  // namespace luftpost::app
