// The strip over the time slider: cover by level, rain, wind and temperature, hour by hour.
#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <cmath>

#include "engine/core/time.h"
#include "engine/weather/genera.h"
#include "game/ui/menu_parts.h"
#include "game/ui/weather_page.h"

namespace luftpost::ui {
namespace {
using namespace colour;
constexpr double kHour = 3600.0, kDay = 86400.0;
constexpr ImU32 kSky = IM_COL32(52, 66, 84, 255), kNight = IM_COL32(24, 29, 38, 255), kLine = IM_COL32(250, 245, 230, 40);
constexpr ImU32 kHigh = IM_COL32(196, 206, 218, 255), kMid = IM_COL32(158, 170, 184, 255), kLow = IM_COL32(226, 226, 222, 255);
constexpr ImU32 kWater = IM_COL32(112, 178, 244, 255), kWarm = IM_COL32(255, 148, 96, 255);

/// Rows of the strip from its top, in units.
struct Row {
    float top, high;
    float foot() const { return top + high; }
};
constexpr Row kHighRow{0.0f, 15.0f}, kMidRow{17.0f, 15.0f}, kLowRow{34.0f, 20.0f}, kRainRow{58.0f, 26.0f}, kWindRow{88.0f, 28.0f},
    kHeatRow{120.0f, 32.0f}, kTimeRow{154.0f, 16.0f};
constexpr float kStripHigh = 170.0f, kLabels = 42.0f, kScale = 72.0f;

struct StripPen {
    ImDrawList& list;
    WeatherStrip const& strip;
    glm::vec2 from;  // upper left of the columns
    float wide;      // of all columns

