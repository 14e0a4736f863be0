#include "engine/weather/air.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include "engine/core/check.h"
#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/cloud_column.h"
#include "engine/weather/convection.h"
#include "engine/weather/fill.h"
#include "engine/weather/genera.h"
#include "engine/weather/noise_volume.h"
#include "engine/weather/point_memo.h"
#include "engine/weather/turbulence.h"
#include "shaders/lib/cloud.glsl"

namespace luftpost::weather {
namespace {
constexpr double kGasConstant = 287.05287;    // J/(kg K), dry air (ISO 2533)
constexpr double kGroundStep = 64.0;          // m, lattice of the ground as the wind feels it
constexpr double kRankStep = 32.0;            // m, lattice of the patterns' ranks
constexpr double kSlotsPerHour = 60.0;        // a pattern's slow change is followed minute by minute
constexpr double kGustShare = 0.567;          // of W20: three rms of Dryden's gusts at 10 m
constexpr double kHazeFrom = 500.0, kHazeScale = 1500.0;  // m above ground: haze is even below, thins out above
constexpr double kClearAir = 2.5e5;           // m, visibility in air without any haze
constexpr double kStirring = 12.0;             // m/s: this wind mixes the air without any sun
constexpr double kBoil = 0.4;                 // m/s: gusts change with time even where no wind carries them

double smooth(double low, double high, double x) {
    double const u = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}
}  // namespace

struct Air::Data {
    Field const* field;
    core::GroundFunction ground;
    unsigned seed;
    NoiseVolumes const* noise;
    PointMemo heights;
    std::vector<std::pair<unsigned, PointMemo>> ranks;  // by pattern

