// What a Field is made of. Private to the field's own files.
#pragma once
#include "engine/weather/curve.h"
#include "engine/weather/field.h"
#include "engine/weather/fill.h"
#include "engine/weather/fronts.h"
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

/// Temperature and dew point over a site at an altitude; the latter where it is known.
struct MassCurve {
    double altitude;
    Curve temperature;
    std::optional<Curve> dewPoint;
};

/// The quantities that are blended each among the sites that know it.
enum class Quantity : std::size_t { Wind, Gust, Temperature, DewPoint, Pressure, Visibility, Precipitation, Cape, FreezingLevel, Snow, Clouds };
inline constexpr std::size_t kQuantities = 11;

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
    std::vector<MassCurve> masses;                       // ascending, above the site
    std::array<bool, kQuantities> knows{};               // whether any report says it
    std::vector<std::pair<std::size_t, Window>> fronts;  // over the site, in time: which, and when it changes the weather here
    std::vector<SiteTrack> tracks;
    std::vector<std::optional<std::size_t>> trackOf;     // field's track -> this site's
    std::vector<std::optional<TrackCurves>> curves;      // by the field's track
};

/// Temperature, dew point and pressure over a site at one time.
struct Masses {
    static constexpr int kMostLevels = Profile::kMaxLevels + 1;
    int levels = 0;               // the lowest is the site's own
    double pressureSea = 101325.0;  // Pa
    std::array<double, kMostLevels> altitude{}, temperature{}, dewPoint{}, pressure{};  // m, K, K, Pa
    void add(double altitude, double temperature, std::optional<double> dewPoint);      // upward, from the site on
};
struct MassAt {
    double temperature, dewPoint, pressure;  // K, K, Pa
};
/// Linear between levels; the standard atmosphere's lapse below the lowest and above the topmost, isothermal above 11 km; the
/// pressure hydrostatic. Where no level says it the dew point falls by 1.8 K/km up to the condensation level and by 8 K/km
/// above it.
MassAt massAt(Masses const& masses, double altitude);

/// A track over one site.
struct Extent {
    bool knows = false;    // the site's cover counts: it has the track, or says that there is nothing at that height
    bool present = false;  // it has base and top
    double cover = 0.0, base = 0.0, top = 0.0;
};

/// One site's share of the weather at a moment.
struct SiteNow {
    Weather weather;  // all but the layers
    Profile profile;
    Masses masses;
    std::vector<Extent> extents;  // by track
};

/// A layer's life over the whole field.
struct FieldTrack {
    Genus genus = Genus::Cu;
    unsigned pattern = 0;
    double meanBase = 0.0;   // m above sea level
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

    std::vector<Front> fronts;
    std::vector<Passage> passages;

    /// How much each site counts at a point, by 1/d2; they sum to 1.
    void weights(double east, double north, std::vector<double>& weights) const;
    std::vector<double> weights(double east, double north) const;
    Profile profile(std::size_t site, double time) const;
    Masses masses(std::size_t site, double time) const;
    Weather siteWeather(std::size_t site, double time) const;
    std::vector<Extent> extents(std::size_t site, double time) const;
    SiteNow siteNow(std::size_t site, double time) const { return {siteWeather(site, time), profile(site, time), masses(site, time), extents(site, time)}; }
    double readingTimeAt(std::size_t site, double east, double north, double time) const;
    std::vector<double> allTimes() const;
    void build();
    void findFronts();
    void joinTracks();
    void carryPatterns();
    void findWinds();
    void listReports();
    std::size_t reportIndex(std::size_t site, double time) const;
};

struct FieldInstant::Now {
    core::UtcSeconds time = 0.0;
    std::shared_ptr<Field::Data const> data;
    std::vector<SiteNow> sites;
    std::vector<Layer> tracks;  // all but cover, base and top
    bool frontal = false;       // a front is so near in time that sites are read at other times for other places

    /// What a site contributes at a point: as it is, or, where a front is on its way, as it was or will be.
    SiteNow const& site(std::size_t index, double east, double north, std::optional<SiteNow>& own) const;
};

struct FieldAccess {
    static Field field(std::shared_ptr<Field::Data const> data) { return Field{std::move(data)}; }
    static Field::Data const& data(Field const& field) { return *field.data_; }
    using Data = Field::Data;
};
}  // namespace luftpost::weather
