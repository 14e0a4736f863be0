#include "engine/gl/sampler.h"

#include "engine/gl/gl_api.h"

namespace luftpost::gl {
Sampler::Sampler(SamplerSettings const& settings, std::string_view label) {
    glCreateSamplers(1, &id_);
    glSamplerParameteri(id_, GL_TEXTURE_MIN_FILTER, static_cast<GLint>(api::number(settings.minFilter)));
    glSamplerParameteri(id_, GL_TEXTURE_MAG_FILTER, static_cast<GLint>(api::number(settings.magFilter)));
    for (GLenum axis : {GL_TEXTURE_WRAP_S, GL_TEXTURE_WRAP_T, GL_TEXTURE_WRAP_R})
        glSamplerParameteri(id_, axis, static_cast<GLint>(api::number(settings.wrap)));
    glSamplerParameterfv(id_, GL_TEXTURE_BORDER_COLOR, &settings.border.x);
    if (settings.compareDepth) {
        glSamplerParameteri(id_, GL_TEXTURE_COMPARE_MODE, GL_COMPARE_REF_TO_TEXTURE);
        glSamplerParameteri(id_, GL_TEXTURE_COMPARE_FUNC, GL_GEQUAL);
    }
    api::label(GL_SAMPLER, id_, label);
}

Sampler::~Sampler() {
    if (id_) glDeleteSamplers(1, &id_);
}

void Sampler::bind(unsigned unit) const { glBindSampler(unit, id_); }
void Sampler::unbind(unsigned unit) { glBindSampler(unit, 0); }
}  // namespace luftpost::gl
