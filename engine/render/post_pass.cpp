#include "engine/render/post_pass.h"

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr int kBloomLevels = 5;
constexpr glm::ivec2 kGroup{8, 8};
/// What one texel may add to the bloom, exposed: the sun's disc glows, but not over the whole sky.
constexpr float kBloomCeiling = 60.0f;
}  // namespace

PostPass::PostPass(gl::ProgramLibrary& programs)
    : down_{programs.compute("bloom_down")},
      up_{programs.compute("bloom_up")},
      toneMap_{programs.graphics(gl::GraphicsStages{"fullscreen", "tone_map", ""})},
      finish_{programs.graphics(gl::GraphicsStages{"fullscreen", "finish", ""})} {}

void PostPass::takeLevels(glm::ivec2 const& picture) {
    if (picture == picture_) return;
    picture_ = picture;
    levels_.clear();
    glm::ivec2 level = glm::max(picture / 4, glm::ivec2{1});
    for (int i = 0; i < kBloomLevels; ++i, level = glm::max(level / 2, glm::ivec2{1}))
        levels_.emplace_back(gl::Format::rgba16f, level, 1, "bloom");
}

void PostPass::takeEncoded(glm::ivec2 const& size) {
    if (size == encoded_.size()) return;
    encoded_ = gl::Texture2D{gl::Format::rgba16, size, 1, "encoded"};
    encodedTarget_ = gl::Framebuffer{{&encoded_}, nullptr, "encoded"};
}

void PostPass::drawBloom(FrameContext const& context) {
    takeLevels(context.targets.size);
    down_.use();
    gl::Texture2D const* finer = &context.targets.colour;
    for (gl::Texture2D const& level : levels_) {
        bool const first = finer == &context.targets.colour;
        down_.set("ceiling", first ? kBloomCeiling * context.frame.exposure.x / context.frame.exposure.y : 65504.0f);
        finer->bind(0);
        level.bindImage(0, gl::Access::write);
        gl::dispatchOver(level.size(), kGroup);
        gl::barrier(gl::Barrier::textureFetch);
        finer = &level;
    }
    up_.use();
    for (std::size_t i = levels_.size() - 1; i-- > 0;) {
        gl::barrier(gl::Barrier::image);
        levels_[i + 1].bind(0);
        levels_[i].bindImage(0, gl::Access::readWrite);
        gl::dispatchOver(levels_[i].size(), kGroup);
        gl::barrier(gl::Barrier::textureFetch);
    }
}

void PostPass::drawToneMap(FrameContext const& context, gl::Framebuffer const& display) {
    takeEncoded(context.targets.size);
    gl::apply({});
    encodedTarget_.bind();
    toneMap_.use();
    toneMap_.set("bloomShare", context.snapshot.graphics.bloom);
    context.targets.colour.bind(0);
    levels_[0].bind(1);
    gl::drawFullscreen();
    display.bind();
    finish_.use();
    finish_.set("smoothing", context.snapshot.graphics.smoothEdges ? 1.0f : 0.0f);
    finish_.set("dither", context.snapshot.dither ? 1.0f : 0.0f);
    encoded_.bind(0);
    gl::drawFullscreen();
}
}  // namespace luftpost::render
