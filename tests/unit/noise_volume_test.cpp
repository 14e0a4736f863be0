// The noise volumes: files, mipmaps, and a sampler that reads as GLSL's does.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>

#include "engine/core/error.h"
#include "engine/weather/noise_volume.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;
using weather::NoiseVolume;

NoiseVolume small() {
    std::vector<std::uint8_t> texels(4 * 4 * 4);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 37 % 251);
    return NoiseVolume{glm::ivec3{4}, 1, texels};
}

TEST(NoiseVolume, MipmapsAreMeans) {
    NoiseVolume const volume = small();
    ASSERT_EQ(volume.levelCount(), 3);
    double mean = 0.0;
    for (std::uint8_t texel : volume.texels(0)) mean += texel / 64.0;
    EXPECT_NEAR(volume.texels(2)[0], mean, 1.0);
}

TEST(NoiseVolume, SamplerGivesTexelsAtTheirCentresAndRepeats) {
    NoiseVolume const volume = small();
    for (int x = 0; x < 4; ++x) {
        glm::vec3 const unit = (glm::vec3{x, 2, 1} + 0.5f) / 4.0f;
        float const texel = static_cast<float>(volume.texels(0)[static_cast<std::size_t>((1 * 4 + 2) * 4 + x)]) / 255.0f;
        EXPECT_NEAR(glsl::textureLod(volume.sampler(), unit, 0.0f).x, texel, 1e-5f);
        EXPECT_NEAR(glsl::textureLod(volume.sampler(), unit + glm::vec3{-3.0f, 2.0f, 1.0f}, 0.0f).x, texel, 1e-4f);
    }
}

TEST(NoiseVolume, PlanesAreReadAsSlicesOfVolumes) {
    std::vector<std::uint8_t> four, one;
    for (int i = 0; i < 16; ++i)
        for (int channel = 0; channel < 4; ++channel) four.push_back(static_cast<std::uint8_t>((4 * i + channel) * 37 % 251));
    for (int z = 0; z < 4; ++z)
        for (std::size_t i = 0; i < four.size(); i += 4) one.push_back(four[i]);
    NoiseVolume const plane{glm::ivec3{4, 4, 1}, 4, four}, volume{glm::ivec3{4}, 1, one};
    for (float lod : {0.0f, 1.0f, 2.0f})
        for (float at : {0.03f, 0.41f, 0.77f, 1.9f}) {
            glm::vec3 const unit{at, 0.6f - at, 2.0f * at};
            EXPECT_NEAR(glsl::textureLod(volume.sampler(), unit, lod).x, glsl::textureLod(plane.plane(), glm::vec2{unit.x, unit.y}, lod).x, 1e-5f) << lod << " " << at;
        }
}

TEST(NoiseVolume, FilesComeBackAsTheyWere) {
    std::filesystem::path const folder = tests::scratch();
    weather::NoiseVolumes const made = weather::makeNoise(5, 2);
    weather::writeNoise(made, folder);
    weather::NoiseVolumes const read = weather::loadNoise(folder);
    EXPECT_EQ(read.shape.texels(0), made.shape.texels(0));
    EXPECT_EQ(read.detail.texels(1), made.detail.texels(1));
    EXPECT_EQ(read.curl.texels(0), made.curl.texels(0));
    std::filesystem::resize_file(folder / "noise_curl.bin", 1000);
    EXPECT_THROW(weather::loadNoise(folder), core::Error);
    std::filesystem::remove(folder / "noise_shape.bin");
    EXPECT_THROW(weather::loadNoise(folder), core::Error);
}
}  // namespace
