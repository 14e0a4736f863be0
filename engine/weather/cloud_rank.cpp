#include "engine/weather/cloud_rank.h"

#include "engine/weather/cloud_rank_table.h"

namespace luftpost::weather {
float rankOf(Genus genus, bool coarse, float value) {
    table::RankRow const& row = table::kRanks[static_cast<std::size_t>(genus)][coarse ? 1 : 0];
    float const place = (value - row.low) / (row.high - row.low) * static_cast<float>(table::kRankSteps);
    if (!(place > 0.0f)) return 1.0f;
    if (place >= static_cast<float>(table::kRankSteps)) return 0.0f;
    auto const step = static_cast<std::size_t>(place);
    float const share = place - static_cast<float>(step);
    return 1.0f - (row.below[step] + share * (row.below[step + 1] - row.below[step]));
}
}  // namespace luftpost::weather
