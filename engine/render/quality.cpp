#include "engine/render/quality.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace luftpost::render {
namespace {
struct Preset {
    float resolution;
    int triangles, cloudSteps;
    bool vegetation, smoothEdges;
    float rays;  // of the clouds, a frame
};
/// low, medium, high, ultra.
constexpr std::array<Preset, 4> kPresets{{{0.5f, 100'000, 48, false, false, 0.0625f},
                                          {0.75f, 200'000, 72, true, true, 0.0625f},
                                          {1.0f, 300'000, 96, true, true, 0.0625f},
                                          {1.0f, 1'000'000, 160, true, true, 0.25f}}};

constexpr double kMemory = 10.0;      // frames
constexpr int kSettle = 20;           // frames between two changes of size
constexpr double kTooSlow = 1.06;     // times the time of a frame asked for: smaller
constexpr double kFast = 0.82;        // larger
constexpr float kStep = 1.0f / 16.0f;
}  // namespace

void applyQuality(Quality quality, GraphicsSettings& graphics, weather::CloudSettings& clouds) {
    if (quality == Quality::own) return;
    Preset const& preset = kPresets[static_cast<std::size_t>(quality) - 1];
    graphics.resolution = preset.resolution;
    graphics.triangles = preset.triangles;
    graphics.cloudSteps = preset.cloudSteps;
    graphics.vegetation = preset.vegetation;
    graphics.smoothEdges = preset.smoothEdges;
    clouds.rays = std::max(clouds.rays, preset.rays);
}

bool decidedByQuality(std::string_view key) {
    constexpr std::array<std::string_view, 5> kKeys{"graphics.resolution", "graphics.triangles", "graphics.cloud_steps", "graphics.vegetation",
                                                    "graphics.smooth_edges"};
    return std::find(kKeys.begin(), kKeys.end(), key) != kKeys.end();
}

void ResolutionScale::note(double frameSeconds, int framesPerSecond) {
    if (framesPerSecond <= 0 || frameSeconds <= 0.0) return;
    mean_ = mean_ > 0.0 ? mean_ + (frameSeconds - mean_) / kMemory : frameSeconds;
    if (++settled_ < kSettle) return;
    double const share = mean_ * framesPerSecond;
    if (share > kTooSlow) {
        // What takes time goes by the number of pixels, at most; not by more than two steps in three at once.
        auto const wanted = static_cast<float>(static_cast<double>(scale_) / std::sqrt(std::min(share, 1.5)));
        scale_ = std::max(std::min(std::floor(wanted / kStep) * kStep, scale_ - kStep), kSmallest);
    } else if (share < kFast && scale_ < 1.0f) {
        scale_ = std::min((std::floor(scale_ / kStep + 0.5f) + 1.0f) * kStep, 1.0f);
    } else {
        return;
    }
    settled_ = 0;
    mean_ = 0.0;
}

float ResolutionScale::scale(float most, int framesPerSecond) const { return framesPerSecond > 0 ? most * scale_ : most; }
}  // namespace luftpost::render
