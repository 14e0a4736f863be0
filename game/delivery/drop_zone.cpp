#include "game/delivery/drop_zone.h"

#include <array>
#include <cmath>
#include <string_view>

namespace luftpost::delivery {
namespace {
constexpr double kCosSteepest = 0.98480775301220806;  // cos 10 degrees
constexpr double kHighestZone = 3000.0;               // m above sea level: loaded aircraft get there
constexpr double kClimbShare = 0.08;                  // m of climb per m of way that every aircraft manages

std::string siteName(core::Random& random) {
    constexpr std::array<std::string_view, 24> kFirst{
        "Linden", "Hohen",  "Stein",   "Eich",    "Birken", "Mühl",   "Alten", "Neu",
        "Wiesen", "Ober",   "Unter",   "Schwarz", "Rosen",  "Falken", "Kirch", "Wald",
        "Hasel",  "Sonnen", "Fichten", "Mönch",   "Kalten", "Grün",   "Schön", "Erlen"};
    constexpr std::array<std::string_view, 20> kSecond{
        "au",   "bach",  "berg", "feld", "hof",  "ried",  "tal", "dorf", "egg",   "wil",
        "moos", "brunn", "heim", "rain", "matt", "stein", "see", "furt", "halde", "acker"};
    std::string name{kFirst[random.below(kFirst.size())]};
    return name += kSecond[random.below(kSecond.size())];
}

/// A direction by throwing darts at the unit disc: no function that differs between machines.
glm::dvec2 direction(core::Random& random) {
    while (true) {
        double const x = random.uniform(-1.0, 1.0), y = random.uniform(-1.0, 1.0);
        double const squared = x * x + y * y;
        if (squared <= 1.0 && squared > 0.01) return glm::dvec2{x, y} / std::sqrt(squared);
    }
}

/// The whole neighbourhood of the centre must be good: a site is a field, not a ledge.
bool isGoodField(glm::dvec2 place, core::GroundFunction const& ground) {
    constexpr double kHalf = 40.0;  // m
    for (glm::dvec2 const offset : {glm::dvec2{0.0, 0.0}, glm::dvec2{kHalf, 0.0}, glm::dvec2{-kHalf, 0.0},
                                    glm::dvec2{0.0, kHalf}, glm::dvec2{0.0, -kHalf}})
        if (!isGoodSite(ground(place.x + offset.x, place.y + offset.y))) return false;
    return true;
}

DropZone zoneAt(core::Random& random, glm::dvec2 place, core::GroundFunction const& ground) {
    return {siteName(random), place.x, place.y, ground(place.x, place.y).height};
}
}  // namespace

double distanceFrom(DropZone const& zone, double east, double north) {
    double const x = east - zone.east, y = north - zone.north;
    return std::sqrt(x * x + y * y);
}

double pointsFor(double distance) {
    return distance < kDropZoneRadius ? 100.0 * (1.0 - distance / kDropZoneRadius) : 0.0;
}

bool isGoodSite(core::GroundSample const& ground) {
    return ground.surface != core::Surface::water && ground.normalWorld.y > kCosSteepest;
}

DropZone firstDropZone(core::Random& random, glm::dvec2 start, glm::dvec2 heading,
                       core::GroundFunction const& ground) {
    glm::dvec2 const ahead = start + heading * kFirstZoneAhead;
    constexpr int kTries = 4000;
    glm::dvec2 place = ahead;
    for (int tried = 0; tried < kTries && !isGoodField(place, ground); ++tried)
        place = ahead + direction(random) * (random.uniform(0.0, 1.0) * (50.0 + 1.0 * tried));
    return zoneAt(random, place, ground);
}

DropZone nextDropZone(core::Random& random, DropZone const& last, core::GroundFunction const& ground) {
    constexpr int kTries = 4000, kStrictTries = 400;
    glm::dvec2 place{0.0};
    for (int tried = 0; tried < kTries; ++tried) {
        double const distance = random.uniform(kNearestZone, kFarthestZone);
        place = glm::dvec2{last.east, last.north} + direction(random) * distance;
        if (!isGoodField(place, ground)) continue;
        double const height = ground(place.x, place.y).height;
        bool const reachable = height < kHighestZone && height - last.height < 50.0 + kClimbShare * distance;
        if (reachable || tried >= kStrictTries) break;
    }
    return zoneAt(random, place, ground);
}
}  // namespace luftpost::delivery
