// Runs one flight from its options to its files.
#pragma once
#include "game/app/play_options.h"

namespace luftpost::app {
/// Flies until the seconds are over or the window closes, then writes what was asked for. Returns the exit
/// code; throws core::Error.
int playFlight(PlayOptions options);
}  // namespace luftpost::app
