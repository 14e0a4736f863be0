#include "game/ui/weather_strip.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "engine/weather/fill.h"
#include "engine/weather/genera.h"

namespace luftpost::ui {
namespace {
constexpr double kZeroCelsius = 273.15;    // K
constexpr double kFineStep = 600.0;        // s, within a column
constexpr int kMostParts = 12;             // of a column
constexpr double kApart = 5400.0;          // s: closer moments are one
constexpr double kGustWorth = 12.0, kRainWorth = 2.0;  // m/s, mm/h

double& levelCover(StripColumn& column, weather::Genus genus) {
    switch (weather::levelOf(genus)) {
        case weather::Level::High: return column.high;
        case weather::Level::Mid: return column.mid;
        case weather::Level::Low: break;
    }
    return column.low;
}

void addLayers(StripColumn& column, weather::Weather const& weather) {
    for (int i = 0; i < weather.layerCount; ++i) {
        weather::Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        double& cover = levelCover(column, layer.genus);
        cover = 1.0 - (1.0 - cover) * (1.0 - static_cast<double>(layer.cover));
        column.fog = column.fog || layer.genus == weather::Genus::Fog;
        column.storm = column.storm || layer.genus == weather::Genus::Cb;
    }
}

StripColumn columnAt(weather::Field const& field, glm::dvec2 at, double middle, double width) {
    StripColumn column;
    weather::Weather const weather = field.at(at.x, at.y, middle);
    column.time = middle;
    column.wind = weather.windSurface;
    column.temperature_c = weather.temperature - kZeroCelsius;
    column.night = weather::sunHeight(field.place().lat_deg, field.place().lon_deg, middle) < 0.0;
    addLayers(column, weather);
    int const parts = std::clamp(static_cast<int>(std::lround(width / kFineStep)), 1, kMostParts);
    for (int i = 0; i < parts; ++i) {
        weather::Weather const part = field.at(at.x, at.y, middle + width * ((i + 0.5) / parts - 0.5));
        if (part.precipitationRate > column.rain) column.kind = part.precipitation;
        column.rain = std::max(column.rain, part.precipitationRate);
        column.gust = std::max(column.gust, part.gust);
        column.thunder = column.thunder || part.thunder;
    }
    return column;
}

/// Candidates, the weightiest first; a later one too close to one already taken is left out.
void take(std::vector<StripMoment>& taken, StripMoment moment) {
    auto const close = [&](StripMoment const& other) { return std::abs(other.time - moment.time) < kApart; };
    if (taken.size() < kMostMoments && std::none_of(taken.begin(), taken.end(), close)) taken.push_back(std::move(moment));
}

std::vector<StripMoment> momentsOf(WeatherStrip const& strip, std::vector<weather::Passage> const& fronts) {
    std::vector<StripMoment> taken;
    for (weather::Passage const& front : fronts) take(taken, {front.time, "front"});
    bool before = false;
    for (StripColumn const& column : strip.columns) {
        if (column.thunder && !before) take(taken, {column.time, "thunder"});
        before = column.thunder;
    }
    auto const most = [&](auto const& value) {
        return *std::max_element(strip.columns.begin(), strip.columns.end(), [&](auto const& a, auto const& b) { return value(a) < value(b); });
    };
    if (!strip.columns.empty()) {
        StripColumn const gust = most([](StripColumn const& c) { return c.gust; }), rain = most([](StripColumn const& c) { return c.rain; });
        if (gust.gust >= kGustWorth) take(taken, {gust.time, fmt::format("gust {:.0f} m/s", gust.gust)});
        if (rain.rain >= kRainWorth) take(taken, {rain.time, fmt::format("rain {:.0f} mm/h", rain.rain)});
    }
    std::sort(taken.begin(), taken.end(), [](auto const& a, auto const& b) { return a.time < b.time; });
    return taken;
}
}  // namespace

WeatherStrip weatherStrip(weather::Field const& field, glm::dvec2 eastNorth, int columns) {
    WeatherStrip strip{field.start(), field.end(), {}, {}};
    if (!(strip.end > strip.start)) return strip;
    double const width = (strip.end - strip.start) / columns;
    for (int i = 0; i < columns; ++i)
        strip.columns.push_back(columnAt(field, eastNorth, strip.start + (i + 0.5) * width, width));
    strip.moments = momentsOf(strip, field.passages());
    return strip;
}
}  // namespace luftpost::ui
