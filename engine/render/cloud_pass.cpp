#include "engine/render/cloud_pass.h"

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr glm::ivec2 kGroup{8, 8};
constexpr unsigned kRayListBinding = 8;
constexpr unsigned kAskedShare = 16;  // one pixel in so many may ask for a ray of its own in a frame

/// The head of CloudRayList: groups of two dispatches, the length of the list, the budget.
struct RayListHead {
    std::array<std::uint32_t, 4> marchGroups{0, 1, 1, 0};
    std::array<std::uint32_t, 4> fillGroups{0, 1, 1, 0};
};

std::size_t pixelCount(glm::ivec2 const& size) { return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y); }
}  // namespace

CloudPass::Screen::Screen(glm::ivec2 const& pixels) : size{pixels} {
    light[0] = gl::Texture2D{gl::Format::rgba16f, size, 1, "cloud light"};
    facts[0] = gl::Texture2D{gl::Format::rgba16f, size, 1, "cloud facts"};
}

void CloudPass::Screen::prepareHistory() {
    if (rays.id() != 0) return;
    light[1] = gl::Texture2D{gl::Format::rgba16f, size, 1, "cloud light"};
    facts[1] = gl::Texture2D{gl::Format::rgba16f, size, 1, "cloud facts"};
    rays = gl::Buffer{sizeof(RayListHead) + pixelCount(size) * sizeof(std::uint32_t), "cloud ray list"};
}

CloudPass::CloudPass(gl::ProgramLibrary& programs)
    : marchProgram_{programs.compute("cloud_march")},
      resolveProgram_{programs.compute("cloud_resolve")},
      listProgram_{programs.compute("cloud_march_list")},
      fillProgram_{programs.compute("cloud_fill")},
      compositeProgram_{programs.compute("cloud_composite")},
      scene_{programs},
      shadow_{programs},
      depths_{programs} {}

void CloudPass::describe(Snapshot const& snapshot) {
    scene_.update(snapshot, frame_++);
    shadow_.place(snapshot, scene_);
    depths_.place(snapshot, scene_);
    scene_.upload();
}

void CloudPass::prepare(FrameContext const& context) {
    scene_.bind();
    shadow_.draw(context, scene_);
    shadow_.bind();
    depths_.draw(scene_);
    depths_.bind();
}

void CloudPass::prepareScreen(glm::ivec2 const& size) {
    if (!screen_ || screen_->size != size) {
        screen_.emplace(size);
        newest_ = 0;
        history_ = false;
    }
    if (scene_.leapt()) history_ = false;
    if (scene_.block().march.w == 1) return;
    screen_->prepareHistory();
    newest_ = 1 - newest_;
}

void CloudPass::bindStore() const {
    screen_->light[newest()].bindImage(0, gl::Access::readWrite);
    screen_->facts[newest()].bindImage(1, gl::Access::readWrite);
}

void CloudPass::march(FrameContext const& context) {
    if (scene_.empty()) {
        history_ = false;
        return;
    }
    prepareScreen(context.targets.size);
    scene_.bind();
    marchProgram_.use();
    context.targets.depth.bind(0);
    bindStore();
    int const side = scene_.block().march.w;
    gl::dispatchOver((context.targets.size + side - 1) / side, kGroup);
    gl::barrier(gl::Barrier::all);
}

void CloudPass::resolve(FrameContext const& context) {
    if (scene_.empty()) return;
    if (scene_.block().march.w > 1) {
        findAgain(context);
        marchAsked();
    }
    history_ = true;
    exposureBefore_ = context.frame.exposure.x;
}

void CloudPass::findAgain(FrameContext const& context) {
    RayListHead head;
    head.fillGroups[3] = static_cast<std::uint32_t>(pixelCount(screen_->size) / kAskedShare);
    screen_->rays.update(gl::bytesOf(head));
    screen_->rays.bindStorage(kRayListBinding);
    resolveProgram_.use();
    resolveProgram_.set("historyValid", history_ && context.historyValid ? 1.0f : 0.0f);
    resolveProgram_.set("exposureRatio", context.frame.exposure.x / exposureBefore_);
    context.targets.depth.bind(0);
    screen_->light[1 - newest()].bind(1);
    screen_->facts[1 - newest()].bind(2);
    screen_->facts[newest()].bind(3);
    gl::dispatchOver(screen_->size, kGroup);
    gl::barrier(gl::Barrier::all);
}

void CloudPass::marchAsked() {
    listProgram_.use();
    gl::dispatchIndirect(screen_->rays, offsetof(RayListHead, marchGroups));
    gl::barrier(gl::Barrier::image);
    fillProgram_.use();
    gl::dispatchIndirect(screen_->rays, offsetof(RayListHead, fillGroups));
    gl::barrier(gl::Barrier::textureFetch);
}

void CloudPass::composite(FrameContext const& context) {
    if (scene_.empty()) return;
    compositeProgram_.use();
    screen_->light[newest()].bind(0);
    screen_->facts[newest()].bind(1);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    gl::dispatchOver(screen_->size, kGroup);
    gl::barrier(gl::Barrier::all);
}

std::size_t CloudPass::screenBytes() const {
    std::size_t sum = shadow_.bytes() + depths_.bytes();
    if (!screen_) return sum;
    for (std::size_t i = 0; i < 2; ++i) sum += screen_->light[i].bytes() + screen_->facts[i].bytes();
    return sum + screen_->rays.bytes();
}
}  // namespace luftpost::render
