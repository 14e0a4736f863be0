#include "game/ui/replay_bar.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "game/ui/menu_parts.h"

namespace luftpost::ui {
namespace {
std::string clockText(double seconds) {
    auto const whole = static_cast<long>(seconds);
    if (whole >= 3600) return fmt::format("{}:{:02}:{:02}", whole / 3600, whole / 60 % 60, whole % 60);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

char const* speedText(double speed) {
    constexpr std::array<char const*, kReplaySpeeds.size()> kTexts{"1/4", "1/2", "1x", "2x", "4x", "8x", "16x"};
    return kTexts[static_cast<std::size_t>(std::find(kReplaySpeeds.begin(), kReplaySpeeds.end(), speed) - kReplaySpeeds.begin())];
}

/// Colour and shape say the same: a full ring, an open one, a cross, a stroke.
void drawMark(ImDrawList& list, ReplayMarkKind kind, glm::vec2 at, float size) {
    using namespace colour;
    switch (kind) {
        case ReplayMarkKind::delivered: list.AddCircleFilled(im(at), size, kGreen, 16); return;
        case ReplayMarkKind::lost: list.AddCircle(im(at), size, kYellow, 16, 0.4f * size); return;
        case ReplayMarkKind::crashed:
            list.AddLine(im(at - size), im(at + size), kRed, 0.5f * size);
            list.AddLine(im(at + glm::vec2{-size, size}), im(at + glm::vec2{size, -size}), kRed, 0.5f * size);
            return;
        case ReplayMarkKind::other: list.AddLine(im(at - glm::vec2{0.0f, 0.8f * size}), im(at + glm::vec2{0.0f, 0.8f * size}), kFaint, 0.3f * size); return;
    }
}

/// The line from the flight's begin to its end. Where it is dragged to.
std::optional<double> drawTimeLine(ReplayBar const& bar) {
    float const width = ImGui::GetContentRegionAvail().x, height = 26.0f * unit(), thick = 5.0f * unit();
    ImVec2 const corner = ImGui::GetCursorScreenPos();
    ImGui::InvisibleButton("line", {width, height});
    float const from = corner.x + 8.0f * unit(), length = width - 16.0f * unit(), y = corner.y + 0.5f * height;
    auto const place = [&](double seconds) { return glm::vec2{from + length * static_cast<float>(bar.length > 0.0 ? seconds / bar.length : 0.0), y}; };
    ImDrawList& list = *ImGui::GetWindowDrawList();
    auto const stroke = [&](double end, ImU32 ink) { list.AddRectFilled({from, y - 0.5f * thick}, {place(end).x, y + 0.5f * thick}, ink, 0.5f * thick); };
    stroke(bar.length, IM_COL32(250, 245, 230, 46));
    stroke(bar.known, IM_COL32(250, 245, 230, 120));
    stroke(bar.seconds, colour::kYellow);
    double const under = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from) / length), 0.0, 1.0) * bar.length;
    ReplayMark const* near = nullptr;
    for (ReplayMark const& mark : bar.marks) {
        drawMark(list, mark.kind, place(mark.seconds), 6.0f * unit());
        if (std::abs(place(mark.seconds).x - ImGui::GetIO().MousePos.x) < 8.0f * unit()) near = &mark;
    }
    list.AddCircleFilled(im(place(bar.seconds)), 8.0f * unit(), colour::kInk, 20);
    list.AddCircleFilled(im(place(bar.seconds)), 6.5f * unit(), colour::kPaper, 20);
    if (ImGui::IsItemHovered() || ImGui::IsItemActive()) ImGui::SetTooltip("%s%s", clockText(near ? near->seconds : under).c_str(), near ? ("  " + near->text).c_str() : "");
    return ImGui::IsItemActive() ? std::optional{under} : std::nullopt;
}

void drawSpeeds(ReplayBar const& bar, ReplayAnswer& answer) {
    float const width = 46.0f * unit(), between = 4.0f * unit();
    ImGui::SameLine(ImGui::GetWindowContentRegionMax().x - static_cast<float>(kReplaySpeeds.size()) * (width + between) + between);
    for (double speed : kReplaySpeeds) {
        bool const chosen = speed == bar.speed;
        if (chosen) ImGui::PushStyleColor(ImGuiCol_Button, ImGui::GetStyleColorVec4(ImGuiCol_ButtonActive));
        if (ImGui::Button(speedText(speed), {width, 0.0f})) answer.speed = speed;
        if (chosen) ImGui::PopStyleColor();
        ImGui::SameLine(0.0f, between);
    }
    ImGui::NewLine();
}
}  // namespace

ReplayAnswer drawReplayBar(ReplayBar const& bar) {
    ReplayAnswer answer;
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    ImGui::SetNextWindowPos({0.5f * size.x, 66.0f * unit()}, ImGuiCond_Always, {0.5f, 0.0f});
    ImGui::SetNextWindowSize({std::min(720.0f * unit(), size.x - 20.0f), 0.0f});
    ImGui::SetNextWindowBgAlpha(0.66f);
    ImGui::Begin("replay", nullptr, ImGuiWindowFlags_NoDecoration | ImGuiWindowFlags_NoMove | ImGuiWindowFlags_NoSavedSettings | ImGuiWindowFlags_NoNavInputs);
    answer.toggle = ImGui::Button(bar.playing ? "Pause" : "Play", {74.0f * unit(), 0.0f});
    ImGui::SameLine();
    ImGui::TextUnformatted(fmt::format("{} of {}", clockText(bar.seconds), clockText(bar.length)).c_str());
    drawSpeeds(bar, answer);
    answer.seconds = drawTimeLine(bar);
    if (!bar.note.empty()) ImGui::TextUnformatted(bar.note.c_str());
    ImGui::End();
    return answer;
}
}  // namespace luftpost::ui
