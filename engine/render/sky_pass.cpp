#include "engine/render/sky_pass.h"

#include <algorithm>
#include <cmath>

#include "engine/gl/draw.h"
#include "engine/render/sky_conditions.h"

namespace luftpost::render {
namespace {
constexpr glm::ivec2 kTransmittanceSize{256, 64}, kMultipleSize{32, 32}, kViewSize{192, 108}, kAroundSize{16, 2};
constexpr glm::ivec3 kAerialSize{48, 48, 32};
constexpr glm::ivec2 kGroup{8, 8};
constexpr double kSunSteps = 3.0e-4;        // rad: what the sun moves in four seconds
constexpr double kMoonlightMatters = -0.03;  // sine of the sun's elevation
constexpr float kHeadroom = 0.25f;           // the sun's disc at noon, 15000, fits half floats

bool differs(double a, double b, double relative, double absolute) {
    return std::abs(a - b) > relative * std::max(std::abs(a), std::abs(b)) + absolute;
}

glm::vec4 withRadius(glm::dvec3 const& direction, double radius) {
    return glm::vec4{glm::vec3{direction}, static_cast<float>(radius)};
}
}  // namespace

SkyPass::SkyPass(gl::ProgramLibrary& programs)
    : transmittanceProgram_{programs.compute("sky_transmittance")},
      multipleProgram_{programs.compute("sky_multiple")},
      viewProgram_{programs.compute("sky_view")},
      aerialProgram_{programs.compute("sky_aerial")},
      aroundProgram_{programs.compute("sky_around")},
      transmittance_{gl::Format::rgba32f, kTransmittanceSize, 1, "sky transmittance"},
      multiple_{gl::Format::rgba32f, kMultipleSize, 1, "sky multiple scattering"},
      view_{gl::Format::rgba32f, kViewSize, 1, "sky view"},
      around_{gl::Format::rgba16f, kAroundSize, 1, "sky around"},
      aerial_{gl::Format::rgba32f, kAerialSize, 1, "aerial radiance"},
      aerialThrough_{gl::Format::rgba16f, kAerialSize, 1, "aerial transmittance"},
      buffer_{sizeof(glsl::SkyBlock), "sky block"} {
    // The azimuth wraps; the shaders keep the other coordinates inside.
    view_.setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::repeat);
    aerial_.setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::repeat);
    aerialThrough_.setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::repeat);
}

bool SkyPass::airChanged(sky::AirConditions const& now) const {
    return !tables_ || differs(now.visibility, tablesMadeFor_.visibility, 0.02, 0.0) ||
           differs(now.groundAltitude, tablesMadeFor_.groundAltitude, 0.0, 5.0) ||
           differs(now.fogDepth, tablesMadeFor_.fogDepth, 0.05, 0.0) ||
           differs(now.cloudAlbedo, tablesMadeFor_.cloudAlbedo, 0.0, 0.01) || differs(now.cloudTop, tablesMadeFor_.cloudTop, 0.02, 10.0);
}

bool SkyPass::viewChanged(View const& now) const {
    if (!viewMadeFor_) return true;
    View const& then = *viewMadeFor_;
    return glm::distance(now.state.sunDirectionWorld, then.state.sunDirectionWorld) > kSunSteps ||
           glm::distance(now.state.moonDirectionWorld, then.state.moonDirectionWorld) > 3.0 * kSunSteps ||
           differs(now.altitude, then.altitude, 0.005, 1.0) ||
           differs(now.conditions.cover, then.conditions.cover, 0.0, 0.01) ||
           differs(now.conditions.landCover, then.conditions.landCover, 0.0, 0.01) ||
           differs(now.conditions.closedShare, then.conditions.closedShare, 0.02, 0.0) ||
           differs(now.conditions.cloudBase, then.conditions.cloudBase, 0.01, 5.0);
}

