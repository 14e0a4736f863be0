// Presets of the picture, and the size that holds a frame rate.
#include "engine/render/quality.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <string>

#include "engine/core/settings.h"

namespace {
using namespace luftpost;
using render::Quality;

struct Picture {
    render::GraphicsSettings graphics;
    weather::CloudSettings clouds;
};

Picture pictureOf(Quality quality) {
    Picture picture;
    picture.graphics.quality = quality;
    applyQuality(quality, picture.graphics, picture.clouds);
    return picture;
}

TEST(Quality, OfOnesOwnChangesNothing) {
    render::GraphicsSettings graphics;
    graphics.triangles = 123'456;
    graphics.resolution = 0.61f;
    weather::CloudSettings clouds;
    applyQuality(Quality::own, graphics, clouds);
    EXPECT_EQ(graphics.triangles, 123'456);
    EXPECT_EQ(graphics.resolution, 0.61f);
    EXPECT_EQ(clouds.rays, weather::CloudSettings{}.rays);
}

TEST(Quality, RisesFromPresetToPreset) {
    double before = 0.0;
    for (Quality quality : {Quality::low, Quality::medium, Quality::high, Quality::ultra}) {
        Picture const p = pictureOf(quality);
        double const work = static_cast<double>(p.graphics.resolution) * p.graphics.triangles * p.graphics.cloudSteps * static_cast<double>(p.clouds.rays);
        EXPECT_GT(work, before);
        before = work;
    }
    EXPECT_EQ(pictureOf(Quality::high).graphics.triangles, render::GraphicsSettings{}.triangles) << "high is what one has without a preset";
}

TEST(Quality, DecidesJustTheSettingsThatItSays) {
    std::set<std::string> decided;
    for (Quality quality : {Quality::low, Quality::medium, Quality::high, Quality::ultra}) {
        render::GraphicsSettings odd{.resolution = 0.33f, .triangles = 77'777, .cloudSteps = 33, .vegetation = false, .smoothEdges = false};
        render::GraphicsSettings preset = odd;
        weather::CloudSettings clouds;
        applyQuality(quality, preset, clouds);
        core::SettingList a, b;
        core::appendSettings(a, odd, render::graphicsFields);
        core::appendSettings(b, preset, render::graphicsFields);
        for (std::size_t i = 0; i < a.size(); ++i)
            if (a[i].get() != b[i].get()) decided.emplace(a[i].key);
    }
    render::GraphicsSettings settings;
    core::SettingList list;
    core::appendSettings(list, settings, render::graphicsFields);
    for (core::Setting const& setting : list) EXPECT_EQ(decided.contains(std::string{setting.key}), render::decidedByQuality(setting.key)) << setting.key;
}

TEST(Quality, NeverTakesCloudRaysAway) {
    Picture all;
    all.clouds.rays = 1.0f;
    applyQuality(Quality::low, all.graphics, all.clouds);
    EXPECT_EQ(all.clouds.rays, 1.0f);
}

/// A machine that takes `fixed` s a frame and `whole` s more for a picture of full size.
struct Machine {
    double fixed, whole;
    double frame(float scale) const { return fixed + whole * static_cast<double>(scale * scale); }
};

/// Frame rate after so many frames, held at `wanted`.
float settle(render::ResolutionScale& control, Machine const& machine, int wanted, int frames = 2000) {
    for (int i = 0; i < frames; ++i) control.note(machine.frame(control.scale(1.0f, wanted)), wanted);
    return control.scale(1.0f, wanted);
}

TEST(ResolutionScale, HoldsTheFrameRate) {
    for (Machine const& machine : {Machine{0.004, 0.020}, Machine{0.002, 0.030}, Machine{0.008, 0.012}}) {
        render::ResolutionScale control;
        float const scale = settle(control, machine, 60);
        EXPECT_LT(scale, 1.0f);
        EXPECT_LE(machine.frame(scale) * 60.0, 1.06);
        EXPECT_GE(machine.frame(std::min(scale + 2.0f / 16.0f, 1.0f)) * 60.0, 0.82) << "smaller than it need be";
    }
}

TEST(ResolutionScale, ComesBackAndStays) {
    render::ResolutionScale control;
    float const slow = settle(control, {0.004, 0.030}, 60);
    EXPECT_LT(slow, 0.8f);
    EXPECT_EQ(settle(control, {0.002, 0.006}, 60), 1.0f);
    int changes = 0;
    float before = settle(control, {0.004, 0.020}, 60);
    for (int i = 0; i < 600; ++i) {
        float const now = settle(control, {0.004, 0.020}, 60, 1);
        changes += now != before;
        before = now;
    }
    EXPECT_EQ(changes, 0) << "it goes to and fro";
}

TEST(ResolutionScale, IsOffAtNoughtAndHasAnEnd) {
    render::ResolutionScale control;
    EXPECT_EQ(settle(control, {0.5, 1.0}, 30), render::ResolutionScale::kSmallest);
    EXPECT_EQ(control.scale(0.9f, 0), 0.9f);
    render::ResolutionScale off;
    for (int i = 0; i < 100; ++i) off.note(1.0, 0);
    EXPECT_EQ(off.scale(1.0f, 60), 1.0f);
}
}  // namespace
