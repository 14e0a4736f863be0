#include "engine/assets/model.h"

#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtx/matrix_decompose.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include "engine/assets/gltf_reader.h"
#include "engine/core/file.h"

namespace luftpost::assets {
namespace {
/// Keeps an image's encoded bytes; they are decoded once every index is known to be good. Images in buffer views are
/// not touched here: tinygltf has not checked their offsets.
bool keepBytes(tinygltf::Image* image, int, std::string*, std::string*, int, int, unsigned char const* bytes, int size,
               void*) {
    if (image->bufferView == -1 && size > 0) image->image.assign(bytes, bytes + size);
    return true;
}

void parse(tinygltf::Model& file, std::string bytes, std::string const& name, std::filesystem::path const& folder) {
    if (bytes.size() > std::numeric_limits<unsigned>::max() / 2) throw core::Error{name, "", "expected less than 2 GB"};
    auto const length = static_cast<unsigned>(bytes.size());
    bytes.append(16, '\0');  // tinygltf checks a broken chunk's length without the chunk's own header
    tinygltf::TinyGLTF loader;
    loader.SetImageLoader(keepBytes, nullptr);
    std::string error, warning;
    bool good = false;
    try {
        good = bytes.starts_with("glTF")
                   ? loader.LoadBinaryFromMemory(&file, &error, &warning,
                                                 reinterpret_cast<unsigned char const*>(bytes.data()), length,
                                                 folder.string())
                   : loader.LoadASCIIFromString(&file, &error, &warning, bytes.data(), length, folder.string());
    } catch (std::exception const& thrown) {
        error = thrown.what();
    }
    std::replace(error.begin(), error.end(), '\n', ' ');
    if (!good) throw core::Error{name, "", "expected a glTF 2.0 file: " + (error.empty() ? warning : error)};
    for (std::string const& extension : file.extensionsRequired)
        throw core::Error{name, "extensionsRequired", "expected none, found " + extension};
}

Image texture(GltfReader const& reader, int index) {
    std::string const place = fmt::format("textures[{}]", index);
    tinygltf::Texture const& texture = reader.item(reader.file().textures, index, place);
    tinygltf::Image const& image = reader.item(reader.file().images, texture.source, place + ".source");
    std::string const imagePlace = fmt::format("{}: images[{}]", reader.name(), texture.source);
    std::string bytes{image.image.begin(), image.image.end()};
    if (image.bufferView != -1) {
        auto const view = reader.view(image.bufferView, fmt::format("images[{}]", texture.source));
        bytes.assign(view.begin(), view.end());
    }
    if (bytes.empty()) reader.fail(fmt::format("images[{}]", texture.source), "expected the image " + image.uri);
    bool const jpeg = bytes.size() > 1 && bytes[0] == '\xff' && bytes[1] == '\xd8';
    return decodeImage(bytes, imagePlace + (jpeg ? ".jpg" : ".png"));
}

float number(GltfReader const& reader, double value, double low, double high, std::string const& place) {
    if (!(value >= low && value <= high))
        reader.fail(place, fmt::format("expected {}..{}, found {}", low, high, value));
    return static_cast<float>(value);
}

glm::vec4 colour(GltfReader const& reader, std::vector<double> const& values, std::size_t count,
                 std::string const& place) {
    if (values.size() != count) reader.fail(place, fmt::format("expected {} numbers, found {}", count, values.size()));
    glm::vec4 result{1.0f};
    for (std::size_t i = 0; i < count; ++i)
        result[static_cast<glm::length_t>(i)] = number(reader, values[i], 0.0, 1.0, place);
    return result;
}

int textureNumber(GltfReader const& reader, int index, int uvSet, std::string const& place) {
    if (index == -1) return -1;
    reader.item(reader.file().textures, index, place);
    if (uvSet != 0) reader.fail(place + ".texCoord", fmt::format("expected 0, found {}", uvSet));
    return index;
}

Material material(GltfReader const& reader, tinygltf::Material const& from, std::string const& place) {
    auto const& pbr = from.pbrMetallicRoughness;
    Material to;
    to.name = from.name;
    to.baseColour = colour(reader, pbr.baseColorFactor, 4, place + ".baseColorFactor");
    to.emissive = glm::vec3{colour(reader, from.emissiveFactor, 3, place + ".emissiveFactor")};
    to.metallic = number(reader, pbr.metallicFactor, 0.0, 1.0, place + ".metallicFactor");
    to.roughness = number(reader, pbr.roughnessFactor, 0.0, 1.0, place + ".roughnessFactor");
    to.normalScale = number(reader, from.normalTexture.scale, -16.0, 16.0, place + ".normalTexture.scale");
    to.occlusionStrength = number(reader, from.occlusionTexture.strength, 0.0, 1.0, place + ".occlusionTexture.strength");
    to.alphaCutoff = number(reader, from.alphaCutoff, 0.0, 1.0, place + ".alphaCutoff");
    to.masked = from.alphaMode == "MASK";
    to.blended = from.alphaMode == "BLEND";
    to.doubleSided = from.doubleSided;
    auto const texture = [&](auto const& info, char const* key) {
        return textureNumber(reader, info.index, info.texCoord, place + "." + key);
    };
    to.baseColourTexture = texture(pbr.baseColorTexture, "baseColorTexture");
    to.metallicRoughnessTexture = texture(pbr.metallicRoughnessTexture, "metallicRoughnessTexture");
    to.normalTexture = texture(from.normalTexture, "normalTexture");
    to.occlusionTexture = texture(from.occlusionTexture, "occlusionTexture");
    to.emissiveTexture = texture(from.emissiveTexture, "emissiveTexture");
    return to;
}

/// Flat normals where the file has none.
void makeNormals(Mesh& mesh) {
    Mesh flat;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        Vertex corners[3];
        for (std::size_t k = 0; k < 3; ++k) corners[k] = mesh.vertices[mesh.indices[i + k]];
        glm::vec3 const normal = glm::cross(corners[1].position - corners[0].position,
                                            corners[2].position - corners[0].position);
        float const length = glm::length(normal);
        for (Vertex& corner : corners) {
            corner.normal = length > 0.0f ? normal / length : glm::vec3{0.0f, 1.0f, 0.0f};
            flat.indices.push_back(static_cast<std::uint32_t>(flat.vertices.size()));
            flat.vertices.push_back(corner);
        }
    }
    mesh = std::move(flat);
}

/// Tangents along growing u, averaged over the triangles of each vertex, where the file has none.
void makeTangents(Mesh& mesh) {
    std::vector<glm::vec3> alongU(mesh.vertices.size(), glm::vec3{0.0f}), alongV = alongU;
    for (std::size_t i = 0; i + 2 < mesh.indices.size(); i += 3) {
        std::uint32_t const* corner = &mesh.indices[i];
        Vertex const& a = mesh.vertices[corner[0]];
        Vertex const& b = mesh.vertices[corner[1]];
        Vertex const& c = mesh.vertices[corner[2]];
        glm::vec2 const u1 = b.uv - a.uv, u2 = c.uv - a.uv;
        float const area = u1.x * u2.y - u1.y * u2.x;
        if (std::abs(area) < 1e-12f) continue;
        glm::vec3 const p1 = b.position - a.position, p2 = c.position - a.position;
        for (int k = 0; k < 3; ++k) {
            alongU[corner[k]] += (p1 * u2.y - p2 * u1.y) / area;
            alongV[corner[k]] += (p2 * u1.x - p1 * u2.x) / area;
        }
    }
    for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
        Vertex& vertex = mesh.vertices[i];
        glm::vec3 tangent = alongU[i] - vertex.normal * glm::dot(vertex.normal, alongU[i]);
        if (glm::length(tangent) < 1e-12f)
            tangent = glm::cross(vertex.normal, std::abs(vertex.normal.y) < 0.9f ? glm::vec3{0.0f, 1.0f, 0.0f}
                                                                                 : glm::vec3{1.0f, 0.0f, 0.0f});
        bool const mirrored = glm::dot(glm::cross(vertex.normal, tangent), alongV[i]) < 0.0f;
        vertex.tangent = glm::vec4{glm::normalize(tangent), mirrored ? -1.0f : 1.0f};
    }
}

