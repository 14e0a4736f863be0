// Where the stations of aerodrome reports are: the table assets/weather/stations.txt (assets/make/stations.py made it).
#pragma once
#include <optional>
#include <string>
#include <string_view>
#include <unordered_map>

namespace luftpost::weather {
struct Station {
    double lat_deg = 0.0, lon_deg = 0.0;
    std::optional<double> elevation_m;
    std::string name;
};

class Stations {
public:
    Stations() = default;  // knows none
    /// Lines "ICAO<TAB>lat<TAB>lon<TAB>elevation_m<TAB>name", the elevation empty where nobody says it; # begins a comment. Throws
    /// core::Error that names the line.
    static Stations parse(std::string_view text, std::string const& file);

    Station const* find(std::string const& icao) const;
    std::size_t size() const { return stations_.size(); }

private:
    std::unordered_map<std::string, Station> stations_;
};
}  // namespace luftpost::weather
