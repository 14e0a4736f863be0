#include "engine/assets/gltf_reader.h"

#include <cmath>
#include <cstring>

namespace luftpost::assets {
namespace {
constexpr std::size_t kMostElements = 1u << 24;

template <class T>
T load(unsigned char const* bytes) {
    T value;
    std::memcpy(&value, bytes, sizeof value);
    return value;
}

/// One component as float; `normalised` integers are scaled as glTF 2.0 says (section 3.11).
float component(unsigned char const* bytes, int type, bool normalised) {
    switch (type) {
        case TINYGLTF_COMPONENT_TYPE_FLOAT: return load<float>(bytes);
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE: {
            float const value = static_cast<float>(load<std::uint8_t>(bytes));
            return normalised ? value / 255.0f : value;
        }
        case TINYGLTF_COMPONENT_TYPE_BYTE: {
            float const value = static_cast<float>(load<std::int8_t>(bytes));
            return normalised ? std::fmax(value / 127.0f, -1.0f) : value;
        }
        case TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT: {
            float const value = static_cast<float>(load<std::uint16_t>(bytes));
            return normalised ? value / 65535.0f : value;
        }
        default: {
            float const value = static_cast<float>(load<std::int16_t>(bytes));
            return normalised ? std::fmax(value / 32767.0f, -1.0f) : value;
        }
    }
}

bool isFloatSource(int type) {
    return type == TINYGLTF_COMPONENT_TYPE_FLOAT || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
           type == TINYGLTF_COMPONENT_TYPE_BYTE || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ||
           type == TINYGLTF_COMPONENT_TYPE_SHORT;
}
}  // namespace

std::span<unsigned char const> GltfReader::view(int index, std::string const& place) const {
    tinygltf::BufferView const& view = item(file_.bufferViews, index, place + ".bufferView");
    tinygltf::Buffer const& buffer =
        item(file_.buffers, view.buffer, fmt::format("bufferViews[{}].buffer", index));
    if (view.byteLength == 0 || view.byteOffset > buffer.data.size() ||
        view.byteLength > buffer.data.size() - view.byteOffset)
        fail(fmt::format("bufferViews[{}]", index),
             fmt::format("expected bytes within the buffer's {}, found {} at {}", buffer.data.size(), view.byteLength,
                         view.byteOffset));
    return {buffer.data.data() + view.byteOffset, view.byteLength};
}

std::vector<unsigned char const*> GltfReader::elements(tinygltf::Accessor const& accessor,
                                                       std::string const& place) const {
    if (accessor.sparse.isSparse) fail(place, "expected a dense accessor, found a sparse one");
    if (accessor.count == 0 || accessor.count > kMostElements)
        fail(place, fmt::format("expected 1..{} elements, found {}", kMostElements, accessor.count));
    std::span<unsigned char const> const bytes = view(accessor.bufferView, place);
    int const componentBytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    int const components = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (componentBytes < 1 || components < 1) fail(place, "expected a component type and a type of glTF 2.0");
    auto const elementBytes = static_cast<std::size_t>(componentBytes * components);
    std::size_t const given = file_.bufferViews[static_cast<std::size_t>(accessor.bufferView)].byteStride;
    std::size_t const stride = given ? given : elementBytes;
    if (accessor.byteOffset > bytes.size() || stride < elementBytes ||
        (accessor.count - 1) * stride + elementBytes > bytes.size() - accessor.byteOffset)
        fail(place, fmt::format("expected {} elements of {} bytes within the view's {}", accessor.count, elementBytes,
                                bytes.size()));
    std::vector<unsigned char const*> result(accessor.count);
    for (std::size_t i = 0; i < accessor.count; ++i) result[i] = bytes.data() + accessor.byteOffset + i * stride;
    return result;
}

std::vector<float> GltfReader::floats(int index, int components, std::string const& place) const {
    tinygltf::Accessor const& accessor = item(file_.accessors, index, place);
    int const found = tinygltf::GetNumComponentsInType(static_cast<std::uint32_t>(accessor.type));
    if (found != components || !isFloatSource(accessor.componentType))
        fail(place, fmt::format("expected {} numbers an element (float, or 8 or 16 bit), found {} of type {}", components,
                                found, accessor.componentType));
    int const bytes = tinygltf::GetComponentSizeInBytes(static_cast<std::uint32_t>(accessor.componentType));
    std::vector<float> values;
    values.reserve(accessor.count <= kMostElements ? accessor.count * static_cast<std::size_t>(components) : 0);
    for (unsigned char const* element : elements(accessor, place))
        for (int c = 0; c < components; ++c) {
            float const value = component(element + c * bytes, accessor.componentType, accessor.normalized);
            if (!std::isfinite(value)) fail(place, "expected finite numbers");
            values.push_back(value);
        }
    return values;
}

std::vector<std::uint32_t> GltfReader::indices(int index, std::size_t vertices, std::string const& place) const {
    tinygltf::Accessor const& accessor = item(file_.accessors, index, place);
    int const type = accessor.componentType;
    bool const known = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE ||
                       type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT || type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_INT;
    if (!known || accessor.type != TINYGLTF_TYPE_SCALAR)
        fail(place, fmt::format("expected unsigned scalars, found component type {}", type));
    std::vector<std::uint32_t> values;
    for (unsigned char const* element : elements(accessor, place)) {
        std::uint32_t const value = type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_BYTE    ? load<std::uint8_t>(element)
                                    : type == TINYGLTF_COMPONENT_TYPE_UNSIGNED_SHORT ? load<std::uint16_t>(element)
                                                                                     : load<std::uint32_t>(element);
        if (value >= vertices) fail(place, fmt::format("expected indices below {}, found {}", vertices, value));
        values.push_back(value);
    }
    return values;
}
}  // namespace luftpost::assets
