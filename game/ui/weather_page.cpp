#include "game/ui/weather_page.h"

#include <fmt/format.h>
#include <imgui.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <utility>

#include "engine/core/time.h"
#include "engine/weather/genera.h"
#include "game/ui/menu_parts.h"

namespace luftpost::ui {
namespace {
constexpr double kHour = 3600.0, kDay = 86400.0;

void sameLine() { ImGui::SameLine(0.0f, 5.0f * unit()); }

std::string hourText(double utc) {
    std::string const time = core::formatUtc(utc);
    return fmt::format("{}  {} UTC", time.substr(0, 10), time.substr(11, 5));
}

// --- real hours -------------------------------------------------------------------------------------------------
void drawTime(MenuWeather const& weather, WeatherAnswer& answer) {
    bool const recorded = weather.end > weather.start;
    double const start = recorded ? weather.start : std::floor(weather.utc / kDay) * kDay;
    double const end = recorded ? weather.end : start + kDay - 60.0;
    ImGui::TextUnformatted("Time");
    ImGui::SameLine();
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::kYellow), "%s", hourText(weather.utc).c_str());
    float const width = ImGui::GetContentRegionAvail().x;
    if (weather.strip)
        if (auto const utc = drawWeatherStrip(*weather.strip, weather.utc, width)) answer.utc = utc;
    double hours = std::clamp((weather.utc - start) / kHour, 0.0, (end - start) / kHour);
    ImGui::SetNextItemWidth(-1.0f);
    if (drawSlider("##time", hours, 0.0, (end - start) / kHour, recorded ? "%.1f h after the start" : "%.1f h UTC")) answer.utc = start + hours * kHour;
    ImGui::PushFont(fonts().small.letters);
    constexpr std::array<std::pair<char const*, double>, 6> kSteps{{{"\u22121 day", -24.0}, {"\u22121 h", -1.0}, {"\u221210 min", -1.0 / 6.0}, {"+10 min", 1.0 / 6.0}, {"+1 h", 1.0}, {"+1 day", 24.0}}};
    for (auto const& [label, step] : kSteps) {
        if (ImGui::Button(label)) answer.utc = std::clamp(weather.utc + step * kHour, start, end);
        if (label != kSteps.back().first) sameLine();
    }
    ImGui::PopFont();
}

/// Buttons that break into a new line where the next would not fit.
class Flow {
public:
    bool button(std::string const& label) {
        float const wide = ImGui::CalcTextSize(label.c_str()).x + 2.0f * ImGui::GetStyle().FramePadding.x;
        float const edge = ImGui::GetWindowPos().x + ImGui::GetContentRegionMax().x;
        if (any_ && ImGui::GetItemRectMax().x + 5.0f * unit() + wide < edge) sameLine();
        any_ = true;
        return ImGui::Button(label.c_str());
    }

private:
    bool any_ = false;
};

void drawMoments(WeatherStrip const& strip, WeatherAnswer& answer) {
    if (strip.moments.empty()) return;
    ImGui::PushFont(fonts().small.letters);
    Flow flow;
    for (std::size_t i = 0; i < strip.moments.size(); ++i) {
        StripMoment const& moment = strip.moments[i];
        std::string const stamp = core::formatUtc(moment.time);
        if (flow.button(fmt::format("{} {}. {}##{}", moment.name, stamp.substr(8, 2), stamp.substr(11, 5), i)))
            answer.utc = std::max(strip.start, moment.time - 300.0);  // a little before, so that one sees it come
        if (ImGui::IsItemHovered()) ImGui::SetTooltip("Five minutes before");
    }
    ImGui::PopFont();
}

void drawRate(MenuWeather const& weather, WeatherAnswer& answer) {
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Speed of time");
    for (double rate : kTimeRates) {
        ImGui::SameLine(0.0f, 10.0f * unit());
        std::string const label = rate == 0.0 ? "stop" : fmt::format("{:.0f} x", rate);
        if (ImGui::RadioButton(label.c_str(), weather.rate == rate) && weather.rate != rate) answer.rate = rate;
    }
}

