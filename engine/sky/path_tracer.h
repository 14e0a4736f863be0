// Light followed from scatter to scatter: what the reference is made of. Pure; any thread, one Random each.
//
// PROBLEM. The radiance that reaches the eye through a medium that scatters is an integral over all ways from the lights
// to the eye. What the game draws are models of it; here ways are drawn at random, each as often as nature takes it, and
// the mean of what they carry is the integral, with no error but noise.
//
// METHOD. Delta tracking (Woodcock 1965): free flights in a medium that is everywhere as dense as a bound, the majorant;
// where they end, the collision is real with the share that the true density has of it. With colours, a flight carries one
// weight for each, and is real or not as often as their sum would have it (Kutz et al. 2017, Spectral and decomposition
// tracking). A density above the majorant stays right in the mean: weights then turn negative. Where a part of the density is
// known beforehand, `sure`, that part of the collisions is real without asking (the same, decomposition tracking), and of a
// transmittance it is left out of the dice; one that is more than the true density stays right in the mean likewise.
// Toward the sun goes, from each collision, a way whose transmittance is estimated by ratio tracking (Novak et al. 2014).
// What a connection would bring is guessed before it is made: those that bring little are made seldom, and count the more.
// A guess may be wrong, for it only says how often.
//
// A medium has
//   static constexpr int kKinds                      of particles that scatter
//   static constexpr int kSureKind                   which of them is sure to be where a stretch says so; they do not absorb
//   Stretch stretchAt(PathRay, double from)          the bounds from there on
//   MediumPoint<kKinds> at(glm::dvec3 place)         what is there
//   Phase const& phase(int kind)
//   double surface(PathRay)                          m to a solid face, kNever for none
//   MediumFace face(glm::dvec3 place)
//   SunThere sun(glm::dvec3 place, Random&)          a light so far that all its rays are parallel
//   std::optional<glm::dvec3> toSun()                toward it, where it is one narrow light
//   Stretch shadowStretchAt(PathRay, double from)    bounds of what `shadowExtinction` finds
//   float shadowExtinction(glm::dvec3 place)         1/m, grey: of what `sun` has not taken off already
//   float sunGuess(glm::dvec3 place)                 about the transmittance that `shadow` finds toward the sun, above 0
//   glm::vec3 beyond(PathRay, bool seen)             radiance of what lies behind everything; `seen`: by the eye itself
// and for `seen`, of the two that it is made of, clouds in thin air,
//   MediumPoint<kKinds> cloudAt(glm::dvec3 place)    what `shadowExtinction` finds, by kinds
//   MediumPoint<kKinds> airAt(glm::dvec3 place)      the rest
//   glm::vec3 throughAir(PathRay, double distance, Random&)  an estimate of what the air lets through
#pragma once
#include <array>
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <vector>

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
    float sure = 0.0f;      // 1/m, grey, below the majorant: that much of kSureKind is there all along
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
    float sure = 0.0f;         // there, 1/m
    bool collided = false;     // else the limit was reached, or nothing came
};

/// Where a flight ends that begins `from` m along a ray. `here` is the stretch in which it begins, if that is known, and then the one in
/// which it ends: a flight that goes on need not ask.
template <class StretchAt>
Flight freeFlight(StretchAt const& stretchAt, PathRay const& ray, double from, double limit, Stretch& here, core::Random& random) {
    double left = -std::log(1.0 - random.uniform(0.0, 1.0));
    while (from < limit) {
        if (!(from < here.end)) here = stretchAt(ray, from);
        double const end = std::min(here.end, limit);
        double const depth = static_cast<double>(here.majorant) * (end - from);
        if (here.majorant > 0.0f && left < depth) return {from + left / static_cast<double>(here.majorant), here.majorant, here.sure, true};
        if (end == kNever) break;
        left -= here.majorant > 0.0f ? depth : 0.0;
        from = end;
    }
    return {limit, 0.0f, 0.0f, false};
}
inline constexpr Stretch kUnknown{0.0};  // the stretch before the first

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

