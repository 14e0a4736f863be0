// Which chunks a camera needs and which are drawn: a world-aligned quadtree whose levels change with distance (CDLOD).
// A level-L chunk is wanted where its square comes nearer than range(L); a quarter without a finer chunk is drawn by its
// parent. Over the last fifth of range(L) level L turns into level L + 1, so that levels meet exactly and nothing pops.
#pragma once
#include <functional>
#include <vector>

#include "engine/terrain/chunk.h"

namespace luftpost::terrain {
/// range(L) in sides of a chunk. Level L reaches out to range(L) + its own diagonal and must end before level L + 1
/// begins to change at 0.8 range(L + 1): 1.6 k >= k + sqrt(2).
inline constexpr double kRangeInChunks = 2.4;
inline constexpr double kMorphBegin = 0.8;  // of a level's range
inline double levelRange(int level) { return kRangeInChunks * chunkSize(level); }

/// Who looks. Directions are the world's.
struct CameraView {
    glm::dvec3 positionWorld{0.0};
    glm::dvec3 forward{0.0, 0.0, -1.0}, up{0.0, 1.0, 0.0};  // unit, at right angles
    double tanHalfWidth = 0.77, tanHalfHeight = 0.43;       // of the picture
    bool allRound = false;                                  // panorama, dome: everything is in view
};

/// The distance by which levels are chosen and vertices move, from the camera to a point `across` metres away on the
/// flat map. `aboveGround`: the camera's height over the land below it, so that little detail is made under a high flight.
double levelDistance(double across, double aboveGround);

/// The farthest land that can stand above the horizon, m on the flat map.
double farthestLand(double cameraAboveWater);

/// A chunk to draw: the quarters of it that no finer chunk covers, and the sides where the neighbour is coarser.
struct DrawnChunk {
    ChunkKey key;
    unsigned quarters = 0xf;      // bit q: quarter q (ChunkKey::quarter)
    unsigned coarserSides = 0;    // bits: 1 west, 2 east, 4 south, 8 north: vertices there lie on the coarser mesh
};

struct Wanted {
    ChunkKey key;
    bool inView = false;
    bool near = false;            // under a low camera, which must not find itself below a coarser mesh
    bool kept = false;            // needed whatever the view: resident or near
    double distance = 0.0;        // m, levelDistance of its nearest point
};

/// Lowest and highest land of a chunk, or of the nearest ancestor that is known, widened for what that cannot tell.
struct HeightBounds {
    double lowest = 0.0, highest = 0.0;
};
using BoundsFunction = std::function<HeightBounds(ChunkKey)>;

/// All chunks the camera wants, most urgent first: those kept all round, then those in view from coarse to fine and
/// near to far, then those out of view likewise.
std::vector<Wanted> wantedChunks(CameraView const& view, double aboveGround, double waterLevel, BoundsFunction const& bounds);

/// The chunks to draw of those wanted and ready: a chunk whose parent is drawn takes that quarter over when it is ready
/// and no visible neighbour would then lie two levels above it.
std::vector<DrawnChunk> drawnChunks(std::vector<Wanted> const& wanted, std::function<bool(ChunkKey)> const& ready);
}  // namespace luftpost::terrain
