// The input file: a flight by hand of a script.
#pragma once
#include <filesystem>
#include <string_view>
#include <vector>

#include "game/ui/input.h"

namespace luftpost::ui {
/// What the devices say from a tick on.
struct StampedSample {
    long long tick = 0;
    InputSample sample;
};

/// The first tick at or after `t` seconds of flight: ceil(240 t).
long long tickAtOrAfter(double t);

/// Reads `t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop` (this header, then rows in the order of
/// time): a row acts from tick ceil(240 t_s) and is held until the next; an empty cell leaves its value.
/// Throws core::Error naming file, row, column and what was expected.
std::vector<StampedSample> readInputCsv(std::filesystem::path const& file);
/// The same from text; `name` stands for the file in errors.
std::vector<StampedSample> parseInputCsv(std::string_view text, std::string_view name);
}  // namespace luftpost::ui
