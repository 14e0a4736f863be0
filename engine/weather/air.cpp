#include "engine/weather/air.h"

#include <cmath>
#include <optional>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/cloud_air.h"
#include "engine/weather/ramp.h"
#include "engine/weather/slope_wind.h"
#include "engine/weather/turbulence.h"

namespace luftpost::weather {
namespace {
constexpr double kGasConstant = 287.05287;    // J/(kg K), dry air (ISO 2533)
constexpr double kGustShare = 0.567;          // of W20: three rms of Dryden's gusts at 10 m
constexpr double kHazeFrom = 500.0, kHazeScale = 1500.0;  // m above ground: haze is even below, thins out above
constexpr double kClearAir = 2.5e5;           // m, visibility in air without any haze
constexpr double kStirring = 12.0;            // m/s: this wind mixes the air without any sun
constexpr double kBoil = 0.4;                 // m/s: gusts change with time even where no wind carries them
constexpr double kGroundLayer = 20.0;         // m: no air goes through the ground

std::vector<unsigned> patternsOf(Field const& field) {
    std::vector<unsigned> patterns = field.patterns();
    patterns.push_back(kDryPattern);
    return patterns;
}
}  // namespace

struct Air::Data {
    Field const* field;
    unsigned seed;
    NoiseVolumes const* noise;
    Relief relief;
    Ranks ranks;
};

/// All that one moment's air is made of.
struct AirInstant::Now {
    core::UtcSeconds time = 0.0;
    CloudSettings settings;
    FieldInstant field;
    glm::dvec2 drift{0.0};     // of the boundary layer
    double rise = 0.0;         // m, of the turbulence's frame
    double sun = 0.0;          // 0..1, sunHeating
    Layer dry;                 // pattern of the thermals without cloud
    CloudsNow clouds;          // where the field is uniform
};

Air::Air(Field const& field, core::GroundFunction ground, unsigned seed, NoiseVolumes const* noise)
    : data_{std::make_shared<Data>(&field, seed, noise, Relief{std::move(ground)}, Ranks{patternsOf(field), seed})} {}

AirInstant Air::instant(core::UtcSeconds time, CloudSettings const& settings) const {
    Field const& field = *data_->field;
    auto now = std::make_shared<AirInstant::Now>();
    now->time = time;
    now->settings = settings;
    now->field = field.instant(time);
    now->drift = field.boundaryDrift(time);
    now->rise = (time - field.start()) * kBoil;
    now->sun = sunHeating(field.place(), time);
    now->dry = dryLayer(now->drift, (time - field.start()) / 3600.0);
    if (now->field.uniform())
        now->clouds = cloudsOf(now->field.at(0.0, 0.0), data_->seed, settings, data_->noise != nullptr, now->sun);
    return AirInstant{data_, std::move(now)};
}

core::AirSample Air::at(glm::dvec3 const& positionWorld, core::UtcSeconds time) const { return instant(time).at(positionWorld); }

AirInstant::AirInstant(std::shared_ptr<Air::Data const> data, std::shared_ptr<Now const> now) : data_{std::move(data)}, now_{std::move(now)} {}
core::UtcSeconds AirInstant::time() const { return now_->time; }

namespace {
/// The haze near the ground, thinner above; the reported figure up to half a kilometre.
double hazeExtinction(double visibility, double height) {
    double const clear = 3.0 / kClearAir, haze = std::max(3.0 / visibility - clear, 0.0);
    return clear + haze * core::exp(-std::max(height - kHazeFrom, 0.0) / kHazeScale);
}

/// Rms and lengths of the gusts: Dryden's from the ground's gusts, and what land and clouds add. `W20`, the wind that stands for them, m/s.
Gustiness gustinessOf(double w20, double speed, double height, Stirring const& stirring, double variance) {
    AirStability const stability{std::min(1.0, 0.25 + 0.75 * stirring.heating + speed / kStirring), stirring.stable};
    Gustiness g = drydenGustiness(w20, height, stability);
    g.sigmaHorizontal = std::sqrt(g.sigmaHorizontal * g.sigmaHorizontal + variance);
    g.sigmaVertical = std::sqrt(g.sigmaVertical * g.sigmaVertical + variance);
    return g;
}

AirPoint pointOf(glm::dvec3 const& positionWorld, double ground) {
    AirPoint at;
    at.positionWorld = positionWorld;
    at.east = positionWorld.x;
    at.north = -positionWorld.z;
    at.altitude = positionWorld.y;
    at.ground = ground;
    at.height = std::max(at.altitude - ground, 0.0);
    return at;
}
}  // namespace

core::AirSample AirInstant::at(glm::dvec3 const& positionWorld) const {
    Now const& now = *now_;
    Relief const& relief = data_->relief;
    AirPoint at = pointOf(positionWorld, relief.height(positionWorld.x, -positionWorld.z));
    MeanAir const mean = now.field.meanAir(at.east, at.north, at.altitude, at.ground);
    at.temperature = mean.temperature;

    std::optional<CloudsNow> own;  // where the sites differ, so do the clouds from point to point
    if (!now.field.uniform())
        own = cloudsOf(now.field.at(at.east, at.north), data_->seed, now.settings, data_->noise != nullptr, now.sun);
    CloudsNow const& clouds = own ? *own : now.clouds;
    CloudEffect const cloud = cloudEffect(clouds, at, {data_->ranks, relief, now.dry, data_->noise, static_cast<double>(now.settings.weatherScale)});
    SlopeWind slope;
    if (int const finest = finestFelt(at.height); finest < kReliefBands)
        slope = slopeWind(relief.bands(at.east, at.north, finest), mean.wind, at.height, clouds.stirring.stable);

    double const surface = glm::length(mean.windSurface), w20 = std::max(mean.gust - surface, 0.0) / kGustShare;
    Gustiness const gustiness = gustinessOf(w20, surface, at.height, clouds.stirring, cloud.variance + slope.variance);
    glm::dvec3 const gust = gustAt({at.east - now.drift.x, at.altitude - now.rise, at.north - now.drift.y}, gustiness, data_->seed);
    double const offGround = smooth(0.0, kGroundLayer, at.height);

    core::AirSample sample;
    glm::dvec2 const wind = mean.wind + slope.wind + cloud.wind + glm::dvec2{gust.x, gust.z};
    sample.windWorld = {wind.x, offGround * (gust.y + cloud.lift + slope.lift), -wind.y};
    sample.turbulence = offGround * gustiness.sigmaVertical;
    sample.temperature = mean.temperature;
    sample.pressure = mean.pressure;
    sample.density = mean.pressure / (kGasConstant * mean.temperature);
    sample.visibility = 3.0 / (hazeExtinction(core::exp(mean.logVisibility), at.height) + cloud.extinction);
    sample.icing = cloud.icing;
    sample.rain = cloud.rain;
    sample.snow = cloud.snow;
    sample.hail = cloud.hail;
    return sample;
}
}  // namespace luftpost::weather
