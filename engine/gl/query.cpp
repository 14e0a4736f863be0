#include "engine/gl/query.h"

#include "engine/gl/gl_api.h"

namespace luftpost::gl {
Query Query::timestamp() {
    Query query;
    glCreateQueries(GL_TIMESTAMP, 1, &query.id_);
    return query;
}

Query::~Query() {
    if (id_) glDeleteQueries(1, &id_);
}

void Query::record() { glQueryCounter(id_, GL_TIMESTAMP); }

std::optional<std::uint64_t> Query::poll() const {
    GLint available = 0;
    glGetQueryObjectiv(id_, GL_QUERY_RESULT_AVAILABLE, &available);
    if (!available) return std::nullopt;
    return wait();
}

std::uint64_t Query::wait() const {
    GLuint64 time = 0;
    glGetQueryObjectui64v(id_, GL_QUERY_RESULT, &time);
    return time;
}

Fence Fence::insert() {
    Fence fence;
    fence.sync_ = glFenceSync(GL_SYNC_GPU_COMMANDS_COMPLETE, 0);
    return fence;
}

Fence::~Fence() {
    if (sync_) glDeleteSync(static_cast<GLsync>(sync_));
}

bool Fence::passed() const { return wait(0); }

bool Fence::wait(std::uint64_t nanoseconds) const {
    GLenum const result = glClientWaitSync(static_cast<GLsync>(sync_), GL_SYNC_FLUSH_COMMANDS_BIT, nanoseconds);
    return result == GL_ALREADY_SIGNALED || result == GL_CONDITION_SATISFIED;
}
}  // namespace luftpost::gl
