// The weather field: the function (position, time) -> weather, made of reports by interpolation over hours and between
// sites. Immutable after it is loaded; every function may be called from any thread and neither throws nor blocks.
#pragma once
#include <array>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/environment.h"
#include "engine/core/frames.h"
#include "engine/weather/recording.h"
#include "engine/weather/weather.h"

namespace luftpost::weather {
/// The recording that a start without --weather plays, in the product's data (platform::dataFile), and its hour.
inline constexpr std::string_view kDefaultRecording = "assets/weather/basel_2023-06-21_23.json";
inline constexpr std::string_view kDefaultTime = "2023-06-23T18:40Z";

/// What --place says: without an altitude the nearest site's elevation is taken.
struct PlaceWish {
    double lat_deg = 0.0;
    double lon_deg = 0.0;
    std::optional<double> altitude_m;
};

enum class SourceMode { Recorded, Preset, Live, Stale };

/// Where the weather comes from.
struct Origin {
    SourceMode mode = SourceMode::Preset;
    std::string name;      // "Basel, 21-23 June 2023" or "preset calm"
    std::string provider;  // "MeteoSwiss (open data)"; "Luftpost" for a preset
    std::string licence;
    std::string sha256;    // empty for a preset
    core::UtcSeconds fetched = 0.0;  // Live and Stale: when the source gave it
};

/// One site's report as the field uses it: what was said, and by place what the field uses instead.
struct FieldReport {
    Report said;
    Filled filled;
};

/// A report of one of the sites.
struct SiteReport {
    std::size_t site = 0;
    FieldReport report;
};

/// The mean air over one site at one time: all that wind, temperature and pressure need at any height.
struct Profile {
    static constexpr int kMaxLevels = 40;
    int levels = 0;                             // 0: the wind aloft comes from the surface wind alone
    std::array<double, kMaxLevels> altitude{};  // m above sea level, ascending
    std::array<glm::dvec2, kMaxLevels> wind{};  // m/s, east and north, where the air goes to
    glm::dvec2 windSurface{0.0};                // m/s, 10 m above ground
    glm::dvec2 windMean{0.0};                   // m/s, the same over three hours: what the free air above goes by
    double gust = 0.0;                          // m/s, 10 m above ground, the largest of the interval
    double temperature = 288.15;                // K, 2 m above the site
    double pressureSea = 101325.0;              // Pa
    double logVisibility = 11.0;                // of m
    double elevation = 0.0;                     // m above sea level, of the site
    bool southern = false;                      // there the wind backs with height instead of veering
};

/// The wind of a profile at an altitude over ground of height `ground` (m above sea level): between levels linear; below the
/// lowest and without any, the logarithmic law to 10 m, a power law to 1 km and Ekman's veering from the surface wind. m/s.
glm::dvec2 windAt(Profile const& profile, double altitude, double ground);

/// The mean air at a point: the sites' air blended, before gusts, terrain and clouds act on it.
struct MeanAir {
    glm::dvec2 wind{0.0};         // m/s, east and north, where the air goes to
    glm::dvec2 windSurface{0.0};  // m/s, 10 m above ground
    double gust = 0.0;            // m/s, 10 m above ground
    double temperature = 288.15;  // K, at the altitude
    double dewPoint = 281.15;     // K, at the altitude
    double pressure = 101325.0;   // Pa, at the altitude
    double logVisibility = 11.0;  // of m, at the ground
};

/// A front's way over a site: found in the reports (a wind shift of 30 degrees with a fall of 3 K or a rise of 1 hPa).
struct Passage {
    std::size_t site = 0;
    core::UtcSeconds time = 0.0;
    glm::dvec2 toward{1.0, 0.0};  // unit, east and north: where the line moves, square to itself
    double speed = 10.0;          // m/s
};

/// A front as a line near a point.
struct FrontNear {
    glm::dvec2 toward{1.0, 0.0};  // unit, east and north: where it moves
    double speed = 10.0;          // m/s
    double distance = 0.0;        // m from the line to the point along `toward`: above 0 it has not come yet
    double width = 4500.0;        // m, from 10 to 90 % of the change
};

class Field;

/// The field at one moment, everywhere: prepare it once for a map or a tick, then ask it at many points. Cheap to copy; it
/// may outlive the field. Any thread.
class FieldInstant {
public:
    FieldInstant() = default;  // of no field: only to be assigned to
    Weather at(double east, double north) const;
    /// `altitude` above sea level over ground of height `ground`. About a tenth of a microsecond a site, more while a front passes.
    MeanAir meanAir(double east, double north, double altitude, double ground) const;
    /// True where the weather is the same everywhere at this moment: at() may be asked once for a whole map.
    bool uniform() const;
    core::UtcSeconds time() const;

private:
    friend class Field;
    struct Now;
    std::shared_ptr<Now const> now_;
};

class Field {
public:
    ~Field();
    Field(Field&&) noexcept;
    Field& operator=(Field&&) noexcept;

