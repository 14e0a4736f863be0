// Owner of a linked program.
#pragma once
#include <memory>
#include <span>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include <glm/glm.hpp>

#include "engine/assets/shader_source.h"
#include "engine/gl/types.h"

namespace luftpost::gl {
struct ShaderText {
    Stage stage;
    assets::ShaderSource source;
};

/// Vertex + fragment (+ geometry), or compute. Id 0 is empty.
class Program {
public:
    Program();
    /// Compiles and links; throws core::Error with the compiler's messages in our files and lines.
    explicit Program(std::span<ShaderText const> stages, std::string_view label = {});
    /// Hands it to the driver and does not wait, so that a driver with threads compiles several side by side. Not to be used before finish().
    static Program begun(std::span<ShaderText const> stages, std::string_view label = {});
    /// Waits for one that was begun; throws as the constructor does. Does nothing else.
    void finish();
    ~Program();
    Program(Program&& other) noexcept;
    Program& operator=(Program&& other) noexcept;
    unsigned id() const { return id_; }

    void use() const;
    /// Sets a plain uniform by name. A name that the program does not have (or that the compiler dropped) is ignored.
    void set(std::string_view name, int value) const;
    void set(std::string_view name, unsigned value) const;
    void set(std::string_view name, float value) const;
    void set(std::string_view name, glm::vec2 const& value) const;
    void set(std::string_view name, glm::vec3 const& value) const;
    void set(std::string_view name, glm::vec4 const& value) const;
    void set(std::string_view name, glm::ivec2 const& value) const;
    void set(std::string_view name, glm::ivec3 const& value) const;
    void set(std::string_view name, glm::ivec4 const& value) const;
    void set(std::string_view name, glm::mat3 const& value) const;
    void set(std::string_view name, glm::mat4 const& value) const;
    bool has(std::string_view name) const { return location(name) >= 0; }

    /// Byte offset of a block's member as the driver reports it, -1 when the program does not have it. `member` is
    /// the name in the shader's interface: "FrameBlock.sunDirection", or "sunDirection" for a block without a name.
    int uniformOffset(std::string_view member) const;
    /// The same for a member of a shader storage block.
    int storageOffset(std::string_view member) const;
    /// Byte size of a uniform block as the driver reports it, -1 when the program does not have it.
    int uniformBlockBytes(std::string_view block) const;

private:
    int location(std::string_view name) const;

    struct Pending;  // what finish() asks for
    std::unique_ptr<Pending> pending_;
    unsigned id_ = 0;
    mutable std::unordered_map<std::string, int> locations_;
};
}  // namespace luftpost::gl