/// An estimate of the share of a light that comes through along a ray, up to `limit`. What is less than `least` is now that, now nothing.
template <class Medium>
float shadow(Medium const& medium, PathRay const& ray, double limit, float least, core::Random& random) {
    glm::vec3 through{1.0f};
    double from = 0.0;
    double left = -std::log(1.0 - random.uniform(0.0, 1.0));
    Stretch stretch = kUnknown;
    while (from < limit) {
        if (!(from < stretch.end)) stretch = medium.shadowStretchAt(ray, from);
        auto const sure = static_cast<double>(stretch.sure), rest = static_cast<double>(stretch.majorant) - sure;
        double end = std::min(stretch.end, limit);
        if (end == kNever && !(rest > 0.0)) break;
        bool const collided = left < rest * (end - from);
        if (collided) end = from + left / rest;
        if (sure > 0.0) through *= static_cast<float>(std::exp(sure * (from - end)));
        if (collided) {
            through *= 1.0f - (medium.shadowExtinction(ray.at(end)) - stretch.sure) / static_cast<float>(rest);
            left = -std::log(1.0 - random.uniform(0.0, 1.0));
        } else {
            left -= rest * (end - from);
        }
        if (!survives(std::abs(through.x), least, through, random)) return 0.0f;
        from = end;
    }
    return through.x;
}

/// Which kind of particle scatters at a real collision, and by what the weights change.
template <int kKinds>
struct Scatter {
    int kind = -1;          // -1: no real collision
    glm::vec3 weight{1.0f};
};

/// Decides what happens at the end of a flight, where nothing is sure.
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

/// The kind of particle that turns a way at the end of a flight, where `pointThere` finds what is there; -1 for none. What is sure
/// is real without a look, as often as it is part of the majorant; the rest of what is there is held against the rest of it.
template <class Medium, class PointThere>
int kindAt(Medium const&, Flight const& flight, glm::vec3& weight, PointThere const& pointThere, core::Random& random) {
    if (flight.sure > 0.0f && random.uniform(0.0, 1.0) * static_cast<double>(flight.majorant) < static_cast<double>(flight.sure)) return Medium::kSureKind;
    auto point = pointThere();
    point.extinction -= flight.sure;
    point.scattering[Medium::kSureKind] -= flight.sure;
    auto const event = collision(point, flight.majorant - flight.sure, weight, random);
    weight *= event.weight;
    return event.kind;
}

/// Follows the way to the next real collision or face, or to its end, whose radiance it gathers.
template <class Medium>
Meeting nextMeeting(Medium const& medium, EyePath& path, core::Random& random) {
    constexpr float kLeast = 0.1f;
    auto const stretches = [&](PathRay const& ray, double from) { return medium.stretchAt(ray, from); };
    double const limit = medium.surface(path.ray);
    float const least = std::min(kLeast, most(path.weight));  // a look that set out with little is not cut down for it
    Stretch here = kUnknown;
    Flight flight = freeFlight(stretches, path.ray, 0.0, limit, here, random);
    while (flight.collided) {
        glm::dvec3 const place = path.ray.at(flight.distance);
        int const kind = kindAt(medium, flight, path.weight, [&] { return medium.at(place); }, random);
        if (!survives(most(path.weight), least, path.weight, random)) return {};
        if (kind >= 0) return {kind, false, place};
        flight = freeFlight(stretches, path.ray, flight.distance, limit, here, random);
    }
    if (limit < kNever) return {-1, false, path.ray.at(limit)};
    path.light += path.weight * medium.beyond(path.ray, path.turns == 0);
    return {};
}

// What is left to the dice: what brings less than this is now brought as this, now not at all. Small against what clouds in the sun
// send on, some 0.1 of the sun's irradiance for each sr, so that the dice add little noise and save most of the work.
inline constexpr float kGlimmer = 0.01f;    // 1/sr: of the sun's irradiance, what a connection to it brings
inline constexpr float kLook = 0.04f;       // 1/sr: the same of a look
inline constexpr float kMostLeast = 0.2f;   // a transmittance, whatever it is for
inline constexpr float kWorthIt = 0.5f;     // the weight of a way that sets out anew: from a face, from the air before the clouds

