// Inside engine/assets: checked access to what tinygltf read.
#pragma once
#include <fmt/format.h>
#include <tiny_gltf.h>

#include <span>
#include <string>
#include <vector>

#include "engine/core/error.h"

namespace luftpost::assets {
/// Every index, offset and length of the file is checked before it is used.
class GltfReader {
public:
    GltfReader(tinygltf::Model const& file, std::string name) : file_{file}, name_{std::move(name)} {}

    [[noreturn]] void fail(std::string const& place, std::string const& expected) const {
        throw core::Error{name_, place, expected};
    }
    template <class T>
    T const& item(std::vector<T> const& items, int index, std::string const& place) const {
        if (index < 0 || static_cast<std::size_t>(index) >= items.size())
            fail(place, fmt::format("expected a number 0..{}, found {}", static_cast<long>(items.size()) - 1, index));
        return items[static_cast<std::size_t>(index)];
    }
    /// `components` floats an element; normalised integers become 0..1 or -1..1. All values are finite.
    std::vector<float> floats(int accessor, int components, std::string const& place) const;
    /// Indices, each below `vertices`.
    std::vector<std::uint32_t> indices(int accessor, std::size_t vertices, std::string const& place) const;
    /// The bytes of a buffer view.
    std::span<unsigned char const> view(int index, std::string const& place) const;

    tinygltf::Model const& file() const { return file_; }
    std::string const& name() const { return name_; }

private:
    /// First byte of each element.
    std::vector<unsigned char const*> elements(tinygltf::Accessor const& accessor, std::string const& place) const;

    tinygltf::Model const& file_;
    std::string name_;
};
}  // namespace luftpost::assets
