// The page on which everything is bound anew: pick, press, done. Main thread; `draw` between ScreenFrame::begin and end.
#pragma once
#include <optional>
#include <string>
#include <vector>

#include "engine/core/settings.h"
#include "engine/platform/input.h"
#include "game/ui/bindings.h"

namespace luftpost::ui {
/// A changed setting: the new value, of the setting's type and within its range.
struct SettingChange {
    std::string key;
    core::SettingValue value;
};

class BindingsPage {
public:
    /// A row waits for its key, or the key it got is still held: nothing else may take what is pressed.
    bool listening() const { return wish_.has_value() || held_.has_value(); }
    /// While it listens, once a poll: what the player pressed becomes the row's; whatever had it before loses it and is named.
    /// Escape leaves all as it was, Delete takes the old one away. Over a menu the mouse is the menu's (`overMenu`).
    std::vector<SettingChange> listen(platform::Input const& input, Bindings const& bindings, bool overMenu = false);
    /// The rows of actions, then those of axes. `input`, for the axes' bars, may be null.
    std::vector<SettingChange> draw(Bindings const& bindings, platform::Input const* input);
    /// As if the row's button was clicked: the trigger at `place`, or a further one.
    void ask(bool axis, std::size_t row, std::size_t place);
    void giveUp() { wish_.reset(), held_.reset(); }
    /// What the last press did, for the player.
    std::string const& note() const { return note_; }

private:
    struct Wish {
        bool axis = false;
        std::size_t row = 0, place = 0;
        std::optional<platform::Input> start{}, before{};
    };
    static std::optional<Trigger> heardBy(Wish const& wish, platform::Input const& input);
    std::vector<SettingChange> take(Wish const& wish, std::optional<Trigger> const& trigger, Bindings const& bindings);
    void drawAction(std::size_t row, Bindings const& bindings, std::vector<SettingChange>& changes);
    void drawAxis(std::size_t row, Bindings const& bindings, platform::Input const* input, std::vector<SettingChange>& changes);
    void drawTriggers(bool axis, std::size_t row, Triggers const& triggers, Bindings const& bindings, std::vector<SettingChange>& changes);

    std::optional<Wish> wish_;
    std::optional<Trigger> held_;  // was given to a row and has not been let go
    std::string note_;
};
}  // namespace luftpost::ui