/// Gathers the sun at a place where light is turned with the probability `phaseAt` of its direction, 1/sr.
template <class Medium, class PhaseAt>
void gatherSun(Medium const& medium, EyePath& path, glm::dvec3 const& place, PhaseAt const& phaseAt, core::Random& random) {
    glm::vec3 weight = path.weight * path.share;
    if (auto const toSun = medium.toSun())
        if (!survives(most(weight) * phaseAt(*toSun) * medium.sunGuess(place), kGlimmer, weight, random)) return;
    SunThere const sun = medium.sun(place, random);
    weight *= sun.irradiance * phaseAt(sun.toward);
    float const bright = most(sun.irradiance), brings = most(weight);
    if (!(brings > 0.0f)) return;
    path.light += weight * shadow(medium, PathRay{place, sun.toward}, kNever, std::min(kMostLeast, kGlimmer * bright / brings), random);
}

/// The lobe around the sun that lookToSun draws from, so often at each turn.
inline constexpr int kLooks = 4;
inline Phase const& sunwardLobe() {
    static Phase const lobe = Phase::henyeyGreenstein(0.85f);
    return lobe;
}

/// Droplets scatter forward so much that a way which happens to run toward the sun gathers a hundred times the mean: rare, and
/// so noise. More draws, from a lobe around the sun, make such ways often and each of them small; they and the way itself share
/// what they gather by the balance heuristic (Veach 1995). From `place`, where the way was turned by `phase`, one looks for the
/// next turn and gathers the sun there.
template <class Medium>
void lookToSun(Medium const& medium, EyePath& path, glm::dvec3 const& place, Phase const& phase, glm::dvec3 const& toSun, core::Random& random) {
    glm::dvec3 const direction = turned(toSun, sunwardLobe().draw(random), random);
    float const straight = phase.at(static_cast<float>(glm::dot(path.ray.direction, direction)));
    float const sunward = kLooks * sunwardLobe().at(static_cast<float>(glm::dot(direction, toSun)));
    EyePath look{{place, direction}, glm::vec3{0.0f}, path.weight * (straight / (straight + sunward)), path.turns + 1, 1.0f};
    // Droplets where it is turned next would turn it to the sun about as the lobe does. From deep down it brings much when it happens to
    // fly far: what counts is the root of the mean square, which falls like the root of the guess.
    if (!survives(most(look.weight) * (sunward / kLooks) * std::sqrt(medium.sunGuess(place)), kLook, look.weight, random)) return;
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
        for (int i = 0; i < kLooks; ++i) lookToSun(medium, path, meeting.place, phase, *toSun, random);
        float const straight = phase.at(static_cast<float>(glm::dot(path.ray.direction, direction)));
        path.share = straight / (straight + kLooks * sunwardLobe().at(static_cast<float>(glm::dot(direction, *toSun))));
    }
    path.ray = {meeting.place, direction};
}

