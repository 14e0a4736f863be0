#include "game/ui/menu_parts.h"

#include <imgui_internal.h>

#include <array>
#include <cstdio>

namespace luftpost::ui {
bool beginPage(char const* title) {
    ImGui::PushFont(fonts().small.letters);
    bool const open = ImGui::BeginTabItem(title);
    ImGui::PopFont();
    return open;
}

void drawHelp(std::string_view help) {
    std::string_view const all = help;
    if (help.ends_with(')')) help = help.substr(0, help.rfind(" ("));
    ImGui::PushFont(fonts().small.letters);
    ImGui::PushStyleColor(ImGuiCol_Text, ImGui::GetStyleColorVec4(ImGuiCol_TextDisabled));
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(help.data(), help.data() + help.size());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
    ImGui::PopFont();
    if (all.size() != help.size() && ImGui::IsItemHovered()) ImGui::SetTooltip("%.*s", static_cast<int>(all.size()), all.data());
}

void drawNumberText(std::string const& format, double value) {
    std::array<char, 48> text{};
    std::snprintf(text.data(), text.size(), format.c_str(), value);
    ImVec2 const from = ImGui::GetItemRectMin(), to = ImGui::GetItemRectMax();
    glm::vec2 const at{0.5f * (from.x + to.x), 0.5f * (from.y + to.y - fonts().normal.size_px)};
    drawText(*ImGui::GetWindowDrawList(), fonts().normal, at, colour::kPaper, text.data(), 0.5f);
}

bool drawSlider(char const* id, double& value, double least, double most, std::string const& format, bool logarithmic) {
    ImGuiSliderFlags const flags = ImGuiSliderFlags_AlwaysClamp | (logarithmic ? ImGuiSliderFlags_Logarithmic : 0);
    bool const typing = ImGui::TempInputIsActive(ImGui::GetID(id));
    if (!typing) ImGui::PushStyleColor(ImGuiCol_Text, IM_COL32(0, 0, 0, 0));
    bool const changed = ImGui::SliderScalar(id, ImGuiDataType_Double, &value, &least, &most, format.c_str(), flags);
    if (!typing) ImGui::PopStyleColor();
    if (!typing) drawNumberText(format, value);
    return changed;
}

bool drawSliderRow(char const* label, double& value, double least, double most, std::string const& format, bool logarithmic) {
    ImGui::PushID(label);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted(label);
    ImGui::SameLine(118.0f * unit());
    ImGui::SetNextItemWidth(-1.0f);
    bool const changed = drawSlider("##value", value, least, most, format, logarithmic);
    ImGui::PopID();
    return changed;
}
}  // namespace luftpost::ui
