// The settings table: every type round-trips, and wrong keys and values are answered as the contract says.
#include "engine/core/settings.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost::core;
namespace fs = std::filesystem;

enum class Mode { low, high };
constexpr std::array<std::string_view, 2> kModes{"low", "high"};
struct Sample {
    float share = 0.3f;
    double height = 120.5;
    int steps = 4;
    bool shadows = true;
    Mode mode = Mode::low;
    std::string source = "recorded";
};
constexpr std::tuple kFields{Field{&Sample::share, "sample.share", 0.0f, 1.0f, "A share"},
                             Field{&Sample::height, "sample.height", 0.0, 500.0, "A height"},
                             Field{&Sample::steps, "sample.steps", 1, 8, "Steps"},
                             Field{&Sample::shadows, "sample.shadows", "Shadows"},
                             Field{&Sample::mode, "sample.mode", kModes, "A mode"},
                             Field{&Sample::source, "sample.source", "A source"}};

SettingList listOf(Sample& sample) {
    SettingList list;
    appendSettings(list, sample, kFields);
    return list;
}

std::string messageOf(auto&& action) {
    try {
        action();
    } catch (Error const& error) {
        return error.what();
    }
    return "";
}

fs::path freshFile(char const* name, std::string const& text = "") {
    fs::path const file = luftpost::tests::scratch() / name;
    if (!text.empty()) std::ofstream{file} << text;
    return file;
}

TEST(Settings, RoundTripEveryTypeThroughAFile) {
    Sample written{0.7f, 3.25, 8, false, Mode::high, "a \"quoted\" one"}, read;
    auto list = listOf(written);
    fs::path const file = freshFile("settings_round_trip.toml");
    writeSettings(list, {}, file);
    auto target = listOf(read);
    readSettings(target, file);
    EXPECT_EQ(read.share, 0.7f);
    EXPECT_EQ(read.height, 3.25);
    EXPECT_EQ(read.steps, 8);
    EXPECT_FALSE(read.shadows);
    EXPECT_EQ(read.mode, Mode::high);
    EXPECT_EQ(read.source, "a \"quoted\" one");
    EXPECT_FALSE(fs::exists(file.string() + ".new"));
}

TEST(Settings, NameTheNearestKeyForAnUnknownOne) {
    Sample sample;
    auto list = listOf(sample);
    EXPECT_EQ(messageOf([&] { assignSetting(list, "--set", "sample.stepps=3"); }),
              "--set: sample.stepps: no such setting; the nearest known is sample.steps");
    EXPECT_EQ(nearestKey(list, "shadow"), "sample.shadows");
    std::vector<std::string> const known{"clouds.height", "clouds.densityThreshold", "clouds.sigma"};
    EXPECT_EQ(nearestText(known, "clouds.densty"), "clouds.densityThreshold") << "a word that was left off";
    EXPECT_EQ(nearestText(known, "clouds.higt"), "clouds.height");
}

TEST(Settings, RefuseValuesOutOfRangeOrOfAnotherType) {
    Sample sample;
    auto list = listOf(sample);
    EXPECT_EQ(messageOf([&] { assignSetting(list, "--set", "sample.share=1.5"); }),
              "--set: sample.share: expected a number 0..1, found 1.5");
    EXPECT_EQ(messageOf([&] { assignSetting(list, "--set", "sample.steps=2.5"); }),
              "--set: sample.steps: expected a whole number 1..8, found 2.5");
    EXPECT_EQ(messageOf([&] { assignSetting(list, "--set", "sample.mode=middle"); }),
              "--set: sample.mode: expected one of low, high, found middle");
    EXPECT_EQ(messageOf([&] { assignSetting(list, "--set", "sample.shadows=maybe"); }),
              "--set: sample.shadows: expected true or false, found maybe");
    EXPECT_EQ(messageOf([&] { assignSetting(list, "--set", "sample.share"); }),
              "--set: sample.share: expected key=value");
    EXPECT_EQ(sample.share, 0.3f);
}

TEST(Settings, ListWhatChanged) {
    Sample sample;
    auto list = listOf(sample);
    EXPECT_TRUE(changedSettings(list).empty());
    assignSetting(list, "--set", "sample.share=0.4");
    auto const changed = changedSettings(list);
    ASSERT_EQ(changed.size(), 1u);
    EXPECT_EQ(settingText(changed.at("sample.share")), "0.4");
    resetSettings(list);
    EXPECT_TRUE(changedSettings(list).empty());
}

TEST(Settings, NameFileAndLineOfABadFile) {
    Sample sample;
    auto list = listOf(sample);
    fs::path const wrong = freshFile("settings_wrong.toml", "[sample]\nshare = 0.5\nsteps = 99\n");
    EXPECT_EQ(messageOf([&] { readSettings(list, wrong); }),
              wrong.string() + ":3: sample.steps: expected a whole number 1..8, found 99");
    fs::path const broken = freshFile("settings_broken.toml", "[sample\n");
    EXPECT_NE(messageOf([&] { readSettings(list, broken); }).find(broken.string() + ":1: expected TOML"),
              std::string::npos);
}

TEST(Settings, OfThePlayerAreClampedKeptOrSetAside) {
    Sample sample;
    auto list = listOf(sample);
    fs::path const file =
        freshFile("settings_player.toml", "sample.share = 7\nfuture.key = [1, 2]\nsample.steps = 2\n");
    auto const notes = readPlayerSettings(list, file);
    EXPECT_EQ(sample.share, 1.0f);
    EXPECT_EQ(sample.steps, 2);
    EXPECT_EQ(notes.lines.size(), 2u);
    writeSettings(list, notes, file);
    EXPECT_NE(readFile(file).find("future.key = [ 1, 2 ]"), std::string::npos) << readFile(file);

    fs::path const broken = freshFile("settings_bad.toml", "= nonsense");
    EXPECT_EQ(readPlayerSettings(list, broken).lines.size(), 1u);
    EXPECT_FALSE(fs::exists(broken));
    EXPECT_TRUE(fs::exists(broken.string() + ".bad"));
}

TEST(Files, SayWhichFolderIsMissing) {
    EXPECT_NE(messageOf([] { checkOutputFolder("--log", "/no/such/folder/log.csv"); }).find("--log"),
              std::string::npos);
    EXPECT_NE(messageOf([] { writeFileAtomically("/dev/full", "x"); }).find("/dev/full"), std::string::npos);
    EXPECT_NE(messageOf([] { readFile("/no/such/file"); }).find("/no/such/file"), std::string::npos);
}
}  // namespace
