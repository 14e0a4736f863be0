#include "game/ui/menu.h"

#include <fmt/format.h>
#include <imgui.h>
#include <imgui_internal.h>
#include <imgui_stdlib.h>

#include <algorithm>
#include <array>
#include <cctype>
#include <cmath>
#include <utility>

#include "game/ui/menu_parts.h"

namespace luftpost::ui {
namespace {
using core::Setting;
using core::SettingValue;

std::string_view groupOf(std::string_view key) { return key.substr(0, key.find('.')); }

/// Pages in this order, others after them under their own name. A page shows one group of settings or two.
struct Page {
    std::string_view title, group, second;

    bool shows(Setting const& setting) const {
        std::string_view const of = groupOf(setting.key);
        return of == group || (!second.empty() && of == second);
    }
};
constexpr std::array<Page, 6> kPages{{{"Aircraft", "aircraft", ""}, {"Clouds", "clouds", ""}, {"Picture", "graphics", ""},
                                      {"View", "hud", "view"}, {"Sound", "sound", ""}, {"Controls", "controls", ""}}};
constexpr Page kLivePage{"Live", "weather", ""};  // among the weather's own pages
constexpr Page kKeysPage{"Keys", "keys", "axes"};  // drawn by BindingsPage

std::string capitalised(std::string_view text) {
    std::string result{text};
    if (!result.empty()) result[0] = static_cast<char>(std::toupper(static_cast<unsigned char>(result[0])));
    return result;
}

struct Unit {
    std::string_view suffix, sign;
};
constexpr std::array<Unit, 11> kUnits{{{"_deg", "\u00b0"}, {"_dps", "\u00b0/s"}, {"_ev", " EV"}, {"_km", " km"}, {"_m", " m"},
                                       {"_s", " s"}, {"_kg", " kg"}, {"_kt", " kt"}, {"_ft", " ft"}, {"_fpm", " ft/min"}, {"_mps", " m/s"}}};

std::string_view unitOf(std::string_view key) {
    for (Unit const& u : kUnits)
        if (key.ends_with(u.suffix)) return u.sign;
    return {};
}

/// "aircraft.rollFactor" -> "Roll factor", "graphics.field_of_view_deg" -> "Field of view".
std::string labelOf(std::string_view key) {
    std::string_view name = key.substr(key.find('.') + 1);
    for (Unit const& u : kUnits)
        if (name.ends_with(u.suffix)) {
            name.remove_suffix(u.suffix.size());
            break;
        }
    std::string label;
    for (char c : name) {
        if (std::isupper(static_cast<unsigned char>(c))) label += ' ', c = static_cast<char>(std::tolower(static_cast<unsigned char>(c)));
        label += c == '_' || c == '.' ? ' ' : c;
    }
    bool const initials = label.size() <= 2;  // "hg" is a name's
    if (initials) std::transform(label.begin(), label.end(), label.begin(), [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return capitalised(label);
}

std::string numberFormat(Setting const& setting) {
    double const range = setting.max - setting.min;
    int const decimals = setting.whole || range >= 200.0 ? 0 : range >= 20.0 ? 1 : range >= 0.5 ? 2 : 4;
    std::string unitSign{unitOf(setting.key)};
    return fmt::format("%.{}f{}", decimals, unitSign);
}

/// A notch on the slider where the default stands.
void markDefault(Setting const& setting, double initial) {
    ImVec2 const from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    float const grab = ImGui::GetStyle().GrabMinSize;
    auto const share = static_cast<float>((initial - setting.min) / std::max(setting.max - setting.min, 1e-12));
    float const x = std::round(from.x + 2.0f + 0.5f * grab + share * (to.x - from.x - grab - 4.0f));
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddTriangleFilled({x, to.y - 5.0f * unit()}, {x - 4.0f * unit(), to.y + 1.0f * unit()}, {x + 4.0f * unit(), to.y + 1.0f * unit()}, colour::kFaint);
}

std::optional<SettingValue> drawNumber(Setting const& setting, double value) {
    bool const logarithmic = setting.min > 0.0 && setting.max / setting.min > 50.0;
    bool const changed = drawSlider("##value", value, setting.min, setting.max, numberFormat(setting), logarithmic);
    if (!logarithmic) markDefault(setting, std::get<double>(setting.initial));
    if (!changed) return std::nullopt;
    return SettingValue{setting.whole ? std::round(value) : value};
}

std::optional<SettingValue> drawWord(Setting const& setting, std::string const& value) {
    std::optional<SettingValue> answer;
    if (!ImGui::BeginCombo("##value", value.c_str())) return answer;
    for (std::string_view word : setting.words) {
        std::string const text{word};
        if (ImGui::Selectable(text.c_str(), text == value)) answer = SettingValue{text};
    }
    ImGui::EndCombo();
    return answer;
}

std::optional<SettingValue> drawTextBox(std::string value) {
    if (ImGui::InputText("##value", &value, ImGuiInputTextFlags_EnterReturnsTrue)) return SettingValue{std::move(value)};
    return std::nullopt;
}

std::optional<SettingValue> drawValue(Setting const& setting, SettingValue const& value) {
    if (auto const* number = std::get_if<double>(&value)) return drawNumber(setting, *number);
    if (auto const* text = std::get_if<std::string>(&value)) return setting.words.empty() ? drawTextBox(*text) : drawWord(setting, *text);
    bool on = std::get<bool>(value);
    if (ImGui::Checkbox(on ? "on##value" : "off##value", &on)) return SettingValue{on};
    return std::nullopt;
}

/// Label, control and way back in one line, the help under it.
void drawSetting(Setting const& setting, ConfigAnswer& answer) {
    std::string const key{setting.key};
    SettingValue const value = setting.get();
    bool const changed = value != setting.initial;
    ImGui::PushID(key.c_str());
    ImGui::AlignTextToFramePadding();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(changed ? colour::kYellow : colour::kPaper), "%s", labelOf(setting.key).c_str());
    float const reset = 30.0f * unit();
    ImGui::SameLine(158.0f * unit());
    ImGui::SetNextItemWidth(-reset);
    if (auto wanted = drawValue(setting, value)) answer.changes.push_back({key, std::move(*wanted)});
    if (changed) {
        ImGui::SameLine(ImGui::GetContentRegionMax().x - reset + 6.0f * unit());
        if (ImGui::Button("\u2190", {reset - 6.0f * unit(), 0.0f})) answer.changes.push_back({key, setting.initial});
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Back to %s", core::settingText(setting.initial).c_str());
    }
    drawHelp(setting.help);
    ImGui::Dummy({0.0f, 1.0f * unit()});
    ImGui::PopID();
}

void reset(Setting const& setting, ConfigAnswer& answer) {
    if (setting.get() != setting.initial) answer.changes.push_back({std::string{setting.key}, setting.initial});
}

void drawPage(core::SettingList const& settings, Page const& page, ConfigAnswer& answer, ResponseCurves const* response = nullptr) {
    bool const any = std::any_of(settings.begin(), settings.end(), [&](Setting const& s) { return page.shows(s); });
    std::string const title{page.title};
    if (!any || !beginPage(title.c_str())) return;
    float const foot = ImGui::GetFrameHeightWithSpacing() + 12.0f * unit() + (response ? responseHeight() : 0.0f);
    ImGui::BeginChild("rows", {0.0f, -foot}, false);
    ImGui::Dummy({0.0f, 2.0f * unit()});
    for (Setting const& setting : settings)
        if (page.shows(setting)) drawSetting(setting, answer);
    ImGui::EndChild();
    if (response) drawResponse(*response);
    ImGui::Separator();
    bool const resetPage = ImGui::Button(fmt::format("Reset {}", title).c_str());
    ImGui::SameLine();
    bool const resetAll = ImGui::Button("Reset everything");
    for (Setting const& setting : settings)
        if (resetAll || (resetPage && page.shows(setting))) reset(setting, answer);
    ImGui::EndTabItem();
}

void drawKeysTab(ConfigPages const& pages, ConfigAnswer& answer) {
    if (!beginPage("Keys")) return pages.bindingsPage.giveUp();
    std::vector<SettingChange> const changes = pages.bindingsPage.draw(pages.bindings, pages.input);
    answer.changes.insert(answer.changes.end(), changes.begin(), changes.end());
    ImGui::EndTabItem();
}

void drawPages(core::SettingList const& settings, ConfigPages const& pages, ConfigAnswer& answer) {
    drawPage(settings, kPages[0], answer, pages.response);
    if (pages.weather) drawWeatherPage(*pages.weather, pages.weatherPage, answer.weather, [&] { drawPage(settings, kLivePage, answer); });
    for (Page const& page : kPages)
        if (&page != &kPages[0]) drawPage(settings, page, answer);
    drawKeysTab(pages, answer);
    std::vector<std::string_view> others;
    for (Setting const& setting : settings) {
        bool const known = std::any_of(kPages.begin(), kPages.end(), [&](Page const& p) { return p.shows(setting); }) || kLivePage.shows(setting) || kKeysPage.shows(setting);
        std::string_view const group = groupOf(setting.key);
        if (!known && std::find(others.begin(), others.end(), group) == others.end()) others.push_back(group);
    }
    for (std::string_view group : others) {
        std::string const title = capitalised(group);
        drawPage(settings, {title, group, ""}, answer);
    }
}

/// Darkens the picture behind a menu that stops the flight.
void drawVeil() {
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    ImGui::GetBackgroundDrawList()->AddRectFilled({0.0f, 0.0f}, size, IM_COL32(8, 10, 14, 120));
}

void beginCentred(char const* name, float width, float height) {
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * size.x, 0.47f * size.y}, ImGuiCond_Always, {0.5f, 0.5f});
    ImGui::SetNextWindowSize({width, height});
    ImGui::Begin(name, nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings);
}

void drawTitle(std::string const& title, std::string const& line) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImVec2 const at = ImGui::GetCursorScreenPos();
    drawPlainText(list, fonts().large, {at.x, at.y}, colour::kYellow, title);
    drawPlainText(list, fonts().small, {at.x, at.y + 33.0f * unit()}, colour::kFaint, line);
    ImGui::Dummy({0.0f, 58.0f * unit()});
}

