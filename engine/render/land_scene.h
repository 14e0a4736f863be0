// The land as the GPU holds it: chunks' textures, the shared grid meshes, the shadow that land throws on land. The passes
// of land, water and plants draw from it.
#pragma once
#include <array>
#include <memory>
#include <mutex>
#include <optional>
#include <unordered_map>
#include <vector>

#include "engine/gl/buffer.h"
#include "engine/gl/program.h"
#include "engine/gl/sampler.h"
#include "engine/gl/texture.h"
#include "engine/gl/vertex_array.h"
#include "engine/render/frame_context.h"
#include "engine/terrain/shadow_map.h"
#include "engine/terrain/streamer.h"
#include "shaders/shared/terrain.glsl.h"

namespace luftpost::render {
/// One of the six meshes that all chunks share: every `stride`-th vertex of 241 x 241, in four quarters (bit 0 east,
/// bit 1 north), each with its part of the skirt.
struct GridMesh {
    explicit GridMesh(int stride);
    int stride;
    int indicesPerQuarter;
    gl::Buffer vertices, indices;
    gl::VertexArray array;
};

class LandScene {
public:
    /// `workers` make chunks.
    explicit LandScene(int workers);

    /// Brings the land up to the frame: another land when seed or base changed, chunks, uploads within the budget,
    /// the block. A still waits for all that it shows.
    void update(FrameContext const& context);

    /// What there is to draw, near first.
    std::vector<terrain::DrawnChunk> const& chunks() const { return list_.chunks; }
    /// Lowest land of a chunk that is drawn, m above sea level.
    float lowest(terrain::ChunkKey key) const { return textures_.at(key).lowest; }
    /// Draws the chunk with `program` in use, whose shader includes lib/terrain_mesh.glsl.
    void draw(terrain::DrawnChunk const& chunk, gl::Program const& program, glm::dvec3 const& camera) const;
    /// Binds what all land shaders read: the block and the shadow map.
    void bind() const;

    terrain::Land const& land() const { return *land_; }
    double aboveGround() const { return list_.aboveGround; }
    terrain::StreamerStats stats() const;
    int trianglesDrawn() const;

private:
    struct ChunkTexture {
        gl::Texture2D texture;
        float lowest = 0.0f;
    };
    void startOver(Snapshot const& snapshot, int step);
    void take(terrain::DrawList list);
    gl::Texture2D spareTexture(int side);
    void chooseMesh(int budget);
    void updateShadow(Snapshot const& snapshot);
    void takeShadow(terrain::ShadowMap map);
    void fillBlock(FrameContext const& context);

    int workers_;
    std::unique_ptr<terrain::Land> land_;
    std::unique_ptr<terrain::Streamer> streamer_;
    terrain::DrawList list_;
    std::unordered_map<terrain::ChunkKey, ChunkTexture, terrain::ChunkHash> textures_;
    std::vector<gl::Texture2D> spare_;  // of dropped chunks
    std::array<std::unique_ptr<GridMesh>, 6> meshes_;
    GridMesh const* mesh_ = nullptr;
    gl::Buffer block_;

    /// A shadow map in the making, shared with the worker.
    struct Making {
        std::mutex mutex;
        bool busy = false;
        std::optional<terrain::ShadowMap> made;
    };
    gl::Texture2D shadowTexture_;
    std::optional<terrain::ShadowMap> shadow_;  // what the texture holds; its texels are not kept
    std::shared_ptr<Making> making_ = std::make_shared<Making>();
    std::unique_ptr<core::Jobs> shadowJobs_;    // last: ends before what it reads
};

/// How the streamer sees the snapshot's camera.
terrain::CameraView cameraView(Camera const& camera, glm::ivec2 const& size);
}  // namespace luftpost::render
