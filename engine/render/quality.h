// Presets of how fine the picture is, and the size that holds a frame rate.
#pragma once
#include "engine/render/graphics_settings.h"
#include "engine/weather/cloud_settings.h"

namespace luftpost::render {
/// The settings that a preset decides are its own, the others stay; `Quality::own` changes nothing. Clouds: never fewer rays than
/// the preset's.
void applyQuality(Quality quality, GraphicsSettings& graphics, weather::CloudSettings& clouds);
/// Whether presets decide this setting.
bool decidedByQuality(std::string_view key);

/// The size of the picture, per side against the window's, at which frames come as fast as wished.
class ResolutionScale {
public:
    static constexpr float kSmallest = 0.4f;

    /// Takes how long the latest frame took, s; 0: nothing is known. Steps of a sixteenth, some frames apart.
    void note(double frameSeconds, int framesPerSecond);
    /// `most` at the most; `most` itself when no frame rate is asked for.
    float scale(float most, int framesPerSecond) const;

private:
    double mean_ = 0.0;  // s a frame takes, over the last frames
    float scale_ = 1.0f;
    int settled_ = 0;    // frames since the size changed
};
}  // namespace luftpost::render