    float x(double time) const {
        return from.x + wide * static_cast<float>(std::clamp((time - strip.start) / (strip.end - strip.start), 0.0, 1.0));
    }
    float y(float units) const { return from.y + units * unit(); }
    float columnWide() const { return wide / static_cast<float>(strip.columns.size()); }
    void box(std::size_t column, float top, float foot, ImU32 fill) const {
        float const left = from.x + columnWide() * static_cast<float>(column);
        list.AddRectFilled({std::floor(left), y(top)}, {std::floor(left + columnWide()), y(foot)}, fill);
    }
    void name(Row row, char const* text) const {
        float const at = y(row.top + 0.5f * row.high) - 0.5f * fonts().small.size_px;
        drawPlainText(list, fonts().small, {from.x - (kLabels - 1.0f) * unit(), at}, kFaint, text);
    }
    void scale(float units, std::string const& text) const {
        drawPlainText(list, fonts().small, {from.x + wide + 6.0f * unit(), y(units) - 0.5f * fonts().small.size_px}, kFaint, text);
    }
};

void drawGround(StripPen const& pen) {
    for (std::size_t i = 0; i < pen.strip.columns.size(); ++i)
        pen.box(i, 0.0f, kHeatRow.foot(), pen.strip.columns[i].night ? kNight : kSky);
    for (Row row : {kRainRow, kWindRow, kHeatRow})
        pen.list.AddLine({pen.from.x, pen.y(row.top - 2.0f)}, {pen.from.x + pen.wide, pen.y(row.top - 2.0f)}, kLine);
}

/// Cover as the filled share of the row's height: it reads without colour.
void drawCover(StripPen const& pen) {
    auto const bar = [&](std::size_t i, Row row, double cover, ImU32 fill) {
        if (cover > 0.02) pen.box(i, row.foot() - row.high * static_cast<float>(cover), row.foot(), fill);
    };
    for (std::size_t i = 0; i < pen.strip.columns.size(); ++i) {
        StripColumn const& column = pen.strip.columns[i];
        bar(i, kHighRow, column.high, kHigh);
        bar(i, kMidRow, column.mid, kMid);
        bar(i, kLowRow, column.low, column.storm ? IM_COL32(250, 214, 120, 255) : kLow);
    }
    pen.name(kHighRow, "High");
    pen.name(kMidRow, "Mid");
    pen.name(kLowRow, "Low");
    pen.scale(kMidRow.top + 0.5f * kMidRow.high, "cloud");
}

/// A flash with a dark edge, once at the start of thunder and again every so often while it lasts.
void drawThunder(StripPen const& pen) {
    float last = -1e9f;
    for (StripColumn const& column : pen.strip.columns) {
        float const x = pen.x(column.time), s = unit(), y = pen.y(kLowRow.top + 1.0f);
        if (!column.thunder || x - last < 17.0f * s) continue;
        last = x;
        ImVec2 const flash[] = {{x + 3 * s, y}, {x - 3 * s, y + 9 * s}, {x + 2 * s, y + 8 * s}, {x - 3 * s, y + 17 * s}};
        pen.list.AddPolyline(flash, 4, kInk, 0, 4.5f * s);
        pen.list.AddPolyline(flash, 4, kYellow, 0, 2.0f * s);
    }
}

char const* kindWord(weather::Precipitation kind) {
    return kind == weather::Precipitation::None || kind == weather::Precipitation::Unknown ? "rain" : weather::precipitationName(kind).data();
}

void drawRain(StripPen const& pen) {
    double most = 0.0;
    for (StripColumn const& column : pen.strip.columns) most = std::max(most, column.rain);
    double const top = std::max(most, 2.0);
    weather::Precipitation shown = weather::Precipitation::None;
    float labelEnd = -1e9f;
    for (std::size_t i = 0; i < pen.strip.columns.size(); ++i) {
        StripColumn const& column = pen.strip.columns[i];
        if (column.rain < 0.02) continue;
        // The root of the rate: drizzle is seen beside a cloudburst.
        auto const share = static_cast<float>(std::sqrt(column.rain / top));
        pen.box(i, kRainRow.foot() - std::max(1.5f, kRainRow.high * share), kRainRow.foot(), kWater);
        if (column.kind == weather::Precipitation::Rain || column.kind == weather::Precipitation::Unknown || column.kind == shown || pen.x(column.time) < labelEnd) continue;
        shown = column.kind;
        labelEnd = pen.x(column.time) + drawText(pen.list, fonts().small, {pen.x(column.time), pen.y(kRainRow.top - 1.0f)}, kPaper, kindWord(shown));
    }
    pen.name(kRainRow, "Rain");
    pen.scale(kRainRow.top + 0.5f * kRainRow.high, most < 0.05 ? "none" : fmt::format("{:.{}f} mm/h", most, most < 9.95 ? 1 : 0));
}

/// Arrows go where the air goes, north up, as long as it is fast; the line above them is the gust.
void drawWinds(StripPen const& pen) {
    double gust = 0.0, fast = 0.0;
    for (StripColumn const& column : pen.strip.columns)
        gust = std::max(gust, column.gust), fast = std::max(fast, glm::length(column.wind));
    float const s = unit(), apart = 22.0f * s;
    auto const every = static_cast<std::size_t>(std::max(1.0f, std::ceil(apart / pen.columnWide())));
    std::vector<ImVec2> line;
    for (std::size_t i = 0; i < pen.strip.columns.size(); ++i) {
        StripColumn const& column = pen.strip.columns[i];
        float const high = kWindRow.high * static_cast<float>(column.gust / std::max(gust, 5.0));
        line.push_back({pen.x(column.time), pen.y(kWindRow.foot() - high)});
        double const speed = glm::length(column.wind);
        if (i % every != every / 2 || speed < 0.3) continue;
        glm::vec2 const way{glm::dvec2{column.wind.x, -column.wind.y} / speed};
        float const reach = (4.5f + 7.0f * static_cast<float>(speed / std::max(fast, 4.0))) * s;
        glm::vec2 const middle{pen.x(column.time), pen.y(kWindRow.top + 0.5f * kWindRow.high)};
        drawArrow(pen.list, middle - reach * way, middle + reach * way, 2.0f * s, kPaper);
    }
    pen.list.AddPolyline(line.data(), static_cast<int>(line.size()), kYellow, 0, 1.2f * s);
    pen.name(kWindRow, "Wind");
    pen.scale(kWindRow.top + 8.0f, fmt::format("{:.0f} m/s", gust));
    pen.scale(kWindRow.top + 21.0f, "gust");
}

void drawHeat(StripPen const& pen) {
    auto const colder = [](auto const& a, auto const& b) { return a.temperature_c < b.temperature_c; };
    auto const [least, most] = std::minmax_element(pen.strip.columns.begin(), pen.strip.columns.end(), colder);
    double const low = least->temperature_c, range = std::max(most->temperature_c - low, 4.0);
    std::vector<ImVec2> line;
    for (StripColumn const& column : pen.strip.columns)
        line.push_back({pen.x(column.time), pen.y(kHeatRow.foot() - 3.0f - (kHeatRow.high - 6.0f) * static_cast<float>((column.temperature_c - low) / range))});
    pen.list.AddPolyline(line.data(), static_cast<int>(line.size()), kInk, 0, 4.0f * unit());
    pen.list.AddPolyline(line.data(), static_cast<int>(line.size()), kWarm, 0, 2.0f * unit());
    pen.name(kHeatRow, "Temp");
    pen.scale(kHeatRow.top + 8.0f, fmt::format("{:.0f}\u00b0C", most->temperature_c));
    pen.scale(kHeatRow.foot() - 7.0f, fmt::format("{:.0f}\u00b0C", low));
}

/// Hours that are far enough apart to be read; the date at each midnight.
void drawHours(StripPen const& pen) {
    double const span = pen.strip.end - pen.strip.start;
    double step = kHour;
    for (double wanted : {1.0, 3.0, 6.0, 12.0, 24.0, 48.0, 96.0, 240.0}) {
        step = wanted * kHour;
        if (pen.wide * static_cast<float>(step / span) >= 44.0f * unit()) break;
    }
    for (double time = std::ceil(pen.strip.start / step) * step; time <= pen.strip.end; time += step) {
        float const x = pen.x(time);
        bool const midnight = std::fmod(time, kDay) == 0.0;
        pen.list.AddLine({x, pen.y(0.0f)}, {x, pen.y(kHeatRow.foot())}, midnight ? IM_COL32(250, 245, 230, 110) : kLine);
        std::string const stamp = core::formatUtc(time);
        if (x < pen.from.x + 14.0f * unit() || x > pen.from.x + pen.wide - 8.0f * unit()) continue;
        drawPlainText(pen.list, fonts().small, {x, pen.y(kTimeRow.top)}, kFaint, midnight ? stamp.substr(8, 2) + "." + stamp.substr(5, 2) + "." : stamp.substr(11, 5), 0.5f);
    }
}

void drawNow(StripPen const& pen, double utc) {
    float const x = std::round(pen.x(utc)), s = unit();
    pen.list.AddLine({x, pen.y(-3.0f)}, {x, pen.y(kHeatRow.foot() + 2.0f)}, kInk, 4.0f * s);
    pen.list.AddLine({x, pen.y(-3.0f)}, {x, pen.y(kHeatRow.foot() + 2.0f)}, kYellow, 2.0f * s);
    pen.list.AddTriangleFilled({x, pen.y(2.0f)}, {x - 6.0f * s, pen.y(-6.0f)}, {x + 6.0f * s, pen.y(-6.0f)}, kYellow);
}
}  // namespace

std::optional<double> drawWeatherStrip(WeatherStrip const& strip, double utc, float width) {
    if (strip.columns.empty()) return std::nullopt;
    ImGui::Dummy({0.0f, 3.0f * unit()});
    ImVec2 const corner = ImGui::GetCursorScreenPos();
    glm::vec2 const from{corner.x + kLabels * unit(), corner.y};
    float const wide = width - (kLabels + kScale) * unit();
    ImGui::InvisibleButton("strip", {width, kStripHigh * unit()});
    StripPen const pen{*ImGui::GetWindowDrawList(), strip, from, wide};
    drawGround(pen);
    drawCover(pen);
    drawThunder(pen);
    drawRain(pen);
    drawWinds(pen);
    drawHeat(pen);
    drawHours(pen);
    drawNow(pen, utc);
    if (!ImGui::IsItemActive()) return std::nullopt;
    double const share = std::clamp(static_cast<double>((ImGui::GetIO().MousePos.x - from.x) / wide), 0.0, 1.0);
    return strip.start + share * (strip.end - strip.start);
}
}  // namespace luftpost::ui
