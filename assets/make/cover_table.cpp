// Measures at which threshold of the rank a column's optical depth crosses that of cover, and prints
// engine/weather/cloud_cover_table.h: for each genus, thickness and cover c the threshold that leaves the share c of all
// columns thick enough. Run it when a form, the density or the noise changes (see make_rank_table).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/cloud_column.h"
#include "engine/weather/cloud_depth.h"
#include "engine/weather/genera.h"
#include "engine/weather/noise_volume.h"

namespace {
using namespace luftpost;
constexpr int kColumns = 8000, kRealColumns = 30000;
constexpr int kCandidates = 12;  // real places looked at for each of which a column is taken
constexpr std::array kCovers{0.02f, 0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 0.95f, 0.98f};
constexpr std::array kThicknesses{80.0f, 150.0f, 300.0f, 500.0f, 800.0f, 1300.0f, 2000.0f, 3500.0f, 6000.0f, 12000.0f};

/// The threshold at which the column over `place` has the optical depth that counts as cover.
float crossing(glsl::LayerColumn column, glsl::LayerShape const& shape, glm::vec2 const& place, float depth,
               weather::NoiseVolumes const& noise) {
    float low = -0.5f, high = 1.6f;
    for (int i = 0; i < 12; ++i) {
        column.cover = 0.5f * (low + high);
        (weather::layerDepth(column, shape, place, noise) > depth ? high : low) = column.cover;
    }
    return 0.5f * (low + high);
}

/// A layer that has this cover, alone.
weather::Weather weatherOf(weather::Genus genus, float thickness, float cover) {
    weather::Weather here;
    here.layerCount = 1;
    weather::GenusRow const& row = weather::genusRow(genus);
    here.layers[0] = {.genus = genus, .cover = cover, .base = 1000.0f, .top = 1000.0f + thickness,
                      .water = static_cast<float>(row.water), .wind = {8.0, 3.0}};
    return here;
}

/// Thresholds of kColumns columns strewn over the plane, sorted.
std::vector<float> crossings(weather::Weather const& here, glsl::LayerShape const& shape, weather::NoiseVolumes const& noise) {
    weather::Layer const& layer = here.layers[0];
    float const water = weather::CloudColumns{here, 1}.bare().layers[0].water;
    std::vector<float> result;
    unsigned hash = 7;
    auto const unit = [&] { return glsl::unitFromHash(hash = glsl::hashOf(hash)); };
    for (int i = 0; i < kColumns; ++i) {
        float const rank = (static_cast<float>(i) + unit()) / static_cast<float>(kColumns);  // stratified: the rank is uniform
        glsl::LayerColumn const column{rank, 0.0f, layer.base, layer.top, water, 1.0f};
        glm::vec2 const place{65536.0f * unit(), 65536.0f * unit()};
        result.push_back(crossing(column, shape, place, weather::coverDepth(layer.genus), noise));
    }
    std::sort(result.begin(), result.end());
    return result;
}

/// A layer with towers and an anvil under one of the winds that may carry this.
struct Carried {
    weather::Weather weather;
    glsl::LayerShape shape;
};
std::vector<Carried> carriedEachWay(weather::Weather const& here) {
    std::vector<Carried> result;
    for (int i = 0; i < 12; ++i) {
        double const turn = (i + 0.5) * core::kPi / 6.0;
        weather::Weather weather = here;
        weather.layers[0].wind = 9.0 * glm::dvec2{core::cos(turn), core::sin(turn)};
        result.push_back({weather, weather::cloudShape(weather, 1, glm::dvec2{0.0}).layers[0]});
    }
    return result;
}

struct Standing {
    glsl::LayerColumn column;
    glm::vec2 place;
    glsl::LayerShape const* shape;
};

/// kRealColumns columns of real places, moments and winds: the ranks of a tower and its anvil belong together. Taken evenly from many
/// more in the order of their rank, for the share of so few strewn at will is uncertain by 0.003.
std::vector<Standing> realColumns(std::vector<Carried> const& ways) {
    std::vector<Standing> result;
    unsigned hash = 7;
    auto const unit = [&] { return glsl::unitFromHash(hash = glsl::hashOf(hash)); };
    float const period = 3.0f / ways[0].shape.anchor.w;  // m: no part of the noise is met more often than another
    for (int i = 0; i < kCandidates * kRealColumns; ++i) {
        Carried const& way = ways[static_cast<std::size_t>(unit() * static_cast<float>(ways.size()))];
        weather::Weather there = way.weather;
        glm::vec2 const place{period * unit(), period * unit()};
        there.layers[0].pattern = hash;
        there.layers[0].phase = 24.0 * static_cast<double>(unit());
        result.push_back({weather::CloudColumns{there, 1}.at(static_cast<double>(place.x), -static_cast<double>(place.y)).layers[0], place, &way.shape});
    }
    std::sort(result.begin(), result.end(), [](Standing const& a, Standing const& b) { return a.column.rank < b.column.rank; });
    for (std::size_t i = 0; i < kRealColumns; ++i) result[i] = result[kCandidates * i + kCandidates / 2];
    result.resize(kRealColumns);
    return result;
}

/// The threshold that leaves this share of real columns thick enough. One by one they have no threshold: as it rises, an anvil's streaks
/// reach further out, and at a cover that closes less far again.
float realThreshold(weather::Weather const& here, float cover, weather::NoiseVolumes const& noise) {
    std::vector<Carried> const ways = carriedEachWay(here);
    std::vector<Standing> const columns = realColumns(ways);
    float const limit = weather::coverDepth(here.layers[0].genus);
    float low = -0.5f, high = 1.6f;
    for (int i = 0; i < 13; ++i) {
        float const threshold = 0.5f * (low + high);
        auto const thick = std::count_if(columns.begin(), columns.end(), [&](Standing const& standing) {
            glsl::LayerColumn column = standing.column;
            column.cover = threshold;
            return weather::layerDepth(column, *standing.shape, standing.place, noise) > limit;
        });
        (static_cast<float>(thick) > cover * static_cast<float>(columns.size()) ? high : low) = threshold;
    }
    return 0.5f * (low + high);
}

template <class Values>
void printList(Values const& values) {
    for (std::size_t i = 0; i < values.size(); ++i) fmt::print("{}{:.4f}f", i == 0 ? "" : ", ", values[i]);
}

void printTop() {
    fmt::print("// The calibrated cover of every genus. Written by assets/make/cover_table.cpp; do not edit.\n"
               "#pragma once\n#include <array>\n\nnamespace luftpost::weather::table {{\n"
               "/// Covers and thicknesses (m) of the table's columns and rows.\ninline constexpr std::array<float, {}> kCovers{{",
               kCovers.size());
    printList(kCovers);
    fmt::print("}};\ninline constexpr std::array<float, {}> kThicknesses{{", kThicknesses.size());
    printList(kThicknesses);
    fmt::print("}};\n/// The rank's threshold, by genus, thickness and cover.\n"
               "inline constexpr std::array<std::array<std::array<float, {}>, {}>, {}> kThresholds{{{{\n",
               kCovers.size(), kThicknesses.size(), weather::kGenera);
}
}  // namespace

