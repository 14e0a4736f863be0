#include "engine/gl/vertex_array.h"

#include "engine/core/check.h"
#include "engine/gl/gl_api.h"

namespace luftpost::gl {
namespace {
void describe(GLuint id, GLuint binding, Attribute const& attribute) {
    glEnableVertexArrayAttrib(id, attribute.location);
    glVertexArrayAttribBinding(id, attribute.location, binding);
    GLenum const type = api::number(attribute.type);
    if (attribute.integer)
        glVertexArrayAttribIFormat(id, attribute.location, attribute.components, type, attribute.offset);
    else
        glVertexArrayAttribFormat(id, attribute.location, attribute.components, type,
                                  attribute.normalised ? GL_TRUE : GL_FALSE, attribute.offset);
}
}  // namespace

VertexArray::VertexArray(std::initializer_list<VertexSource> sources, Buffer const* indices, IndexType indexType,
                         std::string_view label)
    : indexType_{indexType} {
    CHECK((indices != nullptr) == (indexType != IndexType::none), "indices and their type belong together");
    glCreateVertexArrays(1, &id_);
    GLuint binding = 0;
    for (VertexSource const& source : sources) {
        setSource(binding, *source.buffer, source.stride, source.offset);
        glVertexArrayBindingDivisor(id_, binding, source.divisor);
        for (Attribute const& attribute : source.attributes) describe(id_, binding, attribute);
        ++binding;
    }
    if (indices) glVertexArrayElementBuffer(id_, indices->id());
    api::label(GL_VERTEX_ARRAY, id_, label);
}

VertexArray VertexArray::withoutAttributes() {
    VertexArray vertices;
    glCreateVertexArrays(1, &vertices.id_);
    return vertices;
}

VertexArray::~VertexArray() {
    if (id_) glDeleteVertexArrays(1, &id_);
}

void VertexArray::setSource(unsigned source, Buffer const& buffer, int stride, std::size_t offset) {
    glVertexArrayVertexBuffer(id_, source, buffer.id(), static_cast<GLintptr>(offset), stride);
}
}  // namespace luftpost::gl
