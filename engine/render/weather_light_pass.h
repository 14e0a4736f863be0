// What the weather adds to the light of the picture: shafts of rain and snow, rainbow, cloud bow, glory, halo, sun dogs, lightning.
#pragma once
#include <array>
#include <future>
#include <optional>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/texture.h"
#include "engine/render/cloud_pass.h"
#include "engine/render/frame_context.h"
#include "shaders/shared/falling.glsl.h"

namespace luftpost::render {
/// By layer of `sky`: what falls from it at the camera or, if it rains only there, within a front's reach of it. Pure.
std::array<glsl::LayerFall, weather::kMaxLayers> layerFalls(Snapshot const& snapshot, weather::Weather const& sky);

/// Flashes that shine at the snapshot's moment, the brightest at the camera first, at most kMostStrokes. Pure.
std::vector<glsl::Stroke> strokesNow(Snapshot const& snapshot);

class WeatherLightPass {
public:
    /// Begins to compute the phase functions, some tenths of a second, on a thread of their own; the first draw waits for them.
    explicit WeatherLightPass(gl::ProgramLibrary& programs);

    /// Fills the block; lightning's light is added to that of sky and ground. After the sky has described its own.
    void describe(Snapshot const& snapshot, glsl::FrameBlock& frame);
    /// Over the HDR picture, after the clouds. Nothing without clouds.
    void draw(FrameContext const& context, CloudPass const& clouds);

private:
    /// Shafts, marched for every pixel of a still and for every 16th in flight.
    struct Shafts {
        Shafts(glm::ivec2 const& picture, int block);
        glm::ivec2 picture;
        int block;
        gl::Texture2D light, lit;
    };
    bool adds(FrameContext const& context, CloudScene const& scene) const;
    void takePhases();
    void drawShafts(FrameContext const& context);

    gl::Program const& program_;
    gl::Program const& quietProgram_;  // for when nothing falls or flashes
    gl::Program const& fallingProgram_;
    std::optional<Shafts> shafts_;
    std::future<std::vector<float>> computing_;
    std::optional<gl::Texture2D> phases_;
    gl::Buffer buffer_;
    glsl::FallBlock block_{};
};
}  // namespace luftpost::render
