#include "engine/render/cloud_pass.h"

#include <fmt/format.h>

#include "engine/gl/context.h"
#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
constexpr glm::ivec2 kGroup{8, 8};
constexpr unsigned kRayListBinding = 8;
constexpr int kWidestBlock = 4;       // pixels; one of each whole block never asks, for it is marched
constexpr unsigned kAskedShare = 16;  // one pixel in so many may ask for a ray of its own in a frame

/// The head of CloudRayList: groups of two dispatches, the length of the list, the budget.
struct RayListHead {
    std::array<std::uint32_t, 4> marchGroups{0, 1, 1, 0};
    std::array<std::uint32_t, 4> fillGroups{0, 1, 1, 0};
};

/// Rays that the march takes together, as the shader's MARCH_GROUP wants them.
glm::ivec2 marchGroup() { return gl::isSoftware() ? glm::ivec2{8, 8} : glm::ivec2{32, 16}; }
gl::ProgramLibrary::Defines marchDefines() { return {fmt::format("MARCH_GROUP {}", marchGroup().x * marchGroup().y)}; }

std::size_t pixelCount(glm::ivec2 const& size) { return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y); }
}  // namespace

CloudPass::Store::Store(glm::ivec2 const& size)
    : light{gl::Format::rgba16f, size, 1, "cloud light"}, facts{gl::Format::rgba16f, size, 1, "cloud facts"} {}

CloudPass::CloudPass(gl::ProgramLibrary& programs)
    : marchProgram_{programs, "cloud_march", marchDefines()},
      resolveProgram_{programs.compute("cloud_resolve", marchDefines())},
      fillProgram_{programs.compute("cloud_fill")},
      compositeProgram_{programs.compute("cloud_composite")},
      scene_{programs},
      shadow_{programs},
      depths_{programs},
      glow_{programs},
      shade_{programs} {}

void CloudPass::describe(Snapshot const& snapshot) {
    scene_.update(snapshot, frame_++);
    shadow_.place(snapshot, scene_);
    depths_.place(snapshot, scene_);
    scene_.upload();
}

void CloudPass::prepare(FrameContext const& context) {
    scene_.bind();
    if (!context.tile) shadow_.draw(context, scene_);
    shadow_.bind();
    GridRows const rows = context.tile ? GridRows{} : depths_.draw(scene_);
    depths_.bind();
    glow_.draw(rows);
    glow_.bind();
    if (!context.tile) shade_.draw(context, scene_);
    shade_.bind();
}

void CloudPass::takeStore(glm::ivec2 const& size) {
    if (scene_.leapt()) history_ = false;
    if (scene_.block().march.w > 1) {
        newest_ = 1 - newest_;
        std::size_t const list = sizeof(RayListHead) + (pixelCount(size) - pixelCount(size / kWidestBlock)) * sizeof(std::uint32_t);
        if (rays_.bytes() != list) rays_ = gl::Buffer{list, "cloud ray list"};
    } else if (rays_.bytes() == 0) {
        rays_ = gl::Buffer{sizeof(RayListHead), "cloud ray list"};
    }
    std::optional<Store>& store = stores_[static_cast<std::size_t>(newest_)];
    if (!store || store->light.size() != size) store.emplace(size);
}

void CloudPass::march(FrameContext const& context) {
    if (scene_.empty()) {
        history_ = false;
        return;
    }
    takeStore(context.targets.size);
    scene_.bind();
    rays_.bindStorage(kRayListBinding);
    gl::Program const& program = marchProgram_.of(scene_);
    program.use();
    program.set("asked", 0);
    context.targets.depth.bind(0);
    newest().light.bindImage(0, gl::Access::readWrite);
    newest().facts.bindImage(1, gl::Access::readWrite);
    int const side = scene_.block().march.w;
    gl::dispatchOver((context.targets.size + side - 1) / side, marchGroup());
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
    head.fillGroups[3] = static_cast<std::uint32_t>(pixelCount(context.targets.size) / kAskedShare);
    rays_.update(gl::bytesOf(head));
    rays_.bindStorage(kRayListBinding);
    resolveProgram_.use();
    bool const known = history_ && context.historyValid;
    resolveProgram_.set("historyValid", known ? 1.0f : 0.0f);
    resolveProgram_.set("exposureRatio", context.frame.exposure.x / exposureBefore_);
    context.targets.depth.bind(0);
    (known ? older() : newest()).light.bind(1);
    (known ? older() : newest()).facts.bind(2);
    newest().facts.bind(3);
    gl::dispatchOver(context.targets.size, kGroup);
    gl::barrier(gl::Barrier::image);
    gl::barrier(gl::Barrier::indirect);
}

void CloudPass::marchAsked() {
    gl::Program const& program = marchProgram_.of(scene_);
    program.use();
    program.set("asked", 1);
    gl::dispatchIndirect(rays_, offsetof(RayListHead, marchGroups));
    gl::barrier(gl::Barrier::image);
    fillProgram_.use();
    gl::dispatchIndirect(rays_, offsetof(RayListHead, fillGroups));
    gl::barrier(gl::Barrier::all);
}

void CloudPass::composite(FrameContext const& context) {
    if (scene_.empty()) return;
    compositeProgram_.use();
    newest().light.bind(0);
    newest().facts.bind(1);
    context.targets.colour.bindImage(0, gl::Access::readWrite);
    gl::dispatchOver(context.targets.size, kGroup);
    gl::barrier(gl::Barrier::all);
}

gl::Texture2D const* CloudPass::facts() const {
    return !scene_.empty() && stores_[static_cast<std::size_t>(newest_)] ? &newest().facts : nullptr;
}

std::size_t CloudPass::screenBytes() const {
    std::size_t sum = shadow_.bytes() + depths_.bytes() + glow_.bytes() + shade_.bytes();
    for (std::optional<Store> const& store : stores_)
        if (store) sum += store->light.bytes() + store->facts.bytes();
    return sum + rays_.bytes();
}
}  // namespace luftpost::render
