#include "game/ui/response_plot.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "game/ui/menu_parts.h"

namespace luftpost::ui {
namespace {
constexpr float kHeight = 92.0f, kCaption = 20.0f;

struct Graph {
    char const* title;
    double ResponsePoint::*value;
    double ResponsePoint::*stick;
    double most_deg;  // at the upper edge; the lower one is its negative
};
constexpr Graph kGraphs[]{
    {"Stick right: bank", &ResponsePoint::bank, &ResponsePoint::aileron, 70.0},
    {"Stick back: pitch \u00b0/s", &ResponsePoint::pitchRate, &ResponsePoint::elevator, 40.0},
    {"Pedal: yaw \u00b0/s", &ResponsePoint::yawRate, &ResponsePoint::rudder, 30.0}};

/// The stretch of the trial in which this graph's stick is moved and what follows it.
std::pair<double, double> stretchOf(std::vector<ResponsePoint> const& points, double ResponsePoint::*stick) {
    constexpr double kBefore = 0.4, kAfter = 3.0;  // s
    auto const moved = [stick](ResponsePoint const& p) { return p.*stick != 0.0; };
    auto const first = std::find_if(points.begin(), points.end(), moved);
    if (first == points.end()) return {0.0, 1.0};
    auto const last = std::find_if(points.rbegin(), points.rend(), moved);
    return {first->t - kBefore, last->t + kAfter};
}

struct Frame {
    glm::vec2 from, to;
    double begin, end, most;
    ImVec2 at(double t, double value) const {
        auto const x = static_cast<float>((t - begin) / (end - begin)),
                   y = static_cast<float>(0.5 - 0.5 * std::clamp(value / most, -1.0, 1.0));
        return {from.x + x * (to.x - from.x), from.y + y * (to.y - from.y)};
    }
};

void drawCurve(Frame const& frame, std::vector<ResponsePoint> const& points, double ResponsePoint::*value,
               double scale, ImU32 tone, float wide) {
    std::vector<ImVec2> line;
    for (ResponsePoint const& p : points)
        if (p.t >= frame.begin && p.t <= frame.end) line.push_back(frame.at(p.t, p.*value * scale));
    ImGui::GetWindowDrawList()->AddPolyline(line.data(), static_cast<int>(line.size()), tone, 0, wide);
}

void drawGraph(Graph const& graph, ResponseCurves const& curves, glm::vec2 from, glm::vec2 to) {
    ImDrawList& list = *ImGui::GetWindowDrawList();
    list.AddRectFilled(im(from), im(to), ImGui::GetColorU32(ImGuiCol_FrameBg), 5.0f * unit());
    auto const [begin, end] = stretchOf(curves.usual, graph.stick);
    Frame const frame{from + 3.0f * unit(), to - 3.0f * unit(), begin, end, graph.most_deg};
    ImVec2 const zero = frame.at(begin, 0.0);
    list.AddLine(zero, {to.x - 3.0f * unit(), zero.y}, IM_COL32(250, 245, 230, 60), 1.0f);
    double const toDegrees = core::degrees(1.0);
    drawCurve(frame, curves.usual, graph.stick, 0.9 * graph.most_deg, IM_COL32(250, 245, 230, 70),
              1.5f * unit());
    drawCurve(frame, curves.usual, graph.value, toDegrees, IM_COL32(150, 190, 240, 190), 1.5f * unit());
    drawCurve(frame, curves.now, graph.value, toDegrees, colour::kYellow, 2.4f * unit());
    drawPlainText(list, fonts().small, {from.x + 4.0f * unit(), from.y - kCaption * unit()}, colour::kFaint,
                  graph.title);
    drawPlainText(list, fonts().small, {to.x - 4.0f * unit(), from.y + 2.0f * unit()}, colour::kFaint,
                  fmt::format("{:.0f}\u00b0", graph.most_deg), 1.0f);
}
}  // namespace

float responseHeight() { return (kHeight + kCaption + 26.0f) * unit(); }

void drawResponse(ResponseCurves const& curves) {
    ImVec2 const at = ImGui::GetCursorScreenPos();
    float const gap = 8.0f * unit(), wide = (ImGui::GetContentRegionAvail().x - 2.0f * gap) / 3.0f;
    float x = at.x;
    for (Graph const& graph : kGraphs) {
        glm::vec2 const from{x, at.y + kCaption * unit()};
        drawGraph(graph, curves, from, from + glm::vec2{wide, kHeight * unit()});
        x += wide + gap;
    }
    ImGui::Dummy({0.0f, (kHeight + kCaption + 3.0f) * unit()});
    if (curves.now.empty()) return drawHelp("A trial flight is under way ...");
    drawHelp(fmt::format("Yellow: as set. Blue: by default. Full lever: {:.0f} % of the power.",
                         100.0 * curves.now.front().throttle));
}
}  // namespace luftpost::ui
