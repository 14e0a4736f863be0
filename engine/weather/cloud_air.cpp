#include "engine/weather/cloud_air.h"

#include <algorithm>
#include <cmath>

#include "engine/weather/cloud_column.h"
#include "engine/weather/convection.h"
#include "engine/weather/genera.h"
#include "engine/weather/noise_volume.h"
#include "engine/weather/outflow.h"
#include "engine/weather/ramp.h"
#include "engine/weather/showers.h"
#include "shaders/lib/cloud.glsl"

namespace luftpost::weather {
namespace {
constexpr double kCoreLead = 1500.0;                    // m, a storm's updraught stands before its rain
constexpr double kDryWind = 2.0;                        // wind at the top of the mixed layer over that at 10 m: the power law 0.16
constexpr double kBareFrom = 1500.0, kBareTo = 2500.0;  // m above ground: rain of which no cloud is known

/// Share of the droplets that are still water: all at -10 C and above, none at -35 C.
double liquidShare(double temperature) { return smooth(238.15, 263.15, temperature); }
/// 1 where water that touches something freezes, 0 above 0 C.
double freezing(double temperature) { return 1.0 - smooth(272.65, 273.15, temperature); }

UnderCloud underCloud(glsl::LayerColumn const& column, double visible, AirPoint const& at, double heating) {
    UnderCloud under;
    under.threshold = visible;
    under.altitude = at.altitude;
    under.ground = at.ground;
    under.base = static_cast<double>(column.base);
    under.top = static_cast<double>(column.top);
    under.heating = heating;
    return under;
}

/// One layer over one point, and where its effects go.
struct LayerAir {
    CloudsNow const& sky;
    AirPoint const& at;
    CloudAirSources const& from;
    Layer const& layer;
    glsl::LayerColumn const& column;
    double visible;  // CloudsNow::visible
    CloudEffect& effect;

