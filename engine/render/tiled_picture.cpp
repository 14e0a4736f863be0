#include "engine/render/tiled_picture.h"

#include <algorithm>
#include <chrono>
#include <utility>

namespace luftpost::render {
TiledPicture::TiledPicture(Renderer& renderer, Snapshot snapshot, glm::ivec2 const& size, std::filesystem::path const& file)
    : renderer_{renderer},
      snapshot_{std::move(snapshot)},
      file_{file},
      linear_{file.extension() == ".exr"},
      writer_{file, size.x, size.y},
      tiles_{tilesOf(size, kTileSide)} {}

TiledPicture::~TiledPicture() = default;

void TiledPicture::step() {
    if (next_ < tiles_.size()) {
        Tile const& tile = tiles_[next_++];
        renderer_.drawTile(snapshot_, tile);
        if (linear_) return keep(linearBand_, renderer_.readTileHdr(), tile);
        return keep(band_, renderer_.readTilePixels(), tile);
    }
    if (finished_ || !written()) return;
    writing_.get();
    finished_ = true;
}

void TiledPicture::finish() {
    while (next_ < tiles_.size()) step();
    writing_.wait();
    step();
}

/// Puts the tile's pixels into its row's band; the last one of a row hands the band over.
template <class Band>
void TiledPicture::keep(Band& band, Band const& part, Tile const& tile) {
    if (tile.corner.x == 0) {
        band = {tile.picture.x, tile.size.y, 4, {}};
        band.values.resize(band.index(0, band.height, 0));
    }
    for (int y = 0; y < part.height; ++y)
        std::copy_n(part.values.begin() + static_cast<std::ptrdiff_t>(part.index(0, y, 0)), 4 * part.width,
                    band.values.begin() + static_cast<std::ptrdiff_t>(band.index(tile.corner.x, y, 0)));
    if (tile.corner.x + tile.size.x == tile.picture.x) hand(band);
}

template <class Band>
void TiledPicture::hand(Band& band) {
    if (writing_.valid()) writing_.get();
    bool const last = next_ == tiles_.size();
    writing_ = std::async(std::launch::async, [this, last, rows = std::move(band)] {
        writer_.add(rows);
        if (last) writer_.finish();
    });
    band = {};
}

bool TiledPicture::written() const { return writing_.wait_for(std::chrono::seconds{0}) == std::future_status::ready; }
}  // namespace luftpost::render
