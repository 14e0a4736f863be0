#include <GLFW/glfw3.h>
#include <fmt/format.h>

#include <algorithm>
#include <cctype>
#include <utility>

#include "engine/platform/input.h"

namespace luftpost::platform {
namespace {
using Named = std::pair<Key, char const*>;
constexpr Named kNamed[] = {
    {Key::space, "space"}, {Key::apostrophe, "apostrophe"}, {Key::comma, "comma"}, {Key::minus, "minus"},
    {Key::period, "period"}, {Key::slash, "slash"}, {Key::semicolon, "semicolon"}, {Key::equal, "equal"},
    {Key::leftBracket, "leftBracket"}, {Key::backslash, "backslash"}, {Key::rightBracket, "rightBracket"},
    {Key::graveAccent, "graveAccent"}, {Key::world1, "world1"}, {Key::world2, "world2"}, {Key::escape, "escape"},
    {Key::enter, "enter"}, {Key::tab, "tab"}, {Key::backspace, "backspace"}, {Key::insert, "insert"},
    {Key::del, "delete"}, {Key::right, "right"}, {Key::left, "left"}, {Key::down, "down"}, {Key::up, "up"},
    {Key::pageUp, "pageUp"}, {Key::pageDown, "pageDown"}, {Key::home, "home"}, {Key::end, "end"},
    {Key::capsLock, "capsLock"}, {Key::scrollLock, "scrollLock"}, {Key::numLock, "numLock"},
    {Key::printScreen, "printScreen"}, {Key::pause, "pause"}, {Key::keypadDecimal, "keypadDecimal"},
    {Key::keypadDivide, "keypadDivide"}, {Key::keypadMultiply, "keypadMultiply"},
    {Key::keypadSubtract, "keypadSubtract"}, {Key::keypadAdd, "keypadAdd"}, {Key::keypadEnter, "keypadEnter"},
    {Key::keypadEqual, "keypadEqual"}, {Key::leftShift, "leftShift"}, {Key::leftControl, "leftControl"},
    {Key::leftAlt, "leftAlt"}, {Key::leftSuper, "leftSuper"}, {Key::rightShift, "rightShift"},
    {Key::rightControl, "rightControl"}, {Key::rightAlt, "rightAlt"}, {Key::rightSuper, "rightSuper"},
    {Key::menu, "menu"}};

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

/// "pageUp" -> "Page Up".
std::string spaced(std::string const& token) {
    std::string label;
    for (char const c : token) {
        if (!label.empty() && std::isupper(static_cast<unsigned char>(c))) label += ' ';
        label += label.empty() ? static_cast<char>(std::toupper(static_cast<unsigned char>(c))) : c;
    }
    return label;
}
}  // namespace

std::string keyToken(Key key) {
    int const number = static_cast<int>(key);
    if ((key >= Key::a && key <= Key::z) || (key >= Key::digit0 && key <= Key::digit9))
        return std::string(1, static_cast<char>(std::tolower(number)));
    if (key >= Key::f1 && key <= Key::f12) return fmt::format("f{}", number - static_cast<int>(Key::f1) + 1);
    if (key >= Key::keypad0 && key <= Key::keypad9)
        return fmt::format("keypad{}", number - static_cast<int>(Key::keypad0));
    for (auto const& [named, token] : kNamed)
        if (named == key) return token;
    return {};
}

std::optional<Key> keyFromToken(std::string_view token) {
    if (token.empty()) return std::nullopt;
    for (int number = 0; number < kKeys; ++number)
        if (keyToken(static_cast<Key>(number)) == token) return static_cast<Key>(number);
    return std::nullopt;
}

std::string keyLabel(Key key) {
    switch (key) {  // as they are printed everywhere
        case Key::left: return "\u2190";
        case Key::up: return "\u2191";
        case Key::right: return "\u2192";
        case Key::down: return "\u2193";
        default: break;
    }
    if (glfwGetCurrentContext())
        if (char const* printed = glfwGetKeyName(static_cast<int>(key), 0); printed && *printed) return upper(printed);
    std::string const token = keyToken(key);
    return token.size() <= 3 && key != Key::tab && key != Key::end ? upper(token) : spaced(token);
}
}  // namespace luftpost::platform
