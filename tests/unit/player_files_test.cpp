// The player's settings file holds what the player chose, and nothing that the command line said.
#include "game/app/player_files.h"

#include <gtest/gtest.h>

#include <fstream>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;
namespace fs = std::filesystem;

/// The file's settings by key, as text.
std::map<std::string, std::string> storedIn(fs::path const& file) {
    app::Settings settings;
    core::SettingList list = app::settingList(settings);
    core::readPlayerSettings(list, file);
    std::map<std::string, std::string> texts;
    for (auto const& [key, value] : core::changedSettings(list)) texts[key] = core::settingText(value);
    return texts;
}

TEST(PlayerFiles, KeepWhatTheFileSaidAndTakeOnlyWhatWasChanged) {
    fs::path const file = tests::scratch() / "settings.toml";
    std::ofstream{file} << "sound.master = 0.5\nhud.scale = 1.5\nfuture.key = 3\n";
    app::StoredSettings stored{file};
    stored.change("hud.scale", 1.25);
    stored.write();
    EXPECT_EQ(storedIn(file), (std::map<std::string, std::string>{{"hud.scale", "1.25"}, {"sound.master", "0.5"}}));
    EXPECT_NE(core::readFile(file).find("future.key = 3"), std::string::npos);
}

TEST(PlayerFiles, AreLeftAloneUntilSomethingChanged) {
    fs::path const file = tests::scratch() / "settings.toml";
    app::StoredSettings stored{file};
    stored.write();
    EXPECT_FALSE(fs::exists(file));
    stored.change("hud.visible", false);
    stored.write();
    EXPECT_EQ(storedIn(file), (std::map<std::string, std::string>{{"hud.visible", "false"}}));
    fs::remove(file);
    stored.write();
    EXPECT_FALSE(fs::exists(file)) << "nothing changed since";
}

TEST(PlayerFiles, OfAFlightWithoutAPlayerAreNotWritten) {
    app::StoredSettings stored{""};
    stored.change("hud.visible", false);
    EXPECT_NO_THROW(stored.write());
}
}  // namespace
