#include "engine/render/model_pass.h"

#include <glm/gtc/matrix_inverse.hpp>
#include <glm/gtc/matrix_transform.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/check.h"
#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr int kShadowSize = 1024;
constexpr double kShadowReach = 9.0;    // m from the aircraft's middle that cast a shadow
constexpr double kShadowDepth = 4000.0; // m along the light that the map's depth covers
constexpr unsigned kShadowUnit = 14;

constexpr std::array<gl::Attribute, 4> kAttributes{{
    {.location = 0, .components = 3, .offset = offsetof(assets::Vertex, position)},
    {.location = 1, .components = 3, .offset = offsetof(assets::Vertex, normal)},
    {.location = 2, .components = 2, .offset = offsetof(assets::Vertex, uv)},
    {.location = 3, .components = 4, .offset = offsetof(assets::Vertex, tangent)},
}};

glm::dmat4 local(assets::Node const& node, NodePose const* pose) {
    glm::dmat4 const rest = glm::translate(glm::dmat4{1.0}, glm::dvec3{node.translation}) *
                            glm::mat4_cast(glm::dquat{node.rotation}) *
                            glm::scale(glm::dmat4{1.0}, glm::dvec3{node.scale});
    if (!pose) return rest;
    return rest * glm::translate(glm::dmat4{1.0}, glm::dvec3{pose->translation}) *
           glm::mat4_cast(glm::dquat{pose->rotation}) * glm::scale(glm::dmat4{1.0}, glm::dvec3{pose->scale});
}

NodePose const* poseOf(ModelInstance const& instance, std::string const& node) {
    auto const found = std::ranges::find(instance.poses, node, &NodePose::node);
    return found == instance.poses.end() ? nullptr : &*found;
}

gl::Texture2D single(glm::u8vec4 const& texel, char const* label) {
    gl::Texture2D texture{gl::Format::rgba8, {1, 1}, 1, label};
    texture.upload<std::uint8_t>(std::array<std::uint8_t, 4>{texel.x, texel.y, texel.z, texel.w});
    return texture;
}

/// Whether a texture holds colour (sRGB) rather than numbers.
bool holdsColour(assets::Model const& model, int texture) {
    return std::ranges::any_of(model.materials, [&](assets::Material const& material) {
        return material.baseColourTexture == texture || material.emissiveTexture == texture;
    });
}

bool isBlended(assets::Material const& material, ModelInstance const& instance) {
    return material.blended || instance.tint.w < 1.0f;
}
}  // namespace

ModelPass::ModelPass(gl::ProgramLibrary& programs)
    : program_{programs.graphics("model")},
      shadowProgram_{programs.graphics(gl::GraphicsStages{"model_shadow", "", ""})},
      normalsProgram_{programs.graphics(gl::GraphicsStages{"model", "normals", "normals"})},
      white_{single({255, 255, 255, 255}, "white")},
      flat_{single({128, 128, 255, 255}, "flat normal")},
      shadowMap_{gl::Format::depth32f, {kShadowSize, kShadowSize}, 1, "model shadow"},
      shadowTarget_{{}, &shadowMap_, "model shadow"},
      repeat_{{.minFilter = gl::Filter::linearMipLinear, .wrap = gl::Wrap::repeat}, "model textures"} {
    shadowMap_.setSampling(gl::Filter::nearest, gl::Filter::nearest, gl::Wrap::clampToEdge);
}

ModelId ModelPass::add(assets::Model const& model) {
    Held held;
    held.nodes = model.nodes;
    held.materials = model.materials;
    for (std::size_t i = 0; i < model.textures.size(); ++i) {
        assets::Image const& image = model.textures[i];
        gl::Format const format = holdsColour(model, static_cast<int>(i)) ? gl::Format::srgba8 : gl::Format::rgba8;
        glm::ivec2 const size{image.width, image.height};
        held.textures.emplace_back(format, size, gl::fullLevels({size, 1}), model.name);
        held.textures.back().upload<std::uint8_t>(image.values);
        held.textures.back().generateMipmaps();
    }
    for (assets::Primitive const& primitive : model.primitives) {
        Part part{gl::Buffer{gl::bytesOfRange(primitive.mesh.vertices), model.name},
                  gl::Buffer{gl::bytesOfRange(primitive.mesh.indices), model.name},
                  {},
                  static_cast<int>(primitive.mesh.indices.size()),
                  primitive.material};
        part.array = gl::VertexArray({{&part.vertices, sizeof(assets::Vertex), kAttributes}}, &part.indices,
                                     gl::IndexType::uint32, model.name);
        held.parts.push_back(std::move(part));
    }
    models_.push_back(std::move(held));
    return static_cast<ModelId>(models_.size() - 1);
}

