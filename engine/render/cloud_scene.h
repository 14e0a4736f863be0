// The clouds of the frame on the GPU: noise volumes, the cloud map, the block that every pass of the clouds reads.
#pragma once
#include <array>
#include <optional>

#include "engine/gl/buffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/sampler.h"
#include "engine/gl/texture.h"
#include "engine/render/ray_blocks.h"
#include "engine/render/snapshot.h"
#include "engine/weather/cloud_map.h"
#include "shaders/shared/cloud.glsl.h"

namespace luftpost::render {
/// GL thread only. About 9 MB of textures: volumes 2.6 MB, map 6.3 MB.
class CloudScene {
public:
    /// Loads the volumes that the build made; throws core::Error when they are missing.
    explicit CloudScene(gl::ProgramLibrary& programs);

    /// Asks for the map's tiles, uploads what is done (a still waits for all), fills the block. `frameNumber` moves the
    /// rays of the blocks.
    void update(Snapshot const& snapshot, std::uint64_t frameNumber);
    /// Binds block, volumes and map for the passes that include lib/cloud_scene.glsl.
    void bind() const;

    /// Of volumes and map.
    std::size_t bytes() const { return shape_.bytes() + detail_.bytes() + curl_.bytes() + map_.bytes(); }
    /// The weather's clock has gone so far since the frame before that nothing seen then is worth keeping.
    bool leapt() const { return leapt_; }
    bool empty() const { return block_.march.x == 0; }
    /// A layer around the camera has towers and an anvil.
    bool hasTowers() const;
    glsl::CloudBlock const& block() const { return block_; }
    /// Sets where the shadow map lies; update() leaves it as it is.
    void setShadowPlace(glm::vec4 const& place) { block_.shadowPlace = place; }
    /// Sets where the grids of optical depth lie (CloudBlock::depthPlaces, depthHeights); update() leaves them as they are.
    void setDepthPlaces(std::array<glm::vec4, 2> const& places, glm::vec4 const& heights) {
        block_.depthPlaces[0] = places[0];
        block_.depthPlaces[1] = places[1];
        block_.depthHeights = heights;
    }
    /// Uploads the block; after update() and the places of shadow and depths.
    void upload() { buffer_.update(gl::bytesOf(block_)); }

private:
    struct Slice {
        std::optional<weather::MapKey> key;
        glm::dvec2 corner{0.0};
    };

    void loadVolumes();
    void remakeVolumes(unsigned seed);
    void assignSlots(weather::Weather const& weather);
    void takeTiles(int budget);
    void placeMaps(Snapshot const& snapshot, weather::Weather const& sky);
    void fillMarch(Snapshot const& snapshot, std::uint64_t frameNumber);

    gl::ProgramLibrary& programs_;
    gl::Texture3D shape_, detail_;
    gl::Texture2D curl_;
    gl::Texture2DArray map_;
    gl::Sampler repeat_, clamp_;
    gl::Buffer buffer_;
    glsl::CloudBlock block_{};
    weather::CloudMap tiles_;
    weather::MapLayers slots_{};
    std::array<int, weather::kMaxLayers> slotOfLayer_{};
    std::array<std::array<Slice, weather::kMapLevels>, weather::kMaxLayers> slices_{};
    int noiseSeed_ = 0;
    RayBlocks blocks_;
    std::optional<core::UtcSeconds> weatherBefore_;  // the weather's clock of the frame before
    bool leapt_ = false;
};
}  // namespace luftpost::render
