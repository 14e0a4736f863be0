// Light followed from scatter to scatter: what the reference is made of. Pure; any thread, one Random each.
//
// PROBLEM. The radiance that reaches the eye through a medium that scatters is an integral over all ways from the lights
// to the eye. What the game draws are models of it; here ways are drawn at random, each as often as nature takes it, and
// the mean of what they carry is the integral, with no error but noise.
//
// METHOD. Delta tracking (Woodcock 1965): free flights in a medium that is everywhere as dense as a bound, the majorant;
// where they end, the collision is real with the share that the true density has of it. With colours, a flight carries one
// weight for each, and is real or not as often as their sum would have it (Kutz et al. 2017, Spectral and decomposition
// tracking). A density above the majorant stays right in the mean: weights then turn negative. Toward the sun goes, from
// each collision, a way whose transmittance is estimated by ratio tracking (Novak et al. 2014).
//
// A medium has
//   static constexpr int kKinds                      of particles that scatter
//   Stretch stretchAt(PathRay, double from)          the majorant from there on
//   MediumPoint<kKinds> at(glm::dvec3 place)         what is there
//   Phase const& phase(int kind)
//   double surface(PathRay)                          m to a solid face, kNever for none
//   MediumFace face(glm::dvec3 place)
//   SunThere sun(glm::dvec3 place, Random&)          a light so far that all its rays are parallel
//   std::optional<glm::dvec3> toSun()                toward it, where it is one narrow light
//   Stretch shadowStretchAt(PathRay, double from)    majorant of what `shadowExtinction` finds
//   float shadowExtinction(glm::dvec3 place)         1/m, grey: of what `sun` has not taken off already
//   glm::vec3 beyond(PathRay, bool seen)             radiance of what lies behind everything; `seen`: by the eye itself
#pragma once
#include <array>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>

#include <glm/glm.hpp>

#include "engine/core/frames.h"
#include "engine/core/random.h"
#include "engine/sky/phase.h"

