#include "engine/terrain/streamer.h"

#include <algorithm>
#include <limits>
#include <unordered_set>

#include "engine/core/check.h"

namespace luftpost::terrain {
namespace {
constexpr int kWholeLevel = 3;  // of near chunks down to 3.84 km none may miss: a flight has asked for them long before
constexpr std::size_t kInFlightBytes = 12'000'000;  // enough that workers do not starve between slow frames

std::size_t mostInFlight(StreamerOptions const& options, std::size_t bytesEach) {
    return std::max(static_cast<std::size_t>(options.workers) + 1, kInFlightBytes / bytesEach);
}
}  // namespace

StreamerOptions Streamer::options(int workers, std::size_t capBytes) {
    StreamerOptions options;
    options.workers = workers;
    options.capBytes = capBytes;
    return options;
}

Streamer::Streamer(Land const& land, StreamerOptions const& options)
    : land_{land}, options_{options}, bytesEach_{chunkBytes(kChunkCells / options.step)},
      mostInFlight_{mostInFlight(options, bytesEach_)},
      cache_{options.capBytes - std::min(options.capBytes, mostInFlight_ * bytesEach_)}, jobs_{options.workers} {
    CHECK(cache_.capacity() >= bytesEach_, "a cap of {} bytes holds no chunk of {}", options.capBytes, bytesEach_);
}

HeightBounds Streamer::bounds(ChunkKey key) const {
    for (ChunkKey at = key; at.level <= kTopLevel; at = at.parent())
        if (HeightBounds const* known = cache_.peek(at)) {
            double const slack = at.size() / 100.0;  // what may stand between the samples
            return {known->lowest - slack, known->highest + slack};
        }
    return {land_.waterLevel() - 300.0, land_.waterLevel() + 3700.0};
}

std::vector<Wanted> Streamer::wanted(CameraView const& view, double aboveGround) {
    std::vector<Wanted> all = wantedChunks(view, aboveGround, land_.waterLevel(), [this](ChunkKey key) { return bounds(key); });
    all.resize(std::min(all.size(), cache_.capacity() / bytesEach_));
    for (std::size_t i = all.size(); i-- > 0;) cache_.find(all[i].key);  // the most urgent becomes the most recently used
    return all;
}

// Moves what workers finished into the cache, as far as the frame's budget goes; the rest waits for the next frame.
void Streamer::takeIn(DrawList& list, std::size_t budget) {
    std::lock_guard const lock{made_.mutex};
    for (std::size_t used = 0; !made_.chunks.empty() && (used == 0 || used + bytesEach_ <= budget); used += bytesEach_) {
        std::shared_ptr<Chunk const> const chunk = std::move(made_.chunks.front());
        made_.chunks.pop_front();
        inFlight_.erase(chunk->key);
        ++taken_;
        HeightBounds const heights{static_cast<double>(chunk->lowest), static_cast<double>(chunk->highest)};
        cache_.insert(chunk->key, heights, chunk->bytes(), [&](ChunkKey key, HeightBounds&) {
            list.dropped.push_back(key);
            std::erase_if(list.fresh, [&](auto const& fresh) { return fresh->key == key; });
        });
        list.fresh.push_back(chunk);
    }
}

bool Streamer::asks(Ask ask, Wanted const& chunk) {
    return ask == Ask::all || chunk.inView || (ask == Ask::shownAndKept && chunk.kept);
}

// Keeps the most urgent missing chunks in the workers' queue, and nothing else.
void Streamer::request(std::vector<Wanted> const& all, Ask ask) {
    std::unordered_set<ChunkKey, ChunkHash> missing;
    std::vector<ChunkKey> order;
    for (Wanted const& chunk : all) {
        if (order.size() >= mostInFlight_) break;
        if (!asks(ask, chunk)) continue;
        if (!cache_.contains(chunk.key) && missing.insert(chunk.key).second) order.push_back(chunk.key);
    }
    std::erase_if(inFlight_, [&](auto const& entry) { return !missing.contains(entry.first) && jobs_.cancel(entry.second); });
    for (std::size_t rank = 0; rank < order.size() && inFlight_.size() < mostInFlight_; ++rank) {
        ChunkKey const key = order[rank];
        if (inFlight_.contains(key)) continue;
        inFlight_[key] = jobs_.submit(static_cast<double>(rank), [this, key] {
            auto chunk = std::make_shared<Chunk const>(makeChunk(land_, key, options_.step));
            std::lock_guard const lock{made_.mutex};
            made_.chunks.push_back(std::move(chunk));
        });
    }
    peakBytes_ = std::max(peakBytes_, cache_.bytes() + inFlight_.size() * bytesEach_);
}

DrawList Streamer::updateWithin(CameraView const& view, std::size_t budget, Ask ask, bool& complete) {
    DrawList list;
    takeIn(list, budget);
    double const ground = std::max(land_.height(view.positionWorld.x, -view.positionWorld.z), land_.waterLevel());
    list.aboveGround = std::max(0.0, view.positionWorld.y - ground);
    std::vector<Wanted> const all = wanted(view, list.aboveGround);
    request(all, ask);
    complete = std::all_of(all.begin(), all.end(), [&](Wanted const& chunk) { return !asks(ask == Ask::all ? Ask::shown : ask, chunk) || cache_.contains(chunk.key); });
    list.whole = std::all_of(all.begin(), all.end(), [&](Wanted const& chunk) { return !chunk.near || chunk.key.level < kWholeLevel || cache_.contains(chunk.key); });
    list.chunks = drawnChunks(all, [&](ChunkKey key) { return cache_.contains(key); });
    return list;
}

DrawList Streamer::update(CameraView const& view) {
    if (options_.workers == 0) jobs_.help();
    bool complete = false;
    return updateWithin(view, options_.bytesPerUpdate, Ask::all, complete);
}

DrawList Streamer::finish(CameraView const& view, bool residents) {
    DrawList result;
    for (bool complete = false; !complete;) {
        DrawList next = updateWithin(view, std::numeric_limits<std::size_t>::max() / 2, residents ? Ask::shownAndKept : Ask::shown, complete);
        for (ChunkKey const& key : next.dropped)
            std::erase_if(result.fresh, [&](auto const& chunk) { return chunk->key == key; });
        next.dropped.insert(next.dropped.begin(), result.dropped.begin(), result.dropped.end());
        next.fresh.insert(next.fresh.begin(), result.fresh.begin(), result.fresh.end());
        result = std::move(next);
        if (!complete) jobs_.finish();
    }
    // A chunk dropped and made again on the way stays.
    std::erase_if(result.dropped, [&](ChunkKey const& key) { return cache_.contains(key); });
    return result;
}

StreamerStats Streamer::stats() const { return {taken_, cache_.evicted(), cache_.size(), peakBytes_}; }
}  // namespace luftpost::terrain
