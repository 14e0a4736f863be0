#include "engine/weather/diagnosis.h"

#include <algorithm>

#include "engine/weather/genera.h"

namespace luftpost::weather {
namespace {
constexpr double kLiftingPerKelvin = 125.0;  // m of convective base per K of dew-point spread (Espy's rule)
constexpr double kSteadyRain = 0.2;          // mm/h
constexpr double kLeastCover = 0.05;

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
    if (altitude >= s.bounds.mid_m) return highGenus(cover);
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
}  // namespace luftpost::weather
