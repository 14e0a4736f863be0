#include "engine/render/reference_sky.h"

#include <algorithm>
#include <cmath>

#include "engine/render/sky_conditions.h"
#include "engine/sky/light.h"
#include "shaders/lib/atmosphere.glsl"
#include "shaders/lib/cloud_light.glsl"

namespace luftpost::render {
namespace {
constexpr double kRadius = 6371000.0;  // m, the Earth's
constexpr double kTop = static_cast<double>(glsl::kAirTop);
constexpr int kTableWidth = 512, kTableHeight = 128;
constexpr double kNudge = 1e-3;        // m: over a face, so that a flight goes on
glm::vec2 const kTableSize{static_cast<float>(kTableWidth), static_cast<float>(kTableHeight)};

float highest(glm::vec3 const& v) { return std::max(v.x, std::max(v.y, v.z)); }
}  // namespace

ReferenceSky::ReferenceSky(Snapshot const& snapshot, weather::NoiseVolumes const& noise, int workers)
    : eye_{snapshot.camera.positionWorld.y},
      ground_{std::min(snapshot.place.altitude_m, snapshot.camera.positionWorld.y - 1.0)},
      albedo_{sky::landAlbedo(airConditions(snapshot))},
      air_{sky::atmosphere(airConditions(snapshot))},
      clouds_{snapshot, noise, workers},
      phases_{sky::Phase::cloud(snapshot.clouds.hg), sky::Phase::cloud(glsl::kIceShare * snapshot.clouds.hg), sky::Phase::rayleigh(), sky::Phase::haze()} {
    bool const sunlit = snapshot.sky.sunDirectionWorld.y > glsl::kSunGivesWay;
    light_ = sunlit ? Light{snapshot.sky.sunDirectionWorld, glm::vec3{1.0f}, snapshot.sky.sunAngularRadius}
                    : Light{snapshot.sky.moonDirectionWorld, sky::moonIrradiance(snapshot.sky), snapshot.sky.moonAngularRadius};
    clouds_.makeSunGuess(light_.toward, workers);
    makeBands();
    makeTable();
}

void ReferenceSky::makeBands() {
    bands_ = {ground_};
    double const fog = static_cast<double>(air_.fog.y), base = static_cast<double>(air_.fog.z);
    for (double share : {0.1, 0.25, 0.5, 1.0, 2.0, 4.0}) bands_.push_back(base + share * fog);
    for (double km : {0.5, 1.0, 1.5, 2.0, 3.0, 4.0, 6.0, 8.0, 10.0, 12.0, 15.0, 20.0, 25.0, 30.0, 40.0, 60.0}) bands_.push_back(1000.0 * km);
    // Among the clouds there is one band, which the cells of their bounds need not ask for.
    if (!clouds_.empty()) {
        std::erase_if(bands_, [&](double altitude) { return altitude > clouds_.lowest() && altitude < clouds_.highest(); });
        bands_.insert(bands_.end(), {clouds_.lowest(), clouds_.highest()});
    }
    bands_.push_back(kTop);
    std::sort(bands_.begin(), bands_.end());
    std::erase_if(bands_, [&](double altitude) { return altitude < ground_; });
    bands_.erase(std::unique(bands_.begin(), bands_.end(), [](double a, double b) { return b - a < 1.0; }), bands_.end());
    constexpr int kProbes = 16;
    for (std::size_t i = 0; i + 1 < bands_.size(); ++i) {
        glm::vec3 most{0.0f}, least{1.0f};
        for (int k = 0; k <= kProbes; ++k) {
            glm::vec3 const here = glsl::airAt(air_, static_cast<float>(glm::mix(bands_[i], bands_[i + 1], k / double{kProbes}))).extinction;
            most = glm::max(most, here);
            least = glm::min(least, here);
        }
        bandMajorants_.push_back(1.01f * highest(most));
        bandLeasts_.push_back(0.99f * least);
        if (!clouds_.empty() && bands_[i + 1] > clouds_.lowest() && bands_[i] < clouds_.highest()) airAmongClouds_ = std::max(airAmongClouds_, bandMajorants_.back());
        bandRests_.push_back(highest(1.01f * most - 0.99f * least));
    }
}

void ReferenceSky::makeTable() {
    transmittance_.reserve(static_cast<std::size_t>(kTableWidth * kTableHeight));
    for (int y = 0; y < kTableHeight; ++y)
        for (int x = 0; x < kTableWidth; ++x) {
            glm::vec2 const argument = glsl::transmittanceArgument(kTableSize, (glm::vec2{static_cast<float>(x), static_cast<float>(y)} + 0.5f) / kTableSize);
            transmittance_.emplace_back(glsl::transmittanceToTopExact(air_, argument.x, argument.y), 1.0f);
        }
}

double ReferenceSky::altitudeOf(glm::dvec3 const& place) const {
    double const up = kRadius + eye_ + place.y;
    double const across = place.x * place.x + place.z * place.z;
    double const radius = std::sqrt(across + up * up);
    // The difference of two squares over the sum: no digits lost.
    return ((eye_ + place.y) * (2.0 * kRadius + eye_ + place.y) + across) / (radius + kRadius);
}

double ReferenceSky::flattening(glm::dvec3 const& place) const {
    double const across2 = place.x * place.x + place.z * place.z;
    double const up = kRadius + eye_ + place.y;
    double const s = across2 / (up * up);
    // atan(t) / t: its series where it is exact to 1e-9, a third of the Earth's radius around.
    double const share = s < 0.01 ? 1.0 - s * (1.0 / 3.0 - s * (1.0 / 5.0 - s * (1.0 / 7.0 - s / 9.0))) : std::atan(std::sqrt(s)) / std::sqrt(s);
    return kRadius / up * share;
}

glm::dvec3 ReferenceSky::flatOf(glm::dvec3 const& place, double altitude) const {
    double const flat = flattening(place);
    return {place.x * flat, altitude, place.z * flat};
}

/// Distance along the ray, beyond `from`, to the sphere at an altitude that lies above (`outward`) or below; kNever where it is missed.
double ReferenceSky::crossing(sky::PathRay const& ray, double from, double altitude, bool outward) const {
    glm::dvec3 const start = ray.at(from);
    double const h = altitudeOf(start);
    glm::dvec3 const centred{start.x, start.y + kRadius + eye_, start.z};
    double const b = glm::dot(centred, ray.direction);
    if (!outward && b >= 0.0) return sky::kNever;
    double const c = (h - altitude) * (2.0 * kRadius + h + altitude);
    double const square = b * b - c;
    if (square < 0.0) return sky::kNever;
    double const root = std::sqrt(square);
    if (outward) return from + std::max(b > 0.0 ? -c / (b + root) : root - b, 0.0);
    return from + std::max(c / (root - b), 0.0);
}

sky::Stretch ReferenceSky::cloudStretch(sky::PathRay const& ray, double from, glm::dvec3 const& place, double altitude) const {
    glm::dvec3 const centred{place.x, place.y + kRadius + eye_, place.z};
    double const flat = flattening(place);
    glm::dvec3 const velocity{ray.direction.x * flat, glm::dot(centred, ray.direction) / glm::length(centred), ray.direction.z * flat};
    auto const bound = clouds_.bound({place.x * flat, altitude, place.z * flat}, velocity);
    return {from + bound.reach, bound.most, bound.sure};
}

std::size_t ReferenceSky::bandOf(double altitude) const {
    return static_cast<std::size_t>(std::upper_bound(bands_.begin() + 1, bands_.end() - 1, altitude) - bands_.begin()) - 1;
}

double ReferenceSky::endOfBand(sky::PathRay const& ray, double from, std::size_t band) const {
    double const end = crossing(ray, from, bands_[band + 1], true);
    return (band > 0 ? std::min(end, crossing(ray, from, bands_[band], false)) : end) + kNudge;
}

sky::Stretch ReferenceSky::stretchAt(sky::PathRay const& ray, double from) const {
    glm::dvec3 const place = ray.at(from);
    double const altitude = altitudeOf(place);
    if (altitude >= kTop) return {};
    if (!clouds_.empty() && altitude >= clouds_.lowest() && altitude < clouds_.highest()) {
        sky::Stretch cloud = cloudStretch(ray, from, place, altitude);
        cloud.majorant += airAmongClouds_;
        return cloud;
    }
    std::size_t const band = bandOf(altitude);
    return {endOfBand(ray, from, band), bandMajorants_[band]};
}

sky::Stretch ReferenceSky::shadowStretchAt(sky::PathRay const& ray, double from) const {
    if (clouds_.empty()) return {};
    glm::dvec3 const place = ray.at(from);
    double const altitude = altitudeOf(place);
    if (altitude >= clouds_.lowest() && altitude <= clouds_.highest()) return cloudStretch(ray, from, place, altitude);
    bool const under = altitude < clouds_.lowest();
    double const face = crossing(ray, from, under ? clouds_.lowest() : clouds_.highest(), under);
    return {face + kNudge, 0.0f};
}

float ReferenceSky::shadowExtinction(glm::dvec3 const& place) const {
    auto const cloud = clouds_.at(flatOf(place, altitudeOf(place)));
    return cloud.droplets + cloud.ice;
}

sky::MediumPoint<ReferenceSky::kKinds> ReferenceSky::at(glm::dvec3 const& place) const {
    double const altitude = altitudeOf(place);
    glsl::AirAt const air = glsl::airAt(air_, static_cast<float>(altitude));
    sky::MediumPoint<kKinds> point;
    ReferenceClouds::Extinction cloud;
    if (!clouds_.empty() && altitude > clouds_.lowest() && altitude < clouds_.highest()) cloud = clouds_.at(flatOf(place, altitude));
    point.extinction = air.extinction + cloud.droplets + cloud.ice;
    point.scattering = {glm::vec3{cloud.droplets}, glm::vec3{cloud.ice}, air.rayleigh, air.haze};
    return point;
}

sky::MediumPoint<ReferenceSky::kKinds> ReferenceSky::cloudAt(glm::dvec3 const& place) const {
    auto const cloud = clouds_.at(flatOf(place, altitudeOf(place)));
    return {glm::vec3{cloud.droplets + cloud.ice}, {glm::vec3{cloud.droplets}, glm::vec3{cloud.ice}}};
}

sky::MediumPoint<ReferenceSky::kKinds> ReferenceSky::airAt(glm::dvec3 const& place) const {
    glsl::AirAt const air = glsl::airAt(air_, static_cast<float>(altitudeOf(place)));
    return {air.extinction, {glm::vec3{0.0f}, glm::vec3{0.0f}, air.rayleigh, air.haze}};
}

// Of each band the least extinction is taken off as it is; what there is more by ratio tracking, for each colour.
glm::vec3 ReferenceSky::throughAir(sky::PathRay const& ray, double distance, core::Random& random) const {
    glm::vec3 through{1.0f};
    double left = -std::log(1.0 - random.uniform(0.0, 1.0));
    for (double from = 0.0; from < distance;) {
        double const altitude = altitudeOf(ray.at(from));
        if (altitude >= kTop) break;
        std::size_t const band = bandOf(altitude);
        auto const rest = static_cast<double>(bandRests_[band]);
        double end = std::min(endOfBand(ray, from, band), distance);
        bool const collided = left < rest * (end - from);
        if (collided) end = from + left / rest;
        through *= glm::exp(-bandLeasts_[band] * static_cast<float>(end - from));
        if (collided) {
            glm::vec3 const here = glsl::airAt(air_, static_cast<float>(altitudeOf(ray.at(end)))).extinction;
            through *= 1.0f - (here - bandLeasts_[band]) / bandRests_[band];
            left = -std::log(1.0 - random.uniform(0.0, 1.0));
        } else {
            left -= rest * (end - from);
        }
        from = end;
    }
    return through;
}

sky::AirDraw ReferenceSky::airDraw(sky::PathRay const& ray) const {
    constexpr int kParts = 48;
    // Parts grow with the square of the distance. One more reaches beyond where any ray of the pixel leaves the air, the ground left out.
    double const far = 1.2 * crossing(ray, 0.0, kTop, true), ground = surface(ray), reach = std::min(far, 1.5 * ground);
    std::vector<sky::AirDraw::Part> parts;
    glm::vec3 through{1.0f};
    double start = 0.0, sum = 0.0;
    for (int i = 1; i <= kParts; ++i) {
        double const share = i / double{kParts}, end = reach * share * share, length = end - start;
        double const altitude = altitudeOf(ray.at(0.5 * (start + end)));
        glsl::AirAt const air = glsl::airAt(air_, static_cast<float>(std::max(altitude, ground_)));
        double sends = static_cast<double>(highest((air.rayleigh + air.haze) * through)) * length;
        if (altitude > kTop || start > ground) sends = 0.0;
        through *= glm::exp(-air.extinction * static_cast<float>(length));
        sum += sends;
        parts.push_back({end, sends});
        start = end;
    }
    // Some go everywhere: the other rays of the pixel may go on where this one ends.
    for (sky::AirDraw::Part& part : parts) part.share += 0.01 * std::max(sum, 1e-9) / kParts;
    if (reach < far) parts.push_back({far, 0.05 * std::max(sum, 1e-9)});
    return sky::AirDraw{parts};
}

double ReferenceSky::surface(sky::PathRay const& ray) const { return crossing(ray, 0.0, ground_, false); }

sky::MediumFace ReferenceSky::face(glm::dvec3 const& place) const {
    return {glm::normalize(glm::dvec3{place.x, place.y + kRadius + eye_, place.z}), albedo_};
}

glm::vec3 ReferenceSky::sunThroughAir(double altitude, double cosine, double radius) const {
    return glsl::lightThroughAir({transmittance_.data(), kTableWidth, kTableHeight}, kTableSize, static_cast<float>(std::max(altitude, 0.0)),
                                 static_cast<float>(cosine), static_cast<float>(radius));
}

sky::SunThere ReferenceSky::sun(glm::dvec3 const& place, core::Random& random) const {
    glm::dvec3 const up = face(place).normal;
    double const cosine = glm::dot(up, light_.toward);
    glm::vec3 const irradiance = light_.above * sunThroughAir(altitudeOf(place), cosine, light_.radius);
    double const spread = random.uniform(1.0 - 0.5 * light_.radius * light_.radius, 1.0);
    return {sky::turned(light_.toward, spread, random), irradiance};
}

glm::vec3 ReferenceSky::beyond(sky::PathRay const& ray, bool seen) const {
    // Turned ways have met the light at each turn.
    bool const disc = seen && glm::dot(ray.direction, light_.toward) > 1.0 - 0.5 * light_.radius * light_.radius;
    return disc ? light_.above / static_cast<float>(core::kPi * light_.radius * light_.radius) : glm::vec3{0.0f};
}
}  // namespace luftpost::render
