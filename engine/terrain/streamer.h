// Streams chunks: workers make what the camera wants, a cache bounded in bytes keeps it, and each frame learns what to draw.
#pragma once
#include <cstddef>
#include <cstdint>
#include <deque>
#include <memory>
#include <mutex>
#include <unordered_map>
#include <vector>

#include "engine/core/jobs.h"
#include "engine/core/lru_cache.h"
#include "engine/terrain/level_choice.h"

namespace luftpost::terrain {
struct StreamerOptions {
    int workers = 1;
    std::size_t capBytes = 160'000'000;              // of all chunks, those being made included
    int step = 1;                                    // every step-th of the 240 cells' vertices is sampled
    std::size_t bytesPerUpdate = 8u << 20;           // upload budget of one frame; at least one chunk passes
};

/// What a frame draws and what its owner of textures must do first, in this order: forget `dropped`, take in `fresh`.
struct DrawList {
    std::vector<DrawnChunk> chunks;                    // near ones first
    std::vector<std::shared_ptr<Chunk const>> fresh;   // newly made: their samples are held by nobody else
    std::vector<ChunkKey> dropped;
    bool whole = true;                                 // else the view has jumped: call finishKept before drawing
    double aboveGround = 0.0;                          // m, of levelDistance for this frame
};

struct StreamerStats {
    std::uint64_t made = 0, evicted = 0;
    std::size_t cached = 0;      // chunks
    std::size_t peakBytes = 0;   // never above the cap
};

/// One thread calls; no GL, so it works with --no-render too. The flight does not depend on it: wheels ask Land.
class Streamer {
public:
    /// `land` outlives the streamer.
    Streamer(Land const& land, StreamerOptions const& options);
    Streamer(Land const& land, int workers, std::size_t capBytes) : Streamer{land, options(workers, capBytes)} {}

    /// Takes in what workers made, asks them for what `view` lacks, forgets what it no longer wants. Never waits.
    DrawList update(CameraView const& view);
    /// The same, but waits (and works) until everything `view` shows is there: stills, screenshots.
    DrawList finish(CameraView const& view) { return finish(view, false); }
    /// Waits for what `view` shows and for what is kept all round: the first frame, a jump.
    DrawList finishKept(CameraView const& view) { return finish(view, true); }

    StreamerStats stats() const;
    StreamerOptions const& options() const { return options_; }

private:
    struct Made {
        std::mutex mutex;
        std::deque<std::shared_ptr<Chunk const>> chunks;
    };
    static StreamerOptions options(int workers, std::size_t capBytes);
    void takeIn(DrawList& list, std::size_t budget);
    enum class Ask { all, shown, shownAndKept };
    static bool asks(Ask ask, Wanted const& chunk);
    void request(std::vector<Wanted> const& wanted, Ask ask);
    DrawList finish(CameraView const& view, bool residents);
    HeightBounds bounds(ChunkKey key) const;
    std::vector<Wanted> wanted(CameraView const& view, double aboveGround);
    DrawList updateWithin(CameraView const& view, std::size_t budget, Ask ask, bool& complete);

    Land const& land_;
    StreamerOptions options_;
    std::size_t bytesEach_;
    std::size_t mostInFlight_;  // chunks asked for and not yet taken in
    core::LruCache<ChunkKey, HeightBounds, ChunkHash> cache_;
    std::unordered_map<ChunkKey, core::Jobs::Ticket, ChunkHash> inFlight_;
    Made made_;
    std::uint64_t taken_ = 0;
    std::size_t peakBytes_ = 0;
    core::Jobs jobs_;  // last: its workers end before what they write to
};
}  // namespace luftpost::terrain