/// Turns a way at a face; false where it ends.
template <class Medium>
bool turnAtFace(Medium const& medium, EyePath& path, glm::dvec3 const& place, core::Random& random) {
    MediumFace const face = medium.face(place);
    path.weight *= face.albedo;
    if (!survives(most(path.weight), kWorthIt, path.weight, random)) return false;
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

/// Follows a way to its end. What comes after many turns is little and alike, but costs most: after 128, 256, 512, ... turns every second
/// way is ended. (A constant chance at every turn would end them sooner, and let weights grow
/// faster than long ways grow rare: no number of samples then settles the mean.)
template <class Medium>
void follow(Medium const& medium, EyePath& path, core::Random& random) {
    int next = 128;
    while (followed(medium, path, random)) {
        if (++path.turns < next) continue;
        next *= 2;
        if (random.uniform(0.0, 1.0) < 0.5) break;
        path.weight *= 2.0f;
    }
}

/// Radiance that comes along a ray to its origin: one sample of it.
template <class Medium>
glm::vec3 pathRadiance(Medium const& medium, PathRay const& ray, core::Random& random) {
    EyePath path{ray};
    follow(medium, path, random);
    return path.light;
}

/// Where along a ray the air before the clouds is asked what it sends to the eye: parts with a share each.
class AirDraw {
public:
    struct Part {
        double end = 0.0;    // m, rising
        double share = 0.0;  // positive; the shares need not add up to 1
    };
    explicit AirDraw(std::vector<Part> const& parts) : parts_{parts} {
        for (Part& part : parts_) part.share = sum_ += part.share;
    }
    struct Place {
        double distance = 0.0;  // m
        double density = 0.0;   // 1/m, of the draw
    };
    Place draw(core::Random& random) const {
        double const choice = random.uniform(0.0, sum_);
        auto const part = std::upper_bound(parts_.begin(), parts_.end() - 1, choice, [](double value, Part const& p) { return value < p.share; });
        double const start = part == parts_.begin() ? 0.0 : (part - 1)->end, below = part == parts_.begin() ? 0.0 : (part - 1)->share;
        return {random.uniform(start, part->end), (part->share - below) / (sum_ * (part->end - start))};
    }

private:
    std::vector<Part> parts_;  // shares summed up
    double sum_ = 0.0;
};

/// What the eye sees along a ray, and the share of it that comes through the clouds.
struct Seen {
    glm::vec3 light{0.0f};
    float through = 1.0f;
};

/// What the air at a drawn place of a ray sends along it to the eye, `clear` of which comes through the clouds.
template <class Medium>
glm::vec3 turnedByAir(Medium const& medium, PathRay const& ray, AirDraw::Place const& turn, float clear, core::Random& random) {
    Meeting meeting{0, false, ray.at(turn.distance)};
    auto const point = medium.airAt(meeting.place);
    auto const sum = [](glm::vec3 const& v) { return v.x + v.y + v.z; };
    glm::vec3 all{0.0f};
    for (glm::vec3 const& kind : point.scattering) all += kind;
    float choice = static_cast<float>(random.uniform(0.0, 1.0)) * sum(all);
    while (meeting.kind + 1 < Medium::kKinds && choice >= sum(point.scattering[static_cast<std::size_t>(meeting.kind)]))
        choice -= sum(point.scattering[static_cast<std::size_t>(meeting.kind++)]);
    glm::vec3 const kind = point.scattering[static_cast<std::size_t>(meeting.kind)];
    if (!(sum(kind) > 0.0f)) return glm::vec3{0.0f};
    EyePath path{ray};
    path.weight = kind * (sum(all) / sum(kind)) * medium.throughAir(ray, turn.distance, random) * (clear / static_cast<float>(turn.density));
    turnAtParticle(medium, path, meeting, random);
    path.turns = 1;
    // What follows takes as long as any way, but brings as little as it weighs.
    if (survives(most(path.weight), kWorthIt, path.weight, random)) follow(medium, path, random);
    return path.light;
}

/// As pathRadiance, of clouds in thin air. The air turns few ways to the eye, each of them much brighter than the mean: left to chance
/// that is noise. So every sample has two ways that add up: one that first meets a cloud, a face or nothing, dimmed by the air
/// before it, and one that the air turns at a place drawn by `air`, which must reach as far as the medium, with the weight
/// that such a turn has. The first also says whether a cloud hides that place: it gets there as often as light does.
template <class Medium>
Seen seen(Medium const& medium, PathRay const& ray, AirDraw const& air, core::Random& random) {
    auto const stretches = [&](PathRay const& r, double from) { return medium.shadowStretchAt(r, from); };
    double const limit = medium.surface(ray);
    AirDraw::Place const turn = air.draw(random);
    float clear = 0.0f;
    EyePath path{ray};
    Meeting first;
    Stretch here = kUnknown;
    for (double from = 0.0; from < limit && first.kind < 0;) {
        Flight const flight = freeFlight(stretches, ray, from, limit, here, random);
        if (turn.distance > from && turn.distance <= flight.distance) clear = path.weight.x;
        from = flight.distance;
        if (!flight.collided) break;
        first.place = ray.at(flight.distance);
        first.kind = kindAt(medium, flight, path.weight, [&] { return medium.cloudAt(first.place); }, random);
    }
    Seen result{glm::vec3{0.0f}, first.kind < 0 ? path.weight.x : 0.0f};
    path.weight *= medium.throughAir(ray, first.kind < 0 ? limit : glm::distance(ray.origin, first.place), random);
    bool goesOn = true;
    if (first.kind >= 0) turnAtParticle(medium, path, first, random);
    else if (limit < kNever) goesOn = turnAtFace(medium, path, ray.at(limit), random);
    else goesOn = false;
    if (first.kind < 0 && limit == kNever) path.light += path.weight * medium.beyond(ray, true);
    path.turns = 1;
    if (goesOn) follow(medium, path, random);
    result.light = path.light;
    if (clear != 0.0f && turn.distance < limit) result.light += turnedByAir(medium, ray, turn, clear, random);
    return result;
}
}  // namespace luftpost::sky
