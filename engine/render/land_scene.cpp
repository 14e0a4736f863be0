#include "engine/render/land_scene.h"

#include <algorithm>
#include <bit>
#include <cmath>
#include <utility>

#include "engine/gl/draw.h"

namespace luftpost::render {
namespace {
using terrain::ChunkKey;
using terrain::kChunkCells;

struct GridVertex {
    std::uint8_t east, north, foot, unused = 0;
};

/// Vertices in rows, then the feet of the skirts under the lines 0, half and whole: three along the rows, three across.
std::vector<GridVertex> gridVertices(int stride) {
    std::vector<GridVertex> vertices;
    auto const add = [&](int x, int y, int foot) {
        vertices.push_back({static_cast<std::uint8_t>(x), static_cast<std::uint8_t>(y), static_cast<std::uint8_t>(foot)});
    };
    for (int y = 0; y <= kChunkCells; y += stride)
        for (int x = 0; x <= kChunkCells; x += stride) add(x, y, 0);
    for (int line = 0; line <= kChunkCells; line += kChunkCells / 2)
        for (int x = 0; x <= kChunkCells; x += stride) add(x, line, 1);
    for (int line = 0; line <= kChunkCells; line += kChunkCells / 2)
        for (int y = 0; y <= kChunkCells; y += stride) add(line, y, 1);
    return vertices;
}

/// Two triangles a cell, split along the diagonal from south-west to north-east, on which odd vertices slide. Every
/// quarter has a skirt on its four sides, since its neighbour may be of another level.
std::vector<std::uint16_t> gridIndices(int stride) {
    int const cells = kChunkCells / stride, side = cells + 1, half = cells / 2;
    std::vector<std::uint16_t> indices;
    auto const quad = [&](int a, int b, int c, int d) {  // a b / c d from south-west, counter-clockwise from above
        for (int index : {a, b, d, a, d, c}) indices.push_back(static_cast<std::uint16_t>(index));
    };
    for (int quarter = 0; quarter < 4; ++quarter) {
        int const east = quarter & 1, north = quarter >> 1, x0 = east * half, y0 = north * half;
        for (int y = y0; y < y0 + half; ++y)
            for (int x = x0; x < x0 + half; ++x) quad(y * side + x, y * side + x + 1, (y + 1) * side + x, (y + 1) * side + x + 1);
        int const south = (side + north) * side, far = south + side, west = (side + 3 + east) * side, right = west + side;
        for (int i = 0; i < half; ++i) {
            int const x = x0 + i, y = y0 + i, top = (y0 + half) * side, end = x0 + half;
            quad(south + x, south + x + 1, y0 * side + x, y0 * side + x + 1);
            quad(top + x, top + x + 1, far + x, far + x + 1);
            quad(west + y, y * side + x0, west + y + 1, (y + 1) * side + x0);
            quad(y * side + end, right + y, (y + 1) * side + end, right + y + 1);
        }
    }
    return indices;
}

// A view wants up to 300 chunks from any height, and 12 MB are in the making: more would only serve a way flown twice,
// while memory grew for as long as a flight finds new land.
constexpr std::size_t kMostChunks = 500;

constexpr std::array<gl::Attribute, 1> kAttributes{gl::Attribute{0, 4, gl::AttributeType::uint8, 0, false, true}};

int trianglesOf(int quarters, int stride) { return quarters * 2 * (kChunkCells / stride / 2) * (kChunkCells / stride / 2); }
int quartersOf(std::vector<terrain::DrawnChunk> const& chunks) {
    int quarters = 0;
    for (terrain::DrawnChunk const& chunk : chunks) quarters += std::popcount(chunk.quarters);
    return quarters;
}
}  // namespace

GridMesh::GridMesh(int everyStride) : stride{everyStride} {
    std::vector<GridVertex> const points = gridVertices(stride);
    std::vector<std::uint16_t> const triangles = gridIndices(stride);
    indicesPerQuarter = static_cast<int>(triangles.size() / 4);
    vertices = gl::Buffer{gl::bytesOfRange(points), "grid vertices"};
    indices = gl::Buffer{gl::bytesOfRange(triangles), "grid indices"};
    array = gl::VertexArray{{{&vertices, sizeof(GridVertex), kAttributes}}, &indices, gl::IndexType::uint16, "grid"};
}

terrain::CameraView cameraView(Camera const& camera, glm::ivec2 const& size) {
    terrain::CameraView view;
    view.positionWorld = camera.positionWorld;
    view.forward = camera.worldFromCamera * glm::dvec3{0.0, 0.0, -1.0};
    view.up = camera.worldFromCamera * glm::dvec3{0.0, 1.0, 0.0};
    view.tanHalfWidth = std::tan(0.5 * camera.horizontalFov);
    view.tanHalfHeight = view.tanHalfWidth * size.y / size.x;
    view.allRound = camera.projection != Projection::perspective;
    return view;
}

LandScene::LandScene(int workers)
    : workers_{workers}, block_{sizeof(glsl::LandBlock), "land block"},
      shadowTexture_{gl::Format::rg32f, glm::ivec2{terrain::kShadowSide}, 1, "land shadow"} {
    shadowTexture_.setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::clampToEdge);
}