void drawKeyRow(KeyHelp const& row) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    ImGui::TableNextRow(ImGuiTableRowFlags_None, 29.0f * unit());
    ImGui::TableSetColumnIndex(0);
    ImVec2 at = ImGui::GetCursorScreenPos();
    float x = at.x;
    for (std::string const& cap : row.caps) x += drawKeyCap(list, fonts().small, {x, at.y + 2.0f * unit()}, cap) + 5.0f * unit();
    ImGui::TableSetColumnIndex(1);
    ImGui::TextUnformatted(row.action.c_str());
    ImGui::TableSetColumnIndex(2);
    ImGui::TextDisabled("%s", fmt::format("{}", fmt::join(row.pad, ", ")).c_str());
}

void drawKeyGroup(std::string const& group, std::span<KeyHelp const> rows) {
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::kYellow), "%s", group.c_str());
    if (!ImGui::BeginTable(group.c_str(), 3, ImGuiTableFlags_SizingStretchProp)) return;
    ImGui::TableSetupColumn("keys", ImGuiTableColumnFlags_WidthStretch, 0.30f);
    ImGui::TableSetupColumn("action", ImGuiTableColumnFlags_WidthStretch, 0.44f);
    ImGui::TableSetupColumn("gamepad", ImGuiTableColumnFlags_WidthStretch, 0.26f);
    for (KeyHelp const& row : rows)
        if (row.group == group) drawKeyRow(row);
    ImGui::EndTable();
    ImGui::Dummy({0.0f, 4.0f * unit()});
}
}  // namespace

