#include "engine/weather/lightning.h"

#include <algorithm>
#include <cmath>

#include "engine/weather/cloud_pattern.h"
#include "engine/weather/ramp.h"
#include "engine/weather/showers.h"

namespace luftpost::weather {
namespace {
constexpr double kCell = 8000.0;   // m: a storm's cell
constexpr double kSlot = 16.0;     // s
constexpr double kToGround = 0.35; // share of the flashes

/// Random numbers 0..1 of one cell and slot.
class Dice {
public:
    Dice(unsigned seed, glm::ivec2 const& cell, long long slot)
        : state_{glsl::hashOf(seed + 31u * glsl::hashOf(static_cast<unsigned>(cell.x) * 9781u + glsl::hashOf(static_cast<unsigned>(cell.y))) +
                              glsl::hashOf(static_cast<unsigned>(slot & 0xffffffff)))} {}
    double next() { return static_cast<double>(glsl::unitFromHash(state_ = glsl::hashOf(state_ + 0x9e3779b9u))); }
    unsigned state() const { return state_; }

private:
    unsigned state_;
};

/// The storm layer of a weather, if it has one.
Layer const* stormOf(Weather const& weather) {
    for (int i = 0; i < weather.layerCount; ++i)
        if (weather.layers[static_cast<std::size_t>(i)].genus == Genus::Cb) return &weather.layers[static_cast<std::size_t>(i)];
    return nullptr;
}

struct Storm {
    Weather const& weather;
    Layer const& layer;
    LayerPattern pattern;
    double ground;

    /// The flash of a cell and slot, if it has one. `cell`: in the frame that drifts with the layer.
    bool flash(Dice dice, glm::ivec2 const& cell, long long slot, Flash& flash) const {
        double const chance = 0.06 + 0.10 * smooth(300.0, 2500.0, weather.cape);
        if (dice.next() > chance) return false;
        glm::dvec2 const place = (glm::dvec2{cell} + glm::dvec2{dice.next(), dice.next()}) * kCell;
        double const rank = static_cast<double>(pattern.drifting(place.x, place.y));
        if (showerInside(Genus::Cb, rank, static_cast<double>(layer.cover)).here <= 0.05) return false;  // no tower there
        flash.time = (static_cast<double>(slot) + dice.next()) * kSlot;
        flash.toGround = dice.next() < kToGround;
        double const base = static_cast<double>(layer.base), top = static_cast<double>(layer.top);
        double const height = flash.toGround ? 0.04 : 0.1 + 0.4 * dice.next();
        glm::dvec2 const eastNorth = place + layer.drift;
        flash.sourceWorld = {eastNorth.x, base + height * (top - base), -eastNorth.y};
        double const away = 0.25 * (base - ground);
        flash.groundWorld = {eastNorth.x + away * (dice.next() - 0.5), ground, -eastNorth.y + away * (dice.next() - 0.5)};
        flash.power = 0.3 + 0.7 * dice.next();
        flash.seed = dice.state() & 0xfffffu;
        return true;
    }
};
}  // namespace

std::vector<Flash> flashes(Weather const& weather, unsigned seed, core::UtcSeconds from, core::UtcSeconds to, glm::dvec2 const& eastNorth,
                           double reach, double ground) {
    std::vector<Flash> found;
    Layer const* layer = stormOf(weather);
    if (!weather.thunder || layer == nullptr || !(layer->cover > 0.0f)) return found;
    Storm const storm{weather, *layer, LayerPattern{*layer, seed}, ground};
    glm::dvec2 const middle = eastNorth - layer->drift;
    glm::ivec2 const low{glm::floor((middle - reach) / kCell)}, high{glm::floor((middle + reach) / kCell)};
    for (auto slot = static_cast<long long>(std::floor(from / kSlot)); slot <= static_cast<long long>(std::floor(to / kSlot)); ++slot)
        for (int y = low.y; y <= high.y; ++y)
            for (int x = low.x; x <= high.x; ++x) {
                Flash flash;
                if (!storm.flash(Dice{seed + layer->pattern, {x, y}, slot}, {x, y}, slot, flash)) continue;
                bool const near = glm::distance(glm::dvec2{flash.sourceWorld.x, -flash.sourceWorld.z}, eastNorth) <= reach;
                if (near && flash.time >= from && flash.time < to) found.push_back(flash);
            }
    std::sort(found.begin(), found.end(), [](Flash const& a, Flash const& b) { return a.time < b.time; });
    return found;
}

double flashLight(Flash const& flash, double after) {
    constexpr double kApart = 0.07, kFade = 0.035;  // s
    if (after < 0.0 || after > kFlashSeconds) return 0.0;
    int const strokes = 1 + static_cast<int>(flash.seed % 4u);
    double light = 0.0;
    for (int i = 0; i < strokes; ++i) {
        double const since = after - i * kApart;
        if (since >= 0.0) light = std::max(light, std::exp(-since / kFade) * (i == 0 ? 1.0 : 0.7));
    }
    return light;
}

double thunderDelay(Flash const& flash, glm::dvec3 const& earWorld) {
    glm::dvec3 const way = flash.groundWorld - flash.sourceWorld;
    double const along = flash.toGround ? std::clamp(glm::dot(earWorld - flash.sourceWorld, way) / std::max(glm::dot(way, way), 1e-6), 0.0, 1.0) : 0.0;
    return glm::distance(earWorld, flash.sourceWorld + along * way) / kSoundSpeed;
}

std::vector<Flash> thunders(Weather const& weather, unsigned seed, core::UtcSeconds from, core::UtcSeconds to, glm::dvec3 const& earWorld, double ground) {
    constexpr double kAudible = 20'000.0;      // m
    constexpr double kLatest = 1.5 * kAudible / kSoundSpeed;  // s: clouds are higher than far
    std::vector<Flash> heard = flashes(weather, seed, from - kLatest, to, {earWorld.x, -earWorld.z}, kAudible, ground);
    std::erase_if(heard, [&](Flash const& flash) {
        double const arrives = flash.time + thunderDelay(flash, earWorld);
        return arrives <= from || arrives > to;
    });
    return heard;
}
}  // namespace luftpost::weather
