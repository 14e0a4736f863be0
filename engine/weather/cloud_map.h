// The cloud map: ranks of every layer around the camera as images, for the renderer alone. Three nested levels, each in
// the frame that drifts with its layer and snapped to it, so that a texel means the same place of the pattern for as long
// as it lives, and clouds do not change because one flies. Plain data made on workers; no GL.
#pragma once
#include <array>
#include <cstdint>
#include <memory>
#include <optional>
#include <vector>

#include <glm/glm.hpp>

#include "engine/weather/cloud_settings.h"
#include "engine/weather/weather.h"

namespace luftpost::weather {
inline constexpr int kMapLevels = 3;
inline constexpr int kMapSize = 512;
inline constexpr std::array<double, kMapLevels> kMapWidths{32'000.0, 128'000.0, 768'000.0};  // m

/// One layer at one level: ranks of kMapSize x kMapSize texels, row by row from the north-west corner, 65535 = 1.
struct MapTile {
    glm::dvec2 corner{0.0};  // m, east and south of the layer's drifting frame's origin: outer corner of the first texel
    std::vector<std::uint16_t> ranks;
};

/// What a tile shows; tiles of equal keys are equal.
struct MapKey {
    Genus genus = Genus::Cu;
    unsigned pattern = 0;
    unsigned seed = 1;
    int level = 0;
    glm::ivec2 place{0};   // of the corner, in steps of a sixteenth of the width
    int moment = 0;        // the phase, in steps of the level
    float scale = 1.0f;    // CloudSettings::weatherScale
    bool operator==(MapKey const&) const = default;
};

/// The key of the tile that the layer needs at a level with the camera at `eastNorth` (m, world).
MapKey mapKey(Layer const& layer, int level, glm::dvec2 const& eastNorth, unsigned seed, float scale);

/// The tile of a key: about 15 ms of one core with AVX2. Pure.
MapTile makeTile(MapKey const& key);

/// Layers by slot: a layer keeps its slot as long as it lives, whatever its place in the weather.
using MapLayers = std::array<std::optional<Layer>, kMaxLayers>;

/// Makes tiles in the background and hands them over as they are done. One thread calls; the workers are its own.
class CloudMap {
public:
    explicit CloudMap(int workers);
    ~CloudMap();
    CloudMap(CloudMap const&) = delete;
    CloudMap& operator=(CloudMap const&) = delete;

    struct Ready {
        int slot = 0;
        int level = 0;
        MapKey key;
        MapTile tile;
    };
    /// Says what the camera needs now; inner levels are made first. Cheap, to be called every frame. Tiles that are no
    /// longer wanted are dropped. `wait`: returns when all of them are done (stills).
    void want(MapLayers const& layers, glm::dvec2 const& eastNorth, unsigned seed, float scale, bool wait);
    /// The next tile that is done, if any.
    std::optional<Ready> take();

private:
    struct State;
    std::unique_ptr<State> state_;
};
}  // namespace luftpost::weather
