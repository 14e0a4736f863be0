#include "engine/weather/diagnosis.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kLiftingPerKelvin = 125.0;  // m of convective base per K of dew-point spread (Espy's rule)
constexpr double kSteadyRain = 0.2;          // mm/h
constexpr double kLeastCover = 0.05;
constexpr double kHighBase = 6000.0;         // m above ground: altocumulus and altostratus stand lower (WMO Cloud Atlas: 2 to 7 km)

bool thundery(Signs const& s) { return s.thunder || (s.code && *s.code >= 95); }
bool foggy(Signs const& s) { return s.code && (*s.code == 45 || *s.code == 48); }
double liftingHeight(Signs const& s) { return std::clamp(kLiftingPerKelvin * s.spread, 150.0, 3500.0); }

bool convective(Signs const& s, double cover) {
    bool const unstable = s.cape ? *s.cape > 50.0 : liftingHeight(s) > 400.0;
    return s.day && cover <= 0.6 && unstable;
}

Genus lowGenus(Signs const& s, double cover, double baseAboveGround) {
    if (foggy(s)) return Genus::Fog;
    if (thundery(s)) return Genus::Cb;
    if (s.mid > 0.8 && cover > 0.5 && s.rate > kSteadyRain) return Genus::Ns;
    if (convective(s, cover)) return Genus::Cu;
    if (baseAboveGround < 600.0 && cover > 0.7 && s.spread < 2.0 && s.windSpeed < 6.0) return Genus::St;
    return Genus::Sc;
}

/// Fitted to what an observer at Basel called the sky: closed low cloud gives back most of what a clear sky lacks, cloud high up
/// next to nothing, and cumulus stands by day over dry, warm ground.
Genus genusByReturn(Signs const& s, double cover, double given) {
    constexpr double kHeavy = 6.0;  // mm/h
    double const share = given / std::max(cover, 0.0625);
    if (thundery(s) || (s.rate >= kHeavy && cover >= 0.75)) return Genus::Cb;
    if (s.rate > kSteadyRain && cover > 0.95 && s.spread > 2.0) return Genus::Ns;
    if (cover >= 0.85 && share >= 0.7 && s.spread < 4.0) return Genus::St;
    if (s.sunSine > 0.0 && s.spread >= 5.0 && s.temperature >= 280.15 && cover <= 0.9) return Genus::Cu;
    if (share < 0.15) return cover < 0.4 ? Genus::Ci : cover > 0.95 ? Genus::Cs : Genus::Ac;
    return Genus::Sc;
}

Genus midGenus(Signs const&, double cover) { return cover > 0.8 ? Genus::As : Genus::Ac; }
Genus highGenus(double cover) { return cover > 0.8 ? Genus::Cs : Genus::Ci; }
}  // namespace

double typicalBase(Signs const& s, Genus genus) {
    double const usual = genusRow(genus).base;
    switch (genus) {
        case Genus::Fog: return s.elevation;
        case Genus::Cu:
        case Genus::Cb: return s.elevation + std::max(300.0, liftingHeight(s));
        case Genus::St: return s.elevation + std::clamp(liftingHeight(s), 100.0, 500.0);
        case Genus::Sc: return s.elevation + std::clamp(liftingHeight(s), 500.0, 1800.0);
        case Genus::Ns: return s.elevation + std::clamp(2.0 * liftingHeight(s), 400.0, 1500.0);
        case Genus::Ac:
        case Genus::As: return std::clamp(s.elevation + usual, s.bounds.low_m, s.bounds.mid_m - 500.0);
        default: return std::max(s.elevation + usual, s.bounds.mid_m);
    }
}

double typicalTop(Signs const& s, Genus genus, double cover, double base) {
    double const usual = genusRow(genus).thickness;
    double thickness = usual;
    // Fair-weather cumuli are as deep as they are wide; energy lets them grow, a closed field spreads.
    if (genus == Genus::Cu) thickness = usual * (0.5 + 0.8 * cover) + std::min(1.2 * s.cape.value_or(0.0), 1500.0);
    // A storm stops at the tropopause, near 11 km above the sea in the middle latitudes.
    if (genus == Genus::Cb) thickness = std::max(4000.0, 11000.0 - base);
    if (genus == Genus::Sc || genus == Genus::St) thickness = usual * (0.7 + 0.5 * cover);
    return base + thickness;
}

Genus diagnosedGenus(Signs const& s, double cover, std::optional<double> baseAboveGround) {
    if (!baseAboveGround) return lowGenus(s, cover, liftingHeight(s));
    double const altitude = s.elevation + *baseAboveGround;
    if (altitude >= s.bounds.mid_m || *baseAboveGround >= kHighBase) return highGenus(cover);
    if (altitude >= s.bounds.low_m) return midGenus(s, cover);
    return lowGenus(s, cover, *baseAboveGround);
}

std::vector<FullLayer> diagnosedLayers(Signs const& s) {
    std::vector<FullLayer> layers;
    auto const add = [&](Genus genus, double cover) {
        double const base = typicalBase(s, genus);
        layers.push_back({genus, cover, base, typicalTop(s, genus, cover, base)});
    };
    bool rainCloud = false;
    if (s.low >= kLeastCover || foggy(s)) {
        Genus const genus = lowGenus(s, s.low, liftingHeight(s));
        rainCloud = genus == Genus::Ns;
        add(genus, foggy(s) ? std::max(s.low, 0.9) : s.low);
    }
    // Nimbostratus reaches through the mid level: what the model calls mid cloud is its upper part.
    if (s.mid >= kLeastCover && !rainCloud) add(midGenus(s, s.mid), s.mid);
    if (s.high >= kLeastCover) add(highGenus(s.high), s.high);
    return layers;
}

std::optional<double> skyReturn(Signs const& s) {
    constexpr double kStefanBoltzmann = 5.670374e-8;  // W/(m2 K4)
    if (!s.longwave) return std::nullopt;
    double const celsius = s.dewPoint - 273.15, vapour = 6.112 * core::exp(17.62 * celsius / (243.12 + celsius));  // hPa
    double const black = kStefanBoltzmann * s.temperature * s.temperature * s.temperature * s.temperature;
    double const clear = std::min(1.24 * core::pow(vapour / s.temperature, 1.0 / 7.0), 0.97);
    return (*s.longwave / black - clear) / (1.0 - clear);
}

std::optional<double> coverFromRadiation(Signs const& s) {
    constexpr double kHighSun = 0.17;     // sine of 10 degrees: lower, the index says little
    constexpr double kClosedLow = 0.8;    // what closed low cloud gives back
    if (s.radiation && s.sunSine > kHighSun) {
        double const clear = 1098.0 * s.sunSine * core::exp(-0.057 / s.sunSine);
        double const lost = std::clamp((1.0 - std::max(*s.radiation, 0.0) / clear) / 0.75, 0.0, 1.0);
        return lost > 0.0 ? core::pow(lost, 1.0 / 3.4) : 0.0;
    }
    if (auto const given = skyReturn(s)) return std::clamp(*given / kClosedLow, 0.0, 1.0);
    return std::nullopt;
}

std::vector<FullLayer> layersOfTotal(Signs const& s, double cover) {
    if (cover < kLeastCover) return {};
    auto const given = skyReturn(s);
    Genus const genus = given && !foggy(s) ? genusByReturn(s, cover, *given) : lowGenus(s, cover, liftingHeight(s));
    double const base = typicalBase(s, genus);
    return {{genus, cover, base, typicalTop(s, genus, cover, base)}};
}
}  // namespace luftpost::weather
