// What a courier has done so far: survives a restart.
#pragma once
#include <string>
#include <string_view>

namespace luftpost::delivery {
struct Career {
    unsigned seed = 1;  // of the land that the courier works in
    int deliveries = 0;
    int parcelsLost = 0;
    double score = 0.0;
    double bestDistance_m = -1.0;  // of a delivery from the centre; -1: none yet
    bool operator==(Career const&) const = default;
};

/// The save file's text: JSON, format "luftpost-save-1".
std::string careerText(Career const& career);
/// Throws core::Error naming `file`, the place in it and what was expected. Unknown keys are ignored.
Career parseCareer(std::string_view text, std::string const& file);
}  // namespace luftpost::delivery
