#include "game/ui/studio_page.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "game/ui/menu_parts.h"

namespace luftpost::ui {
namespace {
constexpr std::array<char const*, 3> kSizeNames{"Window", "4K", "8K"};

/// Lines at the thirds of the picture, light beside dark so that they show on both.
void drawThirds() {
    ImDrawList& list = *ImGui::GetBackgroundDrawList();
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    for (int i = 1; i <= 2; ++i)
        for (float shift : {0.0f, 1.0f}) {
            ImU32 const ink = shift > 0.0f ? IM_COL32(8, 10, 14, 90) : IM_COL32(250, 245, 230, 120);
            float const x = std::floor(size.x * static_cast<float>(i) / 3.0f) + shift, y = std::floor(size.y * static_cast<float>(i) / 3.0f) + shift;
            list.AddLine({x, 0.0f}, {x, size.y}, ink);
            list.AddLine({0.0f, y}, {size.x, y}, ink);
        }
}

std::string clockOf(double hours) {
    int const minutes = static_cast<int>(std::lround(hours * 60.0)) % 1440;
    return fmt::format("{:02}:{:02} UTC", minutes / 60, minutes % 60);
}

void drawView(StudioView& view) {
    drawSliderRow("Time", view.hours, 0.0, 24.0, clockOf(view.hours));
    drawSliderRow("View", view.fov_deg, kNarrowestView_deg, kWidestView_deg, "%.0f\u00b0", true);
    drawSliderRow("Exposure", view.exposure_ev, -4.0, 4.0, "%+.1f EV");
    ImGui::Checkbox("Lines at the thirds", &view.thirds);
}

void drawKind(StudioPage const& page, StudioView& view) {
    for (std::size_t i = 0; i < kSizeNames.size(); ++i) {
        if (i > 0) ImGui::SameLine();
        auto const size = static_cast<PictureSize>(i);
        if (ImGui::RadioButton(kSizeNames[i], view.size == size)) view.size = size;
    }
    if (ImGui::RadioButton("PNG, as shown", !view.linear)) view.linear = false;
    ImGui::SameLine();
    if (ImGui::RadioButton("EXR, linear", view.linear)) view.linear = true;
    glm::ivec2 const pixels = picturePixels(view.size, page.window);
    drawHelp(fmt::format("{} x {} pixels, without this page and its lines", pixels.x, pixels.y));
}

void drawNote(StudioPage const& page) {
    if (page.note.empty()) return;
    ImGui::PushStyleColor(ImGuiCol_Text, page.noteIsBad ? colour::kRed : colour::kPaper);
    ImGui::PushTextWrapPos(0.0f);
    ImGui::TextUnformatted(page.note.c_str());
    ImGui::PopTextWrapPos();
    ImGui::PopStyleColor();
}

/// In the place of the button, as high as it.
void drawProgress(StudioPage const& page, StudioAnswer& answer) {
    answer.stop = ImGui::Button("Stop", {70.0f * unit(), 34.0f * unit()});
    ImGui::SameLine();
    ImGui::PushStyleColor(ImGuiCol_PlotHistogram, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
    ImGui::ProgressBar(static_cast<float>(*page.saved), {-1.0f, 34.0f * unit()}, "");
    ImGui::PopStyleColor();
    drawNumberText("%.0f %%", 100.0 * *page.saved);
}
}  // namespace

glm::ivec2 picturePixels(PictureSize size, glm::ivec2 const& window) {
    if (size == PictureSize::window) return window;
    glm::dvec2 const bounds{kPictureBounds[static_cast<std::size_t>(size)]}, shape{window};
    double const scale = std::min(bounds.x / shape.x, bounds.y / shape.y);
    return glm::max(glm::ivec2{glm::round(0.5 * scale * shape)} * 2, glm::ivec2{2});
}

StudioAnswer drawStudioPage(StudioPage const& page) {
    StudioAnswer answer{page.view};
    if (page.view.thirds && !page.saved) drawThirds();
    ImGui::SetNextWindowPos({14.0f * unit(), 14.0f * unit()}, ImGuiCond_Appearing);
    ImGui::SetNextWindowSize({372.0f * unit(), 0.0f});
    bool open = true;
    ImGui::Begin("Studio", &open, ImGuiWindowFlags_NoCollapse | ImGuiWindowFlags_NoResize | ImGuiWindowFlags_NoSavedSettings);
    ImGui::BeginDisabled(page.saved.has_value());
    drawHelp(fmt::format("The flight stands still. {} move the camera, Shift fast; the right mouse button looks around, the wheel zooms.", page.moveCaps));
    drawView(answer.view);
    ImGui::Separator();
    drawKind(page, answer.view);
    ImGui::EndDisabled();
    if (page.saved) drawProgress(page, answer);
    else answer.save = ImGui::Button("Take the picture (F12)", {-1.0f, 34.0f * unit()});
    drawNote(page);
    ImGui::End();
    answer.close = !open;
    return answer;
}
}  // namespace luftpost::ui
