// The sky's passes on their own targets, with a camera block as the renderer would fill it.
#pragma once
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/gl/buffer.h"
#include "engine/gl/draw.h"
#include "engine/gl/program_library.h"
#include "engine/render/composite_pass.h"
#include "engine/render/frame_context.h"
#include "engine/render/sky_pass.h"
#include "tests/gl/gl_fixture.h"

namespace luftpost::test {
struct SkyPicture {
    glm::ivec2 size;
    std::vector<float> values;  // RGBA, radiance, row 0 at the bottom
    glm::vec3 at(int x, int y) const {
        auto const* p = &values[4 * static_cast<std::size_t>(y * size.x + x)];
        return {p[0], p[1], p[2]};
    }
};

class SkyRig {
public:
    explicit SkyRig(glm::ivec2 const& size)
        : targets_{size}, skyPass_{programs_}, compositePass_{programs_}, frameBuffer_{sizeof(glsl::FrameBlock)} {}

    /// A cloudless still with sun and moon where they are asked for, nothing drawn before the sky; `distance` > 0: a
    /// white wall of radiance 0 that many metres away covers the lower half.
    SkyPicture draw(render::Snapshot& snapshot, float distance = 0.0f) {
        glsl::FrameBlock frame{};
        glm::vec2 const size{targets_.size};
        float const tangent = static_cast<float>(std::tan(0.5 * snapshot.camera.horizontalFov));
        frame.viewport = glm::vec4{size.x, size.y, 1.0f / size.x, 1.0f / size.y};
        frame.projection = glm::vec4{tangent, tangent * size.y / size.x, 0.2f, 2.0f * tangent / size.x};
        frame.worldFromCamera = glm::mat4_cast(glm::quat{snapshot.camera.worldFromCamera});
        frame.mode = glm::ivec4{static_cast<int>(snapshot.camera.projection), 0, 0, snapshot.still ? 1 : 0};
        snapshot.still = true;
        skyPass_.describe(snapshot, frame);
        frameBuffer_.update(gl::bytesOf(frame));
        frameBuffer_.bindUniform(0);
        render::FrameContext const context{snapshot, frame, targets_};
        skyPass_.draw(context);
        targets_.colour.clear(glm::vec4{0.0f});
        drawWall(distance);
        compositePass_.draw(context, skyPass_.starsShow());
        SkyPicture picture{targets_.size, targets_.colour.readFloats()};
        for (float& value : picture.values) value /= frame.exposure.x;
        return picture;
    }

    render::SkyPass& skyPass() { return skyPass_; }

private:
    void drawWall(float distance) {
        std::vector<float> depth(static_cast<std::size_t>(targets_.size.x * targets_.size.y), 0.0f);
        if (distance > 0.0f)
            for (std::size_t i = 0; i < depth.size() / 2; ++i) depth[i] = 0.2f / distance;
        targets_.depth.upload<float>(depth);
    }

    gl::ProgramLibrary programs_;
    render::Targets targets_;
    render::SkyPass skyPass_;
    render::CompositePass compositePass_;
    gl::Buffer frameBuffer_;
};

/// A camera at `altitude` that looks at azimuth and elevation (degrees) under a sun at azimuth 180 and `sun_deg`.
inline render::Snapshot skySnapshot(double altitude, double azimuth_deg, double elevation_deg, double sun_deg) {
    render::Snapshot snapshot;
    snapshot.camera.positionWorld = {0.0, altitude, 0.0};
    glm::dvec3 const ahead = sky::directionWorld(core::radians(azimuth_deg), core::radians(elevation_deg));
    glm::dvec3 const up{0.0, 1.0, 0.0};
    snapshot.camera.worldFromCamera = glm::conjugate(glm::quat_cast(glm::lookAt(glm::dvec3{0.0}, ahead, up)));
    snapshot.sky.sunDirectionWorld = sky::directionWorld(core::kPi, core::radians(sun_deg));
    snapshot.sky.moonDirectionWorld = sky::directionWorld(1.0, -0.7);
    return snapshot;
}
}  // namespace luftpost::test