/// The values of an attribute, one element a vertex; empty when the file has none.
std::vector<float> attribute(GltfReader const& reader, tinygltf::Primitive const& from, char const* name, int components,
                             std::size_t vertices, std::string const& place) {
    auto const found = from.attributes.find(name);
    if (found == from.attributes.end()) return {};
    std::string const here = place + "." + name;
    std::vector<float> values = reader.floats(found->second, components, here);
    if (vertices && values.size() != vertices * static_cast<std::size_t>(components))
        reader.fail(here, fmt::format("expected {} elements as POSITION has", vertices));
    return values;
}

glm::vec3 unitOr(glm::vec3 const& v, glm::vec3 const& otherwise) {
    float const length = glm::length(v);
    return length > 1e-12f && std::isfinite(length) ? v / length : otherwise;
}

Mesh mesh(GltfReader const& reader, tinygltf::Primitive const& from, std::string const& place) {
    if (from.mode != TINYGLTF_MODE_TRIANGLES && from.mode != -1)
        reader.fail(place + ".mode", fmt::format("expected 4 (triangles), found {}", from.mode));
    std::vector<float> const positions = attribute(reader, from, "POSITION", 3, 0, place);
    if (positions.empty()) reader.fail(place, "expected a POSITION");
    std::size_t const count = positions.size() / 3;
    std::vector<float> const normals = attribute(reader, from, "NORMAL", 3, count, place);
    std::vector<float> const uvs = attribute(reader, from, "TEXCOORD_0", 2, count, place);
    std::vector<float> const tangents = attribute(reader, from, "TANGENT", 4, count, place);
    Mesh result;
    result.vertices.resize(count);
    for (std::size_t i = 0; i < count; ++i) {
        Vertex& vertex = result.vertices[i];
        vertex.position = {positions[3 * i], positions[3 * i + 1], positions[3 * i + 2]};
        if (!normals.empty())
            vertex.normal = unitOr({normals[3 * i], normals[3 * i + 1], normals[3 * i + 2]}, vertex.normal);
        if (!uvs.empty()) vertex.uv = {uvs[2 * i], uvs[2 * i + 1]};
        if (!tangents.empty())
            vertex.tangent = {unitOr({tangents[4 * i], tangents[4 * i + 1], tangents[4 * i + 2]}, {1.0f, 0.0f, 0.0f}),
                              tangents[4 * i + 3] < 0.0f ? -1.0f : 1.0f};
    }
    if (from.indices >= 0)
        result.indices = reader.indices(from.indices, count, place + ".indices");
    else
        for (std::size_t i = 0; i < count; ++i) result.indices.push_back(static_cast<std::uint32_t>(i));
    if (result.indices.size() % 3 != 0)
        reader.fail(place + ".indices", fmt::format("expected whole triangles, found {} indices", result.indices.size()));
    if (normals.empty()) makeNormals(result);
    if (tangents.empty()) makeTangents(result);
    return result;
}

