#include "engine/render/reference_clouds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "engine/render/cloud_field.h"
#include "engine/weather/cloud_column.h"
#include "shaders/lib/cloud.glsl"

namespace luftpost::render {
namespace {
constexpr std::array<double, 2> kWidths{64'000.0, 384'000.0};  // m, of ranks and bounds
constexpr int kRanks = 2048;    // texels of a map, each way
constexpr int kCellTexels = 8;  // of the ranks in a cell
constexpr int kBlockCells = 8;
constexpr int kSlabs = 40;      // from the lowest base to the highest top

/// Runs work(row) for rows 0..count-1 on threads.
template <class Work>
void inRows(int count, int workers, Work const& work) {
    std::atomic<int> next{0};
    auto const run = [&] { for (int row = next++; row < count; row = next++) work(row); };
    std::vector<std::jthread> threads;
    for (int i = 1; i < workers; ++i) threads.emplace_back(run);
    run();
}

/// m of way until a coordinate that changes by `speed` per m leaves low..high.
double leaves(double value, double speed, double low, double high) {
    if (speed > 0.0) return (high - value) / speed;
    return speed < 0.0 ? (low - value) / speed : sky::kNever;
}
}  // namespace

float PlaneMap::at(double x, double z) const {
    double const u = (x / width_ + 0.5) * size_ - 0.5, v = (z / width_ + 0.5) * size_ - 0.5;
    int const column = std::clamp(static_cast<int>(std::floor(u)), 0, size_ - 2), line = std::clamp(static_cast<int>(std::floor(v)), 0, size_ - 2);
    float const fu = static_cast<float>(u - column), fv = static_cast<float>(v - line);
    return glm::mix(glm::mix(texelAt(column, line), texelAt(column + 1, line), fu),
                    glm::mix(texelAt(column, line + 1), texelAt(column + 1, line + 1), fu), fv);
}

ReferenceClouds::ReferenceClouds(Snapshot const& snapshot, weather::NoiseVolumes const& noise, int workers) : noise_{noise} {
    if (!snapshot.drawClouds || snapshot.field == nullptr) return;
    weather::Weather const sky = skyAround(snapshot);
    layerCount_ = sky.layerCount;
    if (layerCount_ == 0) return;
    glm::dvec2 const eastNorth{snapshot.camera.positionWorld.x, -snapshot.camera.positionWorld.z};
    shape_ = weather::cloudShape(sky, snapshot.seed, eastNorth, snapshot.clouds);
    fields_ = layerFields(snapshot, sky);
    lowest_ = sky::kNever;
    highest_ = -sky::kNever;
    for (int i = 0; i < layerCount_; ++i) {
        glsl::LayerField const& field = fields_[static_cast<std::size_t>(i)];
        lowest_ = std::min(lowest_, static_cast<double>(field.low.y));
        highest_ = std::max(highest_, static_cast<double>(field.high.z));
    }
    makeRanks(snapshot, sky, workers);
    for (std::size_t level = 0; level < grids_.size(); ++level) makeGrid(grids_[level], level, workers);
}

void ReferenceClouds::makeRanks(Snapshot const& snapshot, weather::Weather const& sky, int workers) {
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    auto const scale = static_cast<double>(snapshot.clouds.weatherScale);
    for (int layer = 0; layer < layerCount_; ++layer) {
        weather::LayerPattern const pattern{sky.layers[static_cast<std::size_t>(layer)], snapshot.seed};
        glm::dvec2 const start{camera.x - pattern.drift().x, -camera.z - pattern.drift().y};
        for (std::size_t level = 0; level < kWidths.size(); ++level) {
            PlaneMap map{kWidths[level], kRanks};
            inRows(kRanks, workers, [&](int row) {
                std::vector<double> east(kRanks), north(kRanks);
                for (std::size_t i = 0; i < kRanks; ++i) {
                    east[i] = (start.x + (static_cast<double>(i) + 0.5) * map.texel() - 0.5 * map.width()) / scale;
                    north[i] = (start.y - (row + 0.5) * map.texel() + 0.5 * map.width()) / scale;
                }
                pattern.drifting(east, north, {map.row(row), kRanks});
            });
            ranks_[level].push_back(std::move(map));
        }
    }
}

void ReferenceClouds::makeGrid(Grid& grid, std::size_t level, int workers) {
    grid.width = kWidths[level];
    grid.size = kRanks / kCellTexels;
    grid.cell = grid.width / grid.size;
    int const blocks = grid.size / kBlockCells;
    grid.cells.assign(static_cast<std::size_t>(grid.size) * static_cast<std::size_t>(grid.size) * kSlabs, 0.0f);
    grid.blocks.assign(static_cast<std::size_t>(blocks) * static_cast<std::size_t>(blocks), 0.0f);
    inRows(grid.size, workers, [&](int row) { for (int column = 0; column < grid.size; ++column) boundCell(grid, level, column, row); });
    for (int row = 0; row < grid.size; ++row)
        for (int column = 0; column < grid.size; ++column) {
            auto const first = grid.cells.begin() + (row * grid.size + column) * kSlabs;
            float& block = grid.blocks[static_cast<std::size_t>(row / kBlockCells * blocks + column / kBlockCells)];
            block = std::max(block, *std::max_element(first, first + kSlabs));
        }
}

void ReferenceClouds::boundCell(Grid& grid, std::size_t level, int column, int row) const {
    float* const out = grid.cells.data() + static_cast<std::size_t>(row * grid.size + column) * kSlabs;
    double const west = column * grid.cell - 0.5 * grid.width, north = row * grid.cell - 0.5 * grid.width;
    double const slab = (highest_ - lowest_) / kSlabs;
    for (int layer = 0; layer < layerCount_; ++layer) {
        PlaneMap const& ranks = ranks_[level][static_cast<std::size_t>(layer)];
        // The least rank of the cell, or of where it is `aside` m.
        auto const leastAt = [&](glm::vec2 const& aside) {
            glm::ivec2 const shift{glm::round(glm::dvec2{aside} / ranks.texel())};
            glm::ivec2 const first = glm::clamp(glm::ivec2{column, row} * kCellTexels - 2 + shift, 0, kRanks - 1);
            glm::ivec2 const last = glm::clamp(glm::ivec2{column + 1, row + 1} * kCellTexels + 1 + shift, 0, kRanks - 1);
            float least = 1.0f;
            for (int z = first.y; z <= last.y; ++z)
                for (int x = first.x; x <= last.x; ++x) least = std::min(least, ranks.texelAt(x, z));
            return least;
        };
        glsl::LayerShape const& s = shape_.layers[layer];
        LeastRank least{leastAt(glm::vec2{0.0f}), 1.0f};
        glm::vec2 const carried{s.fibre.x, s.fibre.y};
        if (s.body.z > 0.0f) least.anvil = glsl::anvilRank(leastAt(-s.fibre.z * carried), leastAt(-carried), s.fibre.w);
        // What is linear has its extremes in the corners.
        glsl::LayerField const& field = fields_[static_cast<std::size_t>(layer)];
        glm::vec4 low{1.0e9f}, high{-1.0e9f};
        for (int corner = 0; corner < 4; ++corner) {
            auto const x = static_cast<float>(west + (corner & 1) * grid.cell), z = static_cast<float>(north + (corner >> 1) * grid.cell);
            glm::vec4 const v = glm::clamp(field.centre + field.eastward * x + field.southward * z, field.low, field.high);
            low = glm::min(low, v);
            high = glm::max(high, v);
        }
        for (int i = 0; i < kSlabs; ++i) out[i] += slabBound(layer, low, high, least, lowest_ + i * slab);
    }
}

/// The most that a layer has in a slab whose bottom is at `bottom`: nothing where even the largest envelope stays below.
float ReferenceClouds::slabBound(int layer, glm::vec4 const& low, glm::vec4 const& high, LeastRank const& rank, double bottom) const {
    glsl::LayerShape const& s = shape_.layers[layer];
    double const slab = (highest_ - lowest_) / kSlabs;
    double const base = static_cast<double>(low.y), top = static_cast<double>(high.z);
    if (bottom > top || bottom + slab < base) return 0.0f;
    float const full = high.w * s.look.w;
    float const margin = high.x - rank.tower + s.look.y;
    if (s.look.z > 0.5f) {
        if (margin <= 0.0f) return 0.0f;
        float const thickness = high.z - low.y;
        return (0.07f + 1.96f * full * thickness) * 1.5f / std::max(low.z - high.y, 20.0f);
    }
    float const towers = glsl::towerCover(high.x, s) - rank.tower + s.look.y;
    float const rise = towers > 0.0f ? glsl::riseAt(towers, glsl::towerWidth(glsl::towerCover(low.x, s), s), s) : -1.0f;
    bool const tower = bottom < base + static_cast<double>(rise) * (top - base);
    bool const anvil = s.body.z > 0.0f && high.x - rank.anvil + glsl::anvilFray(high.x) > 0.0f && bottom + slab > base + static_cast<double>(glsl::kAnvilFoot) * (top - base);
    return (tower ? 1.1f * full : 0.0f) + (anvil ? 1.7f * glsl::kAnvilIce * full : 0.0f);
}

glsl::LayerColumn ReferenceClouds::columnAt(int layer, glm::dvec3 const& place) const {
    auto const i = static_cast<std::size_t>(layer);
    PlaneMap const& near = ranks_[0][i];
    PlaneMap const& ranks = near.covers(place.x, place.z) ? near : ranks_[1][i];
    glsl::LayerField const& field = fields_[i];
    glm::vec4 const v = glm::clamp(field.centre + field.eastward * static_cast<float>(place.x) + field.southward * static_cast<float>(place.z),
                                   field.low, field.high);
    auto const rankAt = [&](double x, double z) { return ranks.covers(x, z) ? ranks.at(x, z) : 1.0f; };
    glsl::LayerColumn column{rankAt(place.x, place.z), v.x, v.y, v.z, v.w, 1.0f};
    glsl::LayerShape const& s = shape_.layers[layer];
    glm::dvec2 const carried{s.fibre.x, s.fibre.y}, less = static_cast<double>(s.fibre.z) * carried;
    if (s.body.z > 0.0f) column.anvil = glsl::anvilRank(rankAt(place.x - less.x, place.z - less.y), rankAt(place.x - carried.x, place.z - carried.y), s.fibre.w);
    return column;
}

ReferenceClouds::Extinction ReferenceClouds::at(glm::dvec3 const& place) const {
    Extinction sum;
    if (!grids_.back().covers(place.x, place.z)) return sum;
    glm::vec3 const p{place};
    for (int layer = 0; layer < layerCount_; ++layer) {
        glsl::LayerField const& field = fields_[static_cast<std::size_t>(layer)];
        if (place.y <= static_cast<double>(field.low.y) || place.y >= static_cast<double>(field.high.z)) continue;
        glsl::LayerShape const& shape = shape_.layers[layer];
        float const extinction = glsl::layerSample(p, columnAt(layer, place), shape, noise_.shape.sampler(),
                                                   noise_.detail.sampler(), noise_.curl.plane(), 0.0f).extinction;
        (shape.look.z > 0.5f ? sum.ice : sum.droplets) += extinction;
    }
    return sum;
}

ReferenceClouds::Bound ReferenceClouds::bound(glm::dvec3 const& place, glm::dvec3 const& velocity) const {
    constexpr double kNudge = 0.01;  // m: over the face
    double const slab = (highest_ - lowest_) / kSlabs;
    for (Grid const& grid : grids_) {
        if (!grid.covers(place.x, place.z)) continue;
        int const column = std::clamp(static_cast<int>((place.x + 0.5 * grid.width) / grid.cell), 0, grid.size - 1);
        int const row = std::clamp(static_cast<int>((place.z + 0.5 * grid.width) / grid.cell), 0, grid.size - 1);
        int const blocks = grid.size / kBlockCells;
        bool const empty = grid.blocks[static_cast<std::size_t>(row / kBlockCells * blocks + column / kBlockCells)] <= 0.0f;
        int const share = empty ? kBlockCells : 1;
        double const side = grid.cell * share;
        double const west = column / share * side - 0.5 * grid.width, north = row / share * side - 0.5 * grid.width;
        double reach = std::min(leaves(place.x, velocity.x, west, west + side), leaves(place.z, velocity.z, north, north + side));
        if (empty) return {0.0f, reach + kNudge};
        int const height = std::clamp(static_cast<int>((place.y - lowest_) / slab), 0, kSlabs - 1);
        reach = std::min(reach, leaves(place.y, velocity.y, lowest_ + height * slab, lowest_ + (height + 1) * slab));
        return {grid.cells[static_cast<std::size_t>(row * grid.size + column) * kSlabs + static_cast<std::size_t>(height)], std::max(reach, 0.0) + kNudge};
    }
    return {0.0f, 1000.0};
}
}  // namespace luftpost::render
