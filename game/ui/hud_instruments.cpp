// The parts of the HUD that a pilot flies by.
#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include "game/ui/hud_pen.h"

namespace luftpost::ui {
namespace {
using namespace colour;

/// The tape: `from` is its upper left corner; the speed flown stands in the middle.
struct Tape {
    Pen const& pen;
    glm::vec2 from, to;
    double speed_kt;

    static constexpr double kHalfRange_kt = 40.0;
    float yOf(double kt) const {
        return 0.5f * (from.y + to.y) -
               static_cast<float>((kt - speed_kt) / kHalfRange_kt) * 0.5f * (to.y - from.y);
    }
    bool shows(double kt) const { return std::abs(kt - speed_kt) < 0.96 * kHalfRange_kt; }
    float clampedY(double kt) const { return std::clamp(yOf(kt), from.y, to.y); }
};

void drawTapeScale(Tape const& tape) {
    Pen const& pen = tape.pen;
    for (int kt = std::max(0, static_cast<int>(tape.speed_kt - Tape::kHalfRange_kt) / 10 * 10);
         kt < tape.speed_kt + Tape::kHalfRange_kt; kt += 5) {
        if (!tape.shows(kt)) continue;
        glm::vec2 const at{tape.to.x - 20.0f * pen.s, tape.yOf(kt)};
        bool const big = kt % 20 == 0;
        pen.list.AddLine(im(at - pen.px(kt % 10 == 0 ? 8 : 4, 0)), im(at), kPaper, 1.5f * pen.s);
        if (big) drawText(pen.list, pen.f.small, at - pen.px(12, 9), kPaper, fmt::format("{}", kt), 1.0f);
    }
}

/// A band beside the scale; slanted strokes tell it apart from its neighbours without its colour.
void drawBand(Tape const& tape, double low_kt, double high_kt, ImU32 fill, bool hatched, float offset,
              float wide) {
    Pen const& pen = tape.pen;
    float const top = tape.clampedY(high_kt), foot = tape.clampedY(low_kt);
    if (foot - top < 1.0f) return;
    glm::vec2 const a{tape.to.x - offset * pen.s, top}, b{tape.to.x - (offset - wide) * pen.s, foot};
    pen.list.AddRectFilled(im(a), im(b), fill);
    if (!hatched) return;
    for (float y = top + 3.0f * pen.s; y < foot; y += 7.0f * pen.s)
        pen.list.AddLine({a.x, std::min(y + 4.0f * pen.s, foot)}, {b.x, y}, kInk, 1.5f * pen.s);
}

void drawMark(Tape const& tape, double kt, char const* letters, ImU32 tone) {
    if (!tape.shows(kt)) return;
    Pen const& pen = tape.pen;
    glm::vec2 const at{tape.to.x - 19.0f * pen.s, tape.yOf(kt)};
    pen.list.AddLine(im(at), im(at + pen.px(12, 0)), tone, 2.5f * pen.s);
    drawText(pen.list, pen.f.small, at + pen.px(23, -9), tone, letters);
}

void drawTapeWindow(Tape const& tape, bool stalled) {
    Pen const& pen = tape.pen;
    glm::vec2 const at{tape.to.x - 24.0f * pen.s, 0.5f * (tape.from.y + tape.to.y)};
    glm::vec2 const back = at - pen.px(46, 0);
    pen.list.AddRectFilled(im(back - pen.px(0, 13)), im(at + pen.px(0, 13)),
                           stalled ? IM_COL32(176, 24, 16, 255) : kInk, 4.0f * pen.s);
    pen.list.AddTriangleFilled(im(at + pen.px(0, -6)), im(at + pen.px(0, 6)), im(at + pen.px(7, 0)), kPaper);
    pen.list.AddRect(im(back - pen.px(0, 13)), im(at + pen.px(0, 13)), kPaper, 4.0f * pen.s, 0, 1.5f * pen.s);
    drawText(pen.list, pen.f.normal, at - pen.px(6, 11), kPaper, fmt::format("{:.0f}", tape.speed_kt), 1.0f);
}

/// A level with its ball: the ball runs to the side where the load goes.
void drawBall(Pen const& pen, glm::vec2 at, float wide, double sideLoad) {
    constexpr double kFull = 0.2;  // g at the tube's end
    float const high = 18.0f * pen.s, radius = 7.0f * pen.s;
    glm::vec2 const middle = at + glm::vec2{0.5f * wide, 0.5f * high};
    pen.list.AddRectFilled(im(at), im(at + glm::vec2{wide, high}), IM_COL32(250, 245, 230, 200), 0.5f * high);
    auto const way = static_cast<float>(std::clamp(-sideLoad / kFull, -1.0, 1.0));
    glm::vec2 const ball = middle + glm::vec2{way * (0.5f * wide - radius - 2.0f * pen.s), 0.0f};
    pen.list.AddCircleFilled(im(ball), radius, kInk, 24);
    for (float side : {-1.0f, 1.0f})
        pen.list.AddLine(im(middle + pen.px(side * 10.0f, -9)), im(middle + pen.px(side * 10.0f, 9)),
                         IM_COL32(16, 18, 22, 220), 2.0f * pen.s);
}

/// A reading with its bar; `mark` is where it must not go.
struct Gauge {
    char const* name;
    std::string text;
    double value, low, high;
    std::optional<double> mark{};
    bool alarm = false;
};
void drawGauge(Pen const& pen, glm::vec2 at, Gauge const& gauge) {
    drawText(pen.list, pen.f.small, at, kFaint, gauge.name);
    drawText(pen.list, pen.f.small, at + pen.px(140, 0), gauge.alarm ? kRed : kPaper, gauge.text, 1.0f);
    glm::vec2 const from = at + pen.px(38, 7), to = at + pen.px(92, 13);
    auto const xOf = [&](double value) {
        return from.x +
               static_cast<float>(std::clamp((value - gauge.low) / (gauge.high - gauge.low), 0.0, 1.0)) *
                   (to.x - from.x);
    };
    pen.list.AddRectFilled(im(from), im(to), kTrough, 3.0f * pen.s);
    float const zero = xOf(0.0), end = xOf(gauge.value);
    pen.list.AddRectFilled({std::min(zero, end), from.y}, {std::max(zero, end), to.y},
                           gauge.alarm ? kRed : kYellow, 2.0f * pen.s);
    pen.list.AddLine({zero, from.y - 2.0f * pen.s}, {zero, to.y + 2.0f * pen.s}, kFaint, 1.5f * pen.s);
    if (!gauge.mark) return;
    float const x = xOf(*gauge.mark);
    pen.list.AddTriangleFilled({x, to.y}, {x - 5.0f * pen.s, to.y + 7.0f * pen.s},
                               {x + 5.0f * pen.s, to.y + 7.0f * pen.s}, kRed);
}

std::string signedText(double value, char const* unit) {
    return fmt::format("{}{:.0f}{}", value < -0.5 ? "\u2212" : value > 0.5 ? "+" : "", std::abs(value), unit);
}

std::vector<std::string> landingLines(HudLanding const& landing) {
    std::vector<std::string> lines;
    lines.push_back(fmt::format("Sink {:.1f} m/s at {:.0f} kt, load {:.1f} g", landing.touchdownSpeed,
                                knots(landing.speed), landing.loadFactor));
    char const* const side = landing.drift < 0.0 ? "left" : "right";
    lines.push_back(std::abs(landing.drift) < 0.25
                        ? "No drift"
                        : fmt::format("Drift {:.1f} m/s to the {}", std::abs(landing.drift), side));
    lines.back() += fmt::format(", bank {:.0f}\u00b0", std::abs(core::degrees(landing.bank)));
    if (landing.bounces > 0)
        lines.back() += fmt::format(", {} {}", landing.bounces, landing.bounces == 1 ? "bounce" : "bounces");
    if (!landing.onAirfield) return lines.push_back("Away from the airfield"), lines;
    lines.push_back(fmt::format("{:.0f} m {} the aim, {:.0f} m {} of the line", std::abs(landing.beyondAim),
                                landing.beyondAim < 0.0 ? "before" : "beyond", std::abs(landing.offLine),
                                landing.offLine < 0.0 ? "left" : "right"));
    return lines;
}

char const* landingVerdict(HudLanding const& landing) {
    if (landing.touchdownSpeed < 0.6 && landing.bounces == 0) return "Very soft";
    if (landing.touchdownSpeed < 1.2) return "Soft";
    return landing.touchdownSpeed < 2.0 ? "Firm" : "Hard";
}
}  // namespace

void drawSpeedTape(Pen const& pen, HudState const& state) {
    glm::vec2 const from = pen.px(14, 250), to = from + pen.px(92, 304);
    pen.plate(from, to + pen.px(22, 0));
    pen.list.PushClipRect(im(from), im(to + pen.px(22, 0)), true);
    Tape const tape{pen, from + pen.px(0, 4), to - pen.px(0, 4), knots(state.indicatedSpeed)};
    HudMarks const& marks = state.marks;
    double const stall =
        knots(marks.stall + std::clamp(state.flaps, 0.0, 1.0) * (marks.stallFlaps - marks.stall));
    drawBand(tape, 0.0, stall, kRed, true, 18.0f, 10.0f);
    drawBand(tape, stall, knots(marks.cruiseLimit), kGreen, false, 18.0f, 5.0f);
    drawBand(tape, knots(marks.stallFlaps), knots(marks.flapLimit), kPaper, false, 12.0f, 4.0f);
    drawBand(tape, knots(marks.cruiseLimit), knots(marks.neverExceed), kYellow, true, 18.0f, 10.0f);
    drawBand(tape, knots(marks.neverExceed), 400.0, kRed, true, 18.0f, 10.0f);
    drawTapeScale(tape);
    drawMark(tape, stall, "S", kPaper);
    drawMark(tape, knots(marks.flapLimit), "F", kPaper);
    drawMark(tape, knots(marks.neverExceed), "NE", kPaper);
    drawTapeWindow(tape, state.stalled);
    pen.list.PopClipRect();
}

void drawBalance(Pen const& pen, HudState const& state) {
    bool const trim = state.trimActs;
    glm::vec2 const size = pen.px(164, trim ? 112 : 90);
    glm::vec2 const from = pen.size - size - pen.px(14, 150);
    pen.plate(from, from + size);
    drawBall(pen, from + pen.px(12, 10), 140.0f * pen.s, state.sideLoad);
    glm::vec2 const row = from + pen.px(12, 36);
    double const alpha = core::degrees(state.alpha);
    Gauge attack{"Angle", fmt::format("{:.0f}\u00b0", std::round(alpha) + 0.0), alpha,        -6.0,
                 22.0,    core::degrees(state.alpha + state.stallMargin),       state.stalled};
    Gauge const load{"Load",
                     fmt::format("{:.1f} g", state.loadFactor),
                     state.loadFactor,
                     -1.0,
                     4.0,
                     3.8,
                     state.loadFactor > 3.5};
    drawGauge(pen, row, attack);
    drawGauge(pen, row + pen.px(0, 25), load);
    if (!trim) return;
    drawText(pen.list, pen.f.small, row + pen.px(0, 50), kFaint, "Trim");
    drawText(pen.list, pen.f.small, row + pen.px(140, 50), kPaper,
             fmt::format("\u2191{}  \u2192{}", signedText(100.0 * state.elevatorTrim, "%"),
                         signedText(100.0 * state.rudderTrim, "%")),
             1.0f);
}

void drawMouseStick(Pen const& pen, HudState const& state) {
    if (!state.mouseStick) return;
    glm::vec2 const middle = glm::round(0.5f * pen.size);
    float const reach = 110.0f * pen.s;
    glm::vec2 const at = middle + reach * glm::vec2{state.mouseStick->x, state.mouseStick->y};
    pen.list.AddLine(im(middle - pen.px(7, 0)), im(middle + pen.px(7, 0)), kHalo, 3.5f * pen.s);
    pen.list.AddLine(im(middle - pen.px(0, 7)), im(middle + pen.px(0, 7)), kHalo, 3.5f * pen.s);
    pen.list.AddLine(im(middle - pen.px(6, 0)), im(middle + pen.px(6, 0)), kPaper, 1.5f * pen.s);
    pen.list.AddLine(im(middle - pen.px(0, 6)), im(middle + pen.px(0, 6)), kPaper, 1.5f * pen.s);
    pen.list.AddCircle(im(at), 9.0f * pen.s, kHalo, 28, 4.5f * pen.s);
    pen.list.AddCircle(im(at), 9.0f * pen.s, kYellow, 28, 2.2f * pen.s);
}

void drawLanding(Pen const& pen, HudState const& state) {
    if (!state.landing || state.landing->age > kLandingSeconds) return;
    HudLanding const& landing = *state.landing;
    auto const alpha = static_cast<float>(
        std::clamp(std::min(landing.age * 4.0, (kLandingSeconds - landing.age) * 1.5), 0.0, 1.0));
    std::string const title =
        fmt::format("{}: {}", landing.touchAndGo ? "Touch and go" : "Landed", landingVerdict(landing));
    std::vector<std::string> const lines = landingLines(landing);
    float wide = textSize(pen.f.large, title).x;
    for (std::string const& line : lines) wide = std::max(wide, textSize(pen.f.normal, line).x);
    glm::vec2 const size{wide + 36.0f * pen.s, (48.0f + 23.0f * static_cast<float>(lines.size())) * pen.s};
    glm::vec2 const from =
        glm::round(glm::vec2{0.5f * (pen.size.x - size.x), (state.inside ? 196.0f : 150.0f) * pen.s});
    pen.plate(from, from + size, faded(IM_COL32(14, 18, 24, 205), alpha));
    drawText(pen.list, pen.f.large, from + pen.px(18, 6), faded(kYellow, alpha), title);
    for (std::size_t i = 0; i < lines.size(); ++i)
        drawText(pen.list, pen.f.normal, from + pen.px(18, 42.0f + 23.0f * static_cast<float>(i)),
                 faded(kPaper, alpha), lines[i]);
}
}  // namespace luftpost::ui
