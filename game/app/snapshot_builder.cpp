#include "game/app/snapshot_builder.h"

#include "engine/render/quality.h"
#include "game/app/instruments.h"
#include "game/app/panel.h"

#include <algorithm>
#include <cmath>
#include <glm/gtx/quaternion.hpp>

#include "engine/sky/sky_state.h"

namespace luftpost::app {
namespace {
constexpr double kDiscFromRpm = 500.0;  // above, the eye sees a disc and no blades
constexpr glm::vec3 kCabin{1.02f, 0.9f, 0.75f};  // m from the eye: the models' forepart, to the firewall
constexpr double kStandUp = 0.37;       // m from a parcel's middle to its foot

glm::quat about(glm::vec3 const& axis, double angle) {
    return glm::angleAxis(static_cast<float>(angle), axis);
}
constexpr glm::vec3 kX{1.0f, 0.0f, 0.0f}, kY{0.0f, 1.0f, 0.0f}, kZ{0.0f, 0.0f, 1.0f};

render::NodePose turned(char const* node, glm::quat const& rotation) {
    return {.node = node, .rotation = rotation};
}
render::NodePose shown(char const* node, bool visible) {
    return {.node = node, .scale = glm::vec3{visible ? 1.0f : 0.0f}};
}

/// Trailing edge down is positive about z; a positive elevator command lifts the nose: trailing edge up.
double elevatorAngle(flight::Airframe const& airframe, double command) {
    return -command * (command > 0.0 ? airframe.elevatorUp : airframe.elevatorDown);
}
/// Of the right aileron: a positive command rolls right, so its trailing edge goes up.
double aileronAngle(flight::Airframe const& airframe, double command) {
    return -command * (command > 0.0 ? airframe.aileronUp : airframe.aileronDown);
}

std::vector<render::NodePose> planePoses(flight::Airframe const& airframe, flight::AircraftState const& state,
                                         flight::AircraftPose const& pose, bool inside) {
    double const rpm = state.propellerRate * 60.0 / (2.0 * core::kPi);
    bool const disc = rpm > kDiscFromRpm;
    double const flaps = pose.flaps * airframe.flapTravel;
    std::vector<render::NodePose> poses{
        turned("elevator", about(kZ, elevatorAngle(airframe, pose.elevator))),
        turned("rudder", about(kY, pose.rudder * airframe.rudder)),
        turned("aileron_right", about(kZ, aileronAngle(airframe, pose.aileron))),
        turned("aileron_left", about(kZ, aileronAngle(airframe, -pose.aileron))),
        turned("flap_right", about(kZ, flaps)),
        turned("flap_left", about(kZ, flaps)),
        turned("yoke_left", about(kX, pose.aileron * 1.0)),
        turned("yoke_right", about(kX, pose.aileron * 1.0))};
    render::NodePose blades = shown("propeller", !disc);
    blades.rotation = about(kX, pose.propellerAngle);
    poses.push_back(blades);
    render::NodePose blur = shown("propeller_disc", disc);
    blur.rotation = blades.rotation;
    poses.push_back(blur);
    if (inside)
        for (char const* node : {"exterior_fuselage", "pilot"}) poses.push_back(shown(node, false));
    return poses;
}

/// Moves the wheels up with their legs; names in the airframe's order (nose first or not, by what they are
/// called).
void addWheels(flight::Airframe const& airframe, flight::AircraftState const& state,
               flight::AircraftPose const& pose, std::vector<render::NodePose>& poses) {
    for (std::size_t i = 0; i < airframe.wheels.size(); ++i) {
        flight::WheelData const& wheel = airframe.wheels[i];
        if (wheel.skid) continue;
        double const z = wheel.position.z;
        char const* const node = std::abs(z) < 0.1 ? "wheel_nose" : z > 0.0 ? "wheel_right" : "wheel_left";
        poses.push_back({.node = node,
                         .rotation = about(kZ, -state.wheels[i].angle),
                         .translation = glm::vec3{0.0f, static_cast<float>(pose.compression[i]), 0.0f}});
    }
}

render::ModelInstance planeInstance(Simulation const& simulation, GameModels const& models,
                                    FrameView const& view) {
    flight::Airframe const& airframe = simulation.aircraft().airframe();
    flight::AircraftState const& state = simulation.aircraft().state();
    flight::AircraftPose const pose = shownPose(simulation, view.share);
    render::ModelInstance plane;
    plane.model = models.planes[static_cast<std::size_t>(simulation.airframeChoice())];
    plane.positionWorld = pose.positionWorld;
    plane.worldFromModel = pose.worldFromBody;
    plane.castsShadow = true;
    plane.poses = planePoses(airframe, state, pose, view.inside);
    addWheels(airframe, state, pose, plane.poses);
    std::vector<render::NodePose> const panel = panelPoses(instruments(simulation));
    plane.poses.insert(plane.poses.end(), panel.begin(), panel.end());
    return plane;
}

render::ModelInstance standing(render::ModelId model, glm::dvec3 const& positionWorld, double yaw = 0.0) {
    render::ModelInstance instance;
    instance.model = model;
    instance.positionWorld = positionWorld;
    instance.worldFromModel = glm::angleAxis(yaw, glm::dvec3{0.0, 1.0, 0.0});
    instance.castsShadow = true;
    return instance;
}

/// The turn about y that leads +x along the vector.
double yawAlong(glm::dvec3 const& world) { return std::atan2(-world.z, world.x); }

void addParcels(Simulation const& simulation, GameModels const& models, FrameView const& view,
                std::vector<render::ModelInstance>& instances) {
    for (glm::dvec3 const& place : simulation.delivery().landed())
        instances.push_back(standing(models.parcel, place + glm::dvec3{0.0, kStandUp, 0.0}));
    auto const parcel = shownParcel(simulation, view.share);
    if (!parcel) return;
    glm::dvec3 const air = simulation.airAt(view.utc).at(parcel->positionWorld).windWorld;
    glm::dvec3 const drag = air - parcel->velocityWorld;
    // The chute hangs where the air pulls it: up and back along the way through the air.
    glm::dvec3 const pull = glm::normalize(drag + glm::dvec3{0.0, 0.5, 0.0});
    glm::dquat const upright = glm::rotation(glm::dvec3{0.0, 1.0, 0.0}, pull);
    render::ModelInstance box = standing(models.parcel, parcel->positionWorld);
    box.worldFromModel = upright;
    instances.push_back(box);
    if (parcel->chute <= 0.0) return;
    render::ModelInstance canopy = standing(models.parachute, parcel->positionWorld + pull * 0.45);
    canopy.worldFromModel = upright;
    auto const open = static_cast<float>(0.15 + 0.85 * parcel->chute);
    canopy.scale = {open, 0.6f + 0.4f * open, open};
    instances.push_back(canopy);
}

void addAirfield(Simulation const& simulation, GameModels const& models, core::UtcSeconds utc,
                 std::vector<render::ModelInstance>& instances) {
    World const& world = simulation.world();
    terrain::Runway const& runway = world.land().runway();
    glm::dvec2 const along = runway.directionEastNorth, across{along.y, -along.x};
    auto const beside = [&](double forward, double right) {
        glm::dvec2 const at = along * forward + across * right;
        return core::worldFromEastNorth(at.x, at.y, world.ground()(at.x, at.y).height);
    };
    glm::dvec3 const foot = beside(-250.0, 45.0);
    glm::dvec3 const wind = simulation.airAt(utc).at(foot + glm::dvec3{0.0, 6.0, 0.0}).windWorld;
    render::ModelInstance sock = standing(models.windsock, foot);
    double const speed = std::hypot(wind.x, wind.z);
    sock.poses = {turned("sock", about(kY, yawAlong(wind))),
                  turned("sock_droop", about(kZ, -1.3 * (1.0 - std::min(speed / 8.0, 1.0))))};
    instances.push_back(sock);
    // The door (toward +z) faces the runway.
    instances.push_back(standing(models.hangar, beside(-330.0, 75.0),
                                 yawAlong(core::worldFromEastNorth(along.x, along.y, 0.0))));
}

/// The marker, and smoke that rises from it and goes with the wind of its height: a function of the time
/// alone.
void addDropZone(Simulation const& simulation, GameModels const& models, core::UtcSeconds utc,
                 render::Snapshot& snapshot) {
    delivery::DropZone const& zone = simulation.delivery().target();
    glm::dvec3 const foot = core::worldFromEastNorth(zone.east, zone.north, zone.height);
    weather::AirInstant const air = simulation.airAt(utc);
    glm::dvec3 const low = air.at(foot + glm::dvec3{0.0, 5.0, 0.0}).windWorld;
    glm::dvec3 const high = air.at(foot + glm::dvec3{0.0, 60.0, 0.0}).windWorld;
    render::ModelInstance marker = standing(models.dropZone, foot);
    marker.poses = {turned("pennant", about(kY, yawAlong(low)))};
    snapshot.models.push_back(marker);
    constexpr int kPuffs = 30;
    constexpr double kLife = 24.0, kRise = 2.2;  // s, m/s
    for (int i = 0; i < kPuffs; ++i) {
        double const age = std::fmod(simulation.seconds() + i * kLife / kPuffs, kLife);
        double const share = age / kLife;
        // Between the wind at the foot and the one above, by how far it has risen.
        glm::dvec3 const drift = low * (age - 0.5 * age * share) + high * (0.5 * age * share);
        glm::dvec3 const curl{std::sin(i * 2.4 + age * 0.5), 0.0, std::cos(i * 1.7 + age * 0.4)};
        auto const opacity = static_cast<float>(0.75 * (1.0 - share) * std::min(age * 0.8, 1.0));
        snapshot.puffs.push_back({.positionWorld = foot + glm::dvec3{drift.x, 2.0 + kRise * age, drift.z} +
                                                   curl * (0.4 + 3.0 * share),
                                  .radius = static_cast<float>(1.4 + 9.0 * share),
                                  .colour = {0.92f, 0.30f, 0.07f, opacity}});
    }
}
}  // namespace

GameModels::GameModels(render::Renderer& renderer)
    : planes{renderer.loadModel(kAirframeModels[0]), renderer.loadModel(kAirframeModels[1])},
      parcel{renderer.loadModel("parcel")},
      parachute{renderer.loadModel("parachute")},
      windsock{renderer.loadModel("windsock")},
      hangar{renderer.loadModel("hangar")},
      dropZone{renderer.loadModel("drop_zone")} {}

flight::AircraftPose shownPose(Simulation const& simulation, double share) {
    return flight::interpolatedPose(simulation.aircraft().airframe(), simulation.before(),
                                    simulation.aircraft().state(), share);
}

ui::CameraSubject cameraSubject(Simulation const& simulation, flight::AircraftPose const& pose) {
    flight::AircraftState const& state = simulation.aircraft().state();
    return {pose.positionWorld, pose.worldFromBody, state.velocityWorld, state.readings.loadFactor};
}

std::optional<delivery::Parcel> shownParcel(Simulation const& simulation, double share) {
    auto const& now = simulation.delivery().parcel();
    if (!now) return std::nullopt;
    delivery::Parcel parcel = *now;
    parcel.positionWorld =
        glm::mix(simulation.delivery().parcelBefore().positionWorld, now->positionWorld, share);
    return parcel;
}

render::Snapshot snapshotOf(Simulation const& simulation, GameModels const& models, Settings const& settings,
                            FrameView const& view) {
    World const& world = simulation.world();
    render::Snapshot snapshot;
    snapshot.camera.positionWorld = view.camera.positionWorld;
    snapshot.camera.worldFromCamera = view.camera.worldFromCamera;
    snapshot.camera.horizontalFov = view.camera.horizontalFov;
    snapshot.graphics = settings.graphics;
    snapshot.clouds = simulation.settings().clouds;
    render::applyQuality(settings.graphics.quality, snapshot.graphics, snapshot.clouds);
    snapshot.time = view.utc;
    snapshot.simulationSeconds = simulation.seconds();
    snapshot.frameSeconds = view.seconds;
    snapshot.eyeSeconds = view.eyeSeconds;
    snapshot.seed = world.land().seed();
    snapshot.place = world.place();
    snapshot.sky = sky::skyState(world.place(), view.utc);
    snapshot.field = &world.field();
    glm::dvec3 const& eye = view.camera.positionWorld;
    snapshot.weather = world.field().at(eye.x, -eye.z, view.utc);
    snapshot.air = simulation.airAt(view.utc).at(eye);
    snapshot.models.push_back(planeInstance(simulation, models, view));
    snapshot.aircraftWorld = snapshot.models.front().positionWorld;
    snapshot.hasAircraft = true;
    if (view.inside)
        snapshot.windscreen = render::Windscreen{snapshot.models.front().worldFromModel,
                                                 simulation.aircraft().state().readings.cas, kCabin};
    addParcels(simulation, models, view, snapshot.models);
    addAirfield(simulation, models, view.utc, snapshot.models);
    addDropZone(simulation, models, view.utc, snapshot);
    return snapshot;
}
}  // namespace luftpost::app
