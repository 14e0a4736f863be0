// Measures how the patterns of the genera are distributed and prints engine/weather/cloud_rank_table.h. Run it when a
// pattern changes: `cmake --build DIR --target make_rank_table && DIR/assets/make/make_rank_table > .../cloud_rank_table.h`.
#include <fmt/format.h>

#include <algorithm>
#include <vector>

#include "engine/weather/cloud_pattern.h"

namespace {
using namespace luftpost;
constexpr int kSeeds = 600;
constexpr int kPointsPerSeed = 2500;
constexpr int kSteps = 64;

/// Values of the pattern at places and moments strewn over many seeds, sorted.
std::vector<float> sample(weather::Genus genus, weather::PatternDetail detail) {
    std::vector<float> values;
    values.reserve(static_cast<std::size_t>(kSeeds) * kPointsPerSeed);
    unsigned hash = 1;
    auto const unit = [&] { return static_cast<double>(glsl::unitFromHash(hash = glsl::hashOf(hash))); };
    for (unsigned seed = 0; seed < kSeeds; ++seed) {
        weather::Layer layer;
        layer.genus = genus;
        layer.pattern = glsl::hashOf(seed);
        layer.phase = 24.0 * unit();
        weather::LayerPattern const pattern{layer, seed, detail};
        for (int i = 0; i < kPointsPerSeed; ++i)
            values.push_back(pattern.value(unit() * weather::kPatternPeriod, unit() * weather::kPatternPeriod));
    }
    std::sort(values.begin(), values.end());
    return values;
}

void printRow(std::vector<float> const& values) {
    float const low = values.front();
    float const high = values.back();
    fmt::print("     {{{:.6f}f, {:.6f}f, {{", low, high);
    for (int i = 0; i <= kSteps; ++i) {
        float const edge = low + (high - low) * static_cast<float>(i) / kSteps;
        auto const below = std::lower_bound(values.begin(), values.end(), edge) - values.begin();
        double const share = i == kSteps ? 1.0 : static_cast<double>(below) / static_cast<double>(values.size());
        fmt::print("{}{:.5f}f", i == 0 ? "" : (i % 12 == 0 ? ",\n      " : ", "), share);
    }
    fmt::print("}}}}");
}
}  // namespace

int main() {
    fmt::print("// Measured distribution of every genus' pattern. Written by assets/make/rank_table.cpp; do not edit.\n"
               "#pragma once\n#include <array>\n\nnamespace luftpost::weather::table {{\n"
               "inline constexpr int kRankSteps = {};\n"
               "/// Share of the plane where the value is below low + (high - low) i / kRankSteps.\n"
               "struct RankRow {{\n    float low, high;\n    std::array<float, kRankSteps + 1> below;\n}};\n"
               "/// By genus: the whole pattern, and the coarse one.\n"
               "inline constexpr std::array<std::array<RankRow, 2>, {}> kRanks{{{{\n",
               kSteps, weather::kGenera);
    for (int genus = 0; genus < weather::kGenera; ++genus) {
        fmt::print("    {{{{\n");
        printRow(sample(static_cast<weather::Genus>(genus), weather::PatternDetail::Whole));
        fmt::print(",\n");
        printRow(sample(static_cast<weather::Genus>(genus), weather::PatternDetail::Coarse));
        fmt::print("}}}},\n");
    }
    fmt::print("}}}};\n}}  // namespace luftpost::weather::table\n");
}
