// A model as plain data: what a glTF file says, checked.
#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include <glm/glm.hpp>
#include <glm/gtc/quaternion.hpp>

#include "engine/assets/image.h"
#include "engine/assets/mesh.h"

namespace luftpost::assets {
/// glTF's metallic-roughness material. Texture numbers count Model::textures, -1: none.
struct Material {
    std::string name;
    glm::vec4 baseColour{1.0f};   // linear
    float metallic = 1.0f;
    float roughness = 1.0f;
    glm::vec3 emissive{0.0f};     // linear
    float normalScale = 1.0f;
    float occlusionStrength = 1.0f;
    float alphaCutoff = 0.5f;
    bool masked = false;          // alpha below the cutoff is a hole
    bool blended = false;         // alpha blends
    bool doubleSided = false;
    int baseColourTexture = -1;          // sRGB
    int metallicRoughnessTexture = -1;   // linear: roughness in G, metallic in B
    int normalTexture = -1;              // linear
    int occlusionTexture = -1;           // linear: R
    int emissiveTexture = -1;            // sRGB
};

struct Primitive {
    Mesh mesh;
    int material = 0;  // of Model::materials
};

/// Local transform: position = translation + rotation * (scale * p).
struct Node {
    std::string name;
    int parent = -1;   // stands before its children in Model::nodes
    glm::vec3 translation{0.0f};
    glm::quat rotation{1.0f, 0.0f, 0.0f, 0.0f};
    glm::vec3 scale{1.0f};
    std::vector<int> primitives;  // of Model::primitives
};

struct Model {
    std::string name;
    std::vector<Node> nodes;
    std::vector<Primitive> primitives;
    std::vector<Material> materials;  // at least one
    std::vector<Image> textures;      // RGBA
};

/// Reads .gltf or .glb (by content). Throws core::Error naming the file, the place in it and what was expected, for
/// anything that is broken or that is not in glTF 2.0's core: no skins, no animation, no extensions are used.
Model readModel(std::filesystem::path const& file);
/// The same from bytes; `folder` is where files that it names would lie.
Model decodeModel(std::string const& bytes, std::string const& name, std::filesystem::path const& folder = {});

/// One node, one mesh, one material.
Model modelOf(Mesh mesh, Material const& material, std::string const& name);
}  // namespace luftpost::assets
