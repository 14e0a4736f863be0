#include "game/ui/bindings_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <utility>

#include "game/ui/menu_parts.h"

namespace luftpost::ui {
namespace {
using platform::Key;

std::string keyOf(bool axis, std::size_t row) {
    return std::string{axis ? axisRows()[row].key : actionRows()[row].key};
}
std::string_view initialOf(bool axis, std::size_t row) {
    return axis ? axisRows()[row].initial : actionRows()[row].initial;
}
Triggers const& triggersOf(bool axis, std::size_t row, Bindings const& bindings) {
    return axis ? bindings.axes[row] : bindings.actions[row];
}

SettingChange changeTo(bool axis, std::size_t row, Triggers const& triggers) {
    return {keyOf(axis, row), triggerWords(triggers)};
}

bool wasPressed(platform::Input const& input, Key key) {
    return std::any_of(input.keys.begin(), input.keys.end(), [key](platform::KeyEvent const& event) {
        return event.key == key && event.pressed && !event.repeat;
    });
}

std::string namesOf(std::vector<std::size_t> const& actions) {
    std::string names;
    for (std::size_t action : actions)
        names += fmt::format("{}{}", names.empty() ? "" : ", ", actionRows()[action].label);
    return names;
}

/// Where an axis stands now: a bar from its middle.
void drawAxisBar(float value) {
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const wide = 54.0f * unit(), high = 8.0f * unit(), middle = at.x + 0.5f * wide;
    float const y = at.y + 0.5f * (ImGui::GetFrameHeight() - high);
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled({at.x, y}, {at.x + wide, y + high}, ImGui::GetColorU32(ImGuiCol_FrameBg),
                       3.0f * unit());
    float const end = middle + 0.5f * wide * std::clamp(value, -1.0f, 1.0f);
    list.AddRectFilled({std::min(middle, end), y}, {std::max(middle, end), y + high}, colour::kYellow,
                       2.0f * unit());
    list.AddLine({middle, y - 2.0f * unit()}, {middle, y + high + 2.0f * unit()}, colour::kPaper,
                 1.5f * unit());
    ImGui::Dummy({wide, ImGui::GetFrameHeight()});
}

/// The way back, at the right edge, where there is one.
bool drawReset(bool changed) {
    if (!changed) return false;
    float const wide = 24.0f * unit();
    ImGui::SameLine(ImGui::GetContentRegionMax().x - wide);
    bool const clicked = ImGui::Button("\u2190", {wide, 0.0f});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Back to the default");
    return clicked;
}
}  // namespace

void BindingsPage::ask(bool axis, std::size_t row, std::size_t place) {
    wish_ = Wish{axis, row, place};
    note_.clear();
}

std::optional<Trigger> BindingsPage::heardBy(Wish const& wish, platform::Input const& input) {
    if (wish.axis) return movedFirst(input, *wish.start);
    if (auto const pressed = pressedFirst(input, *wish.before)) return pressed;
    auto moved = movedFirst(input, *wish.start);  // an axis is a button, too, the way it was moved
    if (moved) moved->reversed = axisValue(*moved, input) < axisValue(*moved, *wish.start);
    return moved;
}

std::vector<SettingChange> BindingsPage::listen(platform::Input const& all, Bindings const& bindings,
                                                bool overMenu) {
    platform::Input input = all;
    if (overMenu) input.mouseButtons.clear(), input.scrolled = glm::dvec2{0.0};
    if (held_ && !isDown(*held_, input)) held_.reset();
    if (!wish_) return {};
    if (wasPressed(input, Key::escape)) return wish_.reset(), std::vector<SettingChange>{};
    if (!wish_->start) wish_->start = wish_->before = input;
    bool const away = wasPressed(input, Key::del);
    auto const heard = heardBy(*wish_, input);
    wish_->before = input;
    if (!away && !heard) return {};
    Wish const wish = *std::exchange(wish_, std::nullopt);
    if (!away && !wish.axis) held_ = heard;
    return take(wish, away ? std::nullopt : heard, bindings);
}

/// Puts the trigger into the row's place, or empties that place; an action's key belongs to it alone.
std::vector<SettingChange> BindingsPage::take(Wish const& wish, std::optional<Trigger> const& trigger,
                                              Bindings const& bindings) {
    std::vector<SettingChange> changes;
    Triggers mine = triggersOf(wish.axis, wish.row, bindings);
    if (trigger) std::erase(mine, *trigger);
    std::size_t const place = std::min(wish.place, mine.size());
    if (place < mine.size()) mine.erase(mine.begin() + static_cast<std::ptrdiff_t>(place));
    if (trigger) mine.insert(mine.begin() + static_cast<std::ptrdiff_t>(place), *trigger);
    changes.push_back(changeTo(wish.axis, wish.row, mine));
    note_.clear();
    if (!trigger || wish.axis) return changes;
    std::vector<std::size_t> const others = sharedWith(bindings, wish.row, *trigger);
    for (std::size_t other : others) {
        Triggers theirs = bindings.actions[other];
        std::erase(theirs, *trigger);
        changes.push_back(changeTo(false, other, theirs));
    }
    if (!others.empty())
        note_ = fmt::format("{} now is \"{}\"; taken from \"{}\".", triggerLabel(*trigger),
                            actionRows()[wish.row].label, namesOf(others));
    return changes;
}

void BindingsPage::drawTriggers(bool axis, std::size_t row, Triggers const& triggers,
                                Bindings const& bindings, std::vector<SettingChange>& changes) {
    bool const waits = wish_ && wish_->axis == axis && wish_->row == row;
    for (std::size_t place = 0; place <= triggers.size(); ++place) {
        bool const further = place == triggers.size(), asked = waits && wish_->place == place;
        if (further && triggers.size() >= 4 && !asked) break;
        ImGui::PushID(static_cast<int>(place));
        bool const shared = !axis && !further && !sharedWith(bindings, row, triggers[place]).empty();
        if (shared || asked)
            ImGui::PushStyleColor(ImGuiCol_Button,
                                  asked ? IM_COL32(168, 122, 12, 255) : IM_COL32(150, 40, 30, 255));
        std::string const label = asked     ? (axis ? "move it \u2026" : "press \u2026")
                                  : further ? "add"
                                            : (shared ? "! " : "") + triggerLabel(triggers[place]);
        if (further && !asked)
            ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled)),
                ImGui::PushStyleColor(ImGuiCol_Button, IM_COL32(0, 0, 0, 0));
        bool const clicked = ImGui::Button(label.c_str());
        if (further && !asked) ImGui::PopStyleColor(2);
        if (clicked) ask(axis, row, place);
        if (!further && ImGui::IsItemClicked(1)) {
            Triggers rest = triggers;
            rest.erase(rest.begin() + static_cast<std::ptrdiff_t>(place));
            changes.push_back(changeTo(axis, row, rest));
        }
        if (!wish_ && ImGui::IsItemHovered())
            ImGui::SetTooltip("%s", further ? "One more" : "Click: another. Right click: none");
        if (shared || asked) ImGui::PopStyleColor();
        ImGui::PopID();
        ImGui::SameLine();
    }
}