    /// The weather over a point. Outside the recording's time it holds the nearest end (the clouds go on drifting).
    Weather at(double east, double north, core::UtcSeconds time) const;
    FieldInstant instant(core::UtcSeconds time) const;

    core::UtcSeconds start() const;
    core::UtcSeconds end() const;
    bool covers(core::UtcSeconds time) const;  // false: at() holds the nearest end
    core::Place place() const;                 // the origin of the world frame; its altitude is `land.base_m`
    Origin const& origin() const;

    /// Wind over the point at an altitude above sea level over ground of height `ground`. m/s, east and north.
    glm::dvec2 windAt(double east, double north, double altitude, double ground, core::UtcSeconds time) const;

    std::size_t sites() const;

    /// Fronts: every passage over a site, in time; and the line nearest to a point, if it passes there within two hours.
    std::vector<Passage> const& passages() const;
    std::optional<FrontNear> front(double east, double north, core::UtcSeconds time) const;

    /// The patterns of all layers that ever stand in this field.
    std::vector<unsigned> patterns() const;

    /// The wind of the boundary layer integrated from the recording's start: what carries turbulence and thermals. m.
    glm::dvec2 boundaryDrift(core::UtcSeconds time) const;

    /// Seconds between `time` and the newest report at or before it; 0 for a preset and before the first report.
    double age(core::UtcSeconds time) const;
    /// One line for HUD and menu: "Basel, 21-23 June 2023 · recorded · report 7 min old".
    std::string strip(core::UtcSeconds time) const;

    /// The recording that stands behind (a preset makes its own), and its reports with what was filled in.
    Recording const& recording() const;
    std::vector<std::vector<FieldReport>> const& reports() const;  // [site][report]
    /// The same in the order of the file; a report that another one of its time supersedes is filled as if it stood alone.
    std::vector<SiteReport> listedReports() const;
    /// The field over a site, in the shape of a report.
    FieldReport reportAt(std::size_t site, FieldInstant const& now) const;

private:
    friend class FieldInstant;
    friend struct FieldAccess;  // of the field's own files
    struct Data;
    explicit Field(std::shared_ptr<Data const> data);
    std::shared_ptr<Data const> data_;
};

/// The field of a recording. Throws core::Error where the recording cannot carry one.
Field fieldFrom(Recording recording, Origin origin, std::optional<PlaceWish> const& place);

/// The field that takes over from `before` at `time`, when a feed brings a new recording or a hand changes the weather: at
/// that time it is what `before` was, then it goes to what the recording says within `seconds` (a report of the recording
/// closer than that to `time` waits until then). Layers that both know keep pattern, drift and age, so that no cloud jumps; what
/// `before` said of times before `time` is gone. The place stays. Throws core::Error.
Field nextField(Field const& before, Recording recording, Origin origin, core::UtcSeconds time, double seconds = 300.0);
}  // namespace luftpost::weather