void ModelPass::place(Snapshot const& snapshot, std::size_t number) {
    ModelInstance const& instance = snapshot.models[number];
    if (instance.model == ModelId::none) return;
    auto const model = static_cast<std::size_t>(instance.model);
    CHECK(model < models_.size(), "model {} of {}", model, models_.size());
    std::vector<assets::Node> const& nodes = models_[model].nodes;
    glm::dvec3 const camera = snapshot.camera.positionWorld;
    glm::dmat4 const root = glm::translate(glm::dmat4{1.0}, instance.positionWorld) *
                            glm::mat4_cast(instance.worldFromModel) *
                            glm::scale(glm::dmat4{1.0}, glm::dvec3{instance.scale});
    std::vector<glm::dmat4> world(nodes.size());
    for (std::size_t i = 0; i < nodes.size(); ++i) {
        glm::dmat4 const& parent = nodes[i].parent < 0 ? root : world[static_cast<std::size_t>(nodes[i].parent)];
        world[i] = parent * local(nodes[i], poseOf(instance, nodes[i].name));
        if (nodes[i].primitives.empty() || std::abs(glm::determinant(glm::dmat3{world[i]})) < 1e-12) continue;
        auto const known = previous_.find({number, i});
        glm::dmat4 before = known == previous_.end() ? world[i] : known->second;
        glm::dmat4 now = world[i];
        now[3] -= glm::dvec4{camera, 0.0};
        before[3] -= glm::dvec4{camera, 0.0};
        placed_.push_back({model, i, number, glm::mat4{now}, glm::mat4{before}});
        previous_[{number, i}] = world[i];
    }
}

void ModelPass::describe(Snapshot const& snapshot, glsl::FrameBlock& frame) {
    placed_.clear();
    if (snapshot.still) previous_.clear();
    for (std::size_t i = 0; i < snapshot.models.size(); ++i) place(snapshot, i);
    bool const sun = frame.sunIrradiance.y >= frame.moonIrradiance.y;
    glm::vec4 const light = sun ? frame.sunDirection : frame.moonDirection;
    auto const casts = [](ModelInstance const& instance) { return instance.castsShadow; };
    hasShadow_ = snapshot.hasAircraft && light.y > 0.01f && std::ranges::any_of(snapshot.models, casts);
    frame.modelShadow = glm::vec4{hasShadow_ ? 1.0f : 0.0f, 2.0f * static_cast<float>(kShadowReach),
                                  static_cast<float>(kShadowDepth), light.w};
    if (!hasShadow_) return;
    // A frame at the aircraft that looks along the light: x and y across it, z toward it.
    glm::dvec3 const toward = glm::normalize(glm::dvec3{light});
    glm::dvec3 const across = glm::normalize(glm::cross(std::abs(toward.y) < 0.99 ? glm::dvec3{0, 1, 0} : glm::dvec3{1, 0, 0}, toward));
    glm::dmat4 lightFromWorld = glm::transpose(glm::dmat4{glm::dmat3{across, glm::cross(toward, across), toward}});
    lightFromWorld = lightFromWorld * glm::translate(glm::dmat4{1.0}, snapshot.camera.positionWorld - snapshot.aircraftWorld);
    glm::dmat4 const unitFromLight =
        glm::translate(glm::dmat4{1.0}, glm::dvec3{0.5}) *
        glm::scale(glm::dmat4{1.0}, {0.5 / kShadowReach, 0.5 / kShadowReach, 1.0 / kShadowDepth});
    frame.modelShadowFromWorld = glm::mat4{unitFromLight * lightFromWorld};
    glm::dmat4 const clipFromUnit = glm::translate(glm::dmat4{1.0}, {-1.0, -1.0, 0.0}) * glm::scale(glm::dmat4{1.0}, {2.0, 2.0, 1.0});
    shadowClipFromWorld_ = glm::mat4{clipFromUnit * unitFromLight * lightFromWorld};
}

