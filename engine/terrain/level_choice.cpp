#include "engine/terrain/level_choice.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <unordered_map>

#include "engine/core/frames.h"

namespace luftpost::terrain {
namespace {
constexpr double kHighestRange = 3600.0;  // m above the water: no land stands higher

// Chunks this near, in their sides, are kept at every level.
constexpr double kUnderfoot = 0.25;

/// m on the flat map from the camera to the nearest point of the chunk's square.
double nearestAcross(ChunkKey key, glm::dvec2 camera) {
    glm::dvec2 const corner = key.corner();
    glm::dvec2 const outside = glm::max(glm::max(corner - camera, camera - corner - key.size()), glm::dvec2{0.0});
    return glm::length(outside);
}

/// The picture's pyramid, its planes through the camera with normals inward.
class Frustum {
public:
    explicit Frustum(CameraView const& view) : view_{view} {
        glm::dvec3 const right = glm::cross(view.forward, view.up);
        planes_ = {glm::normalize(view.forward * view.tanHalfWidth + right), glm::normalize(view.forward * view.tanHalfWidth - right),
                   glm::normalize(view.forward * view.tanHalfHeight + view.up), glm::normalize(view.forward * view.tanHalfHeight - view.up)};
    }

    /// May the chunk, bent round the Earth, show in the picture? Errs on the side of yes.
    bool mayShow(ChunkKey key, HeightBounds const& bounds) const {
        if (view_.allRound) return true;
        double const half = 0.5 * key.size();
        glm::dvec2 const centre = key.corner() + half;
        glm::dvec2 const offset{centre.x - view_.positionWorld.x, -centre.y - view_.positionWorld.z};
        double const across = glm::length(offset), middle = 0.5 * (bounds.lowest + bounds.highest);
        double const arc = across / core::kEarthRadius;
        double const r = core::kEarthRadius + middle;
        double const stretch = across > 1.0 ? r * std::sin(arc) / across : 1.0;
        double const drop = 2.0 * r * std::sin(0.5 * arc) * std::sin(0.5 * arc);
        glm::dvec3 const bent{offset.x * stretch, middle - view_.positionWorld.y - drop, offset.y * stretch};
        double const sagitta = half * half / core::kEarthRadius;
        double const radius = std::hypot(half * 1.4142136 * 1.01, 0.5 * (bounds.highest - bounds.lowest) + sagitta);
        return std::all_of(planes_.begin(), planes_.end(), [&](glm::dvec3 const& plane) { return glm::dot(plane, bent) > -radius; });
    }

private:
    CameraView const& view_;
    std::array<glm::dvec3, 4> planes_;
};

class WantedSearch {
public:
    WantedSearch(CameraView const& view, double aboveGround, BoundsFunction const& bounds)
        : camera_{view.positionWorld.x, -view.positionWorld.z}, aboveGround_{aboveGround}, bounds_{bounds}, frustum_{view} {}

    std::vector<Wanted> from(double farthest) {
        double const size = chunkSize(kTopLevel);
        auto const first = glm::ivec2{glm::floor((camera_ - farthest) / size)}, last = glm::ivec2{glm::floor((camera_ + farthest) / size)};
        for (int y = first.y; y <= last.y; ++y)
            for (int x = first.x; x <= last.x; ++x) {
                ChunkKey const key{kTopLevel, x, y};
                if (nearestAcross(key, camera_) <= farthest) visit(key, true);
            }
        return std::move(found_);
    }

private:
    void visit(ChunkKey key, bool parentInView) {
        double const across = nearestAcross(key, camera_), distance = levelDistance(across, aboveGround_);
        if (key.level < kTopLevel && distance >= levelRange(key.level)) return;
        bool const inView = parentInView && frustum_.mayShow(key, bounds_(key));
        bool const near = across < kUnderfoot * key.size();
        found_.push_back({key, inView, near, near || key.level >= kResidentLevel, distance});
        if (key.level == 0) return;
        for (int quarter = 0; quarter < 4; ++quarter)
            visit({key.level - 1, 2 * key.x + (quarter & 1), 2 * key.y + (quarter >> 1)}, inView);
    }

