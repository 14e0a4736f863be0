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
    std::vector<std::uint8_t> texels(4 * 4 * 4 * 4);
    for (std::size_t i = 0; i < texels.size(); ++i) texels[i] = static_cast<std::uint8_t>(i * 37 % 251);
    return NoiseVolume{glm::ivec3{4}, 4, texels};
}

TEST(NoiseVolume, MipmapsAreMeans) {
    NoiseVolume const volume = small();
    ASSERT_EQ(volume.levelCount(), 3);
    double mean = 0.0;
    for (std::size_t i = 0; i < volume.texels(0).size(); i += 4) mean += volume.texels(0)[i] / 64.0;
    EXPECT_NEAR(volume.texels(2)[0], mean, 1.0);
}

TEST(NoiseVolume, SamplerGivesTexelsAtTheirCentresAndRepeats) {
    NoiseVolume const volume = small();
    for (int x = 0; x < 4; ++x) {
        glm::vec3 const unit = (glm::vec3{x, 2, 1} + 0.5f) / 4.0f;
        float const texel = static_cast<float>(volume.texels(0)[static_cast<std::size_t>(((1 * 4 + 2) * 4 + x) * 4)]) / 255.0f;
        EXPECT_NEAR(glsl::textureLod(volume.sampler(), unit, 0.0f).x, texel, 1e-5f);
        EXPECT_NEAR(glsl::textureLod(volume.sampler(), unit + glm::vec3{-3.0f, 2.0f, 1.0f}, 0.0f).x, texel, 1e-4f);
    }
}

TEST(NoiseVolume, BillowsAreAChannelOfTheSame) {
    NoiseVolume const four = small();
    std::vector<std::uint8_t> texels;
    for (std::size_t i = 0; i < four.texels(0).size(); i += 4) texels.push_back(four.texels(0)[i]);
    NoiseVolume const one{glm::ivec3{4}, 1, texels};
    for (float lod : {0.0f, 1.0f, 2.0f})
        for (float at : {0.03f, 0.41f, 0.77f, 1.9f}) {
            glm::vec3 const unit{at, 0.6f - at, 2.0f * at};
            EXPECT_NEAR(glsl::textureLod(one.billows(), unit, lod).x, glsl::textureLod(four.sampler(), unit, lod).x, 1e-5f) << lod << " " << at;
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