void SkyPass::makeLight(View const& view) {
    light_ = sky::skyLight(view.state, *tables_, view.altitude, view.conditions);
    block_.air = sky::atmosphere(view.conditions);
    block_.air.ground = glm::vec4{light_.groundRadiance, block_.air.ground.w};
    // What air under clouds sends along the level: haze scatters forward, so that it is the light of the sky near the
    // horizon, under a closed sky 3/7 of the mean (CIE's overcast), and of the land.
    glm::vec3 const under = 0.5f * (0.65f * light_.sky / static_cast<float>(core::kPi) + light_.groundRadiance);
    block_.air.under = glm::vec4{under, static_cast<float>(view.conditions.cover)};
    block_.lights.sun = withRadius(view.state.sunDirectionWorld, view.state.sunAngularRadius);
    block_.lights.sunLight = glm::vec4{1.0f};
    block_.lights.moon = withRadius(view.state.moonDirectionWorld, view.state.moonAngularRadius);
    block_.lights.moonLight = glm::vec4{light_.moonAboveAir, 0.0f};
    bool const moonlit = view.state.sunDirectionWorld.y < kMoonlightMatters && view.state.moonDirectionWorld.y > -0.15;
    block_.skyCamera = glm::vec4{static_cast<float>(std::max(view.altitude, 0.0)), moonlit ? 1.0f : 0.0f,
                                  view.state.sunDirectionWorld.y < kMoonlightMatters ? 1.0f : 0.0f, 0.0f};
    block_.airglow = glm::vec4{sky::airglowRadiance(), 0.0f};
    block_.land = glm::vec4{sky::landContrast(light_, view.state, view.conditions), 0.0f, 0.0f};
    block_.celestialFromWorld = glm::mat4{glm::mat3{view.state.celestialFromWorld}};
}

void SkyPass::describe(Snapshot const& snapshot, glsl::FrameBlock& frame) {
    View const view{snapshot.sky, airConditions(snapshot), snapshot.camera.positionWorld.y};
    if (snapshot.still || airChanged(view.conditions)) {
        sky::AirConditions clear = view.conditions;
        clear.cover = clear.landCover = 0.0;
        sky::AirConditions const cloudless{.visibility = clear.visibility, .groundAltitude = clear.groundAltitude, .fogDepth = clear.fogDepth, .groundAlbedo = clear.groundAlbedo};
        if (!tables_ || cloudless != cloudless_) tables_.emplace(sky::atmosphere(cloudless));
        cloudless_ = cloudless;
        tablesMadeFor_ = clear;
        airDirty_ = true;
    }
    if (snapshot.still || airDirty_ || viewChanged(view)) {
        makeLight(view);
        viewMadeFor_ = view;
        viewDirty_ = true;
    }
    float const letThrough = static_cast<float>(sky::directShareUnder(view.conditions.cover));
    frame.sunDirection = block_.lights.sun;
    frame.sunIrradiance = glm::vec4{light_.sun, letThrough};
    frame.moonDirection = block_.lights.moon;
    frame.moonIrradiance = glm::vec4{light_.moon, letThrough};
    frame.skyIrradiance = glm::vec4{light_.sky, 0.0f};
    frame.groundIrradiance = glm::vec4{light_.ground, 0.0f};
    frame.exposure.x = kHeadroom * light_.exposure;
    frame.exposure.w = std::exp2(snapshot.graphics.exposure_ev);
    frame.exposure.y = light_.exposure * frame.exposure.w;
}

void SkyPass::draw(FrameContext const& context) {
    if (context.tile) return bind();
    if (viewDirty_) buffer_.update(gl::bytesOf(block_));
    bind();
    if (airDirty_) {
        transmittanceProgram_.use();
        transmittance_.bindImage(0, gl::Access::write);
        gl::dispatchOver(kTransmittanceSize, kGroup);
        gl::barrier(gl::Barrier::textureFetch);
        multipleProgram_.use();
        multiple_.bindImage(0, gl::Access::write);
        gl::dispatchOver(kMultipleSize, kGroup);
        gl::barrier(gl::Barrier::textureFetch);
    }
    if (viewDirty_) {
        viewProgram_.use();
        view_.bindImage(0, gl::Access::write);
        gl::dispatchOver(kViewSize, kGroup);
        aroundProgram_.use();
        around_.bindImage(0, gl::Access::write);
        gl::dispatch({kAroundSize, 1});
        aerialProgram_.use();
        aerial_.bindImage(0, gl::Access::write);
        aerialThrough_.bindImage(1, gl::Access::write);
        gl::dispatchOver({kAerialSize.x, kAerialSize.y}, kGroup);
        gl::barrier(gl::Barrier::textureFetch);
    }
    airDirty_ = viewDirty_ = false;
}

void SkyPass::bind() const {
    buffer_.bindUniform(static_cast<unsigned>(glsl::kSkyBlockBinding));
    transmittance_.bind(static_cast<unsigned>(glsl::kSkyTransmittanceUnit));
    multiple_.bind(static_cast<unsigned>(glsl::kSkyMultipleUnit));
    view_.bind(static_cast<unsigned>(glsl::kSkyViewUnit));
    around_.bind(static_cast<unsigned>(glsl::kSkyAroundUnit));
    aerial_.bind(static_cast<unsigned>(glsl::kSkyAerialUnit));
    aerialThrough_.bind(static_cast<unsigned>(glsl::kSkyAerialThroughUnit));
}
}  // namespace luftpost::render
