// What a Field is made of. Private to the field's own files.
#pragma once
#include "engine/weather/curve.h"
#include "engine/weather/field.h"
#include "engine/weather/fill.h"
#include "engine/weather/tracks.h"

namespace luftpost::weather {
/// A vector over time.
struct VectorCurve {
    Curve east, north;
    VectorCurve() = default;
    VectorCurve(std::vector<double> const& times, std::vector<glm::dvec2> const& values) {
        std::vector<double> e, n;
        for (glm::dvec2 const value : values) {
            e.push_back(value.x);
            n.push_back(value.y);
        }
        east = Curve{times, e};
        north = Curve{times, n};
    }
    glm::dvec2 at(double time) const { return {east.at(time), north.at(time)}; }
    glm::dvec2 integralTo(double time) const { return {east.integralTo(time), north.integralTo(time)}; }
};

struct LevelCurve {
    double altitude;
    VectorCurve wind;
};

/// A track as the field reads it at one site.
struct TrackCurves {
    Curve cover, base, top;
};

struct SiteData {
    double east = 0.0, north = 0.0, elevation = 0.0;
    bool southern = false;
    std::vector<FullReport> reports;
    std::vector<double> times;
    Curve temperature, dewPoint, pressureSea, logVisibility, cape, freezingLevel, snowDepth;
    VectorCurve wind, windMean;
    MaximumCurve gust;
    SumCurve rate;
    std::vector<LevelCurve> levels;
    std::vector<SiteTrack> tracks;
    std::vector<std::optional<std::size_t>> trackOf;     // field's track -> this site's
    std::vector<std::optional<TrackCurves>> curves;      // by the field's track
};

/// A layer's life over the whole field.
struct FieldTrack {
    Genus genus = Genus::Cu;
    unsigned pattern = 0;
    VectorCurve wind;        // the same everywhere, so that the pattern drifts without being torn
    glm::dvec2 atStart{0.0};  // integral of the wind up to the recording's start
};

/// What a field takes over from the one before it, so that clouds and turbulence go on where they were.
struct Carry {
    struct CarriedLayer {
        Genus genus;
        double base;  // m above sea level
        unsigned pattern;
        glm::dvec2 drift;
    };
    core::UtcSeconds time = 0.0;   // of the change
    core::UtcSeconds start = 0.0;  // of the first field: phases count from it
    std::vector<CarriedLayer> layers;
    std::array<unsigned, kGenera> ordinals{};  // patterns used so far
    glm::dvec2 boundaryDrift{0.0};
};

struct Field::Data {
    Recording recording;
    Origin origin;
    core::Place place;
    core::UtcSeconds start = 0.0, end = 0.0;
    std::array<unsigned, kGenera> ordinals{};  // patterns used so far, by genus
    std::optional<Carry> carry;
    std::vector<SiteData> sites;
    std::vector<FieldTrack> tracks;
    VectorCurve boundary;
    glm::dvec2 boundaryAtStart{0.0};
    std::vector<std::vector<FieldReport>> reports;

    double weight(std::size_t site, double east, double north) const;
    Profile profile(std::size_t site, double time) const;
    Weather siteWeather(std::size_t site, double time) const;
    glm::dvec2 windAtOrigin(double altitude, double time) const;
    std::vector<double> allTimes() const;
    void build();
    void joinTracks();
    void carryPatterns();
    void findWinds();
    void listReports();
    std::size_t reportIndex(std::size_t site, double time) const;
};

/// One site's share of the weather at a moment, all but the layers.
struct SiteNow {
    double east, north;
    Weather weather;
    Profile profile;
};

/// A track over one site: nothing where the site never had it.
struct Extent {
    bool present = false;
    double cover = 0.0, base = 0.0, top = 0.0;
};

struct TrackNow {
    Layer layer;  // all but cover, base and top
    std::vector<Extent> sites;
};

struct FieldInstant::Now {
    core::UtcSeconds time = 0.0;
    std::vector<SiteNow> sites;
    std::vector<TrackNow> tracks;  // those with any cover anywhere
};

struct FieldAccess {
    static Field field(std::shared_ptr<Field::Data const> data) { return Field{std::move(data)}; }
    static Field::Data const& data(Field const& field) { return *field.data_; }
    using Data = Field::Data;
};
}  // namespace luftpost::weather
