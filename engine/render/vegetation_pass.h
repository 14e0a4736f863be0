// Draws trees near the camera. Farther off the land's colour shows the woods as a canopy.
#pragma once
#include "engine/core/lru_cache.h"
#include "engine/gl/program_library.h"
#include "engine/render/land_scene.h"
#include "engine/terrain/vegetation.h"

namespace luftpost::render {
class VegetationPass {
public:
    /// Throws core::Error when its shaders do not load.
    explicit VegetationPass(gl::ProgramLibrary& programs);
    /// After the land. Makes a few missing tiles a frame, a still all of them.
    void draw(FrameContext const& context, LandScene const& scene);

private:
    struct Tile {
        int count = 0;
        gl::Buffer trees;
        gl::VertexArray array;
    };
    Tile const* tile(terrain::Land const& land, terrain::TreeTileKey key, int& budget);

    gl::Program const& program_;
    unsigned seed_ = 0;
    double base_ = 0.0;
    core::LruCache<terrain::TreeTileKey, Tile, terrain::TreeTileHash> tiles_{6u << 20};  // woods all round take 4.5 MB
};
}  // namespace luftpost::render
