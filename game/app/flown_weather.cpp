#include "game/app/flown_weather.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "engine/weather/whole_report.h"
#include "game/app/weather_provider.h"

namespace luftpost::app {
namespace {
constexpr double kStepBetween = 1.0;  // s between the last report of one field and the first of the next

bool samePlace(weather::Site const& a, weather::Site const& b) { return a.name == b.name && a.lat_deg == b.lat_deg && a.lon_deg == b.lon_deg; }

double apart(weather::Site const& a, weather::Site const& b) {
    if (!a.lat_deg || !b.lat_deg) return 1.0e9;
    return distance({*a.lat_deg, *a.lon_deg}, {*b.lat_deg, *b.lon_deg});
}

void addNew(std::vector<std::string>& list, std::string const& text) {
    if (!text.empty() && std::find(list.begin(), list.end(), text) == list.end()) list.push_back(text);
}

/// The field's sites join those that are known.
void join(std::vector<weather::Site>& sites, weather::Recording const& recording) {
    for (weather::Site const& site : recording.sites) {
        if (std::any_of(sites.begin(), sites.end(), [&](auto const& known) { return samePlace(known, site); })) continue;
        weather::Site fresh{site.name, site.lat_deg, site.lon_deg, site.elevation_m, {}};
        auto const nearest = std::min_element(sites.begin(), sites.end(), [&](auto const& a, auto const& b) { return apart(a, site) < apart(b, site); });
        if (nearest != sites.end()) fresh.reports = nearest->reports;
        sites.push_back(std::move(fresh));
    }
}
}  // namespace

void FlownWeather::begin(weather::Field const& field, core::UtcSeconds time) {
    bool const first = sites_.empty();
    since_ = first ? time : time + kStepBetween;
    join(sites_, field.recording());
    addNew(providers_, field.origin().provider);
    addNew(licences_, field.origin().licence);
    name_ = field.origin().name;
    if (first) keep(field, since_);
}

void FlownWeather::end(weather::Field const& field, core::UtcSeconds time) {
    if (time < since_) return;
    for (weather::Site& site : sites_)
        std::erase_if(site.reports, [&](weather::Report const& report) { return report.time >= since_ - 0.5 && report.time <= time + 0.5; });
    for (double t = since_; t < time; t += kStep) keep(field, t);
    keep(field, time);
}

/// Times to the whole second, as a recording has them; of two in the same second the later one holds.
void FlownWeather::keep(weather::Field const& field, core::UtcSeconds time) {
    core::UtcSeconds const second = std::floor(time + 0.5);
    for (weather::Site& site : sites_) {
        std::vector<weather::Report>& reports = site.reports;
        std::erase_if(reports, [&](weather::Report const& report) { return report.time == second; });
        auto const after = std::find_if(reports.begin(), reports.end(), [&](weather::Report const& report) { return report.time > second; });
        double const interval = after == reports.begin() ? kStep : std::clamp(second - (after - 1)->time, 1.0, kStep);
        weather::Report report = weather::wholeReport(field, site, time, interval);
        report.time = second;
        reports.insert(after, std::move(report));
    }
}

weather::Recording FlownWeather::recording() const {
    weather::Recording recording;
    recording.name = name_ + ", as flown";
    recording.source = fmt::format("{}", fmt::join(providers_, "; "));
    recording.licence = fmt::format("{}", fmt::join(licences_, "; "));
    recording.sites = sites_;
    return recording;
}
}  // namespace luftpost::app
