// Draws snapshots: the passes and their order. GL thread only.
#pragma once
#include <cstddef>
#include <filesystem>
#include <functional>
#include <memory>
#include <string>
#include <vector>

#include <glm/glm.hpp>

#include "engine/assets/image.h"
#include "engine/render/snapshot.h"
#include "engine/render/tile.h"
#include "engine/terrain/streamer.h"

namespace luftpost::assets {
struct Model;
}
namespace luftpost::gl {
class ProgramLibrary;
}

namespace luftpost::render {
struct RendererOptions {
    glm::ivec2 size{1280, 720};    // of the finished picture, pixels
    int workers = 1;               // threads that make chunks of land
    bool hotReload = false;        // look for changed shaders once a second
    std::function<void(std::size_t ready, std::size_t all)> progress{};  // of the shaders, while they are compiled
};

/// What one pass took, in the order of drawing. Filled when timing is on.
struct PassTime {
    std::string name;
    double milliseconds = 0.0;
};

class Renderer {
public:
    /// The context must be current and prepared (gl::prepareContext). Throws core::Error when a shader or a file of the
    /// data does not load.
    explicit Renderer(RendererOptions const& options);
    ~Renderer();
    Renderer(Renderer const&) = delete;
    Renderer& operator=(Renderer const&) = delete;

    /// A model of the data by name ("plane": assets/models/plane.glb), loaded once. Throws core::Error.
    ModelId loadModel(std::string const& name);
    /// A model made in the program (parametric meshes).
    ModelId addModel(assets::Model const& model);

    /// A new size of the finished picture; nothing when it is the same.
    void resize(glm::ivec2 const& size);
    glm::ivec2 size() const;

    /// Draws the whole picture into the renderer's own target.
    void draw(Snapshot const& snapshot);
    /// Puts the snapshot's menus over the picture that `draw` drew last, in place of those it had.
    void drawMenus(Snapshot const& snapshot);
    /// Draws a part of a still that is too large to be drawn at once, into targets of its own. Its exposure, glow and tables of light are those
    /// of the picture that `draw` drew last: the same snapshot at any size.
    void drawTile(Snapshot const& snapshot, Tile const& tile);

    /// Copies the finished picture to the window's framebuffer of `windowSize` pixels.
    void present(glm::ivec2 const& windowSize);

    /// The finished picture: RGBA, tone-mapped, sRGB, with the menus, alpha 255.
    assets::Image readPixels();
    /// The HDR picture before tone map and menus, preExposure divided out: R, G, B, A = 1 - transmittance of the clouds
    /// (0 outside a dome, with black).
    assets::FloatImage readHdr();
    /// The same of the latest tile.
    assets::Image readTilePixels();
    assets::FloatImage readTileHdr();

    /// Timing of passes by a pair of timestamps around each; on software GL also a glFinish before each, since the
    /// driver otherwise works later than it says. Slows the frame; off at first.
    void setTiming(bool on);
    /// Of the latest draw; empty when timing is off.
    std::vector<PassTime> const& passTimes() const;

    /// The chunks of land made, kept and forgotten so far.
    terrain::StreamerStats chunkStats() const;
    /// GPU bytes of noise volumes and cloud map, screen-sized buffers apart.
    std::size_t cloudBytes() const;
    /// GPU bytes of all that the sky needs: its tables, the clouds' volumes, maps, shadow and grids, and what they keep of each pixel.
    std::size_t skyBytes() const;

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};
}  // namespace luftpost::render