    double groundAt(double east, double north) const;
    double rankAt(Layer const& layer, double scale, double east, double north) const;
};

/// Heights at the nodes, bilinear between them: the wind does not feel a single boulder.
double Air::Data::groundAt(double east, double north) const {
    double const x = std::floor(east / kGroundStep), y = std::floor(north / kGroundStep);
    double const u = east / kGroundStep - x, v = north / kGroundStep - y;
    auto const node = [&](double dx, double dy) {
        auto const key = PointMemo::key(static_cast<std::int64_t>(x + dx), static_cast<std::int64_t>(y + dy));
        return heights.at(key, [&] { return ground((x + dx) * kGroundStep, (y + dy) * kGroundStep).height; });
    };
    double const south = node(0, 0) + (node(1, 0) - node(0, 0)) * u, top = node(0, 1) + (node(1, 1) - node(0, 1)) * u;
    return south + (top - south) * v;
}

/// The rank of the layer's pattern: remembered at the nodes of a lattice that drifts with the layer, at whole minutes.
double Air::Data::rankAt(Layer const& layer, double scale, double east, double north) const {
    auto const memo = std::find_if(ranks.begin(), ranks.end(), [&](auto const& entry) { return entry.first == layer.pattern; });
    CHECK(memo != ranks.end(), "pattern {} is none of the field's", layer.pattern);
    double const px = (east - layer.drift.x) / (scale * kRankStep), py = (north - layer.drift.y) / (scale * kRankStep);
    double const x = std::floor(px), y = std::floor(py);
    double const u = px - x, v = py - y;
    double const slots = layer.phase * kSlotsPerHour, slot = std::floor(slots);
    auto const node = [&](double dx, double dy, double ds) {
        auto const key = PointMemo::key(static_cast<std::int64_t>(x + dx), static_cast<std::int64_t>(y + dy), static_cast<std::int64_t>(slot + ds));
        return memo->second.at(key, [&] {
            Layer then = layer;
            then.phase = (slot + ds) / kSlotsPerHour;
            return static_cast<double>(LayerPattern{then, seed}.drifting((x + dx) * kRankStep, (y + dy) * kRankStep));
        });
    };
    auto const plane = [&](double ds) {
        double const low = node(0, 0, ds) + (node(1, 0, ds) - node(0, 0, ds)) * u;
        double const high = node(0, 1, ds) + (node(1, 1, ds) - node(0, 1, ds)) * u;
        return low + (high - low) * v;
    };
    double const first = plane(0);
    return first + (plane(1) - first) * (slots - slot);
}

namespace {
/// The clouds of one weather, all but their ranks.
struct CloudsNow {
    Weather weather;
    glsl::CloudColumn column;
    glsl::CloudShape shape;
};

CloudsNow cloudsOf(Weather const& weather, unsigned seed, CloudSettings const& settings, bool withShape) {
    CloudsNow clouds{weather, CloudColumns{weather, seed, settings}.bare(), {}};
    if (withShape) clouds.shape = cloudShape(weather, seed, glm::dvec2{0.0}, settings);
    return clouds;
}
}  // namespace

/// All that one moment's air is made of.
struct AirInstant::Now {
    core::UtcSeconds time = 0.0;
    CloudSettings settings;
    FieldInstant field;
    glm::dvec2 drift{0.0};     // of the boundary layer
    double rise = 0.0;         // m, of the turbulence's frame
    double heating = 0.0;      // 0..1
    CloudsNow clouds;          // where the field is uniform
};

namespace {
struct CloudEffect {
    double lift = 0.0, variance = 0.0;      // m/s, m2/s2
    double extinction = 0.0, icing = 0.0;   // 1/m, kg/m3
};

/// Share of the droplets that are still water: all at 0 C, none at -35 C.
double liquidShare(double temperature) { return temperature >= 273.15 ? 0.0 : smooth(238.15, 263.15, temperature); }
}  // namespace

Air::Air(Field const& field, core::GroundFunction ground, unsigned seed, NoiseVolumes const* noise) {
    auto data = std::make_shared<Data>(Data{&field, std::move(ground), seed, noise, PointMemo{-1000.0, 15000.0}, {}});
    for (unsigned const pattern : field.patterns()) data->ranks.emplace_back(pattern, PointMemo{0.0, 1.0});
    data_ = std::move(data);
}

AirInstant Air::instant(core::UtcSeconds time, CloudSettings const& settings) const {
    Field const& field = *data_->field;
    auto now = std::make_shared<AirInstant::Now>();
    now->time = time;
    now->settings = settings;
    now->field = field.instant(time);
    now->drift = field.boundaryDrift(time);
    now->rise = (time - field.start()) * kBoil;
    now->heating = smooth(0.05, 0.65, sunHeight(field.place().lat_deg, field.place().lon_deg, time));
    if (now->field.uniform()) now->clouds = cloudsOf(now->field.at(0.0, 0.0), data_->seed, settings, data_->noise != nullptr);
    return AirInstant{data_, std::move(now)};
}

core::AirSample Air::at(glm::dvec3 const& positionWorld, core::UtcSeconds time) const { return instant(time).at(positionWorld); }

AirInstant::AirInstant(std::shared_ptr<Air::Data const> data, std::shared_ptr<Now const> now) : data_{std::move(data)}, now_{std::move(now)} {}
core::UtcSeconds AirInstant::time() const { return now_->time; }

namespace {
/// What the clouds do to the air at a point. `rankOf(layer)`: the rank of the layer's pattern there.
template <typename RankOf>
CloudEffect cloudEffect(CloudsNow const& sky, UnderCloud at, double temperature, glm::vec3 const& point, NoiseVolumes const* noise,
                        RankOf const& rankOf) {
    CloudEffect effect;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sky.weather.layerCount); ++i) {
        Layer const& layer = sky.weather.layers[i];
        glsl::LayerColumn column = sky.column.layers[i];
        bool const convective = layer.genus == Genus::Cu || layer.genus == Genus::Cb;
        at.base = static_cast<double>(column.base);
        at.top = static_cast<double>(column.top);
        bool const inside = noise && at.altitude > at.base && at.altitude < at.top;
        if (at.altitude >= at.top || !(inside || convective)) continue;
        at.rank = rankOf(layer);
        at.threshold = static_cast<double>(column.cover);
        if (convective) {
            Convection const c = layer.genus == Genus::Cb ? stormConvection(at) : cumulusConvection(at);
            effect.lift += c.lift;
            effect.variance += c.sigma * c.sigma;
        }
        if (!inside) continue;
        column.rank = static_cast<float>(at.rank);
        glsl::LayerShape const& form = sky.shape.layers[i];
        double const extinction = static_cast<double>(
            glsl::layerSample(point, column, form, noise->shape.sampler(), noise->detail.sampler(), noise->curl.sampler(), 0.0f).extinction);
        effect.extinction += extinction;
        if (!genusRow(layer.genus).ice) effect.icing += extinction / static_cast<double>(form.look.w) * liquidShare(temperature);
    }
    return effect;
}

