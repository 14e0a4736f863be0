// The noise volumes that give clouds their third dimension: made once by the build (assets/make/noise.cpp) from
// shaders/lib/noise.glsl, loaded by GPU and CPU alike, so that both see the same cloud. No GL.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

#include <glm/glm.hpp>

#include "shaders/shared/sampler3d.glsl.h"

namespace luftpost::weather {
/// 8-bit texels of one or four channels with all mipmaps (mean of 2 x 2 x 2, rounded). Repeats in every direction. Immutable; the
/// sampler stays good as long as the volume lives and is not moved from.
class NoiseVolume {
public:
    /// Level 0: size.x * size.y * size.z * channels bytes, sizes powers of two.
    NoiseVolume(glm::ivec3 const& size, int channels, std::vector<std::uint8_t> texels);
    NoiseVolume(NoiseVolume&&) noexcept = default;  // the texels stay where they are; a copy's would not
    NoiseVolume& operator=(NoiseVolume&&) noexcept = default;

    glm::ivec3 size() const { return levels_.front().size; }
    int channels() const { return channels_; }
    int levelCount() const { return static_cast<int>(levels_.size()); }
    std::vector<std::uint8_t> const& texels(int level) const { return texels_[static_cast<std::size_t>(level)]; }
    glsl::sampler3D sampler() const { return {levels_.data(), levelCount()}; }   // of one channel
    glsl::planeSampler plane() const { return {levels_.data(), levelCount()}; }  // of four, one texel high

private:
    int channels_ = 4;
    std::vector<std::vector<std::uint8_t>> texels_;
    std::vector<glsl::VolumeLevel> levels_;
};

inline constexpr int kShapeSize = 128;   // billows, 128 x 128 x 128, one channel
inline constexpr int kDetailSize = 64;   // wisps of the edges, 64 x 64 x 64, one channel
inline constexpr int kCurlSize = 128;    // curl, fray and grain, 128 x 128 x 1
inline constexpr unsigned kNoiseSeed = 1;

struct NoiseVolumes {
    NoiseVolume shape, detail, curl;
};

/// The volumes of a seed, made on `workers` threads (about 4 s of one core).
NoiseVolumes makeNoise(unsigned seed, int workers);

/// Writes noise_shape.bin, noise_detail.bin and noise_curl.bin into an existing folder; throws core::Error.
void writeNoise(NoiseVolumes const& volumes, std::filesystem::path const& folder);

/// Reads what writeNoise wrote; throws core::Error where a file is missing or is not such a volume.
NoiseVolumes loadNoise(std::filesystem::path const& folder);
}  // namespace luftpost::weather
