// The report of a flight: what happened, what it cost, as JSON of the contract.
#pragma once
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "engine/core/settings.h"
#include "game/app/landing.h"
#include "game/bot/pilot.h"
#include "game/delivery/delivery.h"

namespace luftpost::app {
struct ChunkFigures {
    std::size_t made = 0, cached = 0, evicted = 0, peakBytes = 0;
};

/// What a bot flew to find out.
struct CardReport {
    std::string bot;  // as --bot has it
    bool finished = false;
    bot::Figures figures;
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
    std::optional<CardReport> card;
};

/// The value below which the share of all lie (nearest rank); 0 of none.
double percentile(std::vector<double> values, double share);
/// What the card found out, a line each: "stall_clean_kcas 53.1".
std::string cardText(CardReport const& card);
/// The report as text.
std::string reportText(FlightReport const& report);
/// Resident memory of this process in MB (10^6 bytes); 0 where the system does not tell.
double residentMemory_mb();
}  // namespace luftpost::app
