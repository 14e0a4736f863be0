// The report of a flight: what happened, what it cost, as JSON of the contract.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "engine/core/settings.h"
#include "game/app/landing.h"
#include "game/delivery/delivery.h"

namespace luftpost::app {
struct ChunkFigures {
    std::size_t made = 0, cached = 0, evicted = 0, peakBytes = 0;
};

struct FlightReport {
    double seconds = 0.0;
    int deliveries = 0, crashes = 0;
    double score = 0.0;
    std::vector<delivery::Drop> drops;
    std::vector<Landing> landings;
    std::vector<std::string> stateHashes;
    std::size_t glErrors = 0;
    ChunkFigures chunks;
    std::vector<double> frame_ms;  // of each frame that was drawn
    double rss_mb = 0.0, gpu_mb = 0.0;
    std::map<std::string, core::SettingValue> changed;
};

/// The value below which the share of all lie (nearest rank); 0 of none.
double percentile(std::vector<double> values, double share);
/// The report as text.
std::string reportText(FlightReport const& report);
/// Resident memory of this process in MB (10^6 bytes); 0 where the system does not tell.
double residentMemory_mb();
}  // namespace luftpost::app
