// The program's own settings: the committed page is what the table says, and no member is without its row.
#include <gtest/gtest.h>

#include <filesystem>
#include <set>

#include "engine/core/file.h"
#include "game/app/settings.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;
using app::Settings;

struct Anything {
    template <class T>
    operator T() const;
};
/// How many members the aggregate has: as many as it takes initialisers.
template <class S, class... Members>
consteval std::size_t memberCount() {
    if constexpr (requires { S{Members{}..., Anything{}}; })
        return memberCount<S, Members..., Anything>();
    else
        return sizeof...(Members);
}
template <class S, class... Fields>
bool everyMemberHasARow(std::tuple<Fields...> const&) {
    return memberCount<S>() == sizeof...(Fields);
}

/// A value that is allowed and not the default.
core::SettingValue otherValue(core::Setting const& setting) {
    if (auto const* flag = std::get_if<bool>(&setting.initial)) return !*flag;
    if (auto const* number = std::get_if<double>(&setting.initial))
        return *number == setting.max ? setting.min : setting.max;
    auto const& initial = std::get<std::string>(setting.initial);
    if (setting.accepts) return std::string{setting.accepts("k") ? "k" : "pad.rightX"} == initial ? std::string{} : std::string{setting.accepts("k") ? "k" : "pad.rightX"};
    if (setting.words.empty()) return initial + "x";
    return std::string{setting.words.back() == initial ? setting.words.front() : setting.words.back()};
}

TEST(SettingsPage, IsTheCommittedOne) {
    EXPECT_EQ(app::settingsPage(), core::readFile(std::filesystem::path{LUFTPOST_SOURCE_DIR} / "docs/settings.md"))
        << "run: luftpost settings --markdown > docs/settings.md";
}

TEST(SettingsPage, ShowsEverySettingOnceAndEveryGroupOnce) {
    Settings settings;
    std::string const page = app::settingsPage();
    auto const count = [&](std::string const& text) {
        std::size_t found = 0;
        for (std::size_t at = page.find(text); at != std::string::npos; at = page.find(text, at + 1)) ++found;
        return found;
    };
    for (core::Setting const& setting : app::settingList(settings)) {
        std::string const key{setting.key};
        EXPECT_EQ(count("| `" + key + "` |"), 1u) << key;
        EXPECT_EQ(count("\n## " + key.substr(0, key.find('.')) + "\n"), 1u) << key;
        EXPECT_FALSE(setting.help.empty()) << key;
        EXPECT_EQ(setting.help.find('|'), std::string_view::npos) << key;
    }
}

TEST(SettingsTable, HasARowForEveryMember) {
    EXPECT_TRUE(everyMemberHasARow<app::PilotSettings>(app::pilotFields));
    EXPECT_TRUE(everyMemberHasARow<flight::AssistSettings>(flight::assistFields));
    EXPECT_TRUE(everyMemberHasARow<flight::AutopilotSettings>(flight::autopilotFields));
    EXPECT_TRUE(everyMemberHasARow<ui::InputSettings>(ui::inputFields));
    EXPECT_TRUE(everyMemberHasARow<weather::CloudSettings>(weather::cloudFields));
    EXPECT_TRUE(everyMemberHasARow<render::GraphicsSettings>(render::graphicsFields));
    EXPECT_TRUE(everyMemberHasARow<app::ViewSettings>(app::viewFields));
    EXPECT_TRUE(everyMemberHasARow<ui::HudSettings>(ui::hudFields));
    EXPECT_TRUE(everyMemberHasARow<audio::AudioSettings>(audio::audioFields));
    EXPECT_TRUE(everyMemberHasARow<ui::MouseSettings>(ui::mouseFields));
    EXPECT_EQ(memberCount<Settings>(), 8u) << "a new group needs its lines here and in settingList";
    EXPECT_EQ(memberCount<app::FlightSettings>(), 5u) << "and in appendFlightSettings";
}

TEST(SettingsTable, MovesOneMemberWithEachKey) {
    Settings settings;
    core::SettingList list = app::settingList(settings);
    std::set<std::string_view> keys;
    for (core::Setting& setting : list) {
        EXPECT_TRUE(keys.insert(setting.key).second) << setting.key << " stands twice";
        setting.set(otherValue(setting));
        auto const changed = core::changedSettings(list);
        EXPECT_EQ(changed.size(), 1u) << setting.key;
        EXPECT_TRUE(changed.contains(std::string{setting.key})) << setting.key;
        core::resetSettings(list);
    }
}

TEST(SettingsTable, RoundTripsEveryKeyThroughAFile) {
    Settings written, read;
    core::SettingList from = app::settingList(written), to = app::settingList(read);
    for (core::Setting& setting : from) setting.set(otherValue(setting));
    std::filesystem::path const file = tests::scratch() / "settings.toml";
    core::writeSettings(from, {}, file);
    core::readSettings(to, file);
    EXPECT_EQ(core::changedSettings(to).size(), to.size());
    EXPECT_EQ(core::changedSettings(to), core::changedSettings(from));
}
}  // namespace
