#include "game/app/flight_track.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>

#include "engine/core/error.h"
#include "engine/core/time.h"

namespace luftpost::app {
namespace {
constexpr double kLeap = 20.0;  // m in one tick: nothing flies so fast

/// A text as XML has it between tags.
std::string escaped(std::string_view text) {
    std::string result;
    for (char c : text) {
        if (c == '&') result += "&amp;";
        else if (c == '<') result += "&lt;";
        else if (c == '>') result += "&gt;";
        else result += c;
    }
    return result;
}
}  // namespace

FlightTrack::FlightTrack(core::Place const& place, core::UtcSeconds begin) : geodesy_{place}, begin_{begin} {}

void FlightTrack::add(long long tick, flight::AircraftState const& state) {
    Point const now{static_cast<double>(tick) * core::kTickSeconds, state.positionWorld};
    bool const leapt = !parts_.empty() && glm::distance(now.positionWorld, latest_.positionWorld) > kLeap;
    if (leapt && parts_.back().back().seconds < latest_.seconds) parts_.back().push_back(latest_);
    if (parts_.empty() || leapt) parts_.emplace_back();
    if (parts_.back().empty() || tick % core::kTicksPerSecond == 0) parts_.back().push_back(now);
    latest_ = now;
}

void FlightTrack::mark(std::string name, double seconds, glm::dvec3 const& positionWorld) { marks_.push_back({std::move(name), {seconds, positionWorld}}); }

void FlightTrack::markDrops(std::vector<delivery::Drop> const& drops) {
    for (std::size_t i = 0; i < drops.size(); ++i) {
        delivery::Drop const& drop = drops[i];
        mark(fmt::format("Parcel {} released", i + 1), drop.t, drop.releaseWorld);
        if (!drop.landingTime) continue;
        std::string const end = drop.delivered ? fmt::format("delivered, {:.0f} points", drop.score) : "lost";
        mark(fmt::format("Parcel {} {}, {:.0f} m from the centre", i + 1, end, drop.distance), *drop.landingTime, drop.landingWorld);
    }
}

std::vector<std::vector<FlightTrack::Point>> FlightTrack::parts() const {
    std::vector<std::vector<Point>> whole = parts_;
    if (!whole.empty() && whole.back().back().seconds < latest_.seconds) whole.back().push_back(latest_);
    return whole;
}

std::string FlightTrack::timeOf(Point const& point) const { return core::formatUtc(begin_ + point.seconds); }

std::string FlightTrack::kml() const {
    std::string text =
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n"
        "<kml xmlns=\"http://www.opengis.net/kml/2.2\" xmlns:gx=\"http://www.google.com/kml/ext/2.2\">\n<Document>\n<name>Luftpost</name>\n"
        "<Placemark>\n<name>Flight</name>\n<gx:MultiTrack>\n<altitudeMode>absolute</altitudeMode>\n<gx:interpolate>0</gx:interpolate>\n";
    auto const out = std::back_inserter(text);
    for (std::vector<Point> const& part : parts()) {
        text += "<gx:Track>\n<altitudeMode>absolute</altitudeMode>\n";
        for (Point const& point : part) fmt::format_to(out, "<when>{}</when>\n", timeOf(point));
        for (Point const& point : part)
            fmt::format_to(out, "<gx:coord>{:.8f} {:.8f} {:.2f}</gx:coord>\n", geodesy_.lon_deg(point.positionWorld), geodesy_.lat_deg(point.positionWorld),
                           point.positionWorld.y);
        text += "</gx:Track>\n";
    }
    text += "</gx:MultiTrack>\n</Placemark>\n";
    for (Mark const& mark : marks_)
        fmt::format_to(out,
                       "<Placemark>\n<name>{}</name>\n<TimeStamp><when>{}</when></TimeStamp>\n"
                       "<Point><altitudeMode>absolute</altitudeMode><coordinates>{:.8f},{:.8f},{:.2f}</coordinates></Point>\n</Placemark>\n",
                       escaped(mark.name), timeOf(mark.point), geodesy_.lon_deg(mark.point.positionWorld), geodesy_.lat_deg(mark.point.positionWorld),
                       mark.point.positionWorld.y);
    return text + "</Document>\n</kml>\n";
}

std::string FlightTrack::gpx() const {
    std::string text = fmt::format(
        "<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n<gpx version=\"1.1\" creator=\"Luftpost\" xmlns=\"http://www.topografix.com/GPX/1/1\">\n"
        "<metadata><time>{}</time></metadata>\n",
        core::formatUtc(begin_));
    auto const out = std::back_inserter(text);
    for (Mark const& mark : marks_)
        fmt::format_to(out, "<wpt lat=\"{:.8f}\" lon=\"{:.8f}\"><ele>{:.2f}</ele><time>{}</time><name>{}</name></wpt>\n", geodesy_.lat_deg(mark.point.positionWorld),
                       geodesy_.lon_deg(mark.point.positionWorld), mark.point.positionWorld.y, timeOf(mark.point), escaped(mark.name));
    text += "<trk>\n<name>Flight</name>\n";
    for (std::vector<Point> const& part : parts()) {
        text += "<trkseg>\n";
        for (Point const& point : part)
            fmt::format_to(out, "<trkpt lat=\"{:.8f}\" lon=\"{:.8f}\"><ele>{:.2f}</ele><time>{}</time></trkpt>\n", geodesy_.lat_deg(point.positionWorld),
                           geodesy_.lon_deg(point.positionWorld), point.positionWorld.y, timeOf(point));
        text += "</trkseg>\n";
    }
    return text + "</trk>\n</gpx>\n";
}

ExportKind exportKind(std::string_view option, std::string_view file) {
    constexpr std::array<std::pair<std::string_view, ExportKind>, 3> kKinds{{{".csv", ExportKind::csv}, {".kml", ExportKind::kml}, {".gpx", ExportKind::gpx}}};
    for (auto const& [ending, kind] : kKinds)
        if (file.ends_with(ending)) return kind;
    throw core::Error{std::string{option}, "", fmt::format("expected FILE.csv, FILE.kml or FILE.gpx, found {}", file)};
}
}  // namespace luftpost::app
