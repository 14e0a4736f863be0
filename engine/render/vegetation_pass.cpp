#include "engine/render/vegetation_pass.h"

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
using terrain::kTreeTile;
constexpr double kReach = 1500.0;       // m: farther trees are smaller than what the canopy's colour shows
constexpr int kTilesPerFrame = 6;       // a third of a millisecond each: not worth handing to a worker
constexpr std::size_t kObjectBytes = 4096;  // about what a driver keeps for a buffer and its array besides the trees
constexpr std::array<gl::Attribute, 2> kAttributes{gl::Attribute{0, 4, gl::AttributeType::float32, 0},
                                                   gl::Attribute{1, 2, gl::AttributeType::float32, 16}};

struct Near {
    terrain::TreeTileKey key;
    double distance;
};

/// Tiles within reach that may show, near first.
std::vector<Near> nearTiles(FrameContext const& context) {
    glm::dvec3 const& position = context.snapshot.camera.positionWorld;
    glm::dvec2 const camera{position.x, -position.z};
    glm::dvec3 const forward = context.snapshot.camera.worldFromCamera * glm::dvec3{0.0, 0.0, -1.0};
    auto const first = glm::ivec2{glm::floor((camera - kReach) / static_cast<double>(kTreeTile))};
    auto const last = glm::ivec2{glm::floor((camera + kReach) / static_cast<double>(kTreeTile))};
    std::vector<Near> tiles;
    for (int y = first.y; y <= last.y; ++y)
        for (int x = first.x; x <= last.x; ++x) {
            glm::dvec2 const middle = (glm::dvec2{x, y} + 0.5) * static_cast<double>(kTreeTile) - camera;
            double const distance = glm::length(middle), ahead = middle.x * forward.x - middle.y * forward.z;
            bool const behind = ahead < -300.0 && std::abs(forward.y) < 0.5;
            if (distance < kReach + 0.75 * kTreeTile && !behind) tiles.push_back({{x, y}, distance});
        }
    std::sort(tiles.begin(), tiles.end(), [](Near const& a, Near const& b) { return a.distance < b.distance; });
    return tiles;
}
}  // namespace

VegetationPass::VegetationPass(gl::ProgramLibrary& programs) : program_{programs.graphics("tree")} {}

VegetationPass::Tile const* VegetationPass::tile(terrain::Land const& land, terrain::TreeTileKey key, int& budget) {
    if (Tile const* known = tiles_.find(key)) return known;
    if (budget-- <= 0) return nullptr;
    std::vector<terrain::Tree> const trees = terrain::treesOf(land, key);
    Tile made;
    made.count = static_cast<int>(trees.size());
    if (made.count > 0) {
        made.trees = gl::Buffer{gl::bytesOfRange(trees), "trees"};
        made.array = gl::VertexArray{{{&made.trees, sizeof(terrain::Tree), kAttributes, 1}}, nullptr, gl::IndexType::none, "trees"};
    }
    tiles_.insert(key, std::move(made), trees.size() * sizeof(terrain::Tree) + kObjectBytes);
    return tiles_.find(key);
}

void VegetationPass::draw(FrameContext const& context, LandScene const& scene) {
    terrain::Land const& land = scene.land();
    if (land.seed() != seed_ || land.base() != base_) {
        tiles_ = decltype(tiles_){tiles_.capacity()};
        seed_ = land.seed(), base_ = land.base();
    }
    if (!context.snapshot.graphics.vegetation || scene.aboveGround() > kReach) return;
    gl::DrawState state = gl::opaqueState();
    state.cull = gl::Cull::none;
    state.wireframe = context.snapshot.debug.wireframe;
    gl::apply(state);
    context.targets.opaque.bind();
    program_.use();
    scene.bind();
    glm::dvec3 const& camera = context.snapshot.camera.positionWorld;
    int budget = context.snapshot.still ? 1'000'000 : kTilesPerFrame;
    program_.set("treeReach", static_cast<float>(kReach));
    for (Near const& near : nearTiles(context)) {
        Tile const* drawn = tile(land, near.key, budget);
        if (!drawn || drawn->count == 0) continue;
        glm::dvec2 const corner = glm::dvec2{near.key.x, near.key.y} * static_cast<double>(kTreeTile);
        program_.set("tileCorner", glm::vec2{corner.x - camera.x, corner.y + camera.z});
        gl::drawArrays(drawn->array, gl::Primitive::triangleStrip, 0, 4, drawn->count);
    }
}
}  // namespace luftpost::render