    double base() const { return static_cast<double>(column.base); }
    double top() const { return static_cast<double>(column.top); }
    double rankAt(glm::dvec2 aside) const { return from.ranks.at(layer, from.scale, at.east + aside.x, at.north + aside.y); }
    void add(Convection const& c) const {
        effect.lift += c.lift;
        effect.variance += c.sigma * c.sigma;
    }
};

void addCumulus(LayerAir const& l) {
    double const warmth = l.at.altitude < l.base() ? l.from.relief.warmth(l.at.east, l.at.north) : 1.0;
    double const blend = smooth(l.base() - 200.0, l.base(), l.at.altitude);  // what has reached the base has left its ground
    UnderCloud under = underCloud(l.column, l.visible, l.at, l.sky.stirring.heating * (warmth + (1.0 - warmth) * blend));
    double const below = std::max(l.base() - l.at.altitude, 0.0);
    under.rank = l.rankAt(thermalLean(l.sky.weather.windSurface, l.layer.wind, below, l.base() - l.at.ground, riseSpeed(l.top() - l.base())));
    l.add(cumulusConvection(under));
}

void addStorm(LayerAir const& l) {
    double const speed = glm::length(l.layer.wind);
    UnderCloud under = underCloud(l.column, l.visible, l.at, 0.0);
    under.rank = l.rankAt(l.layer.wind * (-kCoreLead / (speed + 3.0)));
    l.add(stormUpdraught(under, l.sky.weather.cape));
    double const base = l.base() - l.at.ground;
    double const rate = l.sky.weather.precipitation == Precipitation::None ? 0.0 : l.sky.weather.precipitationRate;
    if (l.at.height >= burstTop(base) || !(rate > 0.0)) return;
    double const strength = std::min(rate / 20.0, 1.0) * (0.5 + 0.5 * smooth(200.0, 1500.0, l.sky.weather.cape));
    RankHill const hill = l.from.ranks.hill(l.layer, l.from.scale, burstFoot(l.visible), l.at.east, l.at.north);
    Outflow const out = downburst(hill, {l.at.height, base}, strength);
    l.effect.wind += out.wind;
    l.effect.lift += out.lift;
    l.effect.variance += out.variance;
}

void addFall(CloudEffect& effect, Falling const& fall) {
    effect.rain += fall.rain;
    effect.snow += fall.snow;
    effect.hail += fall.hail;
}

/// Share of the cover of a storm's foot that its towers still have at an altitude: what falls beside them would fall through clear air.
double towerShare(double altitude, double base, double top) {
    double const height = std::clamp((altitude - base) / std::max(top - base, 1.0), 0.0, 1.0);
    return 1.0 - height * (1.6 - 0.7 * height);  // lib/cloud's walls at a cover of a quarter
}

void addShower(LayerAir const& l, Shower const& shower) {
    double const rank = l.rankAt(shower.source(l.base(), l.at.altitude));
    double const here = showerInside(l.layer.genus, rank, l.visible * (shower.storm ? towerShare(l.at.altitude, l.base(), l.top()) : 1.0)).here;
    double const rate = shower.rate(here, l.at.altitude) * gathered(l.at.altitude, l.base(), l.top());
    double const core = shower.storm ? here : 0.0;
    if (rate > 0.0) addFall(l.effect, fallingOf(l.sky.weather, rate, core, l.at.height, l.at.altitude, l.at.temperature));
}

/// Inside a cloud: what is drawn dims and freezes.
void addDroplets(LayerAir const& l, glsl::LayerShape const& form) {
    glsl::LayerColumn column = l.column;
    column.rank = static_cast<float>(l.rankAt(glm::dvec2{0.0}));
    if (form.body.z > 0.0f) {
        glm::dvec2 const carried{form.fibre.x, -form.fibre.y};
        column.anvil = glsl::anvilRank(static_cast<float>(l.rankAt(-static_cast<double>(form.fibre.z) * carried)), static_cast<float>(l.rankAt(-carried)), form.fibre.w);
    }
    NoiseVolumes const& noise = *l.from.noise;
    double const extinction = static_cast<double>(glsl::layerSample(glm::vec3{l.at.positionWorld}, column, form, noise.shape.sampler(),
                                                                    noise.detail.sampler(), noise.curl.plane(), 0.0f).extinction);
    l.effect.extinction += extinction;
    double const supercooled = liquidShare(l.at.temperature) * freezing(l.at.temperature);
    if (!genusRow(l.layer.genus).ice) l.effect.icing += extinction / static_cast<double>(form.look.w) * supercooled;
}

void addLayer(LayerAir const& l, glsl::LayerShape const& form, Shower const& shower) {
    if (l.at.altitude >= l.top()) return;
    if (l.layer.genus == Genus::Cu) addCumulus(l);
    if (l.layer.genus == Genus::Cb) addStorm(l);
    if (shower.falls()) addShower(l, shower);
    if (l.from.noise && l.at.altitude > l.base()) addDroplets(l, form);
}

void addDryThermals(CloudsNow const& sky, AirPoint const& at, CloudAirSources const& from, CloudEffect& effect) {
    Stirring const& s = sky.stirring;
    if (!(s.dry * s.heating > 0.0) || at.height >= s.depth) return;
    glm::dvec2 const wind = sky.weather.windSurface;
    glm::dvec2 const lean = thermalLean(wind, kDryWind * wind, s.depth - at.height, s.depth, riseSpeed(0.0));
    double const rank = from.ranks.at(from.dry, 1.0, at.east + lean.x, at.north + lean.y);
    double const heating = s.heating * from.relief.warmth(at.east, at.north);
    Convection const c = dryConvection(rank, at.height, s.depth, heating, s.dry);
    effect.lift += c.lift;
    effect.variance += c.sigma * c.sigma;
}

/// Rain of which no cloud is known falls everywhere.
void addBareRain(CloudsNow const& sky, AirPoint const& at, CloudEffect& effect) {
    if (sky.fallsFromClouds() || sky.weather.precipitation == Precipitation::None) return;
    double const rate = sky.weather.precipitationRate * (1.0 - smooth(kBareFrom, kBareTo, at.height));
    if (rate > 0.0) addFall(effect, fallingOf(sky.weather, rate, 0.0, at.height, at.altitude, at.temperature));
}
/// Rain that freezes on what it meets, and what falls beyond the report's rate, which its visibility has in it.
void addFallen(Weather const& weather, double temperature, CloudEffect& effect) {
    effect.icing += rainWater(effect.rain) * freezing(temperature);
    double const fall = effect.rain + effect.snow;
    double const everywhere = weather.precipitation == Precipitation::None ? 0.0 : weather.precipitationRate;
    if (fall <= everywhere) return;
    double const share = everywhere / fall;
    effect.extinction += fallExtinction(effect.rain, effect.snow) - fallExtinction(effect.rain * share, effect.snow * share);
}
}  // namespace

bool CloudsNow::fallsFromClouds() const {
    return std::any_of(showers.begin(), showers.end(), [](Shower const& shower) { return shower.falls(); });
}

CloudsNow cloudsOf(Weather const& weather, unsigned seed, CloudSettings const& settings, bool withShape, double sun) {
    CloudsNow clouds{weather, CloudColumns{weather, seed, settings}.bare(), {}, stirringOf(weather, sun), {}, {}};
    if (withShape) clouds.shape = cloudShape(weather, seed, glm::dvec2{0.0}, settings);
    // The outline lies where the rank is the cover. What the clouds are made from lies further out (calibratedCover).
    for (std::size_t i = 0; i < static_cast<std::size_t>(weather.layerCount); ++i)
        clouds.visible[i] = std::clamp(static_cast<double>(weather.layers[i].cover - settings.densityThreshold), 0.0, 1.0);
    clouds.showers = showersOf(weather, clouds.visible);
    return clouds;
}

Layer dryLayer(glm::dvec2 drift, double hours) {
    Layer layer;
    layer.genus = Genus::Cu;
    layer.drift = drift;
    layer.phase = hours;
    layer.pattern = kDryPattern;
    return layer;
}

CloudEffect cloudEffect(CloudsNow const& sky, AirPoint const& at, CloudAirSources const& from) {
    CloudEffect effect;
    for (std::size_t i = 0; i < static_cast<std::size_t>(sky.weather.layerCount); ++i)
        addLayer({sky, at, from, sky.weather.layers[i], sky.column.layers[i], sky.visible[i], effect}, sky.shape.layers[i], sky.showers[i]);
    addDryThermals(sky, at, from, effect);
    addBareRain(sky, at, effect);
    addFallen(sky.weather, at.temperature, effect);
    return effect;
}
}  // namespace luftpost::weather