    glm::dvec2 camera_;
    double aboveGround_;
    BoundsFunction const& bounds_;
    Frustum frustum_;
    std::vector<Wanted> found_;
};
}  // namespace

double levelDistance(double across, double aboveGround) { return std::sqrt(across * across + aboveGround * aboveGround); }

double farthestLand(double cameraAboveWater) {
    double const camera = std::max(cameraAboveWater, 2.0);
    return std::sqrt(2.0 * core::kEarthRadius * camera) + std::sqrt(2.0 * core::kEarthRadius * kHighestRange);
}

std::vector<Wanted> wantedChunks(CameraView const& view, double aboveGround, double waterLevel, BoundsFunction const& bounds) {
    std::vector<Wanted> wanted = WantedSearch{view, aboveGround, bounds}.from(farthestLand(view.positionWorld.y - waterLevel));
    auto const before = [](Wanted const& a, Wanted const& b) {
        if (a.kept != b.kept) return a.kept;
        if (!a.kept && a.inView != b.inView) return a.inView;
        if (a.key.level != b.key.level) return a.key.level > b.key.level;
        return a.distance < b.distance;
    };
    std::stable_sort(wanted.begin(), wanted.end(), before);
    return wanted;
}

std::vector<DrawnChunk> drawnChunks(std::vector<Wanted> const& wanted, std::function<bool(ChunkKey)> const& ready) {
    struct State {
        bool inView = false, drawn = false;
        unsigned takenQuarters = 0;
    };
    std::unordered_map<ChunkKey, State, ChunkHash> states;
    std::array<std::vector<ChunkKey>, kTopLevel + 1> levels;
    for (Wanted const& chunk : wanted) {
        states[chunk.key].inView = chunk.inView;
        if (chunk.inView) levels[static_cast<std::size_t>(chunk.key.level)].push_back(chunk.key);
    }
    for (Wanted const& chunk : wanted)  // nobody need draw a quarter that cannot be seen
        if (!chunk.inView && chunk.key.level < kTopLevel) states[chunk.key.parent()].takenQuarters |= 1u << chunk.key.quarter();
    auto const drawn = [&](ChunkKey key) {
        auto const found = states.find(key);
        return found != states.end() && found->second.drawn;
    };
    // The parent of a neighbour must be drawn, unless nothing of that neighbour can be seen.
    auto const neighbourAllows = [&](ChunkKey neighbour) {
        auto const found = states.find(neighbour.parent());
        return found == states.end() || !found->second.inView || found->second.drawn;
    };
    for (int level = kTopLevel; level >= 0; --level)
        for (ChunkKey const& key : levels[static_cast<std::size_t>(level)]) {
            if (!ready(key)) continue;
            bool allowed = level == kTopLevel || drawn(key.parent());
            for (int dy = -1; dy <= 1 && allowed && level < kTopLevel; ++dy)
                for (int dx = -1; dx <= 1 && allowed; ++dx) allowed = neighbourAllows({level, key.x + dx, key.y + dy});
            if (!allowed) continue;
            states[key].drawn = true;
            if (level < kTopLevel) states[key.parent()].takenQuarters |= 1u << key.quarter();
        }
    std::vector<DrawnChunk> result;
    for (int level = 0; level <= kTopLevel; ++level)  // near chunks first: they hide what is behind them
        for (ChunkKey const& key : levels[static_cast<std::size_t>(level)]) {
            State const& state = states[key];
            if (!state.drawn || state.takenQuarters == 0xf) continue;
            auto const coarser = [&](int dx, int dy) { return level < kTopLevel && !drawn({level, key.x + dx, key.y + dy}); };
            result.push_back({key, 0xfu & ~state.takenQuarters,
                              (coarser(-1, 0) ? 1u : 0u) | (coarser(1, 0) ? 2u : 0u) | (coarser(0, -1) ? 4u : 0u) | (coarser(0, 1) ? 8u : 0u)});
        }
    return result;
}
}  // namespace luftpost::terrain
