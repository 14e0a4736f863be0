#include <fmt/format.h>

#include <map>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "engine/weather/csv_table.h"
#include "engine/weather/json_body.h"
#include "engine/weather/meteoswiss.h"
#include "engine/weather/report_parts.h"

namespace luftpost::weather {
namespace {
constexpr std::string_view kTime = "zzzztttt", kStation = "IIiii", kKind = "zxltcos0", kLatitudeColumn = "yloclas0", kLongitudeColumn = "yloclos0",
                           kPressureColumn = "zreppps0", kHeight = "zreppzs0", kDry = "zrettts0", kDew = "zretdes0", kFrom = "zklddds0",
                           kWind = "zklfffs0";
constexpr Range kAirPressure{0.0, 1100.0};

/// The line that names the columns stands under the bulletin's head.
std::size_t headingLine(std::string_view bytes, std::string const& file) {
    for (std::size_t line = 0; line < 5 && !bytes.empty(); ++line) {
        std::string_view const text = firstLine(bytes);
        if (text.find(kTime) != text.npos) return line;
        std::size_t const end = bytes.find('\n');
        bytes = end == bytes.npos ? std::string_view{} : bytes.substr(end + 1);
    }
    throw core::Error(file, "line 1", "expected the columns of a sounding (IIiii;zzzztttt;...) within the first five lines");
}

/// Kinds of level: 1 is the ground, 10 a mandatory one (below the ground too), others significant.
bool isGround(CsvTable const& table, std::size_t row) { return table.text(row, kKind) == "1"; }

void addRow(CsvTable const& table, std::size_t row, Site& site, Report& report) {
    auto const altitude = table.number(row, kHeight, kAltitude);
    if (!altitude) return;  // the last row, with codes instead of heights
    ReportedLevel level{*altitude, table.number(row, kDry, kTemperature), table.number(row, kDew, kDewPoint), {}, {}, {}};
    setWind(table.number(row, kWind, kSpeed), table.number(row, kFrom, kDegrees), level.speed_mps, level.from_deg);
    if (isGround(table, row)) {
        site.lat_deg = table.number(row, kLatitudeColumn, kLatitude);
        site.lon_deg = table.number(row, kLongitudeColumn, kLongitude);
        if (!site.lat_deg || !site.lon_deg) site.lat_deg.reset(), site.lon_deg.reset();
        site.elevation_m = table.number(row, kHeight, kElevation);
        report.temperature_c = level.temperature_c;
        report.dew_point_c = level.dew_point_c;
        report.speed_mps = level.speed_mps;
        report.from_deg = level.from_deg;
        if (auto const pressure = table.number(row, kPressureColumn, kAirPressure))
            fillSeaPressure(report, *pressure, *altitude, table.file(), table.place(row, kPressureColumn));
    } else if (level.temperature_c || level.dew_point_c || level.speed_mps) {
        report.levels.push_back(level);
    }
}

/// The freezing level where the air cools through 0 degrees for the first time above the ground. m.
std::optional<double> freezingLevel(Report const& report) {
    std::optional<ReportedLevel> below;
    for (ReportedLevel const& level : report.levels) {
        if (!level.temperature_c) continue;
        if (below && *below->temperature_c > 0.0 && *level.temperature_c <= 0.0)
            return below->altitude_m +
                   (level.altitude_m - below->altitude_m) * *below->temperature_c / (*below->temperature_c - *level.temperature_c);
        below = level;
    }
    return std::nullopt;
}
}  // namespace

Recording parseSounding(std::string_view bytes, std::string const& file) {
    CsvTable const table{bytes, ';', headingLine(bytes, file), file};
    std::map<std::string_view, Site> sites;
    std::map<std::pair<std::string_view, core::UtcSeconds>, Report> reports;
    for (std::size_t row = 0; row < table.rows(); ++row) {
        auto const time = swissTime(table.text(row, kTime));
        if (!time) throw core::Error(file, table.place(row, kTime), "expected a time such as \"202306190000\"");
        std::string_view const station = table.text(row, kStation);
        Report& report = reports[{station, *time}];
        report.time = *time;
        addRow(table, row, sites[station], report);
        if (sites.size() > kMostSites) throw core::Error(file, table.place(row, kStation), fmt::format("expected at most {} stations", kMostSites));
    }
    Recording recording{file, {}, "MeteoSwiss (sounding)", "Source: MeteoSwiss (open data)", sha256Hex(bytes), {}, {}};
    for (auto& [station, site] : sites) {
        std::string_view const wmo = station.size() > 5 ? station.substr(station.size() - 5) : station;
        auto const known = swissStation(wmo);
        site.name = known ? known->name : oneLine(station, 60);
        for (auto const& [key, report] : reports)
            if (key.first == station) site.reports.push_back(report);
        for (Report& report : site.reports) {
            orderLevels(report.levels, site.elevation_m.value_or(kAltitude.low));
            report.freezingLevel_m = freezingLevel(report);
            if (report.freezingLevel_m && *report.freezingLevel_m > kFreezingLevel.high) report.freezingLevel_m.reset();
        }
        keepWhatSpeaks(site.reports);
        if (!site.reports.empty()) recording.sites.push_back(std::move(site));
    }
    checkCounts(recording.sites, file);
    if (recording.sites.empty()) throw core::Error(file, "", "expected at least one height with a value");
    recording.name = fmt::format("{}, sounding of {}", recording.sites.front().name,
                                 core::formatUtc(recording.sites.front().reports.front().time).substr(0, 13) + "Z");
    return recording;
}
}  // namespace luftpost::weather
