// A still of any size, drawn tile by tile and written band by band. GL thread; a thread of its own writes.
#pragma once
#include <filesystem>
#include <future>
#include <vector>

#include "engine/assets/image.h"
#include "engine/render/renderer.h"

namespace luftpost::render {
/// What it keeps in memory is the band in the making and the one that is being written: two rows of tiles.
class TiledPicture {
public:
    static constexpr int kTileSide = 512;  // pixels: so many are drawn at once

    /// `renderer` outlives it and has drawn `snapshot`, a still without menus, as a whole at any size: exposure and glow are that picture's. What the
    /// snapshot points to stays. The file's ending is .png (as shown) or .exr (scene-linear). Throws core::Error when the file cannot be made.
    TiledPicture(Renderer& renderer, Snapshot snapshot, glm::ivec2 const& size, std::filesystem::path const& file);
    ~TiledPicture();
    TiledPicture(TiledPicture const&) = delete;
    TiledPicture& operator=(TiledPicture const&) = delete;

    /// Draws the next tile; with the last one of a row the row goes to the writing thread. After the last tile: looks whether all is written.
    /// Throws core::Error when the disk refuses.
    void step();
    /// All that is left; waits for the disk. Throws as `step` does.
    void finish();
    /// Everything is on the disk.
    bool finished() const { return finished_; }
    /// Of the tiles, those that are drawn: 0..1.
    double share() const { return static_cast<double>(next_) / static_cast<double>(tiles_.size()); }
    std::filesystem::path const& file() const { return file_; }

private:
    template <class Band>
    void keep(Band& band, Band const& part, Tile const& tile);
    template <class Band>
    void hand(Band& band);
    bool written() const;

    Renderer& renderer_;
    Snapshot snapshot_;
    std::filesystem::path file_;
    bool linear_;
    assets::ImageWriter writer_;
    std::vector<Tile> tiles_;
    std::size_t next_ = 0;
    assets::Image band_;
    assets::FloatImage linearBand_;
    std::future<void> writing_;  // the last member: it is waited for before anything else goes
    bool finished_ = false;
};
}  // namespace luftpost::render
