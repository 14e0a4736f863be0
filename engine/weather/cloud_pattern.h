// Each layer's pattern: a rank u, uniform on 0..1, over every point of the plane. Cloud stands where u is below the
// cover, so the share of the ground under cloud is the cover, whatever it is and wherever one looks. No element is
// larger than 8 km: what is larger comes from the field. Only how strong the cells of a cumulonimbus are is dealt within squares of 16 km.
#pragma once
#include <array>
#include <span>

#include <glm/glm.hpp>

#include "engine/weather/weather.h"
#include "shaders/lib/cloud_pattern.glsl"

namespace luftpost::weather {
/// How fine a rank is wanted.
enum class PatternDetail {
    Whole,   // every octave
    Coarse,  // elements of 3 km and more, for texels of 1.5 km; a rank of its own, uniform too
};

/// The period of every pattern, m.
inline constexpr double kPatternPeriod = 1048576.0;

/// One layer's pattern at one moment. Immutable, cheap to make and to copy; uses + - x / sqrt alone, so that it has the
/// same bits everywhere.
class LayerPattern {
public:
    /// Reads genus, drift, phase and pattern of the layer.
    LayerPattern(Layer const& layer, unsigned seed, PatternDetail detail = PatternDetail::Whole);

    /// The rank over a point of the world, m east and north.
    float rank(double east, double north) const { return drifting(east - drift_.x, north - drift_.y); }

    /// The rank at a point of the frame that drifts with the layer.
    float drifting(double east, double north) const;
    /// The same bits for many points, several times quicker each.
    void drifting(std::span<double const> east, std::span<double const> north, std::span<float> ranks) const;

    /// The value before its distribution makes a rank of it; the program that measures the distribution asks for it.
    float value(double east, double north) const;

    /// Unit vector along fibres and rolls, east and north: it belongs to the pattern and never turns.
    glm::vec2 axis() const;

    glm::dvec2 const& drift() const { return drift_; }

private:
    static constexpr int kOctaves = 4;
    static constexpr std::size_t kBlock = 128;  // points worked on at once
    void row(double const* east, double const* north, float* out, std::size_t count) const;
    void rowPlain(double const* east, double const* north, float* out, std::size_t count) const;
    void rowWide(double const* east, double const* north, float* out, std::size_t count) const;

    std::array<glsl::PatternOctave, kOctaves> octaves_{};
    int octaveCount_ = 0;
    glm::ivec2 warpCells_{1};
    float warpTurns_ = 0.0f;
    float warpReach_ = 0.0f;  // of the period
    unsigned seed_ = 0;
    glm::ivec2 lattice_{1, 0};  // the pattern's x axis: whole numbers, so that the turned lattice still repeats
    glm::dvec2 drift_{0.0};
    Genus genus_ = Genus::Cu;
    PatternDetail detail_ = PatternDetail::Whole;
};
}  // namespace luftpost::weather