void setTransform(GltfReader const& reader, tinygltf::Node const& from, Node& to, std::string const& place) {
    auto const all = [&](std::vector<double> const& values, std::size_t count, char const* key) {
        if (values.empty()) return false;
        bool const good = values.size() == count &&
                          std::ranges::all_of(values, [](double v) { return std::isfinite(static_cast<float>(v)); });
        if (!good) reader.fail(place + "." + key, fmt::format("expected {} finite numbers", count));
        return true;
    };
    auto const f = [](double value) { return static_cast<float>(value); };
    if (all(from.matrix, 16, "matrix")) {
        glm::mat4 matrix;
        for (int i = 0; i < 16; ++i) matrix[i / 4][i % 4] = f(from.matrix[static_cast<std::size_t>(i)]);
        glm::vec3 skew;
        glm::vec4 perspective;
        if (!glm::decompose(matrix, to.scale, to.rotation, to.translation, skew, perspective))
            reader.fail(place + ".matrix", "expected a matrix of translation, rotation and scale");
    }
    if (all(from.translation, 3, "translation"))
        to.translation = {f(from.translation[0]), f(from.translation[1]), f(from.translation[2])};
    if (all(from.scale, 3, "scale")) to.scale = {f(from.scale[0]), f(from.scale[1]), f(from.scale[2])};
    if (all(from.rotation, 4, "rotation")) {
        glm::quat const q{f(from.rotation[3]), f(from.rotation[0]), f(from.rotation[1]), f(from.rotation[2])};
        if (std::abs(glm::length(q) - 1.0f) > 0.01f) reader.fail(place + ".rotation", "expected a unit quaternion");
        to.rotation = glm::normalize(q);
    }
}

