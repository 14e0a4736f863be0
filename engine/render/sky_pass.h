// The sky's tables on the GPU and the light of the frame. Other passes read them through shaders/lib/sky_tables.glsl.
#pragma once
#include <optional>

#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/render/frame_context.h"
#include "engine/sky/light.h"
#include "shaders/shared/sky_block.glsl.h"

namespace luftpost::render {
/// Tables are made again when what they depend on has changed by more than the eye would see: those of the air with its
/// haze, those around the camera with the lights, the cover and the altitude. A still makes all of them.
class SkyPass {
public:
    explicit SkyPass(gl::ProgramLibrary& programs);

    /// Fills the frame block's light, its direction and the exposure's start.
    void describe(Snapshot const& snapshot, glsl::FrameBlock& frame);
    /// Makes what has changed and binds block and tables for all passes of the frame. A tile has the tables of the whole.
    void draw(FrameContext const& context);

    sky::SkyLight const& light() const { return light_; }
    /// Table six (shaders/pass/sky_around.comp): what is above (first row) and below a cloud, by its altitude.
    gl::Texture2D const& around() const { return around_; }
    bool starsShow() const { return block_.skyCamera.z > 0.0f; }

    /// GPU bytes of its tables.
    std::size_t bytes() const { return transmittance_.bytes() + multiple_.bytes() + view_.bytes() + around_.bytes() + aerial_.bytes() + aerialThrough_.bytes(); }

private:
    /// What the tables around the camera were made for.
    struct View {
        sky::SkyState state;
        sky::AirConditions conditions;
        double altitude = 0.0;
    };

    bool airChanged(sky::AirConditions const& conditions) const;
    bool viewChanged(View const& view) const;
    void makeLight(View const& view);
    void bind() const;

    gl::Program const& transmittanceProgram_;
    gl::Program const& multipleProgram_;
    gl::Program const& viewProgram_;
    gl::Program const& aerialProgram_;
    gl::Program const& aroundProgram_;
    gl::Texture2D transmittance_, multiple_, view_, around_;
    gl::Texture3D aerial_, aerialThrough_;
    gl::Buffer buffer_;

    std::optional<sky::AtmosphereTables> tables_;  // of the air without clouds, on the CPU
    sky::AirConditions cloudless_;                 // what those are made for
    sky::AirConditions tablesMadeFor_;             // those of the GPU
    std::optional<View> viewMadeFor_;
    sky::SkyLight light_;
    glsl::SkyBlock block_{};
    bool airDirty_ = true;
    bool viewDirty_ = true;
};
}  // namespace luftpost::render