ConfigAnswer drawConfigMenu(core::SettingList const& settings, ConfigPages const& pages) {
    ConfigAnswer answer;
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    float const width = std::min(568.0f * unit(), size.x - 20.0f), top = 84.0f * unit();
    ImGui::SetNextWindowPos({size.x - 14.0f * unit(), top}, ImGuiCond_Appearing, {1.0f, 0.0f});
    ImGui::SetNextWindowSize({width, size.y - top - 150.0f * unit()}, ImGuiCond_Appearing);
    bool open = true;
    if (ImGui::Begin("Settings", &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoSavedSettings)) {
        ImGuiStyle& style = ImGui::GetStyle();
        ImVec2 const between = std::exchange(style.ItemInnerSpacing, ImVec2{2.0f * unit(), style.ItemInnerSpacing.y});
        if (ImGui::BeginTabBar("pages", ImGuiTabBarFlags_FittingPolicyScroll)) {
            drawPages(settings, pages, answer);
            ImGui::EndTabBar();
        }
        style.ItemInnerSpacing = between;
    }
    ImGui::End();
    answer.close = !open;
    return answer;
}

PauseChoice drawPauseMenu() {
    drawVeil();
    beginCentred("pause", 340.0f * unit(), 0.0f);
    drawTitle("Paused", "The post can wait a minute.");
    constexpr std::array<std::pair<char const*, PauseChoice>, 6> kButtons{{{"Fly on", PauseChoice::resume}, {"Studio: take a picture", PauseChoice::studio}, {"Settings", PauseChoice::config}, {"Keys", PauseChoice::keys}, {"Start again", PauseChoice::restart}, {"Quit", PauseChoice::quit}}};
    PauseChoice choice = PauseChoice::none;
    for (auto const& [label, which] : kButtons)
        if (ImGui::Button(label, {-1.0f, 38.0f * unit()})) choice = which;
    ImGui::End();
    return choice;
}

bool drawKeysPage(std::span<KeyHelp const> rows) {
    drawVeil();
    std::vector<std::string> groups;
    for (KeyHelp const& row : rows)
        if (groups.empty() || groups.back() != row.group) groups.push_back(row.group);
    beginCentred("keys", std::min(1080.0f * unit(), ImGui::GetIO().DisplaySize.x), 0.0f);
    drawTitle("Keys", "The letters are those of your keyboard. All can be bound anew: Settings, page Keys.");
    // The first group on the left, the others beside it, so that all is seen at once.
    ImGui::Columns(2, "groups", false);
    for (std::string const& group : groups) {
        drawKeyGroup(group, rows);
        if (group == groups.front()) ImGui::NextColumn();
    }
    ImGui::Columns(1);
    bool const close = ImGui::Button("Close", {-1.0f, 36.0f * unit()});
    ImGui::End();
    return close;
}
}  // namespace luftpost::ui
