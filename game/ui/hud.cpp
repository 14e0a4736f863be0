#include "game/ui/hud.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/time.h"
#include "game/ui/draw_text.h"
#include "game/ui/hud_geometry.h"
#include "game/ui/hud_pen.h"

namespace luftpost::ui {
namespace {
using namespace colour;

std::string thousands(double value) {
    std::string text = fmt::format("{:.0f}", std::abs(value));
    for (int i = static_cast<int>(text.size()) - 3; i > 0; i -= 3) text.insert(static_cast<std::size_t>(i), 1, ',');
    return fmt::format("{}{}", value <= -0.5 ? "\u2212" : "", text);
}

double wholeDegrees(double angle) {
    double const d = std::round(core::degrees(angle));
    return d - 360.0 * std::floor(d / 360.0);
}

std::string distanceText(double metres) {
    return metres < 995.0 ? fmt::format("{:.0f} m", metres) : fmt::format("{:.1f} km", metres / 1000.0);
}

std::string clockText(double seconds) {
    auto const whole = static_cast<int>(std::min(seconds, 5999.0) + 0.5);
    return fmt::format("{}:{:02}", whole / 60, whole % 60);
}

/// 0..1..0 in simulated time.
bool blinkOn(double time, double hertz, double share) { return time * hertz - std::floor(time * hertz) < share; }

// --- compass ----------------------------------------------------------------------------------------------------
std::string compassLabel(int deg) {
    switch (deg) {
        case 0: return "N";
        case 90: return "E";
        case 180: return "S";
        case 270: return "W";
        default: return fmt::format("{}", deg / 10);
    }
}

void drawCompassTicks(Pen const& pen, HudState const& state, glm::vec2 middle, float half, float perDegree) {
    double const heading = core::degrees(state.heading);
    for (int tick = -9; tick <= 9; ++tick) {
        int const mark = static_cast<int>(std::floor(heading / 5.0)) * 5 + 5 * tick;
        float const x = static_cast<float>(mark - heading) * perDegree;
        if (std::abs(x) > half - 6.0f * pen.s) continue;
        int const deg = (mark % 360 + 360) % 360;
        bool const big = deg % 30 == 0;
        float const edge = std::clamp((half - std::abs(x)) / (26.0f * pen.s), 0.0f, 1.0f);
        glm::vec2 const at = middle + glm::vec2{x, 0.0f};
        pen.list.AddLine(im(at + pen.px(0, 2)), im(at + pen.px(0, big ? 10 : deg % 10 == 0 ? 7 : 5)), faded(kPaper, edge), 1.5f * pen.s);
        if (big) drawText(pen.list, pen.f.small, at + pen.px(0, 11), faded(deg % 90 == 0 ? kYellow : kPaper, edge), compassLabel(deg), 0.5f);
    }
}

void drawCompass(Pen const& pen, HudState const& state) {
    float const half = 170.0f * pen.s, perDegree = half / 45.0f;
    glm::vec2 const middle{0.5f * pen.size.x, 10.0f * pen.s};
    pen.plate(middle - glm::vec2{half, 0.0f}, middle + glm::vec2{half, 31.0f * pen.s});
    drawCompassTicks(pen, state, middle, half, perDegree);
    if (state.target) {
        glm::dvec3 const away = state.target->positionWorld - state.positionWorld;
        double const turn = std::remainder(std::atan2(away.x, -away.z) - state.heading, 2.0 * core::kPi);
        float const x = std::clamp(static_cast<float>(core::degrees(turn)) * perDegree, -half + 8.0f * pen.s, half - 8.0f * pen.s);
        glm::vec2 const at = middle + glm::vec2{x, 24.0f * pen.s};
        pen.list.AddTriangleFilled(im(at + pen.px(0, -3)), im(at + pen.px(-9, 10)), im(at + pen.px(9, 10)), kPaper);
        pen.list.AddTriangleFilled(im(at), im(at + pen.px(-6, 8)), im(at + pen.px(6, 8)), kBlue);
    }
        pen.list.AddTriangleFilled(im(middle + pen.px(0, 5)), im(middle + pen.px(-6, -3)), im(middle + pen.px(6, -3)), kYellow);
    drawText(pen.list, pen.f.normal, middle + pen.px(0, 37), kPaper, fmt::format("{:03.0f}\u00b0", wholeDegrees(state.heading)), 0.5f);
}

// --- speed and levers -------------------------------------------------------------------------------------------
void drawLever(Pen const& pen, glm::vec2 at, float high, double value, ImU32 fill) {
    float const wide = 12.0f * pen.s;
    glm::vec2 const foot = at + glm::vec2{wide, high};
    auto const share = static_cast<float>(std::clamp(value, 0.0, 1.0));
    pen.list.AddRectFilled(im(at), im(foot), kTrough, 0.5f * wide);
    glm::vec2 const top{at.x, foot.y - share * (high - wide) - wide};
    pen.list.AddRectFilled(im(top), im(foot), fill, 0.5f * wide);
    glm::vec2 const knob = top + glm::vec2{0.5f * wide, 0.5f * wide};
    pen.list.AddRectFilled(im(knob - pen.px(11, 5)), im(knob + pen.px(11, 5)), kPaper, 4.0f * pen.s);
    pen.list.AddRect(im(knob - pen.px(11, 5)), im(knob + pen.px(11, 5)), kInk, 4.0f * pen.s, 0, 1.5f * pen.s);
}

void drawFlaps(Pen const& pen, glm::vec2 at, double flaps) {
    drawText(pen.list, pen.f.small, at, kFaint, "Flaps");
    glm::vec2 const hinge = at + pen.px(62, 9);
    auto const angle = static_cast<float>(0.70 * flaps);
    pen.list.AddLine(im(hinge - pen.px(17, 0)), im(hinge), kPaper, 4.0f * pen.s);
    glm::vec2 const tip = hinge + 15.0f * pen.s * glm::vec2{std::cos(angle), std::sin(angle)};
    pen.list.AddLine(im(hinge), im(tip), flaps > 0.01 ? kYellow : kPaper, 4.0f * pen.s);
    drawText(pen.list, pen.f.small, at + pen.px(84, 0), kPaper, flaps < 0.01 ? "up" : fmt::format("{:.0f} %", 100.0 * flaps));
}

/// How long it lasts, else how much there is.
std::string fuelText(HudState const& state) {
    if (!state.fuelSeconds || *state.fuelSeconds > 35940.0) return fmt::format("{:.0f} kg", state.fuel_kg);
    auto const minutes = static_cast<int>(*state.fuelSeconds / 60.0);
    return fmt::format("{}:{:02} h", minutes / 60, minutes % 60);
}

void drawFuel(Pen const& pen, glm::vec2 at, HudState const& state) {
    double const share = state.fuelCapacity_kg > 0.0 ? state.fuel_kg / state.fuelCapacity_kg : 0.0;
    ImU32 const fill = share < 0.12 ? kRed : kPaper;
    drawText(pen.list, pen.f.small, at, kFaint, "Fuel");
    glm::vec2 const from = at + pen.px(45, 5), to = at + pen.px(78, 13);
    pen.list.AddRectFilled(im(from), im(to), kTrough, 4.0f * pen.s);
    pen.list.AddRectFilled(im(from), im({from.x + static_cast<float>(std::clamp(share, 0.0, 1.0)) * (to.x - from.x), to.y}), fill, 4.0f * pen.s);
    drawText(pen.list, pen.f.small, at + pen.px(84, 0), fill, fuelText(state));
}

void drawSpeed(Pen const& pen, HudState const& state) {
    glm::vec2 const size = pen.px(196, 128), from{14.0f * pen.s, pen.size.y - 14.0f * pen.s - size.y};
    pen.plate(from, from + size);
    glm::vec2 const lever = from + pen.px(18, 14);
    drawLever(pen, lever, 84.0f * pen.s, state.throttle, kYellow);
    drawText(pen.list, pen.f.small, from + pen.px(24, 104), kPaper, fmt::format("{:.0f} %", 100.0 * state.throttle), 0.5f);
    glm::vec2 const text = from + pen.px(56, 8);
    float const wide = drawText(pen.list, pen.f.large, text, state.stalled ? kRed : kPaper, fmt::format("{:.0f}", knots(state.indicatedSpeed)));
    drawText(pen.list, pen.f.normal, text + glm::vec2{wide + 5.0f * pen.s, 9.0f * pen.s}, kFaint, "kt");
    drawText(pen.list, pen.f.small, from + pen.px(56, 40), kFaint, fmt::format("{:.0f} rpm", std::round(state.rpm / 10.0) * 10.0));
    drawFlaps(pen, from + pen.px(56, 62), state.flaps);
    drawFuel(pen, from + pen.px(56, 83), state);
    bool const braking = state.brakes > 0.05;
    drawText(pen.list, pen.f.small, from + pen.px(56, 104), braking ? kYellow : faded(kFaint, 0.55f), braking ? "Brakes on" : "Brakes off");
}

/// Speed and height as bare figures, for those who want the picture.
void drawFigures(Pen const& pen, HudState const& state) {
    glm::vec2 const size = pen.px(116, 44);
    glm::vec2 const left{14.0f * pen.s, pen.size.y - 14.0f * pen.s - size.y}, right = pen.size - size - 14.0f * pen.s;
    auto const figure = [&](glm::vec2 from, ImU32 tone, std::string const& text, char const* unit) {
        pen.plate(from, from + size);
        float const wide = drawText(pen.list, pen.f.large, from + pen.px(14, 6), tone, text);
        drawText(pen.list, pen.f.normal, from + pen.px(19, 15) + glm::vec2{wide, 0.0f}, kFaint, unit);
    };
    figure(left, state.stalled ? kRed : kPaper, fmt::format("{:.0f}", knots(state.indicatedSpeed)), "kt");
    figure(right, kPaper, thousands(std::round(feet(state.positionWorld.y) / 10.0) * 10.0), "ft");
}

// --- altitude ---------------------------------------------------------------------------------------------------
void drawClimb(Pen const& pen, glm::vec2 at, double climb) {
    double const feetPerMinute = std::round(feet(climb) * 6.0) * 10.0;
    drawText(pen.list, pen.f.small, at, kPaper, fmt::format("{}{} ft/min", feetPerMinute > 0.0 ? "+" : "", thousands(feetPerMinute)));
    // A needle left of the panel's right edge: full scale 10 m/s.
    glm::vec2 const scale = at + pen.px(118, -50);
    pen.list.AddRectFilled(im(scale), im(scale + pen.px(6, 84)), kTrough, 3.0f * pen.s);
    float const way = static_cast<float>(std::clamp(climb / 10.0, -1.0, 1.0)) * 40.0f;
    glm::vec2 const middle = scale + pen.px(0, 42);
    pen.list.AddRectFilled(im(middle + pen.px(0, std::min(0.0f, -way))), im(middle + pen.px(6, std::max(0.0f, -way))),
                           climb > 0 ? kGreen : kYellow, 2.0f * pen.s);
    pen.list.AddLine(im(middle + pen.px(-3, 0)), im(middle + pen.px(9, 0)), kPaper, 2.0f * pen.s);
}

void drawWind(Pen const& pen, glm::vec2 at, HudState const& state) {
    double const speed = std::hypot(state.windWorld.x, state.windWorld.z);
    glm::vec2 const middle = at + pen.px(9, 9);
    pen.list.AddCircleFilled(im(middle), 11.0f * pen.s, IM_COL32(250, 245, 230, 44), 24);
    if (speed < 0.25) {
        drawText(pen.list, pen.f.small, at + pen.px(26, 0), kPaper, "Calm");
        return;
    }
    glm::vec2 const way = windArrow(state.windWorld, state.heading);
    pen.list.AddLine(im(middle - pen.px(0, 13)), im(middle - pen.px(0, 9)), kPaper, 2.0f * pen.s);  // the nose
    drawArrow(pen.list, middle - 10.0f * pen.s * way, middle + 10.0f * pen.s * way, 2.4f * pen.s, kYellow);
    double const from = wholeDegrees(std::atan2(-state.windWorld.x, state.windWorld.z));
    drawText(pen.list, pen.f.small, at + pen.px(26, 0), kPaper, fmt::format("{:03.0f}\u00b0  {:.0f} kt", from, knots(speed)));
}

void drawAltitude(Pen const& pen, HudState const& state) {
    glm::vec2 const size = pen.px(164, 128), from = pen.size - size - 14.0f * pen.s;
    pen.plate(from, from + size);
    glm::vec2 const text = from + pen.px(16, 8);
    float const wide = drawText(pen.list, pen.f.large, text, kPaper, thousands(std::round(feet(state.positionWorld.y) / 10.0) * 10.0));
    drawText(pen.list, pen.f.normal, text + glm::vec2{wide + 5.0f * pen.s, 9.0f * pen.s}, kFaint, "ft");
    double const height = feet(state.height);
    bool const low = height < 200.0 && !state.onGround && state.velocityWorld.y < -2.0;
    double const shown = height > 200.0 ? std::round(height / 10.0) * 10.0 : height;
    drawText(pen.list, pen.f.small, from + pen.px(16, 40), low ? kRed : kFaint,
             state.onGround ? "on the ground" : thousands(std::max(0.0, shown)) + " ft up");
    drawClimb(pen, from + pen.px(16, 62), state.velocityWorld.y);
    drawWind(pen, from + pen.px(16, 92), state);
}

// --- corners ----------------------------------------------------------------------------------------------------
void drawScore(Pen const& pen, HudState const& state) {
    glm::vec2 const from = pen.px(14, 10);
    std::string const score = thousands(state.score);
    std::string const count = fmt::format("{} {}", state.deliveries, state.deliveries == 1 ? "delivery" : "deliveries");
    float const inner = std::max(textSize(pen.f.large, score).x + textSize(pen.f.normal, " points").x + 6.0f * pen.s, textSize(pen.f.small, count).x);
    pen.plate(from, from + glm::vec2{inner + 28.0f * pen.s, 58.0f * pen.s});
    float const wide = drawText(pen.list, pen.f.large, from + pen.px(14, 5), kYellow, score);
    drawText(pen.list, pen.f.normal, from + pen.px(14, 14) + glm::vec2{wide + 5.0f * pen.s, 0.0f}, kFaint, state.score == 1 ? "point" : "points");
    drawText(pen.list, pen.f.small, from + pen.px(14, 36), kPaper, count);
}

std::string ageText(HudWeather const& weather) {
    if (weather.mode == "preset") return "preset";
    if (weather.age < 90.0) return weather.mode + ", fresh";
    if (weather.age < 5400.0) return fmt::format("{}, {:.0f} min old", weather.mode, weather.age / 60.0);
    return fmt::format("{}, {:.1f} h old", weather.mode, weather.age / 3600.0);
}

/// No longer than so many letters.
std::string shortened(std::string const& text, std::size_t most) { return text.size() <= most ? text : text.substr(0, most - 3) + "..."; }

void drawWeather(Pen const& pen, HudState const& state) {
    std::string const time = core::formatUtc(state.utc);  // 2023-06-23T18:40:00Z
    std::string const rate = state.clockRate == 1.0 ? "" : state.clockRate == 0.0 ? "  stopped" : fmt::format("  {:.0f} \u00d7", state.clockRate);
    std::string const stamp = fmt::format("{}  {} UTC{}", time.substr(0, 10), time.substr(11, 5), rate);
    std::string const source = state.weather.name, age = ageText(state.weather), note = shortened(state.weather.note, 64);
    float const inner =
        std::max({textSize(pen.f.small, source).x, textSize(pen.f.small, age).x, textSize(pen.f.small, note).x, textSize(pen.f.normal, stamp).x});
    glm::vec2 const from{pen.size.x - inner - 42.0f * pen.s, 10.0f * pen.s};
    pen.plate(from, {pen.size.x - 14.0f * pen.s, from.y + (note.empty() ? 64.0f : 82.0f) * pen.s});
    float const right = pen.size.x - 28.0f * pen.s;
    drawText(pen.list, pen.f.normal, {right, from.y + 5.0f * pen.s}, kPaper, stamp, 1.0f);
    drawText(pen.list, pen.f.small, {right, from.y + 25.0f * pen.s}, kFaint, source, 1.0f);
    bool const stale = state.weather.mode == "stale";
    drawText(pen.list, pen.f.small, {right, from.y + 43.0f * pen.s}, stale ? kRed : kFaint, age, 1.0f);
    if (!note.empty()) drawText(pen.list, pen.f.small, {right, from.y + 61.0f * pen.s}, kFaint, note, 1.0f);
}

// --- messages, prompts, warnings ----------------------------------------------------------------------------------
void drawMessages(Pen const& pen, HudState const& state) {
    float y = (state.inside ? 196.0f : 74.0f) * pen.s;
    for (HudMessage const& message : state.messages) {
        if (message.age < 0.0 || message.age > kMessageSeconds) continue;
        auto const alpha = static_cast<float>(std::clamp(std::min(message.age * 5.0, (kMessageSeconds - message.age) * 1.5), 0.0, 1.0));
        ImU32 const tone = message.kind == MessageKind::good ? kGreen : message.kind == MessageKind::bad ? kRed : kYellow;
        glm::vec2 const size = textSize(pen.f.normal, message.text) + pen.px(44, 14);
        glm::vec2 const from = glm::round(glm::vec2{0.5f * (pen.size.x - size.x), y});
        pen.plate(from, from + size, faded(IM_COL32(14, 18, 24, 190), alpha));
        pen.list.AddRectFilled(im(from + pen.px(9, 7)), im({from.x + 14.0f * pen.s, from.y + size.y - 7.0f * pen.s}), faded(tone, alpha), 2.5f * pen.s);
        drawText(pen.list, pen.f.normal, from + pen.px(26, 6), faded(kPaper, alpha), message.text);
        y += size.y + 6.0f * pen.s;
    }
}

void drawStall(Pen const& pen, HudState const& state) {
    if (!state.stalled || state.onGround || !blinkOn(state.time, 3.0, 0.7)) return;
    glm::vec2 const at{0.5f * pen.size.x, 0.235f * pen.size.y};
    glm::vec2 const half = pen.px(66, 21);
    pen.plate(at - half, at + half, IM_COL32(176, 24, 16, 225));
    drawText(pen.list, pen.f.large, at - glm::vec2{0.0f, 0.5f * pen.f.large.size_px}, kPaper, "STALL", 0.5f);
}

/// It will not fly on from here: how one gets back into the air.
void drawStuck(Pen const& pen, HudState const& state) {
    if (!state.stuck) return;
    std::string const text = "Stuck? Hold", rest = "to be in the air again";
    float const cap = std::max(1.32f * pen.f.normal.size_px, textSize(pen.f.normal, state.respawnCap).x + 0.84f * pen.f.normal.size_px);
    float const before = textSize(pen.f.normal, text).x + 10.0f * pen.s, wide = before + cap + 10.0f * pen.s + textSize(pen.f.normal, rest).x;
    glm::vec2 const from = glm::round(glm::vec2{0.5f * (pen.size.x - wide), 0.30f * pen.size.y});
    pen.plate(from - pen.px(18, 10), from + glm::vec2{wide, 24.0f * pen.s} + pen.px(18, 10), IM_COL32(14, 18, 24, 215));
    drawText(pen.list, pen.f.normal, from + pen.px(0, 1), kPaper, text);
    drawKeyCap(pen.list, pen.f.normal, from + glm::vec2{before, 0.0f}, state.respawnCap);
    drawText(pen.list, pen.f.normal, from + glm::vec2{before + cap + 10.0f * pen.s, pen.s}, kPaper, rest);
}

void drawPaused(Pen const& pen, HudState const& state) {
    if (!state.paused) return;
    glm::vec2 const at{0.5f * pen.size.x, 0.40f * pen.size.y};
    glm::vec2 const half = pen.px(78, 22);
    pen.plate(at - half, at + half);
    drawText(pen.list, pen.f.large, at - glm::vec2{0.0f, 0.5f * pen.f.large.size_px}, kYellow, "PAUSED", 0.5f);
}

void drawPrompts(Pen const& pen, HudState const& state) {
    if (state.prompts.empty()) return;
    float const row = 28.0f * pen.s;
    float caps = 0.0f, words = 0.0f;
    for (HudPrompt const& prompt : state.prompts) {
        caps = std::max(caps, std::max(1.32f * pen.f.small.size_px, textSize(pen.f.small, prompt.cap).x + 0.84f * pen.f.small.size_px));
        words = std::max(words, textSize(pen.f.small, prompt.action).x);
    }
    float const high = row * static_cast<float>(state.prompts.size()) + 14.0f * pen.s;
    // Over the levers, or under the score where the tape stands between.
    float const top = state.density == HudDensity::full ? 78.0f * pen.s : pen.size.y - 156.0f * pen.s - high;
    glm::vec2 const from{14.0f * pen.s, top};
    pen.plate(from, from + glm::vec2{caps + words + 38.0f * pen.s, high});
    float y = from.y + 10.0f * pen.s;
    for (HudPrompt const& prompt : state.prompts) {
        drawKeyCap(pen.list, pen.f.small, glm::round(glm::vec2{from.x + 12.0f * pen.s, y}), prompt.cap);
        drawText(pen.list, pen.f.small, {from.x + caps + 24.0f * pen.s, y + 1.5f * pen.s}, kPaper, prompt.action);
        y += row;
    }
}

// --- navigation bar ---------------------------------------------------------------------------------------------
void drawNavField(Pen const& pen, HudState const& state, glm::vec2 middle, NavBarLayout const& layout, NavBar const& bar) {
    pen.list.AddCircleFilled(im(middle), layout.circle_px, bar.within ? IM_COL32(120, 214, 120, 120) : IM_COL32(16, 18, 22, 20), 48);
    pen.list.AddCircle(im(middle), layout.circle_px, bar.within ? IM_COL32(20, 120, 40, 255) : kInk, 48, 2.0f * pen.s);
    glm::vec2 const north = middle - glm::vec2{0.0f, layout.circle_px};
    pen.list.AddTriangleFilled(im(north + pen.px(0, -4)), im(north + pen.px(-5, 4)), im(north + pen.px(5, 4)), kInk);
    drawPlainText(pen.list, pen.f.small, north + pen.px(-13, -9), kInk, "N", 0.5f);
    drawArrow(pen.list, middle - 0.35f * bar.arrow_px, middle + bar.arrow_px, 5.0f * pen.s, IM_COL32(0, 0, 0, 255));
    if (!state.target) return;
    if (bar.landing_px && state.parcelReady) {
        glm::vec2 const at = middle + *bar.landing_px;
        pen.list.AddQuad(im(at + pen.px(0, -7)), im(at + pen.px(7, 0)), im(at + pen.px(0, 7)), im(at + pen.px(-7, 0)), IM_COL32(190, 70, 10, 255), 2.4f * pen.s);
    }
    bool const bright = blinkOn(state.time, 1.6, 0.68);
    glm::vec2 const dot = middle + bar.dot_px;
    if (bright) pen.list.AddCircleFilled(im(dot), layout.dot_px, kBlue, 24);
    pen.list.AddCircle(im(dot), layout.dot_px, bright ? IM_COL32(8, 50, 140, 255) : IM_COL32(20, 98, 232, 110), 24, 1.5f * pen.s);
}

void drawZoneSign(Pen const& pen, HudState const& state, NavBar const& bar, glm::vec2 middle) {
    if (!state.target) return;
    bool hits = false;
    std::string text;
    if (state.predictedLandingWorld && state.parcelReady) {
        glm::dvec3 const off = *state.predictedLandingWorld - state.target->positionWorld;
        double const miss = std::hypot(off.x, off.z);
        hits = miss <= state.target->radius;
        if (hits) text = fmt::format("Release now: about {:.0f} m from the centre", std::round(miss / 5.0) * 5.0);
    }
    if (!hits && bar.within) text = "Within the drop zone";
    if (text.empty()) return;
    glm::vec2 const half{0.5f * textSize(pen.f.normal, text).x + 30.0f * pen.s, 15.0f * pen.s};
    glm::vec2 const at = middle + pen.px(0, state.inside ? 72.0f : -72.0f);
    pen.plate(at - half, at + half, hits ? IM_COL32(18, 104, 44, 235) : IM_COL32(20, 70, 150, 225));
    drawText(pen.list, pen.f.normal, at - glm::vec2{-9.0f * pen.s, 0.53f * pen.f.normal.size_px}, kPaper, text, 0.5f);
    pen.list.AddCircleFilled(im({at.x - half.x + 18.0f * pen.s, at.y}), 6.0f * pen.s, hits && blinkOn(state.time, 4.0, 0.6) ? kYellow : kPaper, 20);
}

void drawNavBar(Pen const& pen, HudState const& state) {
    NavBarLayout const layout{glm::vec2{150.0f, 46.0f} * pen.s, 33.0f * pen.s, 6.5f * pen.s};
    float const high = state.inside ? 74.0f * pen.s + layout.half_px.y : pen.size.y - 14.0f * pen.s - layout.half_px.y;
    glm::vec2 const middle = glm::round(glm::vec2{0.5f * pen.size.x, high});
    float const pod = 92.0f * pen.s;
    glm::vec2 const half = layout.half_px + glm::vec2{pod, 0.0f};
    pen.list.AddRectFilled(im(middle - half), im(middle + half), IM_COL32(247, 242, 228, 216), 14.0f * pen.s);
    pen.list.AddRect(im(middle - half), im(middle + half), IM_COL32(16, 18, 22, 150), 14.0f * pen.s, 0, 1.5f * pen.s);
    for (float side : {-1.0f, 1.0f})
        pen.list.AddLine(im(middle + glm::vec2{side * layout.half_px.x, -0.7f * half.y}), im(middle + glm::vec2{side * layout.half_px.x, 0.7f * half.y}),
                         IM_COL32(16, 18, 22, 60), 1.5f * pen.s);
    glm::dvec3 const target = state.target ? state.target->positionWorld : state.positionWorld;
    double const radius = state.target ? state.target->radius : 150.0;
    NavBar const bar = navBar(state.positionWorld, state.velocityWorld, target, radius, state.predictedLandingWorld, layout);
    drawNavField(pen, state, middle, layout, bar);
    glm::vec2 const left = middle - glm::vec2{layout.half_px.x + 0.5f * pod, 0.0f}, right = middle + glm::vec2{layout.half_px.x + 0.5f * pod, 0.0f};
    drawPlainText(pen.list, pen.f.small, left + pen.px(0, -27), IM_COL32(70, 66, 58, 255), "Distance", 0.5f);
    drawPlainText(pen.list, pen.f.small, right + pen.px(0, -27), IM_COL32(70, 66, 58, 255), "Time to go", 0.5f);
    std::string const dash = "\u2013";
    drawPlainText(pen.list, pen.f.large, left + pen.px(0, -9), kInk, state.target ? distanceText(bar.distance) : dash, 0.5f);
    drawPlainText(pen.list, pen.f.large, right + pen.px(0, -9), kInk, state.target && bar.secondsToGo ? clockText(*bar.secondsToGo) : dash, 0.5f);
    drawZoneSign(pen, state, bar, middle);
}

// --- the drop zone in the world -----------------------------------------------------------------------------------
void drawTargetMarker(Pen const& pen, HudState const& state) {
    if (!state.target || state.camera.projection != render::Projection::perspective) return;
    glm::dvec3 const away = state.target->positionWorld - state.positionWorld;
    double const distance = std::hypot(away.x, away.z);
    bool const wide = state.density == HudDensity::full && !state.inside;  // beside the tape and the balance
    glm::vec2 const margin{std::max(0.06f * pen.size.x + 24.0f * pen.s, wide ? 196.0f * pen.s : 0.0f), 0.13f * pen.size.y + 88.0f * pen.s};
    EdgeMarker const marker = edgeMarker(state.camera, pen.size, margin, state.target->positionWorld);
    std::string const far = distanceText(distance);
    if (glm::length(marker.outward) > 0.5f) {  // turn that way
        glm::vec2 const tip = marker.at_px, way = marker.outward, side{-way.y, way.x};
        glm::vec2 const back = tip - 20.0f * pen.s * way;
        pen.list.AddTriangleFilled(im(tip + 6.0f * pen.s * way), im(back + pen.s * (17.0f * side - 2.0f * way)), im(back - pen.s * (17.0f * side + 2.0f * way)), kHalo);
        pen.list.AddTriangleFilled(im(tip + 3.0f * pen.s * way), im(back + 14.0f * pen.s * side), im(back - 14.0f * pen.s * side), kPaper);
        pen.list.AddTriangleFilled(im(tip - 1.0f * pen.s * way), im(back + pen.s * (10.0f * side + 2.0f * way)), im(back + pen.s * (-10.0f * side + 2.0f * way)), kBlue);
        drawText(pen.list, pen.f.small, back - 22.0f * pen.s * way - pen.px(0, 8), kPaper, far, 0.5f);
        return;
    }
    // A pin that hangs over the place and leaves it free; the name stays while it is far.
    glm::vec2 const tip = marker.at_px - pen.px(0, 10), head = tip - pen.px(0, 20);
    pen.list.AddTriangleFilled(im(tip + pen.px(0, 3)), im(head + pen.px(-10, 5)), im(head + pen.px(10, 5)), kHalo);
    pen.list.AddCircleFilled(im(head), 13.0f * pen.s, kHalo, 28);
    pen.list.AddTriangleFilled(im(tip), im(head + pen.px(-8, 5)), im(head + pen.px(8, 5)), kPaper);
    pen.list.AddCircleFilled(im(head), 11.0f * pen.s, kPaper, 28);
    pen.list.AddCircleFilled(im(head), 8.0f * pen.s, kBlue, 28);
    pen.list.AddCircleFilled(im(head), 3.2f * pen.s, kPaper, 16);
    std::string const label = distance > 600.0 && !state.target->name.empty() ? state.target->name + "  " + far : far;
    drawText(pen.list, pen.f.small, head - pen.px(0, 33), kPaper, label, 0.5f);
}
}  // namespace

void drawHud(HudState const& state) {
    if (!state.visible) return;
    ImVec2 const size = ImGui::GetIO().DisplaySize;
    Pen const pen{*ImGui::GetBackgroundDrawList(), fonts(), {size.x, size.y}, fonts().scale};
    drawTargetMarker(pen, state);
    drawCompass(pen, state);
    if (state.density == HudDensity::full && !state.inside) drawSpeedTape(pen, state), drawBalance(pen, state);
    if (state.density == HudDensity::minimal)
        drawFigures(pen, state);
    else
        drawSpeed(pen, state), drawAltitude(pen, state), drawScore(pen, state), drawWeather(pen, state);
    drawPrompts(pen, state);
    drawNavBar(pen, state);
    drawMouseStick(pen, state);
    drawLanding(pen, state);
    drawStuck(pen, state);
    drawStall(pen, state);
    drawPaused(pen, state);
    drawMessages(pen, state);
}
}  // namespace luftpost::ui
