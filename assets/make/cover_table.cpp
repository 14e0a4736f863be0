// Measures at which threshold of the rank a column's optical depth crosses that of cover, and prints
// engine/weather/cloud_cover_table.h: for each genus, thickness and cover c the threshold that leaves the share c of all
// columns thick enough. Run it when a form, the density or the noise changes (see make_rank_table).
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <vector>

#include "engine/weather/cloud_column.h"
#include "engine/weather/cloud_depth.h"
#include "engine/weather/genera.h"
#include "engine/weather/noise_volume.h"

namespace {
using namespace luftpost;
constexpr int kColumns = 8000, kRealColumns = 40000;
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

weather::Weather withLayer(weather::Weather weather, weather::Layer const& layer) {
    weather.layers[0] = layer;
    return weather;
}

/// Thresholds of kColumns columns strewn over the plane, sorted.
std::vector<float> crossings(weather::Weather const& here, weather::NoiseVolumes const& noise) {
    weather::Layer layer = here.layers[0];
    glsl::LayerShape const shape = weather::cloudShape(here, 1, glm::dvec2{0.0}).layers[0];
    float const water = weather::CloudColumns{here, 1}.bare().layers[0].water;
    std::vector<float> result;
    unsigned hash = 7;
    auto const unit = [&] { return glsl::unitFromHash(hash = glsl::hashOf(hash)); };
    // Of real places it takes more: their ranks are not stratified.
    int const columns = shape.body.z > 0.0f ? kRealColumns : kColumns;
    for (int i = 0; i < columns; ++i) {
        float const rank = (static_cast<float>(i) + unit()) / static_cast<float>(columns);  // stratified: the rank is uniform
        glsl::LayerColumn column{rank, 0.0f, layer.base, layer.top, water, 1.0f};
        glm::vec2 const place{65536.0f * unit(), 65536.0f * unit()};
        if (shape.body.z > 0.0f) {  // the ranks of tower and anvil belong together: those of real places and moments
            layer.pattern = hash;
            layer.phase = 24.0 * static_cast<double>(unit());
            column = weather::CloudColumns{withLayer(here, layer), 1}.at(static_cast<double>(place.x), -static_cast<double>(place.y)).layers[0];
        }
        result.push_back(crossing(column, shape, place, weather::coverDepth(layer.genus), noise));
    }
    std::sort(result.begin(), result.end());
    return result;
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
                // How far an anvil is carried depends on its cover; what has none looks alike whatever its cover is.
                if (i == 0 || weather::anvilWay(here.layers[0]).w > 0.0f) sorted = crossings(here, noise);
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
