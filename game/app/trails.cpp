#include "game/app/trails.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::app {
namespace {
constexpr std::size_t kMost = 320;   // the oldest make way
constexpr double kTyreSmoke = 12.0;  // m/s over the ground at which a tyre that begins to turn smokes

/// -1..1, another one each time.
double shaken(unsigned number, unsigned salt) {
    unsigned h = number * 2654435761u + salt * 40503u;
    h = (h ^ (h >> 15)) * 2246822519u;
    return static_cast<double>((h ^ (h >> 13)) & 0xffffu) / 32767.5 - 1.0;
}

/// What a wheel whirls up there; an opacity of 0: nothing.
struct Whirl {
    glm::vec4 colour{0.0f};
    double rise = 0.8;  // m/s
};
Whirl whirlOf(core::Surface surface, core::AirSample const& air) {
    constexpr double kWet = 0.3;  // mm/h
    if (surface == core::Surface::snow) return {{0.95f, 0.96f, 1.0f, 0.45f}, 1.2};
    if (air.rain > kWet) return {{0.80f, 0.84f, 0.88f, 0.30f}, 1.6};
    if (surface == core::Surface::sand) return {{0.82f, 0.72f, 0.54f, 0.60f}, 1.0};
    if (surface == core::Surface::grass || surface == core::Surface::rock)
        return {{0.66f, 0.58f, 0.44f, 0.45f}, 0.9};
    return {};
}
}  // namespace

int Trails::due(double& owed, double rate, double seconds) {
    owed += rate * seconds;
    double const whole = std::floor(std::min(owed, 12.0));
    owed -= whole;
    return static_cast<int>(whole);
}

/// Dust and spray while it rolls, and a breath of smoke from the tyres where it touches a hard runway.
void Trails::followWheels(TrailScene const& scene, double seconds) {
    flight::AircraftState const& state = scene.state;
    double const speed = state.readings.groundSpeed;
    bool const touched =
        state.touchdownTick != touchdownTick_ && state.touchdownTick >= 0 && state.readings.onGround;
    touchdownTick_ = state.touchdownTick;
    for (std::size_t i = 0; i < scene.airframe.wheels.size(); ++i) {
        if (!state.wheels[i].contact || scene.airframe.wheels[i].skid) continue;
        glm::dvec3 const foot =
            scene.pose.positionWorld + scene.pose.worldFromBody * scene.airframe.wheels[i].position;
        core::GroundSample const under = scene.ground(foot.x, -foot.z);
        Whirl const whirl = whirlOf(under.surface, scene.air);
        bool const hard = whirl.colour.w == 0.0f;
        int count = hard ? 0 : due(owedByWheel_[i], std::clamp((speed - 5.0) * 0.9, 0.0, 24.0), seconds);
        if (touched && speed > kTyreSmoke) count += 5;
        for (int k = 0; k < count; ++k) {
            double const back = seconds * speed * (k + 0.5) / count;
            glm::dvec3 const way = speed > 0.1 ? state.velocityWorld / speed : glm::dvec3{0.0};
            Drift puff;
            puff.positionWorld = glm::dvec3{foot.x, under.height + 0.15, foot.z} - way * back;
            puff.velocityWorld = 0.12 * state.velocityWorld +
                                 glm::dvec3{0.6 * shaken(made_, 1), whirl.rise, 0.6 * shaken(made_, 2)};
            puff.age = seconds * (k + 0.5) / count;
            puff.life = hard ? 1.6 : 2.4 + 0.8 * shaken(made_, 3);
            puff.radius = 0.4, puff.growth = hard ? 1.1 : 1.2;
            puff.colour = hard ? glm::vec4{0.75f, 0.75f, 0.77f, 0.35f} : whirl.colour;
            puffs_.push_back(puff);
            ++made_;
        }
    }
}

/// Moist air that a hard pull cools below its dew point leaves a streak off each tip.
void Trails::followTips(TrailScene const& scene, double seconds) {
    constexpr double kDry = 3.0, kPull = 1.6;  // K, g
    flight::Readings const& now = scene.state.readings;
    double const moist = std::clamp(1.0 - scene.spread / kDry, 0.0, 1.0);
    double const pull = std::clamp((now.loadFactor - kPull + moist) / 1.5, 0.0, 1.0);
    double const strength = moist * pull * std::clamp((now.tas - 25.0) / 20.0, 0.0, 1.0);
    if (strength <= 0.02 || now.onGround) return;
    int const count = due(owedByTips_, 120.0, seconds);
    for (int k = 0; k < count; ++k)
        for (double side : {-1.0, 1.0}) {
            glm::dvec3 const tip{-0.6, scene.airframe.wingHeight - 1.0, side * 0.5 * scene.airframe.wingSpan};
            Drift puff;
            puff.positionWorld = scene.pose.positionWorld + scene.pose.worldFromBody * tip -
                                 scene.state.velocityWorld * (seconds * (k + 0.5) / count);
            puff.velocityWorld =
                scene.air.windWorld +
                glm::dvec3{0.3 * shaken(made_, 4), 0.3 * shaken(made_, 5), 0.3 * shaken(made_, 6)};
            puff.age = seconds * (k + 0.5) / count;
            puff.life = 0.5 + 0.6 * strength;
            puff.radius = 0.40, puff.growth = 0.45;
            puff.colour = {0.97f, 0.98f, 1.0f, static_cast<float>(0.26 * strength)};
            puffs_.push_back(puff);
            ++made_;
        }
}

void Trails::advance(TrailScene const& scene, double seconds) {
    if (!(seconds > 0.0)) return;
    for (Drift& puff : puffs_) {
        double const share = 1.0 - std::exp(-seconds / 0.8);  // the wind takes it along
        puff.velocityWorld += (scene.air.windWorld - puff.velocityWorld) * share * 0.5;
        puff.positionWorld += puff.velocityWorld * seconds;
        puff.radius += puff.growth * seconds;
        puff.age += seconds;
    }
    std::erase_if(puffs_, [](Drift const& puff) { return puff.age >= puff.life; });
    followWheels(scene, seconds);
    followTips(scene, seconds);
    if (puffs_.size() > kMost)
        puffs_.erase(puffs_.begin(), puffs_.end() - static_cast<std::ptrdiff_t>(kMost));
}

void Trails::addTo(std::vector<render::Puff>& puffs) const {
    for (Drift const& puff : puffs_) {
        auto const left = static_cast<float>(1.0 - puff.age / puff.life);
        glm::vec4 colour = puff.colour;
        colour.w *= left * std::min(1.0f, static_cast<float>(puff.age / 0.03));
        puffs.push_back({.positionWorld = puff.positionWorld,
                         .radius = static_cast<float>(puff.radius),
                         .colour = colour});
    }
}
}  // namespace luftpost::app