void LandScene::startOver(Snapshot const& snapshot, int step) {
    shadowJobs_.reset();
    shadow_.reset();
    making_ = std::make_shared<Making>();
    streamer_.reset();
    textures_.clear();
    spare_.clear();
    land_ = std::make_unique<terrain::Land>(snapshot.seed, snapshot.place.altitude_m);
    terrain::StreamerOptions options;
    options.workers = workers_;
    options.step = step;
    options.capBytes = std::min(options.capBytes, kMostChunks * terrain::chunkBytes(kChunkCells / step));
    streamer_ = std::make_unique<terrain::Streamer>(*land_, options);
    shadowJobs_ = std::make_unique<core::Jobs>(1);
}

void LandScene::update(FrameContext const& context) {
    Snapshot const& snapshot = context.snapshot;
    // Coarse meshes draw every 4th to 6th vertex: then every second sample is enough, and made four times as fast. Of a
    // small picture every third.
    bool const small = context.picture().x * context.picture().y <= 100'000;
    int const step = snapshot.graphics.triangles > 600'000 ? 1 : small ? 3 : 2;
    bool const first = !land_ || land_->seed() != snapshot.seed || land_->base() != snapshot.place.altitude_m || streamer_->options().step != step;
    if (first) startOver(snapshot, step);
    terrain::CameraView const view = cameraView(snapshot.camera, context.picture());
    take(snapshot.still ? streamer_->finish(view) : streamer_->update(view));
    if (!list_.whole) take(streamer_->finishKept(view));  // the first frame, or a jump across the world
    chooseMesh(snapshot.graphics.triangles);
    updateShadow(snapshot);
    fillBlock(context);
}

void LandScene::take(terrain::DrawList list) {
    list_ = std::move(list);
    for (ChunkKey const& key : list_.dropped)
        if (auto const gone = textures_.extract(key)) spare_.push_back(std::move(gone.mapped().texture));
    for (auto const& chunk : list_.fresh) {
        ChunkTexture entry{spareTexture(chunk->cells + 1), chunk->lowest};
        entry.texture.upload(std::span<float const>{&chunk->samples.front().x, chunk->samples.size() * 4});
        textures_.insert_or_assign(chunk->key, std::move(entry));
    }
    list_.fresh.clear();
}

// All chunks of a streamer are of one size: a dropped one's texture serves the next. Made and freed anew they would be strewn
// over the heap of a driver that keeps them there.
gl::Texture2D LandScene::spareTexture(int side) {
    if (!spare_.empty()) {
        gl::Texture2D texture = std::move(spare_.back());
        spare_.pop_back();
        return texture;
    }
    gl::Texture2D texture{gl::Format::rgba32f, {side, side}, 1, "chunk"};
    texture.setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::clampToEdge);
    return texture;
}

// The finest mesh that keeps the frame within its triangles, of those whose vertices were sampled.
void LandScene::chooseMesh(int budget) {
    int const quarters = quartersOf(list_.chunks), step = streamer_->options().step;
    int chosen = 6;
    for (int stride = 6; stride >= 1; --stride)
        if (stride % step == 0 && trianglesOf(quarters, stride) <= budget) chosen = stride;
    auto& mesh = meshes_[static_cast<std::size_t>(chosen - 1)];
    if (!mesh) mesh = std::make_unique<GridMesh>(chosen);
    mesh_ = mesh.get();
}

int LandScene::trianglesDrawn() const { return mesh_ ? trianglesOf(quartersOf(list_.chunks), mesh_->stride) : 0; }

