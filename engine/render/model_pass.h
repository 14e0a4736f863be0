// Models: the aircraft, parcels, buildings, markers; their shadow; their debug views.
#pragma once
#include <map>
#include <string>
#include <vector>

#include "engine/assets/model.h"
#include "engine/gl/program_library.h"
#include "engine/gl/sampler.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/frame_context.h"

namespace luftpost::render {
class ModelPass {
public:
    /// Throws core::Error when its shaders do not load.
    explicit ModelPass(gl::ProgramLibrary& programs);

    ModelId add(assets::Model const& model);

    /// Places the frame's instances and fills the frame block's model shadow. Call after the sky has filled the light.
    void describe(Snapshot const& snapshot, glsl::FrameBlock& frame);
    /// The map that lib/model_shadow.glsl reads.
    void drawShadow(FrameContext const& context);
    /// What hides what is behind it, into Targets::opaque.
    void drawOpaque(FrameContext const& context);
    /// Glass, propeller disc, markers with alpha below 1, into Targets::blended, farthest instance first.
    void drawBlended(FrameContext const& context);
    /// The normals' lines (F2).
    void drawNormals(FrameContext const& context);

private:
    struct Part {
        gl::Buffer vertices, indices;
        gl::VertexArray array;
        int count = 0;
        int material = 0;
    };
    struct Held {
        std::vector<assets::Node> nodes;
        std::vector<assets::Material> materials;
        std::vector<Part> parts;
        std::vector<gl::Texture2D> textures;
    };
    /// One node of one instance, ready to draw.
    struct Placed {
        std::size_t model, node, instance;
        glm::mat4 worldFromNode;          // relative to the camera
        glm::mat4 previousWorldFromNode;  // relative to this frame's camera
    };

    void place(Snapshot const& snapshot, std::size_t instance);
    void draw(FrameContext const& context, bool blended);
    void drawPart(FrameContext const& context, Placed const& placed, Part const& part, bool blended);
    void bindMaterial(Held const& held, assets::Material const& material, ModelInstance const& instance);
    void bindTexture(Held const& held, unsigned unit, int number, gl::Texture2D const& otherwise);

    gl::Program const& program_;
    gl::Program const& shadowProgram_;
    gl::Program const& normalsProgram_;
    gl::Texture2D white_, flat_;
    gl::Texture2D shadowMap_;
    gl::Framebuffer shadowTarget_;
    gl::Sampler repeat_;
    std::vector<Held> models_;
    std::vector<Placed> placed_;
    std::map<std::pair<std::size_t, std::size_t>, glm::dmat4> previous_;  // instance, node -> world, last frame
    glm::mat4 shadowClipFromWorld_{1.0f};
    bool hasShadow_ = false;
};
}  // namespace luftpost::render
