#include "engine/render/reference_clouds.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "engine/render/cloud_field.h"
#include "engine/weather/cloud_column.h"
#include "shaders/lib/cloud.glsl"

#if defined(__x86_64__) && defined(__GNUC__) && !defined(__clang__) && !defined(__SANITIZE_ADDRESS__) && !defined(__SANITIZE_THREAD__)
#define LUFTPOST_HOT [[gnu::flatten, gnu::target_clones("default", "arch=x86-64-v3")]]
#else
#define LUFTPOST_HOT
#endif

namespace luftpost::render {
namespace {
constexpr std::array<double, 2> kWidths{64'000.0, 384'000.0};  // m, of ranks and bounds
constexpr int kRanks = 2048;    // texels of a map, each way
constexpr int kCellTexels = 2;  // of the ranks in a cell
constexpr int kGroupCells = 4;  // cells and slabs of a group, each way
constexpr int kBlockCells = 16;
constexpr int kSlabs = 40;      // from the lowest base to the highest top
constexpr int kGroupSlabs = kSlabs / kGroupCells;
constexpr double kProbed = 16'000.0;  // m from the camera, within which bounds are narrowed
constexpr double kGuessCell = 100.0;  // m, of the depths toward the sun
constexpr int kGuessSize = 480, kGuessSlabs = 32;

/// Runs work(row) for rows 0..count-1 on threads.
template <class Work>
void inRows(int count, int workers, Work const& work) {
    std::atomic<int> next{0};
    auto const run = [&] { for (int row = next++; row < count; row = next++) work(row); };
    std::vector<std::jthread> threads;
    for (int i = 1; i < workers; ++i) threads.emplace_back(run);
    run();
}

/// m of way until a coordinate that changes by `speed` per m leaves low..high; never, where it stands still but for roundings.
double leaves(double value, double speed, double low, double high) {
    constexpr double kStill = 1e-9;
    if (speed > kStill) return (high - value) / speed;
    return speed < -kStill ? (low - value) / speed : sky::kNever;
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
    grid.cells.assign(static_cast<std::size_t>(grid.size) * static_cast<std::size_t>(grid.size) * kSlabs, Cell{});
    grid.blocks.assign(static_cast<std::size_t>(blocks) * static_cast<std::size_t>(blocks), 0.0f);
    inRows(grid.size, workers, [&](int row) {
        for (int layer = 0; layer < layerCount_; ++layer) {
            std::vector<Probe> const probes = level == 0 ? probesOf(grid, layer, row) : std::vector<Probe>{};
            for (int column = 0; column < grid.size; ++column) boundCell(grid, level, layer, column, row, probes);
        }
    });
    makeGroups(grid);
}

/// The bounds of groups of cells, and of blocks of cells over all heights.
void ReferenceClouds::makeGroups(Grid& grid) {
    int const groups = grid.size / kGroupCells, blocks = grid.size / kBlockCells;
    grid.groups.assign(static_cast<std::size_t>(groups * groups * kGroupSlabs), Cell{0.0f, 1.0f});
    for (int row = 0; row < grid.size; ++row)
        for (int column = 0; column < grid.size; ++column) {
            float& block = grid.blocks[static_cast<std::size_t>(row / kBlockCells * blocks + column / kBlockCells)];
            for (int i = 0; i < kSlabs; ++i) {
                Cell const& cell = grid.cells[static_cast<std::size_t>((row * grid.size + column) * kSlabs + i)];
                Cell& group = grid.groups[static_cast<std::size_t>((row / kGroupCells * groups + column / kGroupCells) * kGroupSlabs + i / kGroupCells)];
                group = {std::max(group.most, cell.most), std::min(group.sure, cell.sure)};
                block = std::max(block, cell.most);
            }
        }
}

void ReferenceClouds::boundCell(Grid& grid, std::size_t level, int layer, int column, int row, std::vector<Probe> const& probes) const {
    Cell* const out = grid.cells.data() + static_cast<std::size_t>(row * grid.size + column) * kSlabs;
    double const west = column * grid.cell - 0.5 * grid.width, north = row * grid.cell - 0.5 * grid.width;
    double const slab = (highest_ - lowest_) / kSlabs;
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
    // Storms fill all slabs, which are then several cells high, and their turrets are as deep: there it takes as much more to be sure.
    auto const across = static_cast<float>(s.body.z > 0.0f ? std::max(grid.cell, slab) : grid.cell);
    for (int i = 0; i < kSlabs; ++i) {
        Cell cell{slabBound(layer, low, high, least, lowest_ + i * slab), 0.0f};
        if (!probes.empty() && cell.most > 0.0f) narrow(cell, probes.data() + column * (kSlabs + 1) + i, across);
        out[i].most += cell.most;
        out[i].sure += cell.sure;
    }
}

/// The clouds of a layer along a row of cells, in three lines: at the cells' north-western corners, at their middles and at their
/// south-western corners. A line is one column longer than the row and one height higher than the slabs. Nothing where it is far.
std::vector<ReferenceClouds::Probe> ReferenceClouds::probesOf(Grid const& grid, int layer, int row) const {
    double const north = row * grid.cell - 0.5 * grid.width;
    if (shape_.layers[layer].look.z > 0.5f || std::abs(north) > kProbed) return {};
    double const slab = (highest_ - lowest_) / kSlabs;
    std::vector<Probe> probes(static_cast<std::size_t>(3 * (grid.size + 1) * (kSlabs + 1)));
    for (int line = 0; line < 3; ++line)
        for (int column = 0; column <= grid.size; ++column) {
            double const middle = line == 1 ? 0.5 : 0.0;
            double const x = (column + middle) * grid.cell - 0.5 * grid.width, z = north + 0.5 * line * grid.cell;
            if (std::abs(x) > kProbed) continue;
            for (int i = 0; i <= kSlabs; ++i) {
                glm::dvec3 const place{x, lowest_ + (i + middle) * slab, z};
                glsl::CloudSample const here = sampleOf(layer, place);
                float const full = columnAt(layer, place).water * shape_.layers[layer].look.w;
                probes[static_cast<std::size_t>((line * (grid.size + 1) + column) * (kSlabs + 1) + i)] = {here.extinction, here.extinction > 0.0f ? here.depth / full : -std::max(here.outside, 0.0f)};
            }
        }
    return probes;
}

/// Narrows the bounds of a cell by what its middle and its corners have: deep in a cloud the least of that is sure, and far from all
/// there is next to nothing. `across`: m, how large a cell is for that. A bound that something breaks between them is still right in the mean (sky/path_tracer.h).
void ReferenceClouds::narrow(Cell& cell, Probe const* first, float across) const {
    int const line = (static_cast<int>(ranks_[0].front().size()) / kCellTexels + 1) * (kSlabs + 1);
    Probe const* const middle = first + line;
    float least = middle->extinction, innermost = middle->inside, outermost = middle->inside;
    for (Probe const* corner : {first, first + 1, first + kSlabs + 1, first + kSlabs + 2}) {
        for (Probe const* p : {corner, corner + 2 * line}) {
            least = std::min(least, p->extinction);
            innermost = std::max(innermost, p->inside);
            outermost = std::min(outermost, p->inside);
        }
    }
    if (outermost > 0.6f * across) cell.sure = 0.92f * least;
    if (innermost < -0.4f * across) cell.most *= 0.05f;
    cell.sure = std::min(cell.sure, 0.98f * cell.most);
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
    float const rise = towers > 0.0f ? glsl::riseAt(towers, glsl::towerCover(high.x, s), s) : -1.0f;
    bool const tower = bottom < base + static_cast<double>(rise) * (top - base);
    bool const anvil = s.body.z > 0.0f && high.x - rank.anvil + glsl::anvilFray(high.x) > 0.0f && bottom + slab > base + static_cast<double>(glsl::kAnvilFoot) * (top - base);
    float const share = std::clamp(static_cast<float>((bottom + slab - base) / (top - base)), 0.0f, 1.0f);
    return (tower ? glm::mix(0.55f, 1.1f, share) * full : 0.0f) + (anvil ? 1.7f * glsl::kAnvilIce * full : 0.0f);
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

// The hottest place of the tracer: all in one function, for the one lod, with the instructions that the machine has. Nothing is
// contracted, so the bits are the same on all.
LUFTPOST_HOT glsl::CloudSample ReferenceClouds::sampleOf(int layer, glm::dvec3 const& place) const {
    return glsl::layerSample(glm::vec3{place}, columnAt(layer, place), shape_.layers[layer], noise_.shape.sampler(), noise_.detail.sampler(),
                             noise_.curl.plane(), 0.0f);
}

ReferenceClouds::Extinction ReferenceClouds::at(glm::dvec3 const& place) const {
    Extinction sum;
    if (!grids_.back().covers(place.x, place.z)) return sum;
    for (int layer = 0; layer < layerCount_; ++layer) {
        glsl::LayerField const& field = fields_[static_cast<std::size_t>(layer)];
        if (place.y <= static_cast<double>(field.low.y) || place.y >= static_cast<double>(field.high.z)) continue;
        (shape_.layers[layer].look.z > 0.5f ? sum.ice : sum.droplets) += sampleOf(layer, place).extinction;
    }
    return sum;
}

/// How far it is out of the box that a cell lies in, `cells` wide and high, or as high as all slabs.
double ReferenceClouds::boxReach(Grid const& grid, glm::dvec3 const& place, glm::dvec3 const& velocity, glm::ivec3 const& cell, int cells) const {
    double const slab = (highest_ - lowest_) / kSlabs, side = grid.cell * cells;
    double const nudge = 0.01 + 3e-4 * grid.cell;  // m: over the face, although the way is not straight on the flat map
    double const west = cell.x / cells * side - 0.5 * grid.width, north = cell.z / cells * side - 0.5 * grid.width;
    double const bottom = cells == kBlockCells ? lowest_ : lowest_ + cell.y / cells * cells * slab;
    double const top = cells == kBlockCells ? highest_ : bottom + cells * slab;
    double const reach = std::min(leaves(place.x, velocity.x, west, west + side),
                                  std::min(leaves(place.z, velocity.z, north, north + side), leaves(place.y, velocity.y, bottom, top)));
    return std::max(reach, 0.0) + nudge;
}

ReferenceClouds::Bound ReferenceClouds::bound(glm::dvec3 const& place, glm::dvec3 const& velocity) const {
    constexpr float kThin = 0.004f;  // 1/m: what lies between clouds, a tenth of what is in them
    constexpr float kAlike = 0.75f;  // share of the most that is sure
    double const slab = (highest_ - lowest_) / kSlabs;
    for (Grid const& grid : grids_) {
        if (!grid.covers(place.x, place.z)) continue;
        int const column = std::clamp(static_cast<int>((place.x + 0.5 * grid.width) / grid.cell), 0, grid.size - 1);
        int const row = std::clamp(static_cast<int>((place.z + 0.5 * grid.width) / grid.cell), 0, grid.size - 1);
        int const blocks = grid.size / kBlockCells;
        bool const empty = grid.blocks[static_cast<std::size_t>(row / kBlockCells * blocks + column / kBlockCells)] <= 0.0f;
        if (empty) return {0.0f, 0.0f, boxReach(grid, place, velocity, {column, 0, row}, kBlockCells)};
        int const height = std::clamp(static_cast<int>((place.y - lowest_) / slab), 0, kSlabs - 1);
        int const groups = grid.size / kGroupCells;
        Cell cell = grid.groups[static_cast<std::size_t>((row / kGroupCells * groups + column / kGroupCells) * kGroupSlabs + height / kGroupCells)];
        // A group that is all alike is as good as its cells, and larger.
        if (cell.most <= kThin || cell.sure > kAlike * cell.most) return {cell.most, cell.sure, boxReach(grid, place, velocity, {column, height, row}, kGroupCells)};
        cell = grid.cells[static_cast<std::size_t>(row * grid.size + column) * kSlabs + static_cast<std::size_t>(height)];
        return {cell.most, cell.sure, boxReach(grid, place, velocity, {column, height, row}, 1)};
    }
    return {0.0f, 0.0f, std::min(1000.0, std::max(leaves(place.y, velocity.y, lowest_, highest_), 0.0) + 0.01)};
}

// Optical depths by columns that lean with the light, from the top down: coarse, for they only say how often a way is followed.
void ReferenceClouds::makeSunGuess(glm::dvec3 const& towardSun, int workers) {
    if (empty() || towardSun.y < 0.02) return;
    lean_ = glm::dvec2{towardSun.x, towardSun.z} / towardSun.y;
    double const slab = (highest_ - lowest_) / kGuessSlabs;
    std::vector<float> depths(static_cast<std::size_t>(kGuessSize) * kGuessSize * kGuessSlabs);
    // Down along the way of the light, which the columns lean with.
    inRows(kGuessSize, workers, [&](int row) {
        for (int column = 0; column < kGuessSize; ++column) {
            float depth = 0.0f;
            for (int i = kGuessSlabs - 1; i >= 0; --i) {
                double const up = (i + 0.5) * slab;
                glm::dvec3 const place{(column + 0.5 - 0.5 * kGuessSize) * kGuessCell + up * lean_.x, lowest_ + up,
                                       (row + 0.5 - 0.5 * kGuessSize) * kGuessCell + up * lean_.y};
                Extinction const here = at(place);
                depth += (here.droplets + here.ice) * static_cast<float>(slab / towardSun.y);
                depths[static_cast<std::size_t>(row * kGuessSize + column) * kGuessSlabs + static_cast<std::size_t>(i)] = depth;
            }
        }
    });
    sunDepths_ = std::move(depths);
}

float ReferenceClouds::sunGuess(glm::dvec3 const& place) const {
    constexpr float kLeast = 0.01f;  // where the guess is worst a way counts a hundred times, no more
    if (sunDepths_.empty() || place.y >= highest_) return 1.0f;
    double const up = place.y - lowest_;
    double const x = (place.x - up * lean_.x) / kGuessCell + 0.5 * kGuessSize, z = (place.z - up * lean_.y) / kGuessCell + 0.5 * kGuessSize;
    if (!(x >= 0.0 && z >= 0.0 && x < kGuessSize && z < kGuessSize)) return 1.0f;
    // A depth holds at the bottom of its slab.
    double const height = std::clamp(up / (highest_ - lowest_) * kGuessSlabs, 0.0, kGuessSlabs - 1.0);
    auto const slab = static_cast<std::size_t>(height);
    float const* const depths = sunDepths_.data() + static_cast<std::size_t>(static_cast<int>(z) * kGuessSize + static_cast<int>(x)) * kGuessSlabs;
    float const above = slab + 1 < kGuessSlabs ? depths[slab + 1] : 0.0f;
    return kLeast + (1.0f - kLeast) * std::exp(-glm::mix(depths[slab], above, static_cast<float>(height - static_cast<double>(slab))));
}
}  // namespace luftpost::render
