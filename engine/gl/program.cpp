#include "engine/gl/program.h"

#include "engine/core/error.h"
#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace {
std::string shaderLog(GLuint id) {
    GLint length = 0;
    glGetShaderiv(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length - 1 : 0), '\0');
    if (!log.empty()) glGetShaderInfoLog(id, length, nullptr, log.data());
    return log;
}

std::string programLog(GLuint id) {
    GLint length = 0;
    glGetProgramiv(id, GL_INFO_LOG_LENGTH, &length);
    std::string log(static_cast<std::size_t>(length > 0 ? length - 1 : 0), '\0');
    if (!log.empty()) glGetProgramInfoLog(id, length, nullptr, log.data());
    return log;
}

/// A shader object for the time of linking. Its compiler is not waited for before it is asked.
class Shader {
public:
    explicit Shader(ShaderText const& text) : id_{glCreateShader(api::number(text.stage))}, files_{text.source.files} {
        char const* code = text.source.text.c_str();
        auto const length = static_cast<GLint>(text.source.text.size());
        glShaderSource(id_, 1, &code, &length);
        glCompileShader(id_);
    }
    ~Shader() {
        if (id_) glDeleteShader(id_);
    }
    Shader(Shader&& other) noexcept : id_{std::exchange(other.id_, 0u)}, files_{std::move(other.files_)} {}
    GLuint id() const { return id_; }
    /// Throws when it did not compile.
    void check() const {
        GLint compiled = GL_FALSE;
        glGetShaderiv(id_, GL_COMPILE_STATUS, &compiled);
        if (compiled) return;
        throw core::Error{"shaders/" + files_.front(), "", "expected a shader that compiles, found\n" + assets::namedMessages(shaderLog(id_), files_)};
    }

private:
    GLuint id_;
    std::vector<std::string> files_;
};
}  // namespace

struct Program::Pending {
    std::vector<Shader> shaders;
    std::string label;
};

Program::Program() = default;

Program::Program(std::span<ShaderText const> stages, std::string_view label) : Program{begun(stages, label)} { finish(); }

Program Program::begun(std::span<ShaderText const> stages, std::string_view label) {
    Program program;
    program.pending_ = std::make_unique<Pending>();
    program.pending_->label = label;
    for (ShaderText const& stage : stages) program.pending_->shaders.emplace_back(stage);
    program.id_ = glCreateProgram();
    for (Shader const& shader : program.pending_->shaders) glAttachShader(program.id_, shader.id());
    glLinkProgram(program.id_);
    return program;
}

void Program::finish() {
    if (!pending_) return;
    auto const pending = std::move(pending_);
    for (Shader const& shader : pending->shaders) shader.check();
    GLint linked = GL_FALSE;
    glGetProgramiv(id_, GL_LINK_STATUS, &linked);
    if (!linked) throw core::Error{pending->label, "link", "expected a program that links, found\n" + programLog(id_)};
    for (Shader const& shader : pending->shaders) glDetachShader(id_, shader.id());
    api::label(GL_PROGRAM, id_, pending->label);
}

Program::Program(Program&& other) noexcept
    : pending_{std::move(other.pending_)}, id_{std::exchange(other.id_, 0u)}, locations_{std::move(other.locations_)} {}

Program& Program::operator=(Program&& other) noexcept {
    std::swap(pending_, other.pending_);
    std::swap(id_, other.id_);
    std::swap(locations_, other.locations_);
    return *this;
}

Program::~Program() {
    if (id_) glDeleteProgram(id_);
}

void Program::use() const { glUseProgram(id_); }

int Program::location(std::string_view name) const {
    std::string const key{name};
    auto const known = locations_.find(key);
    if (known != locations_.end()) return known->second;
    return locations_[key] = glGetUniformLocation(id_, key.c_str());
}

void Program::set(std::string_view name, int value) const { glProgramUniform1i(id_, location(name), value); }
void Program::set(std::string_view name, unsigned value) const { glProgramUniform1ui(id_, location(name), value); }
void Program::set(std::string_view name, float value) const { glProgramUniform1f(id_, location(name), value); }
void Program::set(std::string_view name, glm::vec2 const& value) const {
    glProgramUniform2fv(id_, location(name), 1, &value.x);
}
void Program::set(std::string_view name, glm::vec3 const& value) const {
    glProgramUniform3fv(id_, location(name), 1, &value.x);
}
void Program::set(std::string_view name, glm::vec4 const& value) const {
    glProgramUniform4fv(id_, location(name), 1, &value.x);
}
void Program::set(std::string_view name, glm::ivec2 const& value) const {
    glProgramUniform2iv(id_, location(name), 1, &value.x);
}
void Program::set(std::string_view name, glm::ivec3 const& value) const {
    glProgramUniform3iv(id_, location(name), 1, &value.x);
}
void Program::set(std::string_view name, glm::ivec4 const& value) const {
    glProgramUniform4iv(id_, location(name), 1, &value.x);
}
void Program::set(std::string_view name, glm::mat3 const& value) const {
    glProgramUniformMatrix3fv(id_, location(name), 1, GL_FALSE, &value[0].x);
}
void Program::set(std::string_view name, glm::mat4 const& value) const {
    glProgramUniformMatrix4fv(id_, location(name), 1, GL_FALSE, &value[0].x);
}

namespace {
int memberOffset(GLuint program, GLenum interface, std::string_view member) {
    std::string const name{member};
    GLuint const index = glGetProgramResourceIndex(program, interface, name.c_str());
    if (index == GL_INVALID_INDEX) return -1;
    GLenum const property = GL_OFFSET;
    GLint offset = -1;
    glGetProgramResourceiv(program, interface, index, 1, &property, 1, nullptr, &offset);
    return offset;
}
}  // namespace

int Program::uniformOffset(std::string_view member) const { return memberOffset(id_, GL_UNIFORM, member); }
int Program::storageOffset(std::string_view member) const { return memberOffset(id_, GL_BUFFER_VARIABLE, member); }

int Program::uniformBlockBytes(std::string_view block) const {
    std::string const name{block};
    GLuint const index = glGetProgramResourceIndex(id_, GL_UNIFORM_BLOCK, name.c_str());
    if (index == GL_INVALID_INDEX) return -1;
    GLenum const property = GL_BUFFER_DATA_SIZE;
    GLint bytes = -1;
    glGetProgramResourceiv(id_, GL_UNIFORM_BLOCK, index, 1, &property, 1, nullptr, &bytes);
    return bytes;
}
}  // namespace luftpost::gl