void drawSource(MenuWeather::Source const& source, MenuWeather const& weather, WeatherAnswer& answer) {
    ImGui::PushID(source.source.c_str());
    bool const current = source.source == weather.current;
    if (ImGui::RadioButton(source.label.c_str(), current) && !current) answer.source = source.source;
    if (!source.detail.empty()) {
        ImGui::Indent(30.0f * unit());
        drawHelp(source.detail);
        ImGui::Unindent(30.0f * unit());
    }
    ImGui::PopID();
}

void drawReal(MenuWeather const& weather, WeatherAnswer& answer) {
    if (!beginPage("Recorded")) return;
    ImGui::BeginChild("rows", {0.0f, 0.0f}, false);
    drawTime(weather, answer);
    drawRate(weather, answer);
    if (weather.strip) drawMoments(*weather.strip, answer);
    ImGui::Separator();
    ImGui::TextUnformatted("Source");
    for (std::string const& line : weather.live) drawHelp(line);
    for (bool presets : {false, true}) {
        if (presets) drawHelp("Presets: made up, and the same all day");
        for (MenuWeather::Source const& source : weather.sources)
            if (source.preset == presets) drawSource(source, weather, answer);
    }
    ImGui::EndChild();
    ImGui::EndTabItem();
}

void drawHourRow(MenuWeather::Hour const& hour, std::size_t index, WeatherAnswer& answer) {
    ImGui::PushID(static_cast<int>(index));
    float const button = 64.0f * unit();
    ImVec2 const corner = ImGui::GetCursorPos();
    ImGui::SetCursorPosX(ImGui::GetContentRegionMax().x - button);
    if (ImGui::Button("Fly", {button, 0.0f})) answer.hour = index;
    ImGui::SetCursorPos(corner);
    ImGui::PushStyleVar(ImGuiStyleVar_ItemSpacing, {ImGui::GetStyle().ItemSpacing.x, 3.0f * unit()});
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(colour::kYellow), "%s", hour.name.c_str());
    ImGui::TextUnformatted(hour.when.c_str());
    drawHelp(hour.why);
    ImGui::PopStyleVar();
    ImGui::Separator();
    ImGui::PopID();
}

void drawHours(MenuWeather const& weather, WeatherAnswer& answer) {
    if (!beginPage("Hours")) return;
    ImGui::BeginChild("rows", {0.0f, 0.0f}, false);
    drawHelp("Hours worth seeing. To fly one begins a new flight there and then.");
    for (std::size_t i = 0; i < weather.hours.size(); ++i) drawHourRow(weather.hours[i], i, answer);
    ImGui::EndChild();
    ImGui::EndTabItem();
}

// --- by hand ----------------------------------------------------------------------------------------------------
bool drawGenus(HandLayer& layer, double elevation) {
    bool changed = false;
    ImGui::SetNextItemWidth(64.0f * unit());
    if (!ImGui::BeginCombo("##genus", weather::genusName(layer.genus).data())) return changed;
    for (int i = 0; i < weather::kGenera; ++i) {
        auto const genus = static_cast<weather::Genus>(i);
        if (ImGui::Selectable(weather::genusName(genus).data(), genus == layer.genus) && genus != layer.genus)
            useGenus(layer, genus, elevation), changed = true;
    }
    ImGui::EndCombo();
    return changed;
}

