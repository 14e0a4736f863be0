// A frame of land alone, lit by a plain sun: what the GL tests of the land draw.
#pragma once
#include <cmath>

#include "engine/core/frames.h"
#include "engine/gl/draw.h"
#include "engine/render/terrain_pass.h"
#include "shaders/shared/cloud.glsl.h"
#include "shaders/shared/sky_block.glsl.h"

namespace luftpost::render {
class LandPicture {
public:
    explicit LandPicture(glm::ivec2 const& size) : targets_{size}, buffer_{sizeof(glsl::FrameBlock), "frame"} {
        sky_.clear();
        clouds_.clear();
        snapshot_.seed = 1;
        snapshot_.place.altitude_m = 316.0;
    }

    /// Draws. A still waits for every chunk.
    void look(glm::dvec3 const& position, double azimuth, double elevation, double fov, bool still) {
        aim(position, azimuth, elevation, fov, still);
        draw();
    }
    /// Looks without drawing: chunks are asked for and taken in.
    void aim(glm::dvec3 const& position, double azimuth, double elevation, double fov, bool still) {
        snapshot_.still = still;
        snapshot_.camera.positionWorld = position;
        snapshot_.camera.horizontalFov = fov;
        snapshot_.camera.worldFromCamera =
            glm::angleAxis(-azimuth, glm::dvec3{0.0, 1.0, 0.0}) * glm::angleAxis(elevation, glm::dvec3{1.0, 0.0, 0.0});
        snapshot_.sky.sunDirectionWorld = sun_;
        fillFrame();
        scene_.update(FrameContext{snapshot_, frame_, targets_});
    }
    void draw() {
        FrameContext const context{snapshot_, frame_, targets_};
        targets_.opaque.bind();
        targets_.opaque.clearColour(0, {1.0f, 0.0f, 1.0f, 0.0f});
        targets_.opaque.clearDepth();
        buffer_.update(gl::bytesOf(frame_));
        buffer_.bindUniform(0);
        sky_.bindUniform(9);
        clouds_.bindUniform(glsl::kCloudBlockBinding);
        pass_.draw(context, scene_);
    }

    /// Direction of the light: azimuth and elevation, radians.
    void sun(double azimuth, double elevation) {
        sun_ = {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation)};
    }
    Snapshot& snapshot() { return snapshot_; }
    Targets& targets() { return targets_; }
    LandScene& scene() { return scene_; }
    glsl::FrameBlock const& frame() const { return frame_; }

private:
    void fillFrame() {
        glm::ivec2 const size = targets_.size;
        float const tanX = static_cast<float>(std::tan(0.5 * snapshot_.camera.horizontalFov));
        float const tanY = tanX * static_cast<float>(size.y) / static_cast<float>(size.x), near = 0.2f;
        glm::mat4 clipFromCamera{0.0f};
        clipFromCamera[0][0] = 1.0f / tanX;
        clipFromCamera[1][1] = 1.0f / tanY;
        clipFromCamera[2][3] = -1.0f;
        clipFromCamera[3][2] = near;
        frame_.worldFromCamera = glm::mat4_cast(glm::quat{snapshot_.camera.worldFromCamera});
        frame_.clipFromWorld = clipFromCamera * glm::transpose(frame_.worldFromCamera);
        frame_.worldFromClip = glm::inverse(frame_.clipFromWorld);
        frame_.previousClipFromWorld = frame_.clipFromWorld;
        frame_.viewport = {size.x, size.y, 1.0f / static_cast<float>(size.x), 1.0f / static_cast<float>(size.y)};
        frame_.projection = {tanX, tanY, near, 2.0f * tanX / static_cast<float>(size.x)};
        frame_.mode = glm::ivec4{0};
        frame_.exposure = {1.0f, 1.0f, 0.0f, 0.0f};
        frame_.sunDirection = glm::vec4{glm::vec3{sun_}, 0.0f};
        frame_.sunIrradiance = {0.85f, 0.8f, 0.72f, 1.0f};
        frame_.skyIrradiance = {0.10f, 0.13f, 0.18f, 0.0f};
        frame_.groundIrradiance = {0.05f, 0.05f, 0.04f, 0.0f};
        frame_.weather = {60000.0f, 0.0f, 0.0f, 0.0f};
    }

    glm::dvec3 sun_ = glm::normalize(glm::dvec3{0.5, 0.55, 0.6});
    gl::ProgramLibrary programs_;
    Snapshot snapshot_;
    Targets targets_;
    glsl::FrameBlock frame_{};
    gl::Buffer buffer_;
    gl::Buffer sky_{sizeof(glsl::SkyBlock), "no sky"}, clouds_{sizeof(glsl::CloudBlock), "no clouds"};
    LandScene scene_{2};
    TerrainPass pass_{programs_};
};

}  // namespace luftpost::render