// The map follows camera and sun in steps; a worker makes the next one while the last is in use.
void LandScene::updateShadow(Snapshot const& snapshot) {
    constexpr double kStale = 0.99998;  // cosine of a third of a degree
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    glm::dvec3 const sun = snapshot.sky.sunDirectionWorld;
    glm::dvec2 const corner = terrain::shadowCorner({camera.x, -camera.z});
    {
        std::lock_guard const lock{making_->mutex};
        if (making_->made) {
            takeShadow(std::move(*making_->made));
            making_->made.reset();
        }
    }
    if (shadow_ && shadow_->corner == corner && glm::dot(shadow_->towardLight, sun) > kStale) return;
    if (!shadow_ || snapshot.still) return takeShadow(terrain::makeShadowMap(*land_, corner, sun));
    std::lock_guard const lock{making_->mutex};
    if (std::exchange(making_->busy, true)) return;
    shadowJobs_->submit(0.0, [making = making_, land = land_.get(), corner, sun] {
        terrain::ShadowMap map = terrain::makeShadowMap(*land, corner, sun);
        std::lock_guard const done{making->mutex};
        making->made = std::move(map);
        making->busy = false;
    });
}

void LandScene::takeShadow(terrain::ShadowMap map) {
    shadowTexture_.upload(std::span<float const>{&map.texels.front().x, map.texels.size() * 2});
    map.texels.clear();
    shadow_ = std::move(map);
}

namespace {
/// m above sea level: from where on the land is white. Snow on the ground brings it down; 4 cm hide all of it.
double snowLine(Snapshot const& snapshot) {
    constexpr double kHidden = 0.04, kLowest = -1000.0;  // m
    double const share = std::clamp(snapshot.weather.snowDepth / kHidden, 0.0, 1.0);
    return std::lerp(terrain::kSnowLine, kLowest, share * share * (3.0 - 2.0 * share));
}
}  // namespace

void LandScene::fillBlock(FrameContext const& context) {
    glm::dvec3 const& camera = context.snapshot.camera.positionWorld;
    terrain::Runway const& runway = land_->runway();
    glm::dvec2 const home{-camera.x, camera.z};
    glsl::LandBlock block;
    block.levels = glm::vec4{land_->waterLevel(), snowLine(context.snapshot), list_.aboveGround, camera.y};
    block.runway = glm::vec4{runway.directionEastNorth, runway.length, runway.width};
    block.home = glm::vec4{home, runway.altitude, glm::length(home) < 40'000.0 ? 1.0 : 0.0};
    glm::dvec2 const shadowCorner = shadow_->corner - glm::dvec2{camera.x, -camera.z};
    block.shadow = glm::vec4{shadowCorner, 1.0 / terrain::kShadowWidth, 1.0};
    block_.update(gl::bytesOf(block));
}

void LandScene::bind() const {
    block_.bindUniform(6);
    shadowTexture_.bind(1);
}

void LandScene::draw(terrain::DrawnChunk const& chunk, gl::Program const& program, glm::dvec3 const& camera) const {
    ChunkTexture const& entry = textures_.at(chunk.key);
    glm::dvec2 const corner = chunk.key.corner();
    double const cell = chunk.key.size() / kChunkCells, range = terrain::levelRange(chunk.key.level);
    bool const top = chunk.key.level == terrain::kTopLevel;
    double const begin = top ? 1.0e9 : terrain::kMorphBegin * range, end = top ? 2.0e9 : range;
    entry.texture.bind(0);
    program.set("chunkPlace", glm::vec4{corner.x - camera.x, corner.y + camera.z, cell, 1.0 / streamer_->options().step});
    program.set("chunkOrigin", glm::ivec4{glm::ivec2{corner}, mesh_->stride, static_cast<int>(chunk.coarserSides)});
    program.set("chunkMorph", glm::vec4{begin, 1.0 / (end - begin), 1.0 / entry.texture.size().x, 0.0});
    for (unsigned quarter = 0; quarter < 4;) {  // runs of neighbouring quarters in one draw
        if (!(chunk.quarters >> quarter & 1u)) {
            ++quarter;
            continue;
        }
        unsigned last = quarter;
        while (last < 3 && (chunk.quarters >> (last + 1) & 1u)) ++last;
        auto const count = static_cast<int>(last - quarter + 1) * mesh_->indicesPerQuarter;
        gl::drawElements(mesh_->array, gl::Primitive::triangles, count, quarter * static_cast<std::size_t>(mesh_->indicesPerQuarter));
        quarter = last + 1;
    }
}

terrain::StreamerStats LandScene::stats() const { return streamer_ ? streamer_->stats() : terrain::StreamerStats{}; }
}  // namespace luftpost::render