/// Answers whether something changed; `remove` when the layer shall go.
bool drawLayer(HandLayer& layer, double elevation, bool& remove) {
    float const cross = 30.0f * unit();
    bool changed = drawGenus(layer, elevation);
    sameLine();
    ImGui::SetNextItemWidth(-cross - 6.0f * unit());
    changed |= drawSlider("##cover", layer.eighths, 0.0, 8.0, "%.1f eighths");
    ImGui::SameLine(ImGui::GetContentRegionMax().x - cross);
    remove = ImGui::Button("\u00d7", {cross, 0.0f});
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Remove this layer");
    float const half = 0.5f * (ImGui::GetContentRegionAvail().x - 5.0f * unit());
    ImGui::SetNextItemWidth(half);
    double const thick = layer.top_m - layer.base_m;
    if (drawSlider("##base", layer.base_m, kHandHeight.least, kHandHeight.most - kHandThinnest_m, "base %.0f m"))
        layer.top_m = layer.base_m + thick, changed = true;  // the layer moves as a whole
    sameLine();
    ImGui::SetNextItemWidth(half);
    changed |= drawSlider("##top", layer.top_m, layer.base_m + kHandThinnest_m, kHandHeight.most, "top %.0f m");
    return changed;
}

bool drawLayers(HandWeather& hand, double elevation) {
    bool changed = false;
    std::optional<std::size_t> gone;
    for (std::size_t i = 0; i < hand.layers.size(); ++i) {
        ImGui::PushID(static_cast<int>(i));
        bool remove = false;
        changed |= drawLayer(hand.layers[i], elevation, remove);
        if (remove) gone = i;
        ImGui::Dummy({0.0f, 1.0f * unit()});
        ImGui::PopID();
    }
    if (gone) hand.layers.erase(hand.layers.begin() + static_cast<std::ptrdiff_t>(*gone)), changed = true;
    if (hand.layers.size() < static_cast<std::size_t>(weather::kMaxLayers) && ImGui::Button("+ Add a layer"))
        hand.layers.push_back(anotherLayer(hand, elevation)), changed = true;
    return changed;
}

bool drawRainControls(HandWeather& hand) {
    bool changed = false;
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Falls");
    ImGui::SameLine(118.0f * unit());
    ImGui::SetNextItemWidth(116.0f * unit());
    auto const word = [](weather::Precipitation kind) {
        std::string text{weather::precipitationName(kind)};
        std::replace(text.begin(), text.end(), '_', ' ');
        return text;
    };
    if (ImGui::BeginCombo("##kind", word(hand.kind).c_str())) {
        for (int i = 0; i < static_cast<int>(weather::Precipitation::Unknown); ++i) {
            auto const kind = static_cast<weather::Precipitation>(i);
            if (!ImGui::Selectable(word(kind).c_str(), kind == hand.kind)) continue;
            if (hand.kind == weather::Precipitation::None && hand.rate_mm_h == 0.0) hand.rate_mm_h = 2.0;
            hand.kind = kind, changed = true;
        }
        ImGui::EndCombo();
    }
    sameLine();
    bool const dry = hand.kind == weather::Precipitation::None;
    ImGui::BeginDisabled(dry);
    ImGui::SetNextItemWidth(-1.0f);
    changed |= drawSlider("##rate", hand.rate_mm_h, kHandRate.least, kHandRate.most, "%.1f mm/h");
    ImGui::EndDisabled();
    return changed;
}

bool drawAirControls(HandWeather& hand) {
    bool changed = drawSliderRow("Wind from", hand.from_deg, 0.0, 360.0, "%.0f\u00b0");
    changed |= drawSliderRow("Wind speed", hand.speed_mps, kHandSpeed.least, kHandSpeed.most, "%.1f m/s");
    changed |= drawSliderRow("Gusts", hand.gust_mps, kHandGust.least, kHandGust.most, "%.1f m/s");
    changed |= drawSliderRow("Visibility", hand.visibility_km, kHandVisibility_km.least, kHandVisibility_km.most, "%.2f km", true);
    changed |= drawRainControls(hand);
    ImGui::AlignTextToFramePadding();
    ImGui::TextUnformatted("Thunder");
    ImGui::SameLine(118.0f * unit());
    changed |= ImGui::Checkbox(hand.thunder ? "on##thunder" : "off##thunder", &hand.thunder);
    changed |= drawSliderRow("Temperature", hand.temperature_c, kHandTemperature.least, kHandTemperature.most, "%.1f \u00b0C");
    changed |= drawSliderRow("Dew point", hand.dewPoint_c, kHandTemperature.least - 30.0, kHandTemperature.most, "%.1f \u00b0C");
    changed |= drawSliderRow("Pressure", hand.pressure_hpa, kHandPressure.least, kHandPressure.most, "%.1f hPa");
    changed |= drawSliderRow("Instability", hand.cape_j_kg, kHandCape.least, kHandCape.most, "%.0f J/kg");
    return changed;
}

