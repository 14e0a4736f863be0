// The way of a flight for maps: KML for globes, GPX 1.1 for everything that reads tracks.
#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/environment.h"
#include "engine/flight/aircraft_state.h"
#include "game/app/geodesy.h"
#include "game/delivery/delivery.h"

namespace luftpost::app {
class FlightTrack {
public:
    /// `begin`: the weather's clock as the flight begins; the track's times go on from there with the flight's seconds.
    FlightTrack(core::Place const& place, core::UtcSeconds begin);

    /// Once a tick and once before the first: keeps a point a second. Where the aircraft is set somewhere else (a respawn) the track ends and another
    /// begins there.
    void add(long long tick, flight::AircraftState const& state);
    /// A place with a name on the map.
    void mark(std::string name, double seconds, glm::dvec3 const& positionWorld);
    /// Every parcel's release and landing.
    void markDrops(std::vector<delivery::Drop> const& drops);

    /// With the latest point, if it fell between two seconds. Altitudes are above sea level.
    std::string kml() const;
    std::string gpx() const;

private:
    struct Point {
        double seconds = 0.0;
        glm::dvec3 positionWorld{0.0};
    };
    struct Mark {
        std::string name;
        Point point;
    };
    std::vector<std::vector<Point>> parts() const;
    std::string timeOf(Point const& point) const;

    Geodesy geodesy_;
    core::UtcSeconds begin_;
    std::vector<std::vector<Point>> parts_;
    Point latest_;
    std::vector<Mark> marks_;
};

/// The kinds of file that --export writes, by their endings.
enum class ExportKind { csv, kml, gpx };
/// Throws core::Error for any other ending.
ExportKind exportKind(std::string_view option, std::string_view file);
}  // namespace luftpost::app