void ModelPass::drawShadow(FrameContext const& context) {
    shadowMap_.bind(kShadowUnit);
    if (!hasShadow_) return;
    shadowTarget_.clearDepth();
    shadowTarget_.bind();
    gl::DrawState state = gl::opaqueState();
    state.cull = gl::Cull::none;
    state.colourWrite = false;
    gl::apply(state);
    shadowProgram_.use();
    for (Placed const& placed : placed_) {
        ModelInstance const& instance = context.snapshot.models[placed.instance];
        if (!instance.castsShadow) continue;
        Held const& held = models_[placed.model];
        shadowProgram_.set("clipFromNode", shadowClipFromWorld_ * placed.worldFromNode);
        for (int number : held.nodes[placed.node].primitives) {
            Part const& part = held.parts[static_cast<std::size_t>(number)];
            if (isBlended(held.materials[static_cast<std::size_t>(part.material)], instance)) continue;
            gl::drawElements(part.array, gl::Primitive::triangles, part.count);
        }
    }
}

void ModelPass::bindTexture(Held const& held, unsigned unit, int number, gl::Texture2D const& otherwise) {
    (number < 0 ? otherwise : held.textures[static_cast<std::size_t>(number)]).bind(unit);
    repeat_.bind(unit);
}

void ModelPass::bindMaterial(Held const& held, assets::Material const& material, ModelInstance const& instance) {
    bindTexture(held, 0, material.baseColourTexture, white_);
    bindTexture(held, 1, material.metallicRoughnessTexture, white_);
    bindTexture(held, 2, material.normalTexture, flat_);
    bindTexture(held, 3, material.occlusionTexture, white_);
    bindTexture(held, 4, material.emissiveTexture, white_);
    program_.set("baseColour", material.baseColour * instance.tint);
    program_.set("factors", glm::vec4{material.metallic, material.roughness, material.normalScale,
                                      material.occlusionTexture < 0 ? 0.0f : material.occlusionStrength});
    program_.set("emissive", material.emissive + glm::vec3{instance.tint} * instance.emission);
    program_.set("alphaCutoff", material.masked ? material.alphaCutoff : 0.0f);
}

void ModelPass::drawPart(FrameContext const& context, Placed const& placed, Part const& part, bool blended) {
    ModelInstance const& instance = context.snapshot.models[placed.instance];
    Held const& held = models_[placed.model];
    assets::Material const& material = held.materials[static_cast<std::size_t>(part.material)];
    if (isBlended(material, instance) != blended) return;
    gl::DrawState state = gl::opaqueState();
    state.wireframe = context.snapshot.debug.wireframe;
    if (material.doubleSided || blended) state.cull = gl::Cull::none;
    if (blended) state.blend = gl::Blend::alpha;
    if (blended) state.depthWrite = false;
    gl::apply(state);
    bindMaterial(held, material, instance);
    gl::drawElements(part.array, gl::Primitive::triangles, part.count);
}

void ModelPass::draw(FrameContext const& context, bool blended) {
    program_.use();
    for (Placed const& placed : placed_) {
        program_.set("worldFromNode", placed.worldFromNode);
        program_.set("previousWorldFromNode", placed.previousWorldFromNode);
        program_.set("normalFromNode", glm::inverseTranspose(glm::mat3{placed.worldFromNode}));
        Held const& held = models_[placed.model];
        for (int number : held.nodes[placed.node].primitives)
            drawPart(context, placed, held.parts[static_cast<std::size_t>(number)], blended);
    }
    for (unsigned unit = 0; unit < 5; ++unit) gl::Sampler::unbind(unit);
}

void ModelPass::drawOpaque(FrameContext const& context) {
    context.targets.opaque.bind();
    draw(context, false);
}

void ModelPass::drawBlended(FrameContext const& context) {
    std::ranges::stable_sort(placed_, std::ranges::greater{}, [&](Placed const& placed) {
        return glm::length(context.snapshot.models[placed.instance].positionWorld - context.snapshot.camera.positionWorld);
    });
    context.targets.blended.bind();
    draw(context, true);
}

void ModelPass::drawNormals(FrameContext const& context) {
    context.targets.blended.bind();
    gl::DrawState state = gl::opaqueState();
    state.depthWrite = false;
    state.cull = gl::Cull::none;
    gl::apply(state);
    normalsProgram_.use();
    for (Placed const& placed : placed_) {
        normalsProgram_.set("worldFromNode", placed.worldFromNode);
        normalsProgram_.set("previousWorldFromNode", placed.previousWorldFromNode);
        normalsProgram_.set("normalFromNode", glm::inverseTranspose(glm::mat3{placed.worldFromNode}));
        Held const& held = models_[placed.model];
        for (int number : held.nodes[placed.node].primitives) {
            Part const& part = held.parts[static_cast<std::size_t>(number)];
            gl::drawElements(part.array, gl::Primitive::triangles, part.count);
        }
    }
}
}  // namespace luftpost::render
