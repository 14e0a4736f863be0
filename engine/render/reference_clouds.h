// The clouds of a snapshot on the CPU, for the path tracer: the one density at lod 0 over the ranks that the cloud map
// samples, and bounds of it by cells, so that free flights leave out what is empty. No GL; immutable once made, any thread.
#pragma once
#include <array>
#include <memory>
#include <vector>

#include "engine/render/snapshot.h"
#include "engine/sky/path_tracer.h"
#include "engine/weather/noise_volume.h"
#include "shaders/lib/cloud.glsl"

namespace luftpost::render {
/// Samples of one function over a square around the camera, read bilinearly.
class PlaneMap {
public:
    PlaneMap(double width, int size) : width_{width}, size_{size}, values_(static_cast<std::size_t>(size) * static_cast<std::size_t>(size)) {}
    double width() const { return width_; }
    int size() const { return size_; }
    double texel() const { return width_ / size_; }
    bool covers(double x, double z) const { return std::abs(x) < 0.5 * width_ - texel() && std::abs(z) < 0.5 * width_ - texel(); }
    float at(double x, double z) const;
    float& texelAt(int column, int row) { return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column)]; }
    float texelAt(int column, int row) const { return values_[static_cast<std::size_t>(row) * static_cast<std::size_t>(size_) + static_cast<std::size_t>(column)]; }
    float* row(int index) { return values_.data() + static_cast<std::size_t>(index) * static_cast<std::size_t>(size_); }

private:
    double width_;  // m
    int size_;      // texels each way
    std::vector<float> values_;
};

class ReferenceClouds {
public:
    /// Places: flat, m; x east and z south of the snapshot's camera, y above sea level. Takes a second or two on `workers`
    /// threads. `noise` must outlive it. Clouds reach 192 km; none beyond.
    ReferenceClouds(Snapshot const& snapshot, weather::NoiseVolumes const& noise, int workers);

    /// 1/m: of droplets and of ice (Ci, Cc, Cs).
    struct Extinction {
        float droplets = 0.0f;
        float ice = 0.0f;
    };
    Extinction at(glm::dvec3 const& place) const;

    bool empty() const { return layerCount_ == 0; }
    double lowest() const { return lowest_; }    // m above sea level: no cloud below
    double highest() const { return highest_; }  // nor above
    /// The bounds at a place and how far they hold along `velocity` (per m of way, flat), m of way.
    struct Bound {
        float most = 0.0f;   // 1/m
        float sure = 0.0f;   // 1/m of droplets: deep in a cloud nearly all of it, else 0
        double reach = 0.0;
    };
    Bound bound(glm::dvec3 const& place, glm::dvec3 const& velocity) const;

    /// About the transmittance of the clouds from a place toward the sun, above 0. Needs makeSunGuess first.
    float sunGuess(glm::dvec3 const& place) const;
    void makeSunGuess(glm::dvec3 const& towardSun, int workers);

private:
    struct Cell {
        float most = 0.0f, sure = 0.0f;  // as Bound's
    };
    /// Bounds over a square around the camera: by cells and slabs of height, by groups of 4 x 4 x 4 of these, and by blocks of cells
    /// over all heights.
    struct Grid {
        double width = 0.0;
        double cell = 0.0;
        int size = 0;
        std::vector<Cell> cells, groups;
        std::vector<float> blocks;
        bool covers(double x, double z) const { return std::abs(x) < 0.5 * width && std::abs(z) < 0.5 * width; }
    };
    glsl::LayerColumn columnAt(int layer, glm::dvec3 const& place) const;
    struct LeastRank { float tower, anvil; };
    void makeRanks(Snapshot const& snapshot, weather::Weather const& sky, int workers);
    static void makeGroups(Grid& grid);
    double boxReach(Grid const& grid, glm::dvec3 const& place, glm::dvec3 const& velocity, glm::ivec3 const& cell, int cells) const;
    void makeGrid(Grid& grid, std::size_t level, int workers);
    struct Probe {
        float extinction = 0.0f;  // 1/m
        float inside = 0.0f;      // m from the nearest face, about
    };
    std::vector<Probe> probesOf(Grid const& grid, int layer, int row) const;
    void boundCell(Grid& grid, std::size_t level, int layer, int column, int row, std::vector<Probe> const& probes) const;
    void narrow(Cell& cell, Probe const* first, float across) const;
    float slabBound(int layer, glm::vec4 const& low, glm::vec4 const& high, LeastRank const& rank, double bottom) const;
    glsl::CloudSample sampleOf(int layer, glm::dvec3 const& place) const;

    int layerCount_ = 0;
    glsl::CloudShape shape_;
    std::array<glsl::LayerField, weather::kMaxLayers> fields_{};
    weather::NoiseVolumes const& noise_;
    std::array<std::vector<PlaneMap>, 2> ranks_;  // [near, far][layer]
    std::array<Grid, 2> grids_;
    double lowest_ = 0.0, highest_ = 0.0;
    glm::dvec2 lean_{0.0};            // m east and south that the way to the sun goes for each m up
    std::vector<float> sunDepths_;    // optical depths of the clouds toward the sun: [row, column, slab], at the lowest base
};
}  // namespace luftpost::render
