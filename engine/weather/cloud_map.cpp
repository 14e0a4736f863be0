#include "engine/weather/cloud_map.h"

#include <algorithm>
#include <cmath>
#include <condition_variable>
#include <deque>
#include <mutex>
#include <thread>

#include "engine/weather/cloud_pattern.h"

namespace luftpost::weather {
namespace {
constexpr int kPlaceSteps = 16;                                      // a tile is made anew after 1/16 of its width
constexpr std::array<double, kMapLevels> kMoment{0.01, 0.03, 0.15};  // h, how stale a level may be

double texelSize(int level) { return kMapWidths[static_cast<std::size_t>(level)] / kMapSize; }
double placeStep(int level) { return kMapWidths[static_cast<std::size_t>(level)] / kPlaceSteps; }
}  // namespace

MapKey mapKey(Layer const& layer, int level, glm::dvec2 const& eastNorth, unsigned seed, float scale) {
    auto const index = static_cast<std::size_t>(level);
    glm::dvec2 const centre{eastNorth.x - layer.drift.x, layer.drift.y - eastNorth.y};
    glm::dvec2 const corner = (centre - 0.5 * kMapWidths[index]) / placeStep(level);
    return {layer.genus, layer.pattern, seed, level, glm::ivec2{glm::floor(corner + 0.5)},
            static_cast<int>(std::floor(layer.phase / kMoment[index] + 0.5)), scale};
}

MapTile makeTile(MapKey const& key) {
    Layer layer;
    layer.genus = key.genus;
    layer.pattern = key.pattern;
    layer.phase = key.moment * kMoment[static_cast<std::size_t>(key.level)];
    LayerPattern const pattern{layer, key.seed, key.level == kMapLevels - 1 ? PatternDetail::Coarse : PatternDetail::Whole};
    MapTile tile;
    tile.corner = glm::dvec2{key.place} * placeStep(key.level);
    tile.ranks.resize(static_cast<std::size_t>(kMapSize) * kMapSize);
    double const scale = static_cast<double>(key.scale);
    std::array<double, kMapSize> east, north;
    std::array<float, kMapSize> ranks;
    for (std::size_t x = 0; x < kMapSize; ++x)
        east[x] = (tile.corner.x + (static_cast<double>(x) + 0.5) * texelSize(key.level)) / scale;
    for (std::size_t y = 0; y < kMapSize; ++y) {
        north.fill(-(tile.corner.y + (static_cast<double>(y) + 0.5) * texelSize(key.level)) / scale);
        pattern.drifting(east, north, ranks);
        for (std::size_t x = 0; x < kMapSize; ++x)
            tile.ranks[y * kMapSize + x] = static_cast<std::uint16_t>(ranks[x] * 65535.0f + 0.5f);
    }
    return tile;
}

/// Tiles in hand: wanted, in the making, done. Guarded by one mutex; the work itself is done outside of it.
struct CloudMap::State {
    struct Slot {
        std::optional<MapKey> wanted, have;  // have: made, or in the making
    };
    std::mutex mutex;
    std::condition_variable_any changed;
    std::array<std::array<Slot, kMapLevels>, kMaxLayers> slots;
    std::deque<Ready> done;
    int inHand = 0;
    std::vector<std::jthread> workers;

    bool next(int& layer, int& level) {
        for (level = 0; level < kMapLevels; ++level)
            for (layer = 0; layer < kMaxLayers; ++layer) {
                Slot const& slot = slots[static_cast<std::size_t>(layer)][static_cast<std::size_t>(level)];
                if (slot.wanted && slot.wanted != slot.have) return true;
            }
        return false;
    }

    void work(std::stop_token const& stop) {
        std::unique_lock lock{mutex};
        int layer = 0, level = 0;
        while (changed.wait(lock, stop, [&] { return next(layer, level); })) {
            Slot& slot = slots[static_cast<std::size_t>(layer)][static_cast<std::size_t>(level)];
            MapKey const key = *slot.wanted;
            slot.have = key;
            ++inHand;
            lock.unlock();
            MapTile tile = makeTile(key);
            lock.lock();
            --inHand;
            if (slot.wanted == key) done.push_back({layer, level, key, std::move(tile)});
            changed.notify_all();
        }
    }
};

CloudMap::CloudMap(int workers) : state_{std::make_unique<State>()} {
    for (int i = 0; i < std::max(workers, 1); ++i)
        state_->workers.emplace_back([state = state_.get()](std::stop_token const& stop) { state->work(stop); });
}

CloudMap::~CloudMap() {
    for (std::jthread& worker : state_->workers) worker.request_stop();
    state_->workers.clear();
}

void CloudMap::want(MapLayers const& layers, glm::dvec2 const& eastNorth, unsigned seed, float scale, bool wait) {
    std::unique_lock lock{state_->mutex};
    for (std::size_t i = 0; i < layers.size(); ++i)
        for (int level = 0; level < kMapLevels; ++level) {
            State::Slot& slot = state_->slots[i][static_cast<std::size_t>(level)];
            if (layers[i]) slot.wanted = mapKey(*layers[i], level, eastNorth, seed, scale);
            else slot = {};
        }
    state_->changed.notify_all();
    int layer = 0, level = 0;
    if (wait) state_->changed.wait(lock, [&] { return state_->inHand == 0 && !state_->next(layer, level); });
}

std::optional<CloudMap::Ready> CloudMap::take() {
    std::lock_guard lock{state_->mutex};
    if (state_->done.empty()) return std::nullopt;
    Ready ready = std::move(state_->done.front());
    state_->done.pop_front();
    return ready;
}
}  // namespace luftpost::weather
