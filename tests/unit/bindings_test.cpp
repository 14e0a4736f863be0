// Words and triggers are each other's inverse, bindings are settings, and the page binds anew what the player
// presses.
#include "game/ui/bindings.h"

#include <gtest/gtest.h>

#include <set>

#include "engine/core/error.h"
#include "game/ui/bindings_page.h"

namespace {
using namespace luftpost;
using namespace luftpost::ui;
using platform::Key;

TEST(Trigger, ComesBackFromItsWord) {
    for (char const* word :
         {"w", "shift+f", "shift+control+alt+pageUp", "f12", "leftShift", "mouse.left", "mouse.forward",
          "wheel.down", "pad.south", "pad.dpadLeft", "pad.leftX", "-pad.leftTrigger", "joy1.button1",
          "joy16.button64", "joy2.axis3", "-joy2.axis3"}) {
        auto const trigger = parseTrigger(word);
        ASSERT_TRUE(trigger) << word;
        EXPECT_EQ(triggerWord(*trigger), word);
        EXPECT_FALSE(triggerLabel(*trigger).empty());
    }
    for (char const* word : {"", "ww", "shift+", "mouse.", "mouse.side", "pad.A", "-pad.south", "-w",
                             "joy0.axis1", "joy1.axis0", "joy1.axis65", "joy17.axis1", "joy1.hat1",
                             "joy1.axis2x", "-joy1.button2", "joy.axis1", "joy01.axis1"})
        EXPECT_FALSE(parseTrigger(word)) << word;
}

TEST(Triggers, AreWordsBetweenSpacesEachOnce) {
    EXPECT_EQ(parseTriggers("  a   left a ")->size(), 2u);
    EXPECT_EQ(triggerWords(*parseTriggers(" a  left ")), "a left");
    EXPECT_TRUE(parseTriggers("")->empty());
    EXPECT_FALSE(parseTriggers("a nothing"));
}

TEST(Bindings, HaveOneDefaultForEachTrigger) {
    Bindings const bindings;
    std::set<std::string> seen;
    for (std::size_t i = 0; i < bindings.actions.size(); ++i)
        for (Trigger const& trigger : bindings.actions[i]) {
            EXPECT_TRUE(seen.insert(triggerWord(trigger)).second) << triggerWord(trigger) << " twice";
            EXPECT_TRUE(sharedWith(bindings, i, trigger).empty());
        }
    for (unsigned key = 0; key < static_cast<unsigned>(FlightKey::count); ++key)
        EXPECT_FALSE(bindings.of(static_cast<FlightKey>(key)).empty()) << key << " is reached by nothing";
    for (unsigned command = 0; command < static_cast<unsigned>(Command::count); ++command)
        EXPECT_FALSE(bindings.of(static_cast<Command>(command)).empty())
            << command << " is reached by nothing";
}

TEST(Bindings, AreSettingsThatRefuseWhatIsNoKey) {
    Bindings bindings;
    core::SettingList list;
    appendBindingSettings(list, bindings);
    core::assignSetting(list, "--set", "keys.drop=x mouse.back");
    EXPECT_EQ(triggerWords(bindings.of(FlightKey::drop)), "x mouse.back");
    core::assignSetting(list, "--set", "axes.yaw=-joy2.axis1");
    EXPECT_TRUE(bindings.of(Axis::yaw).front().reversed);
    auto const complaint = [&](char const* assignment) -> std::string {
        try {
            core::assignSetting(list, "--set", assignment);
        } catch (core::Error const& error) {
            return error.what();
        }
        return "";
    };
    EXPECT_EQ(complaint("keys.drop=spacebar"), "--set: keys.drop: expected keys and buttons, found spacebar");
    EXPECT_EQ(complaint("axes.roll=a"), "--set: axes.roll: expected axes, found a");
    EXPECT_EQ(triggerWords(bindings.of(FlightKey::drop)), "x mouse.back") << "as before";
}

platform::Input pressed(Key key) {
    platform::Input input;
    input.held[static_cast<std::size_t>(key)] = true;
    input.keys.push_back({.key = key, .pressed = true});
    return input;
}

/// Takes the page's changes into the bindings.
void accept(Bindings& bindings, std::vector<SettingChange> const& changes) {
    core::SettingList list;
    appendBindingSettings(list, bindings);
    for (SettingChange const& change : changes)
        core::assignSetting(*core::findSetting(list, change.key), "page", change.value);
}

TEST(BindingsPage, GivesTheRowWhatIsPressedAndTakesItFromWhereItWas) {
    Bindings bindings;
    BindingsPage page;
    std::size_t const drop = actionOf(FlightKey::drop);
    page.ask(false, drop, 0);
    EXPECT_TRUE(page.listening());
    EXPECT_TRUE(page.listen({}, bindings).empty());
    accept(bindings, page.listen(pressed(Key::b), bindings));
    EXPECT_TRUE(page.listening()) << "the key is still held: it must not drop the parcel";
    EXPECT_TRUE(page.listen({}, bindings).empty());
    EXPECT_FALSE(page.listening());
    EXPECT_EQ(triggerWords(bindings.of(FlightKey::drop)), "b pad.south joy1.button1");
    EXPECT_EQ(triggerWords(bindings.of(FlightKey::brakes)), "pad.east joy1.button2");
    EXPECT_NE(page.note().find("taken from \"Brakes\""), std::string::npos) << page.note();
}

TEST(BindingsPage, AddsAndTakesAwayAndLeavesAll) {
    Bindings bindings;
    BindingsPage page;
    std::size_t const row = actionOf(Command::pause);
    page.ask(false, row, 2);
    platform::Input click;
    click.mouseButtons = {{platform::MouseButton::back, true}};
    EXPECT_TRUE(page.listen(click, bindings, true).empty()) << "a click on the page is the page's";
    accept(bindings, page.listen(click, bindings));
    EXPECT_EQ(triggerWords(bindings.of(Command::pause)), "p pause mouse.back");
    page.ask(false, row, 0);
    accept(bindings, page.listen(pressed(Key::del), bindings));
    EXPECT_EQ(triggerWords(bindings.of(Command::pause)), "pause mouse.back");
    page.ask(false, row, 0);
    EXPECT_TRUE(page.listen(pressed(Key::escape), bindings).empty());
    EXPECT_FALSE(page.listening());
}

TEST(BindingsPage, TakesAButtonOnceItGoesDownAndAnAxisThatIsMoved) {
    Bindings bindings;
    BindingsPage page;
    platform::Input devices;
    devices.joysticks = {{0, "stick", {1.0f, 0.0f}, {true, false}}};
    page.ask(false, actionOf(FlightKey::respawn), 5);
    EXPECT_TRUE(page.listen(devices, bindings).empty()) << "it was held before";
    devices.joysticks[0].buttons[1] = true;
    accept(bindings, page.listen(devices, bindings));
    EXPECT_EQ(triggerWords(bindings.of(FlightKey::respawn)), "r pad.leftThumb joy1.button2");
    page.ask(true, static_cast<std::size_t>(Axis::brakes), 0);
    EXPECT_TRUE(page.listen(devices, bindings).empty()) << "it rests at its end";
    devices.joysticks[0].axes[0] = 0.2f;
    accept(bindings, page.listen(devices, bindings));
    EXPECT_EQ(triggerWords(bindings.of(Axis::brakes)), "joy1.axis1");
}

TEST(BindingsPage, TakesAnAxisAsAButtonTheWayItIsPushed) {
    for (float way : {1.0f, -1.0f}) {
        Bindings bindings;
        BindingsPage page;
        platform::Input devices;
        devices.joysticks = {{0, "stick", {0.0f, 0.0f, 0.0f, 0.0f, 0.0f}, {}}};
        page.ask(false, actionOf(FlightKey::flapsDown), 0);
        EXPECT_TRUE(page.listen(devices, bindings).empty());
        devices.joysticks[0].axes[4] = 0.3f * way;
        EXPECT_TRUE(page.listen(devices, bindings).empty()) << "not far enough";
        devices.joysticks[0].axes[4] = way;
        accept(bindings, page.listen(devices, bindings));
        Trigger const& taken = bindings.of(FlightKey::flapsDown).front();
        EXPECT_EQ(triggerWord(taken), way > 0.0f ? "joy1.axis5" : "-joy1.axis5");
        EXPECT_TRUE(isDown(taken, devices));
        EXPECT_TRUE(page.listening()) << "it is still pushed";
        devices.joysticks[0].axes[4] = 0.0f;
        page.listen(devices, bindings);
        EXPECT_FALSE(page.listening());
        EXPECT_FALSE(isDown(taken, devices));
    }
}

TEST(KeyHelp, ShowsWhatIsBoundNow) {
    Bindings bindings;
    bindings.actions[actionOf(FlightKey::drop)] = *parseTriggers("x");
    bool found = false;
    for (KeyHelp const& row : keyHelp(bindings))
        if (row.action == "drop the parcel")
            found = row.caps == std::vector<std::string>{"X"} && row.pad.empty();
    EXPECT_TRUE(found);
}
}  // namespace