int main() {
    weather::NoiseVolumes const noise = weather::makeNoise(weather::kNoiseSeed, 2);
    printTop();
    for (int genus = 0; genus < weather::kGenera; ++genus) {
        fmt::print("    {{{{ // {}\n", weather::genusName(static_cast<weather::Genus>(genus)));
        for (float thickness : kThicknesses) {
            std::vector<float> sorted;
            std::array<float, kCovers.size()> row{};
            for (std::size_t i = 0; i < kCovers.size(); ++i) {
                weather::Weather const here = weatherOf(static_cast<weather::Genus>(genus), thickness, kCovers[i]);
                glsl::LayerShape const shape = weather::cloudShape(here, 1, glm::dvec2{0.0}).layers[0];
                if (shape.body.z > 0.0f) {  // how far an anvil is carried depends on its cover
                    row[i] = realThreshold(here, kCovers[i], noise);
                    continue;
                }
                if (i == 0) sorted = crossings(here, shape, noise);  // what has none looks alike whatever its cover is
                row[i] = sorted[static_cast<std::size_t>(kCovers[i] * static_cast<float>(sorted.size()))];
            }
            fmt::print("        {{");
            printList(row);
            fmt::print("}},\n");
        }
        fmt::print("    }}}},\n");
    }
    fmt::print("}}}};\n}}  // namespace luftpost::weather::table\n");
}
