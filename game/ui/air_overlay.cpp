#include "game/ui/air_overlay.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "game/ui/draw_text.h"
#include "game/ui/hud_geometry.h"

namespace luftpost::ui {
namespace {
using namespace colour;
constexpr double kWorth = 0.4;           // m/s: less is a dot
constexpr double kMapReach = 4700.0;     // m, ahead on the map
constexpr ImU32 kUp = kYellow, kDown = IM_COL32(150, 205, 255, 255);

struct AirPen {
    ImDrawList& list;
    glm::vec2 size;
    float s;  // pixels per unit
};

double knots(double speed) { return speed / core::kMetresPerSecondPerKnot; }

/// Up: a filled head; down: an empty one. Told apart without colour, and light with a dark edge over day and night.
void drawTriangle(AirPen const& pen, glm::vec2 at, float half, bool up, ImU32 tint) {
    float const y = up ? -half : half;
    ImVec2 const a = im(at + glm::vec2{0.0f, y}), b = im(at + glm::vec2{-half, -y}), c = im(at + glm::vec2{half, -y});
    if (up) {
        pen.list.AddTriangleFilled(im(at + glm::vec2{0.0f, 1.5f * y}), im(at + glm::vec2{-1.4f * half, -1.3f * y}), im(at + glm::vec2{1.4f * half, -1.3f * y}), kHalo);
        pen.list.AddTriangleFilled(a, b, c, tint);
    } else {
        pen.list.AddTriangle(a, b, c, kHalo, 4.0f * pen.s);
        pen.list.AddTriangle(a, b, c, tint, 1.7f * pen.s);
    }
}

/// Those that none of the points beside them outdoes: in the picture a few tell more than all.
std::vector<LiftPoint> strongest(std::vector<LiftPoint> const& points) {
    std::vector<LiftPoint> peaks;
    for (LiftPoint const& point : points) {
        auto const outdone = [&](LiftPoint const& other) {
            bool const same = (other.up > 0.0) == (point.up > 0.0);
            return same && std::abs(other.up) > std::abs(point.up) && glm::length(other.eastNorth - point.eastNorth) < 1.6 * AirProbe::kCell;
        };
        if (std::none_of(points.begin(), points.end(), outdone)) peaks.push_back(point);
    }
    return peaks;
}

// --- in the picture ---------------------------------------------------------------------------------------------
/// A stem as long as the air moves in 30 s, at its place over the ground, with the head at its end.
void drawLiftArrow(AirPen const& pen, AirView const& view, LiftPoint const& point) {
    double const reach = std::clamp(30.0 * std::abs(point.up), 20.0, 150.0);
    glm::dvec3 const middle{point.eastNorth.x, view.subject.positionWorld.y, -point.eastNorth.y};
    bool const up = point.up > 0.0;
    auto const foot = seenAt(view.camera, pen.size, middle - glm::dvec3{0.0, up ? 0.5 * reach : -0.5 * reach, 0.0});
    auto const head = seenAt(view.camera, pen.size, middle + glm::dvec3{0.0, up ? 0.5 * reach : -0.5 * reach, 0.0});
    if (!foot || !head || head->x < 0.0f || head->x > pen.size.x || std::abs(foot->y - head->y) < 5.0f * pen.s) return;
    float const far = std::clamp(std::abs(foot->y - head->y) / (34.0f * pen.s), 0.4f, 1.0f);
    ImU32 const tint = faded(up ? kUp : kDown, 0.45f + 0.5f * far);
    pen.list.AddLine(im(*foot), im(*head), faded(kHalo, far), (2.0f + 3.0f * far) * pen.s);
    pen.list.AddLine(im(*foot), im(*head), tint, (0.8f + 1.4f * far) * pen.s);
    drawTriangle(pen, *head, (2.5f + 4.5f * far) * pen.s, up, tint);
}

/// A flat arrow that lies in the air at a height and goes where it goes, as far as in 15 s; before the aircraft, beside its way.
void drawWindArrow(AirPen const& pen, AirView const& view, WindLevel const& level) {
    double const speed = glm::length(level.wind), heading = view.subject.heading;
    glm::dvec2 const ahead{std::sin(heading), std::cos(heading)}, right{ahead.y, -ahead.x};
    glm::dvec2 const here{view.subject.positionWorld.x, -view.subject.positionWorld.z};
    glm::dvec2 const mast = here + 900.0 * ahead - 330.0 * right;
    auto const seen = [&](glm::dvec2 at) { return seenAt(view.camera, pen.size, {at.x, level.altitude, -at.y}); };
    glm::dvec2 const way = 15.0 * level.wind;
    auto const tail = seen(mast - 0.5 * way), tip = seen(mast + 0.5 * way), label = seen(mast);
    if (!tail || !tip || !label || label->y < 70.0f * pen.s || label->y > 0.78f * pen.size.y) return;
    glm::vec2 const middle = *label;
    pen.list.AddCircleFilled(im(middle), 5.0f * pen.s, kHalo);
    pen.list.AddCircleFilled(im(middle), 3.0f * pen.s, kPaper);
    if (speed > 0.5) {
        glm::vec2 const along = *tip - *tail;
        float const span = std::max(glm::length(along), 1.0f);
        glm::vec2 const half = 0.5f * std::max(1.0f, 36.0f * pen.s / span) * along, edge = 2.0f * pen.s * glm::normalize(half);  // seen end on, still an arrow
        drawArrow(pen.list, middle - half - edge, middle + half + 2.0f * edge, 5.6f * pen.s, kHalo);
        drawArrow(pen.list, middle - half, middle + half, 3.2f * pen.s, kPaper);
    }
    drawText(pen.list, fonts().small, middle + glm::vec2{0.0f, 8.0f * pen.s}, kPaper, fmt::format("{:.0f} m  {:.0f} kt", level.height, knots(speed)), 0.5f);
}

// Both stand in the corner at the right, one beside the other: at the left are the keys of the first minutes.
constexpr float kEdge = 14.0f, kTop = 84.0f, kMapWide = 212.0f, kLadderWide = 172.0f, kBetween = 8.0f;

// --- the ladder of winds ----------------------------------------------------------------------------------------
void drawLadder(AirPen const& pen, AirView const& view) {
    float const row = 21.0f * pen.s;
    glm::vec2 const from{pen.size.x - pen.s * (kEdge + kMapWide + kBetween + kLadderWide), kTop * pen.s};
    glm::vec2 const to = from + glm::vec2{kLadderWide * pen.s, row * static_cast<float>(view.winds.size()) + 34.0f * pen.s};
    pen.list.AddRectFilled(im(from), im(to), kPlate, 9.0f * pen.s);
    drawText(pen.list, fonts().small, from + pen.s * glm::vec2{12.0f, 6.0f}, kYellow, "Wind over the ground");
    float y = to.y - 6.0f * pen.s;
    for (WindLevel const& level : view.winds) {
        y -= row;
        double const speed = glm::length(level.wind);
        drawText(pen.list, fonts().small, {from.x + 58.0f * pen.s, y}, kFaint, fmt::format("{:.0f} m", level.height), 1.0f);
        glm::vec2 const middle{from.x + 78.0f * pen.s, y + 8.5f * pen.s};
        if (speed > 0.3) {
            glm::vec2 const way{glm::dvec2{level.wind.x, -level.wind.y} / speed};  // north up
            drawArrow(pen.list, middle - 8.5f * pen.s * way, middle + 8.5f * pen.s * way, 2.2f * pen.s, kYellow);
        }
        double const from_deg = core::degrees(std::atan2(-level.wind.x, -level.wind.y));
        double const told = from_deg < 0.0 ? from_deg + 360.0 : from_deg;
        std::string const text = speed > 0.3 ? fmt::format("{:03.0f}\u00b0 {:.0f} kt", told >= 359.5 ? 0.0 : told, knots(speed)) : "calm";
        drawText(pen.list, fonts().small, {from.x + 94.0f * pen.s, y}, kPaper, text);
    }
}

// --- the map of lift --------------------------------------------------------------------------------------------
void drawMapPoint(AirPen const& pen, glm::vec2 at, double up) {
    if (std::abs(up) < kWorth) {
        pen.list.AddCircleFilled(im(at), 1.0f * pen.s, faded(kFaint, 0.5f), 6);
        return;
    }
    auto const half = static_cast<float>(std::clamp(1.6 + 1.3 * std::abs(up), 2.0, 6.5)) * pen.s;
    drawTriangle(pen, at, half, up > 0.0, up > 0.0 ? kUp : kDown);
}

void drawMapLegend(AirPen const& pen, glm::vec2 at) {
    float const s = pen.s;
    for (bool const up : {true, false}) {
        float x = at.x + (up ? 0.0f : 98.0f * s);
        for (double speed : {1.0, 3.0}) {
            drawMapPoint(pen, {x + 6.0f * s, at.y + 8.0f * s}, up ? speed : -speed);
            x += 16.0f * s;
            x += drawText(pen.list, fonts().small, {x, at.y}, kPaper, fmt::format("{:.0f}", speed)) + 6.0f * s;
        }
        drawText(pen.list, fonts().small, {x, at.y}, kFaint, up ? "up" : "down");
    }
}

void drawMap(AirPen const& pen, AirView const& view) {
    float const wide = kMapWide * pen.s, high = 190.0f * pen.s;
    glm::vec2 const from{pen.size.x - kEdge * pen.s - wide, kTop * pen.s}, field = from + pen.s * glm::vec2{0.0f, 24.0f};
    pen.list.AddRectFilled(im(from), im(from + glm::vec2{wide, high + 48.0f * pen.s}), kPlate, 9.0f * pen.s);
    drawText(pen.list, fonts().small, from + pen.s * glm::vec2{12.0f, 5.0f}, kYellow, "Lift at your height, m/s");
    glm::vec2 const own{field.x + 0.5f * wide - 16.0f * pen.s, field.y + high - 14.0f * pen.s};
    double const scale = static_cast<double>(high - 22.0f * pen.s) / kMapReach;  // pixels per metre
    glm::dvec2 const ahead{std::sin(view.subject.heading), std::cos(view.subject.heading)}, right{ahead.y, -ahead.x};
    glm::dvec2 const here{view.subject.positionWorld.x, -view.subject.positionWorld.z};
    for (double km : {2.0, 4.0}) {
        float const y = own.y - static_cast<float>(1000.0 * km * scale);
        pen.list.AddLine({from.x + 8.0f * pen.s, y}, {from.x + wide - 40.0f * pen.s, y}, faded(kFaint, 0.25f));
        drawText(pen.list, fonts().small, {from.x + wide - 7.0f * pen.s, y - 8.0f * pen.s}, kFaint, fmt::format("{:.0f} km", km), 1.0f);
    }
    for (LiftPoint const& point : view.lift) {
        glm::dvec2 const away = point.eastNorth - here;
        glm::vec2 const at = own + glm::vec2{glm::dvec2{glm::dot(away, right), -glm::dot(away, ahead)} * scale};
        if (at.x < from.x + 8.0f * pen.s || at.x > from.x + wide - 40.0f * pen.s || at.y < field.y + 4.0f * pen.s || at.y > field.y + high - 2.0f * pen.s) continue;
        drawMapPoint(pen, at, point.up);
    }
    drawArrow(pen.list, own + glm::vec2{0.0f, 8.0f * pen.s}, own - glm::vec2{0.0f, 9.0f * pen.s}, 5.0f * pen.s, kHalo);
    drawArrow(pen.list, own + glm::vec2{0.0f, 7.0f * pen.s}, own - glm::vec2{0.0f, 7.0f * pen.s}, 2.6f * pen.s, kPaper);
    drawMapLegend(pen, from + glm::vec2{12.0f * pen.s, high + 26.0f * pen.s});
}
}  // namespace

void drawAirOverlay(AirView const& view) {
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    AirPen const pen{*ImGui::GetBackgroundDrawList(), {size.x, size.y}, fonts().scale};
    std::vector<LiftPoint> far = view.lift;
    glm::dvec2 const here{view.subject.positionWorld.x, -view.subject.positionWorld.z};
    auto const distance = [&](LiftPoint const& point) { return glm::length(point.eastNorth - here); };
    std::erase_if(far, [&](LiftPoint const& point) { return std::abs(point.up) < kWorth || distance(point) < 200.0; });
    std::sort(far.begin(), far.end(), [&](LiftPoint const& a, LiftPoint const& b) { return distance(a) > distance(b); });
    std::vector<LiftPoint> const peaks = strongest(far);
    for (LiftPoint const& point : peaks) drawLiftArrow(pen, view, point);
    for (WindLevel const& level : view.winds) drawWindArrow(pen, view, level);
    drawLadder(pen, view);
    drawMap(pen, view);
}
}  // namespace luftpost::ui