/// Walks the scene's tree and appends nodes, parents first.
class Tree {
public:
    Tree(GltfReader const& reader, std::vector<std::vector<int>> const& primitivesOfMesh, Model& model)
        : reader_{reader}, primitivesOfMesh_{primitivesOfMesh}, model_{model}, seen_(reader.file().nodes.size()) {}

    void append(int index, int parent, std::string const& from, int depth = 0) {
        tinygltf::Node const& node = reader_.item(reader_.file().nodes, index, from);
        std::string const place = fmt::format("nodes[{}]", index);
        if (seen_[static_cast<std::size_t>(index)] || depth > 256)
            reader_.fail(place, "expected a tree, found a node that is reached twice or too deep");
        seen_[static_cast<std::size_t>(index)] = true;
        Node to;
        to.name = node.name;
        to.parent = parent;
        setTransform(reader_, node, to, place);
        if (node.mesh != -1) to.primitives = reader_.item(primitivesOfMesh_, node.mesh, place + ".mesh");
        model_.nodes.push_back(std::move(to));
        int const self = static_cast<int>(model_.nodes.size()) - 1;
        for (int child : node.children) append(child, self, place + ".children", depth + 1);
    }

private:
    GltfReader const& reader_;
    std::vector<std::vector<int>> const& primitivesOfMesh_;
    Model& model_;
    std::vector<bool> seen_;
};

std::vector<int> roots(GltfReader const& reader) {
    tinygltf::Model const& file = reader.file();
    if (file.scenes.empty()) reader.fail("scenes", "expected a scene");
    int const scene = file.defaultScene == -1 ? 0 : file.defaultScene;
    return reader.item(file.scenes, scene, "scene").nodes;
}

void appendMaterials(GltfReader const& reader, Model& model) {
    auto const& materials = reader.file().materials;
    for (std::size_t i = 0; i < materials.size(); ++i)
        model.materials.push_back(material(reader, materials[i], fmt::format("materials[{}]", i)));
    model.materials.emplace_back();  // what primitives without one use, as glTF 2.0 says
}

std::vector<std::vector<int>> appendPrimitives(GltfReader const& reader, Model& model) {
    std::vector<std::vector<int>> primitivesOfMesh;
    auto const& meshes = reader.file().meshes;
    for (std::size_t m = 0; m < meshes.size(); ++m) {
        primitivesOfMesh.emplace_back();
        for (std::size_t p = 0; p < meshes[m].primitives.size(); ++p) {
            tinygltf::Primitive const& from = meshes[m].primitives[p];
            std::string const place = fmt::format("meshes[{}].primitives[{}]", m, p);
            int const standard = static_cast<int>(model.materials.size()) - 1;
            int const number = from.material == -1 ? standard : from.material;
            reader.item(model.materials, number, place + ".material");
            primitivesOfMesh.back().push_back(static_cast<int>(model.primitives.size()));
            model.primitives.push_back({mesh(reader, from, place), number});
        }
    }
    return primitivesOfMesh;
}
}  // namespace

Model decodeModel(std::string const& bytes, std::string const& name, std::filesystem::path const& folder) {
    tinygltf::Model file;
    parse(file, bytes, name, folder);
    GltfReader const reader{file, name};
    Model model;
    model.name = std::filesystem::path{name}.stem().string();
    appendMaterials(reader, model);
    for (std::size_t i = 0; i < file.textures.size(); ++i)
        model.textures.push_back(texture(reader, static_cast<int>(i)));
    std::vector<std::vector<int>> const primitivesOfMesh = appendPrimitives(reader, model);
    Tree tree{reader, primitivesOfMesh, model};
    for (int root : roots(reader)) tree.append(root, -1, "scene.nodes");
    return model;
}

Model readModel(std::filesystem::path const& file) {
    return decodeModel(core::readFile(file), file.string(), file.parent_path());
}

Model modelOf(Mesh mesh, Material const& material, std::string const& name) {
    Model model;
    model.name = name;
    model.materials = {material};
    model.primitives = {{std::move(mesh), 0}};
    model.nodes.emplace_back();
    model.nodes[0].name = name;
    model.nodes[0].primitives = {0};
    return model;
}
}  // namespace luftpost::assets