/// The haze near the ground, thinner above; the reported figure up to half a kilometre.
double hazeExtinction(double visibility, double height) {
    double const clear = 3.0 / kClearAir, haze = std::max(3.0 / visibility - clear, 0.0);
    return clear + haze * core::exp(-std::max(height - kHazeFrom, 0.0) / kHazeScale);
}

/// Rms and lengths of the gusts: Dryden's from the ground's gusts, and what the clouds add.
Gustiness gustinessOf(double gust, double speed, double height, double heating, double cloudVariance) {
    double const mixing = std::min(1.0, 0.25 + 0.75 * heating + speed / kStirring);
    Gustiness g = drydenGustiness(std::max(gust - speed, 0.0) / kGustShare, height, mixing);
    g.sigmaHorizontal = std::sqrt(g.sigmaHorizontal * g.sigmaHorizontal + cloudVariance);
    g.sigmaVertical = std::sqrt(g.sigmaVertical * g.sigmaVertical + cloudVariance);
    return g;
}
}  // namespace

core::AirSample AirInstant::at(glm::dvec3 const& positionWorld) const {
    Now const& now = *now_;
    double const east = positionWorld.x, north = -positionWorld.z, altitude = positionWorld.y;
    double const ground = data_->groundAt(east, north);
    double const height = std::max(altitude - ground, 0.0);
    MeanAir const mean = now.field.meanAir(east, north, altitude, ground);

    std::optional<CloudsNow> own;  // where the sites differ, so do the clouds from point to point
    if (!now.field.uniform()) own = cloudsOf(now.field.at(east, north), data_->seed, now.settings, data_->noise != nullptr);
    CloudsNow const& clouds = own ? *own : now.clouds;
    UnderCloud under;
    under.altitude = altitude;
    under.ground = ground;
    under.heating = now.heating;
    under.rain = clouds.weather.precipitationRate;
    double const scale = static_cast<double>(now.settings.weatherScale);
    CloudEffect const cloud = cloudEffect(clouds, under, mean.temperature, glm::vec3{positionWorld}, data_->noise,
                                          [&](Layer const& layer) { return data_->rankAt(layer, scale, east, north); });

    Gustiness const gustiness = gustinessOf(mean.gust, glm::length(mean.windSurface), height, now.heating, cloud.variance);
    glm::dvec3 const gust = gustAt({east - now.drift.x, altitude - now.rise, north - now.drift.y}, gustiness, data_->seed);
    double const offGround = smooth(0.0, 20.0, height);  // no air goes through the ground

    core::AirSample sample;
    sample.windWorld = {mean.wind.x + gust.x, offGround * (gust.y + cloud.lift), -(mean.wind.y + gust.z)};
    sample.turbulence = offGround * gustiness.sigmaVertical;
    sample.temperature = mean.temperature;
    sample.pressure = mean.pressure;
    sample.density = mean.pressure / (kGasConstant * mean.temperature);
    sample.visibility = 3.0 / (hazeExtinction(core::exp(mean.logVisibility), height) + cloud.extinction);
    sample.icing = cloud.icing;
    return sample;
}
}  // namespace luftpost::weather