namespace luftpost::sky {
inline constexpr double kNever = std::numeric_limits<double>::infinity();

struct PathRay {
    glm::dvec3 origin{0.0};     // m
    glm::dvec3 direction{0.0};  // unit
    glm::dvec3 at(double distance) const { return origin + direction * distance; }
};

/// A part of a ray over which one majorant holds. `end` lies beyond where it was asked; kNever with a majorant of 0:
/// nothing more comes.
struct Stretch {
    double end = kNever;    // m from the ray's origin
    float majorant = 0.0f;  // 1/m
};

/// Per metre, red, green and blue. What extinction has beyond the scattering is absorbed.
template <int kKinds>
struct MediumPoint {
    glm::vec3 extinction{0.0f};
    std::array<glm::vec3, kKinds> scattering{};
};

struct MediumFace {
    glm::dvec3 normal{0.0, 1.0, 0.0};
    glm::vec3 albedo{0.0f};  // Lambert's
};

struct SunThere {
    glm::dvec3 toward{0.0, 1.0, 0.0};
    glm::vec3 irradiance{0.0f};  // on a plane that faces it
};

/// Where a free flight ends.
struct Flight {
    double distance = kNever;  // m from the ray's origin
    float majorant = 0.0f;     // there, 1/m
    bool collided = false;     // else the limit was reached, or nothing came
};

template <class StretchAt>
Flight freeFlight(StretchAt const& stretchAt, PathRay const& ray, double from, double limit, core::Random& random) {
    double left = -std::log(1.0 - random.uniform(0.0, 1.0));
    while (from < limit) {
        Stretch const stretch = stretchAt(ray, from);
        double const end = std::min(stretch.end, limit);
        double const depth = static_cast<double>(stretch.majorant) * (end - from);
        if (stretch.majorant > 0.0f && left < depth)
            return {from + left / static_cast<double>(stretch.majorant), stretch.majorant, true};
        if (end == kNever) break;
        left -= stretch.majorant > 0.0f ? depth : 0.0;
        from = end;
    }
    return {limit, 0.0f, false};
}

/// What a way carries at most in one colour, whatever its sign: bounds that are broken turn weights negative.
inline float most(glm::vec3 const& weight) {
    glm::vec3 const size = glm::abs(weight);
    return std::max(size.x, std::max(size.y, size.z));
}

/// Kills ways that carry little, and lets the rest carry theirs: false where the way ends.
inline bool survives(float weight, float least, glm::vec3& carried, core::Random& random) {
    if (weight >= least) return true;
    double const chance = static_cast<double>(weight / least);
    if (random.uniform(0.0, 1.0) >= chance) return false;
    carried *= least / weight;
    return true;
}

/// An estimate of the share of a light that comes through along a ray, up to `limit`.
template <class Medium>
float shadow(Medium const& medium, PathRay const& ray, double limit, core::Random& random) {
    constexpr float kLeast = 0.2f;
    auto const stretches = [&](PathRay const& r, double from) { return medium.shadowStretchAt(r, from); };
    glm::vec3 through{1.0f};
    Flight flight = freeFlight(stretches, ray, 0.0, limit, random);
    while (flight.collided) {
        through *= 1.0f - medium.shadowExtinction(ray.at(flight.distance)) / flight.majorant;
        if (!survives(std::abs(through.x), kLeast, through, random)) return 0.0f;
        flight = freeFlight(stretches, ray, flight.distance, limit, random);
    }
    return through.x;
}

/// Sunlight at a place, with the shadow of what lies before the sun.
template <class Medium>
SunThere sunlit(Medium const& medium, glm::dvec3 const& place, core::Random& random) {
    SunThere sun = medium.sun(place, random);
    if (sun.irradiance.x + sun.irradiance.y + sun.irradiance.z > 0.0f)
        sun.irradiance *= shadow(medium, PathRay{place, sun.toward}, kNever, random);
    return sun;
}

/// Which kind of particle scatters at a real collision, and by what the weights change.
template <int kKinds>
struct Scatter {
    int kind = -1;          // -1: no real collision
    glm::vec3 weight{1.0f};
};

/// Decides what happens at the end of a flight.
template <int kKinds>
Scatter<kKinds> collision(MediumPoint<kKinds> const& point, float majorant, glm::vec3 const& weight, core::Random& random) {
    auto const sum = [&](glm::vec3 const& v) { return std::abs(weight.x * v.x) + std::abs(weight.y * v.y) + std::abs(weight.z * v.z); };
    glm::vec3 const none = glm::vec3{majorant} - point.extinction;
    std::array<float, kKinds> chances{};
    float total = sum(none);
    for (std::size_t i = 0; i < kKinds; ++i) total += chances[i] = sum(point.scattering[i]);
    if (!(total > 0.0f)) return {-1, glm::vec3{0.0f}};
    float choice = static_cast<float>(random.uniform(0.0, 1.0)) * total;
    for (std::size_t i = 0; i < kKinds; ++i) {
        if (choice < chances[i]) return {static_cast<int>(i), point.scattering[i] * (total / (majorant * chances[i]))};
        choice -= chances[i];
    }
    float const chance = sum(none);
    if (!(chance > 0.0f)) return {-1, glm::vec3{0.0f}};
    return {-1, none * (total / (majorant * chance))};
}

/// A way back from the eye: what it has gathered, and what it would still bring of the light it meets.
struct EyePath {
    PathRay ray;
    glm::vec3 light{0.0f};
    glm::vec3 weight{1.0f};
    int turns = 0;        // so far; 0: what it meets is seen by the eye itself
    float share = 1.0f;   // of the sunlight at its next turn that it gathers; `lookToSun` gathers the rest
};

/// What a way meets next.
struct Meeting {
    int kind = -1;         // of the particle that turns it, else a face
    bool ended = true;     // nothing came any more, or the way was given up
    glm::dvec3 place{0.0};
};

/// Follows the way to the next real collision or face, or to its end, whose radiance it gathers.
template <class Medium>
Meeting nextMeeting(Medium const& medium, EyePath& path, core::Random& random) {
    constexpr float kLeast = 0.25f;
    auto const stretches = [&](PathRay const& ray, double from) { return medium.stretchAt(ray, from); };
    double const limit = medium.surface(path.ray);
    float const least = std::min(kLeast, most(path.weight));  // a look that set out with little is not cut down for it
    Flight flight = freeFlight(stretches, path.ray, 0.0, limit, random);
    while (flight.collided) {
        glm::dvec3 const place = path.ray.at(flight.distance);
        auto const event = collision(medium.at(place), flight.majorant, path.weight, random);
        path.weight *= event.weight;
        if (!survives(most(path.weight), least, path.weight, random)) return {};
        if (event.kind >= 0) return {event.kind, false, place};
        flight = freeFlight(stretches, path.ray, flight.distance, limit, random);
    }
    if (limit < kNever) return {-1, false, path.ray.at(limit)};
    path.light += path.weight * medium.beyond(path.ray, path.turns == 0);
    return {};
}

/// Gathers the sun at a place where light is turned with the probability `phaseAt` of its direction, 1/sr.
template <class Medium, class PhaseAt>
void gatherSun(Medium const& medium, EyePath& path, glm::dvec3 const& place, PhaseAt const& phaseAt, core::Random& random) {
    SunThere const sun = sunlit(medium, place, random);
    path.light += path.weight * sun.irradiance * (path.share * phaseAt(sun.toward));
}

/// The lobe around the sun that lookToSun draws from.
inline Phase const& sunwardLobe() {
    static Phase const lobe = Phase::henyeyGreenstein(0.85f);
    return lobe;
}

/// Droplets scatter forward so much that a way which happens to run toward the sun gathers a hundred times the mean: rare, and
/// so noise. A second draw, from a lobe around the sun, makes such ways often and each of them small; the two share what they
/// gather by the balance heuristic (Veach 1995). From `place`, where the way was turned by `phase`, it looks for the next turn
/// and gathers the sun there.
template <class Medium>
void lookToSun(Medium const& medium, EyePath& path, glm::dvec3 const& place, Phase const& phase, glm::dvec3 const& toSun, core::Random& random) {
    constexpr float kLeast = 0.1f;
    glm::dvec3 const direction = turned(toSun, sunwardLobe().draw(random), random);
    float const straight = phase.at(static_cast<float>(glm::dot(path.ray.direction, direction)));
    float const share = straight / (straight + sunwardLobe().at(static_cast<float>(glm::dot(direction, toSun))));
    EyePath look{{place, direction}, glm::vec3{0.0f}, path.weight * share, path.turns + 1, 1.0f};
    if (!survives(share, kLeast, look.weight, random)) return;
    Meeting const meeting = nextMeeting(medium, look, random);
    look.light = glm::vec3{0.0f};  // what lies beyond is the way's own
    if (meeting.ended || meeting.kind < 0) return;
    Phase const& there = medium.phase(meeting.kind);
    gatherSun(medium, look, meeting.place, [&](glm::dvec3 const& toward) { return there.at(static_cast<float>(glm::dot(direction, toward))); }, random);
    path.light += look.light;
}

/// Turns a way at a particle; gathers the sun first.
template <class Medium>
void turnAtParticle(Medium const& medium, EyePath& path, Meeting const& meeting, core::Random& random) {
    Phase const& phase = medium.phase(meeting.kind);
    gatherSun(medium, path, meeting.place, [&](glm::dvec3 const& toward) { return phase.at(static_cast<float>(glm::dot(path.ray.direction, toward))); }, random);
    glm::dvec3 const direction = turned(path.ray.direction, phase.draw(random), random);
    path.share = 1.0f;
    if (auto const toSun = medium.toSun()) {
        lookToSun(medium, path, meeting.place, phase, *toSun, random);
        float const straight = phase.at(static_cast<float>(glm::dot(path.ray.direction, direction)));
        path.share = straight / (straight + sunwardLobe().at(static_cast<float>(glm::dot(direction, *toSun))));
    }
    path.ray = {meeting.place, direction};
}

/// Turns a way at a face; false where it ends.
template <class Medium>
bool turnAtFace(Medium const& medium, EyePath& path, glm::dvec3 const& place, core::Random& random) {
    constexpr float kLeast = 0.25f;
    MediumFace const face = medium.face(place);
    path.weight *= face.albedo;
    if (!survives(most(path.weight), kLeast, path.weight, random)) return false;
    path.share = 1.0f;
    gatherSun(medium, path, place, [&](glm::dvec3 const& toward) { return static_cast<float>(std::max(glm::dot(face.normal, toward), 0.0) / core::kPi); }, random);
    path.ray = {place, lambertian(face.normal, random)};
    return true;
}

/// Follows the way to its next turn; false where it ends.
template <class Medium>
bool followed(Medium const& medium, EyePath& path, core::Random& random) {
    Meeting const meeting = nextMeeting(medium, path, random);
    if (meeting.ended) return false;
    if (meeting.kind < 0) return turnAtFace(medium, path, meeting.place, random);
    turnAtParticle(medium, path, meeting, random);
    return true;
}

/// Radiance that comes along a ray to its origin: one sample of it.
template <class Medium>
glm::vec3 pathRadiance(Medium const& medium, PathRay const& ray, core::Random& random) {
    // What comes after many turns is little and alike, but costs most: after 24, 48, 96, ... turns every second way is ended.
    // (A constant chance at every turn would end them sooner, and let weights grow faster than long ways grow rare: no
    // number of samples then settles the mean.)
    EyePath path{ray};
    int next = 24;
    while (followed(medium, path, random)) {
        if (++path.turns < next) continue;
        next *= 2;
        if (random.uniform(0.0, 1.0) < 0.5) break;
        path.weight *= 2.0f;
    }
    return path.light;
}
}  // namespace luftpost::sky
