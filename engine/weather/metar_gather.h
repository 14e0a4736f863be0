// Aerodrome reports of any file -> a recording: one site a station, its reports ascending, the file's order kept. Private to
// the METAR's files.
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "engine/weather/metar.h"
#include "engine/weather/recording.h"
#include "engine/weather/source.h"
#include "engine/weather/stations.h"

namespace luftpost::weather {
/// Where a report's text begins in its file: "line 7, column 1", or "[3].rawOb, column 1".
struct MetarPlace {
    std::string where;            // used where it is not empty: there is one line
    std::size_t line = 1, column = 1;
};

/// What stands around a report and helps to understand it.
struct MetarHints {
    std::optional<core::UtcSeconds> around;  // a moment near the report's
    std::optional<Station> station;          // the file's own word on where it is; only for stations that the table lacks
};

class MetarGathering {
public:
    /// Throws core::Error where the table of stations cannot be read.
    MetarGathering(std::string const& file, SourceContext const& context);

    /// One report; `text` must outlive this. Throws core::Error when there are too many.
    void add(std::string_view text, MetarPlace const& place, MetarHints const& hints);
    /// Something that is no report.
    void note(MetarPlace const& place, std::string const& what);

    /// Throws core::Error where there was no report.
    Recording finish(std::string_view bytes, std::string provider);

private:
    struct Gathered {
        std::string_view text;
        std::size_t site;
        Report report;
        bool corrected, timed;
    };

    std::size_t siteOf(std::string const& icao, MetarHints const& hints);
    std::optional<core::UtcSeconds> timeOf(Metar const& metar, MetarHints const& hints) const;
    void fillTimes();
    void orderSite(std::size_t site, std::vector<std::size_t> const& entries);
    std::string nameOf() const;

    std::string file_;
    core::UtcSeconds latest_;
    Stations stations_;
    std::unordered_map<std::string, std::size_t> siteByName_;
    std::vector<Gathered> gathered_;
    std::size_t moreNotes_ = 0;
    Recording recording_;
};
}  // namespace luftpost::weather
