#include "engine/weather/metar_gather.h"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <cmath>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/time.h"

namespace luftpost::weather {
namespace {
constexpr std::size_t kMostMetars = 100000;  // of one file: a day of the whole world, or ten years of a station
constexpr std::size_t kMostStations = 10000;
constexpr std::size_t kMostNotes = 1000;
constexpr std::size_t kLongestMetar = 8192;  // bytes
constexpr double kDay = 86400.0;

struct Month {
    int year, month;
    Month before() const { return month > 1 ? Month{year, month - 1} : Month{year - 1, 12}; }
    Month after() const { return month < 12 ? Month{year, month + 1} : Month{year + 1, 1}; }
};

Month monthOf(core::UtcSeconds time) {
    std::string const text = core::formatUtc(time);
    Month month{};
    std::from_chars(text.data(), text.data() + 4, month.year);
    std::from_chars(text.data() + 5, text.data() + 7, month.month);
    return month;
}

/// Nothing where the month has no such day.
std::optional<core::UtcSeconds> timeIn(Month month, MetarTime const& time) {
    return core::parseUtc(fmt::format("{:04}-{:02}-{:02}T{:02}:{:02}Z", month.year, month.month, time.day, time.hour, time.minute));
}

/// The latest such day at or before the day of `latest`.
std::optional<core::UtcSeconds> latestTime(MetarTime const& time, core::UtcSeconds latest) {
    double const endOfDay = (std::floor(latest / kDay) + 1.0) * kDay;
    Month month = monthOf(latest);
    for (int i = 0; i < 3; ++i, month = month.before())  // no two months in a row lack a day
        if (auto const found = timeIn(month, time); found && *found < endOfDay) return found;
    return std::nullopt;
}

/// The one nearest to `around`: a date line or a column may stand minutes on the other side of midnight.
std::optional<core::UtcSeconds> nearestTime(MetarTime const& time, core::UtcSeconds around) {
    Month const month = monthOf(around);
    std::optional<core::UtcSeconds> nearest;
    for (Month const m : {month, month.before(), month.after()})
        if (auto const found = timeIn(m, time); found && (!nearest || std::abs(*found - around) < std::abs(*nearest - around))) nearest = found;
    return nearest;
}

std::string placeText(MetarPlace const& place, std::string_view text, std::size_t offset) {
    if (!place.where.empty()) return fmt::format("{}, column {}", place.where, place.column + offset);
    std::string_view const before = text.substr(0, offset);
    auto const newline = before.rfind('\n');
    auto const lines = static_cast<std::size_t>(std::count(before.begin(), before.end(), '\n'));
    return fmt::format("line {}, column {}", place.line + lines, newline == before.npos ? place.column + offset : offset - newline);
}

/// Text of a file inside a message: one line, printable, short.
std::string quoted(std::string_view text) {
    std::string line = "\"";
    for (char const c : text.substr(0, 60)) line += c >= ' ' && c <= '~' ? c : ' ';
    return line + (text.size() > 60 ? "...\"" : "\"");
}
}  // namespace

MetarGathering::MetarGathering(std::string const& file, SourceContext const& context) : file_{file}, latest_{context.latest} {
    if (!context.stationTable.empty()) stations_ = Stations::parse(core::readFile(context.stationTable), context.stationTable);
}

void MetarGathering::note(MetarPlace const& place, std::string const& what) {
    if (recording_.notes.size() < kMostNotes) recording_.notes.push_back(fmt::format("{}: {}", placeText(place, {}, 0), what));
    else ++moreNotes_;
}

std::size_t MetarGathering::siteOf(std::string const& icao, MetarHints const& hints) {
    auto const [entry, isNew] = siteByName_.try_emplace(icao, recording_.sites.size());
    if (!isNew) return entry->second;
    if (recording_.sites.size() == kMostStations) throw core::Error(file_, icao, fmt::format("expected at most {} stations", kMostStations));
    Site site;
    site.name = icao;
    Station const* const known = stations_.find(icao);
    if (Station const* const station = known ? known : (hints.station ? &*hints.station : nullptr)) {
        site.lat_deg = station->lat_deg;
        site.lon_deg = station->lon_deg;
        site.elevation_m = station->elevation_m;
    }
    recording_.sites.push_back(std::move(site));
    return entry->second;
}

std::optional<core::UtcSeconds> MetarGathering::timeOf(Metar const& metar, MetarHints const& hints) const {
    if (!metar.time) return hints.around;
    return hints.around ? nearestTime(*metar.time, *hints.around) : latestTime(*metar.time, latest_);
}

void MetarGathering::add(std::string_view text, MetarPlace const& place, MetarHints const& hints) {
    auto const metar = text.size() <= kLongestMetar ? decodeMetar(text) : std::nullopt;
    if (!metar) return note(place, fmt::format("{} is no METAR", quoted(text)));
    if (gathered_.size() == kMostMetars) throw core::Error(file_, placeText(place, {}, 0), fmt::format("expected at most {} reports", kMostMetars));
    for (MetarNote const& said : metar->notes) {
        if (recording_.notes.size() == kMostNotes) {
            ++moreNotes_;
            continue;
        }
        recording_.notes.push_back(fmt::format("{}: {}: {} {}", placeText(place, text, said.offset), metar->station,
                                               quoted(text.substr(said.offset, said.length)), said.what));
    }
    std::size_t const site = siteOf(metar->station, hints);
    Report report = reportOf(*metar, recording_.sites[site].elevation_m);
    auto const time = timeOf(*metar, hints);
    report.time = time.value_or(0.0);
    gathered_.push_back({text, site, std::move(report), metar->corrected, time.has_value()});
}

/// A report whose own time cannot be read takes that of the one before it in the file, else of the first that has one.
void MetarGathering::fillTimes() {
    auto const first = std::find_if(gathered_.begin(), gathered_.end(), [](Gathered const& g) { return g.timed; });
    core::UtcSeconds time = first == gathered_.end() ? std::floor(latest_ / 60.0) * 60.0 : first->report.time;
    for (Gathered& entry : gathered_) {
        if (entry.timed) {
            time = entry.report.time;
            continue;
        }
        entry.report.time = time;
        entry.report.filled["time"] = core::formatUtc(time);
    }
}

/// Of several reports of one time the last correction holds, else the last; the same text twice is the same report.
void MetarGathering::orderSite(std::size_t index, std::vector<std::size_t> const& entries) {
    Site& site = recording_.sites[index];
    std::vector<std::size_t> sorted = entries;
    std::stable_sort(sorted.begin(), sorted.end(), [this](auto a, auto b) { return gathered_[a].report.time < gathered_[b].report.time; });
    for (auto from = sorted.begin(); from != sorted.end();) {
        auto const to = std::find_if(from, sorted.end(), [&](auto i) { return gathered_[i].report.time != gathered_[*from].report.time; });
        auto const rank = [this](std::size_t i) { return (gathered_[i].timed ? 2 : 0) + (gathered_[i].corrected ? 1 : 0); };
        std::size_t const holds = *std::max_element(from, to, [&](auto a, auto b) { return std::pair{rank(a), a} < std::pair{rank(b), b}; });
        std::string_view const text = gathered_[holds].text;
        for (; from != to; ++from) {
            bool const same = gathered_[*from].text == text;
            recording_.order[*from] = {index, same ? site.reports.size() : site.superseded.size(), !same};
            if (!same) site.superseded.push_back(std::move(gathered_[*from].report));
        }
        site.reports.push_back(std::move(gathered_[holds].report));
    }
}

std::string MetarGathering::nameOf() const {
    if (recording_.sites.size() > 1) return fmt::format("METAR of {} stations", recording_.sites.size());
    Station const* const station = stations_.find(recording_.sites[0].name);
    return station ? fmt::format("METAR {}, {}", recording_.sites[0].name, station->name) : "METAR " + recording_.sites[0].name;
}

Recording MetarGathering::finish(std::string_view bytes, std::string provider) {
    if (gathered_.empty()) {
        std::string const found = recording_.notes.empty() ? "none" : recording_.notes.front();
        throw core::Error(file_, "", "expected at least one METAR, found " + found);
    }
    fillTimes();
    std::vector<std::vector<std::size_t>> entries(recording_.sites.size());
    for (std::size_t i = 0; i < gathered_.size(); ++i) entries[gathered_[i].site].push_back(i);
    recording_.order.resize(gathered_.size());
    for (std::size_t i = 0; i < entries.size(); ++i) orderSite(i, entries[i]);
    if (moreNotes_ > 0) recording_.notes.push_back(fmt::format("and {} more", moreNotes_));
    recording_.file = file_;
    recording_.name = nameOf();
    recording_.source = std::move(provider);
    recording_.licence = "not stated in the file";
    recording_.sha256 = sha256Hex(bytes);
    return std::move(recording_);
}
}  // namespace luftpost::weather