void drawHand(MenuWeather const& weather, WeatherAnswer& answer) {
    if (!beginPage("By hand")) return;
    ImGui::BeginChild("rows", {0.0f, 0.0f}, false);
    ImGui::TextColored(ImGui::ColorConvertU32ToFloat4(weather.byHand ? colour::kYellow : colour::kFaint), "%s",
                       weather.byHand ? "This weather is yours" : "Move a control: the weather is yours from then on");
    if (ImGui::Button("Start from here")) answer.startFromHere = true;
    if (ImGui::IsItemHovered()) ImGui::SetTooltip("Copies the weather at the aircraft into the controls");
    drawHelp("Cloud layers; heights above sea level");
    HandWeather hand = weather.hand;
    bool changed = drawLayers(hand, weather.elevation);
    ImGui::Separator();
    changed |= drawAirControls(hand);
    ImGui::EndChild();
    ImGui::EndTabItem();
    if (!changed) return;
    tidy(hand);
    answer.hand = std::move(hand);
}

// --- the photograph ---------------------------------------------------------------------------------------------
void drawPhotoPage(PhotoState const& photo, WeatherAnswer& answer) {
    if (photo.name.empty() || !beginPage("Photograph")) return;
    ImGui::BeginChild("rows", {0.0f, 0.0f}, false);
    ImGui::TextUnformatted(photo.name.c_str());
    drawHelp(photo.taken);
    PhotoView view = photo.view;
    constexpr std::array<std::pair<char const*, PhotoMode>, 4> kModes{{{"hidden", PhotoMode::hidden}, {"laid over", PhotoMode::over}, {"split", PhotoMode::split}, {"side by side", PhotoMode::beside}}};
    for (auto const& [label, mode] : kModes) {
        if (ImGui::RadioButton(label, view.mode == mode)) view.mode = mode;
        if (label != kModes.back().first) ImGui::SameLine(0.0f, 12.0f * unit());
    }
    drawSliderRow("Opacity", view.opacity, 0.0, 1.0, "%.2f");
    drawSliderRow("Split at", view.split, 0.0, 1.0, "%.2f of the width");
    ImGui::Separator();
    if (ImGui::Button("Compare the colours now")) answer.comparePhoto = true;
    if (!photo.comparison.empty()) ImGui::TextWrapped("%s", photo.comparison.c_str());
    drawHelp("Share of equal colours in CIELAB: 0 none, 1 all; the photograph cut to the picture's shape, both at 256 points across.");
    ImGui::EndChild();
    ImGui::EndTabItem();
    if (!(view == photo.view)) answer.photo = view;
}
}  // namespace

void drawWeatherPage(MenuWeather const& weather, bool open, WeatherAnswer& answer, std::function<void()> const& drawLivePage) {
    ImGui::PushFont(fonts().small.letters);
    bool const shown = ImGui::BeginTabItem("Weather", nullptr, open ? ImGuiTabItemFlags_SetSelected : ImGuiTabItemFlags_None);
    ImGui::PopFont();
    if (!shown) return;
    if (ImGui::BeginTabBar("weather pages")) {
        drawReal(weather, answer);
        drawHours(weather, answer);
        drawHand(weather, answer);
        drawLivePage();
        drawPhotoPage(weather.photo, answer);
        ImGui::EndTabBar();
    }
    ImGui::EndTabItem();
}
}  // namespace luftpost::ui