void BindingsPage::drawAction(std::size_t row, Bindings const& bindings,
                              std::vector<SettingChange>& changes) {
    Triggers const& triggers = bindings.actions[row];
    bool const changed = triggerWords(triggers) != initialOf(false, row);
    ImGui::PushID(keyOf(false, row).c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(changed ? colour::kYellow : colour::kPaper), "%s",
                       std::string{actionRows()[row].label}.c_str());
    ImGui::SameLine(186.0f * unit());
    drawTriggers(false, row, triggers, bindings, changes);
    if (drawReset(changed)) changes.push_back({keyOf(false, row), std::string{initialOf(false, row)}});
    if (!changed) ImGui::NewLine();  // the way back ends the line by itself
    for (Trigger const& trigger : triggers)
        if (auto const others = sharedWith(bindings, row, trigger); !others.empty())
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::kRed), "! %s does \"%s\", too",
                               triggerLabel(trigger).c_str(), namesOf(others).c_str());
    ImGui::PopID();
}

void BindingsPage::drawAxis(std::size_t row, Bindings const& bindings, platform::Input const* input,
                            std::vector<SettingChange>& changes) {
    Triggers const& triggers = bindings.axes[row];
    bool const changed = triggerWords(triggers) != initialOf(true, row);
    ImGui::PushID(keyOf(true, row).c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(changed ? colour::kYellow : colour::kPaper), "%s",
                       std::string{axisRows()[row].label}.c_str());
    ImGui::SameLine(186.0f * unit());
    float sum = 0.0f;
    if (input)
        for (Trigger const& trigger : triggers) sum += axisValue(trigger, *input);
    drawAxisBar(sum);
    ImGui::SameLine();
    if (!triggers.empty() && ImGui::Button("turn round")) {
        Triggers turned = triggers;
        for (Trigger& trigger : turned) trigger.reversed = !trigger.reversed;
        changes.push_back(changeTo(true, row, turned));
    }
    if (drawReset(changed)) changes.push_back({keyOf(true, row), std::string{initialOf(true, row)}});
    if (triggers.empty() && !changed) ImGui::NewLine();  // nothing followed the bar
    ImGui::Indent(12.0f * unit());
    drawTriggers(true, row, triggers, bindings, changes);
    ImGui::NewLine();
    ImGui::Unindent(12.0f * unit());
    ImGui::PopID();
}

std::vector<SettingChange> BindingsPage::draw(Bindings const& bindings, platform::Input const* input) {
    std::vector<SettingChange> changes;
    float const foot = ImGui::GetFrameHeightWithSpacing() + 34.0f * unit();
    ImGui::BeginChild("bindings", {0.0f, -foot}, false);
    std::string_view group;
    for (std::size_t row = 0; row < bindings.actions.size(); ++row) {
        if (std::exchange(group, actionRows()[row].group) != actionRows()[row].group)
            ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::kYellow), "%s",
                               std::string{group}.c_str());
        drawAction(row, bindings, changes);
    }
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::kYellow), "Gamepad and joystick");
    drawHelp("Dead zones and curves stand on the page Controls.");
    for (std::size_t row = 0; row < bindings.axes.size(); ++row) drawAxis(row, bindings, input, changes);
    ImGui::EndChild();
    ImGui::Separator();
    drawHelp(
        wish_
            ? (wish_->axis
                   ? "Move the axis half way or more. Escape: leave it. Delete: none."
                   : "Press a key or button (the mouse's beside this page) or push an axis that way. Escape: leave it. Delete: none.")
        : note_.empty() ? "Click a key to press another one. What had it before loses it."
                        : note_);
    if (ImGui::Button("Reset Keys")) {
        for (std::size_t row = 0; row < bindings.actions.size(); ++row)
            changes.push_back({keyOf(false, row), std::string{initialOf(false, row)}});
        for (std::size_t row = 0; row < bindings.axes.size(); ++row)
            changes.push_back({keyOf(true, row), std::string{initialOf(true, row)}});
        note_.clear();
    }
    return changes;
}
}  // namespace luftpost::ui
