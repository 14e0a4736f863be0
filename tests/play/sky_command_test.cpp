// `luftpost sky` through the command line: stills, their formats, and what it refuses.
#include <OpenImageIO/imageio.h>
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include "engine/assets/image.h"
#include "tests/support/scratch.h"

namespace {
namespace fs = std::filesystem;
using luftpost::tests::scratch;

struct Outcome {
    int code = -1;
    std::string errors;
};

Outcome run(std::string const& arguments) {
    std::string const errors = (scratch() / "errors.txt").string();
    int const status = std::system((std::string{LUFTPOST_PROGRAM} + " sky " + arguments + " 2>" + errors).c_str());
    std::ifstream in{errors};
    return {WEXITSTATUS(status), {std::istreambuf_iterator<char>{in}, {}}};
}

struct Picture {
    int width = 0, height = 0, channels = 0;
    bool isFloat = false;
    std::vector<float> values;
    float at(int x, int y, int channel) const {
        return values[static_cast<std::size_t>((y * width + x) * channels + channel)];
    }
};

Picture picture(std::string const& name) {
    auto const in = OIIO::ImageInput::open((scratch() / name).string());
    if (!in) return {};
    OIIO::ImageSpec const& spec = in->spec();
    Picture image{spec.width, spec.height, spec.nchannels, spec.format == OIIO::TypeDesc::FLOAT, {}};
    image.values.resize(static_cast<std::size_t>(spec.width * spec.height * spec.nchannels));
    in->read_image(0, 0, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, image.values.data());
    return image;
}

std::string still(std::string const& name, std::string const& options, std::string const& size = "64x36") {
    return "--weather preset:clear --place 47.5,7.5 --size " + size + " " + options + " -o " + (scratch() / name).string();
}

TEST(SkyCommand, DrawsAFloatPictureWhoseUnitIsTheSunAboveTheAir) {
    ASSERT_EQ(run(still("noon.exr", "--time 2023-06-21T11:30Z --look 0,60")).code, 0);
    Picture const image = picture("noon.exr");
    ASSERT_EQ(image.width, 64);
    ASSERT_EQ(image.height, 36);
    ASSERT_EQ(image.channels, 4);
    EXPECT_TRUE(image.isFloat);
    float const luminance = 0.2126f * image.at(32, 18, 0) + 0.7152f * image.at(32, 18, 1) + 0.0722f * image.at(32, 18, 2);
    EXPECT_GT(luminance, 0.01f);  // 1.3 kcd/m2
    EXPECT_LT(luminance, 0.06f);
    EXPECT_GT(image.at(32, 18, 2), 1.7f * image.at(32, 18, 0));
}

TEST(SkyCommand, DrawsTheSameBytesTwice) {
    ASSERT_EQ(run(still("a.png", "--time 2023-06-21T18:40Z --look 300,10")).code, 0);
    ASSERT_EQ(run(still("b.png", "--time 2023-06-21T18:40Z --look 300,10")).code, 0);
    EXPECT_EQ(picture("a.png").values, picture("b.png").values);
    EXPECT_EQ(picture("a.png").height, 36);
}

TEST(SkyCommand, SupersamplesToTheMeanOfALargerPicture) {
    std::string const view = "--time 2023-06-21T11:30Z --look 300,3 ";
    ASSERT_EQ(run(still("small.exr", view + "--supersample 2")).code, 0);
    ASSERT_EQ(run(still("large.exr", view, "128x72")).code, 0);
    Picture const small = picture("small.exr"), large = picture("large.exr");
    ASSERT_EQ(small.width, 64);
    ASSERT_EQ(small.height, 36);
    ASSERT_EQ(large.width, 128);
    for (int y = 0; y < 36; y += 5)
        for (int x = 0; x < 64; x += 3)
            for (int c = 0; c < 4; ++c) {
                float const mean = 0.25f * (large.at(2 * x, 2 * y, c) + large.at(2 * x + 1, 2 * y, c) + large.at(2 * x, 2 * y + 1, c) + large.at(2 * x + 1, 2 * y + 1, c));
                ASSERT_NEAR(small.at(x, y, c), mean, 1e-4f + 1e-4f * mean) << x << ' ' << y << ' ' << c;
            }
}

TEST(SkyCommand, DarkensFromNoonToDuskAndShowsWhatTheExposureAsksFor) {
    ASSERT_EQ(run(still("dusk.exr", "--time 2023-06-21T20:10Z --look 310,30")).code, 0);
    ASSERT_EQ(run(still("day.exr", "--time 2023-06-21T11:30Z --look 310,30")).code, 0);
    EXPECT_LT(picture("dusk.exr").at(32, 18, 1), 0.01f * picture("day.exr").at(32, 18, 1));
    ASSERT_EQ(run(still("bright.png", "--time 2023-06-21T11:30Z --look 0,60 --exposure 1")).code, 0);
    ASSERT_EQ(run(still("dim.png", "--time 2023-06-21T11:30Z --look 0,60 --exposure -1")).code, 0);
    EXPECT_GT(picture("bright.png").at(32, 18, 1), 1.3f * picture("dim.png").at(32, 18, 1));
}

TEST(SkyCommand, PutsTheSunIntoThePanoramaByItsAzimuthAndElevation) {
    ASSERT_EQ(run(still("round.exr", "--time 2023-06-21T11:30Z --panorama", "180x90")).code, 0);
    Picture const image = picture("round.exr");
    int bestX = 0, bestY = 0;
    for (int y = 0; y < 90; ++y)
        for (int x = 0; x < 180; ++x)
            if (image.at(x, y, 1) > image.at(bestX, bestY, 1)) bestX = x, bestY = y;
    EXPECT_NEAR(bestX, 90, 3);  // south, a moment after noon: 180 degrees of 360
    EXPECT_NEAR(bestY, 12, 3);  // 66 degrees up
}

TEST(SkyCommand, LeavesTheOutsideOfTheDomeBlackAndEmpty) {
    ASSERT_EQ(run(still("dome.exr", "--time 2023-06-21T11:30Z --dome", "64x64")).code, 0);
    Picture const image = picture("dome.exr");
    for (int channel = 0; channel < 4; ++channel) EXPECT_EQ(image.at(1, 1, channel), 0.0f);
    EXPECT_GT(image.at(32, 32, 2), image.at(32, 32, 0));
    EXPECT_GT(image.at(32, 32, 0), 0.0f);
}

TEST(SkyCommand, DrawsByTilesWhatIsTooLargeToBeDrawnWhole) {
    for (char const* name : {"wide.png", "wide.exr"}) {
        ASSERT_EQ(run(still(name, "--time 2023-06-21T11:30Z --look 60,40 --fov 40", "4100x24")).code, 0);
        Picture const image = picture(name);
        ASSERT_EQ(image.width, 4100);
        ASSERT_EQ(image.height, 24);
        ASSERT_EQ(image.channels, 4);
        for (int x = 512; x < 4100; x += 512)  // a clear sky changes over one pixel by less than the dither does
            for (int channel = 0; channel < 3; ++channel)
                EXPECT_NEAR(image.at(x, 12, channel) / image.at(x - 1, 12, channel), 1.0, 0.02) << name << " at " << x;
    }
    EXPECT_FALSE(fs::exists(scratch() / "wide.png.new"));
}

TEST(SkyCommand, NumbersThePicturesOfATimeLapse) {
    ASSERT_EQ(run(still("lapse.exr", "--time 2023-06-21T19:00Z --look 90,20 --frames 2:3 --step 900")).code, 0);
    EXPECT_LT(picture("lapse_0003.exr").at(32, 18, 1), picture("lapse_0002.exr").at(32, 18, 1));
    EXPECT_FALSE(fs::exists(scratch() / "lapse.exr"));
}

TEST(SkyCommand, RefusesWhatItCannotDrawInOneLine) {
    std::string const output = " -o " + (scratch() / "no.png").string();
    for (std::string const& arguments :
         {std::string{"--look 10"} + output, "--look 10,95" + output, "--look a,b" + output, "--fov 0" + output,
          "--fov 200" + output, "--fov nan" + output, "--size 0x10" + output, "--size 20000x10" + output,
          "--panorama --dome" + output, "--panorama --look 1,1" + output, "--frames 3:1" + output, "--frames 3" + output,
          "--step 10" + output, "--exposure x" + output, "--time 2023-06-21" + output, "--weather preset:nice" + output,
          "--place 95,0" + output, "--unheard-of" + output, std::string{}, std::string{"-o /no/such/folder/a.png"},
          "-o " + (scratch() / "a.jpg").string(), std::string{"-o /tmp"}}) {
        Outcome const outcome = run(arguments);
        EXPECT_EQ(outcome.code, 2) << arguments;
        EXPECT_EQ(std::count(outcome.errors.begin(), outcome.errors.end(), '\n'), 1) << arguments << "\n" << outcome.errors;
        EXPECT_FALSE(fs::exists(scratch() / "no.png")) << arguments;
    }
}
// With ffmpeg there is a film, without it one line says so; neither leaves a part behind.
TEST(SkyCommand, WritesAFilmWhereFfmpegIsInstalled) {
    fs::path const film = scratch() / "day.mp4";
    bool const installed = std::system("command -v ffmpeg >/dev/null 2>&1") == 0;
    Outcome const outcome = run(still("day.mp4", "--frames 0:2 --step 600", "33x18"));
    EXPECT_EQ(outcome.code, installed ? 0 : 2) << outcome.errors;
    EXPECT_EQ(fs::exists(film), installed);
    EXPECT_EQ(outcome.errors.find("ffmpeg") != std::string::npos, !installed) << outcome.errors;
    EXPECT_FALSE(fs::exists(scratch() / ".day.part.mp4"));
    if (installed) {
        EXPECT_GT(fs::file_size(film), 500u);
    }
}

// The path tracer's sky is the game's where there are no clouds, and needs no OpenGL.
TEST(SkyCommand, TracesTheClearSkyThatTheGameDraws) {
    std::string const view = "--time 2023-06-21T08:00Z --look 300,40 --fov 40";
    ASSERT_EQ(run(still("drawn.exr", view, "24x24")).code, 0);
    ASSERT_EQ(run(still("traced.exr", view + " --reference 256", "24x24")).code, 0);
    Picture const drawn = picture("drawn.exr"), traced = picture("traced.exr");
    ASSERT_EQ(traced.channels, 4);
    for (int channel = 0; channel < 3; ++channel) {
        double ours = 0.0, theirs = 0.0;
        for (int y = 0; y < 24; ++y)
            for (int x = 0; x < 24; ++x) {
                ours += static_cast<double>(drawn.at(x, y, channel));
                theirs += static_cast<double>(traced.at(x, y, channel));
                EXPECT_EQ(traced.at(x, y, 3), 0.0f);
            }
        EXPECT_NEAR(ours / theirs, 1.0, 0.1) << channel;
    }
}

// What was traced goes on where it ended: other dice, and the mean of all; a picture that was not traced, or of another size, is refused.
TEST(SkyCommand, AddsToAPictureThatItTraced) {
    std::string const view = "--time 2023-06-21T08:00Z --look 300,40 --fov 40 --reference 40";
    ASSERT_EQ(run(still("first.exr", view, "16x16")).code, 0);
    std::string const onto = view + " --onto " + (scratch() / "first.exr").string();
    ASSERT_EQ(run(still("both.exr", onto, "16x16")).code, 0);
    auto const first = luftpost::assets::readFacts(scratch() / "first.exr"), both = luftpost::assets::readFacts(scratch() / "both.exr");
    EXPECT_EQ(first.at("samples"), 40.0);
    EXPECT_EQ(both.at("samples"), 80.0);
    EXPECT_NEAR(both.at("noise") / first.at("noise"), std::sqrt(0.5), 0.1);
    Picture const before = picture("first.exr"), after = picture("both.exr");
    double change = 0.0, sum = 0.0;
    for (int y = 0; y < 16; ++y)
        for (int x = 0; x < 16; ++x) {
            change += std::abs(static_cast<double>(after.at(x, y, 1)) - static_cast<double>(before.at(x, y, 1)));
            sum += static_cast<double>(before.at(x, y, 1));
        }
    EXPECT_GT(change / sum, 0.05 * first.at("noise"));  // the same dice would change nothing
    EXPECT_LT(change / sum, 3.0 * first.at("noise"));
    Outcome const wide = run(still("wide.exr", onto, "32x16"));
    EXPECT_EQ(wide.code, 2);
    EXPECT_NE(wide.errors.find("first.exr"), std::string::npos) << wide.errors;
    ASSERT_EQ(run(still("drawn.exr", "--time 2023-06-21T08:00Z", "16x16")).code, 0);
    Outcome const drawn = run(still("x.exr", view + " --onto " + (scratch() / "drawn.exr").string(), "16x16"));
    EXPECT_EQ(drawn.code, 2);
    EXPECT_NE(drawn.errors.find("drawn.exr"), std::string::npos) << drawn.errors;
}
}  // namespace
