#include "engine/render/cloud_pass.h"

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr glm::ivec2 kGroup{8, 8};
constexpr int kBlock = 4;  // one ray in 4 x 4 a frame

glm::ivec2 marchedSize(glm::ivec2 const& size, bool whole) { return whole ? size : (size + kBlock - 1) / kBlock; }
}  // namespace

CloudPass::Screen::Screen(glm::ivec2 const& pixels, bool all)
    : size{pixels},
      whole{all},
      marchedLight{gl::Format::rgba16f, marchedSize(pixels, all), 1, "marched cloud light"},
      marchedDistance{gl::Format::rg32f, marchedSize(pixels, all), 1, "marched cloud distance"} {
    if (whole) return;
    for (gl::Texture2D& texture : light) texture = gl::Texture2D{gl::Format::rgba16f, pixels, 1, "cloud light"};
    for (gl::Texture2D& texture : facts) texture = gl::Texture2D{gl::Format::rgba16f, pixels, 1, "cloud facts"};
}

CloudPass::CloudPass(gl::ProgramLibrary& programs)
    : marchProgram_{programs.compute("cloud_march")},
      resolveProgram_{programs.compute("cloud_resolve")},
      compositeProgram_{programs.compute("cloud_composite")},
      scene_{programs},
      shadow_{programs} {}

void CloudPass::describe(Snapshot const& snapshot) {
    scene_.update(snapshot, frame_++);
    shadow_.place(snapshot, scene_);
    scene_.upload();
}

void CloudPass::prepare(FrameContext const& context) {
    scene_.bind();
    shadow_.draw(context, scene_);
    shadow_.bind();
}

void CloudPass::draw(FrameContext const& context) {
    if (scene_.empty()) {
        history_ = false;
        return;
    }
    bool const whole = scene_.block().march.w == 1;
    if (!screen_ || screen_->size != context.targets.size || screen_->whole != whole) {
        screen_.emplace(context.targets.size, whole);
        history_ = false;
    }
    scene_.bind();
    march(context);
    if (!whole) resolve(context);
    composite(context);
    exposureBefore_ = context.frame.exposure.x;
}

CloudPass::Distance CloudPass::distance() const {
    if (scene_.empty() || !screen_) return {};
    if (screen_->whole) return {&screen_->marchedDistance, false};
    return {&screen_->facts[static_cast<std::size_t>(newest_)], true};
}

void CloudPass::march(FrameContext const& context) {
    marchProgram_.use();
    context.targets.depth.bind(0);
    screen_->marchedLight.bindImage(0, gl::Access::write);
    screen_->marchedDistance.bindImage(1, gl::Access::write);
    gl::dispatchOver(screen_->marchedLight.size(), kGroup);
    gl::barrier(gl::Barrier::textureFetch);
}

void CloudPass::resolve(FrameContext const& context) {
    auto const older = static_cast<std::size_t>(newest_);
    auto const newer = 1 - older;
    resolveProgram_.use();
    resolveProgram_.set("historyValid", history_ && context.historyValid ? 1.0f : 0.0f);
    resolveProgram_.set("exposureRatio", context.frame.exposure.x / exposureBefore_);
    context.targets.depth.bind(0);
    screen_->marchedLight.bind(1);
    screen_->marchedDistance.bind(2);
    screen_->light[older].bind(3);
    screen_->facts[older].bind(4);
    screen_->light[newer].bindImage(0, gl::Access::write);
    screen_->facts[newer].bindImage(1, gl::Access::write);
    gl::dispatchOver(screen_->size, kGroup);
    gl::barrier(gl::Barrier::textureFetch);
    newest_ = static_cast<int>(newer);
    history_ = true;
}

void CloudPass::composite(FrameContext const& context) {
    auto const newest = static_cast<std::size_t>(newest_);
    compositeProgram_.use();
    compositeProgram_.set("inverted", screen_->whole ? 0 : 1);
    (screen_->whole ? screen_->marchedLight : screen_->light[newest]).bind(0);
    (screen_->whole ? screen_->marchedDistance : screen_->facts[newest]).bind(1);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    gl::dispatchOver(screen_->size, kGroup);
    gl::barrier(gl::Barrier::all);
}
}  // namespace luftpost::render
