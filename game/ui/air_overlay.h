// The air made visible: winds at several heights and where it rises and sinks, asked of the same air that carries the aircraft.
// The probe remembers and asks only a few points a frame; the drawing takes plain data. Main thread.
#pragma once
#include <span>
#include <vector>

#include <glm/glm.hpp>

#include "engine/core/environment.h"
#include "game/ui/camera.h"

namespace luftpost::ui {
struct WindLevel {
    double height = 0.0;      // m above the ground under the aircraft
    double altitude = 0.0;    // m above sea level
    glm::dvec2 wind{0.0};     // m/s, east and north, where the air goes to
};

/// Rising air at one point of the map, averaged over the last few seconds that it was asked.
struct LiftPoint {
    glm::dvec2 eastNorth{0.0};  // m
    double up = 0.0;            // m/s
};

/// Where the aircraft is. Angles in radians.
struct AirSubject {
    glm::dvec3 positionWorld{0.0};
    double heading = 0.0;  // clockwise from north
};

class AirProbe {
public:
    static constexpr double kCell = 250.0;       // m between points, on a lattice that stands still in the world
    static constexpr int kCells = 22;            // points in a row
    static constexpr int kAskedPerFrame = 32;    // points of the map; the winds add kHeights, one a frame
    static constexpr double kAhead = 2000.0;     // m from the aircraft to the middle of the map
    static constexpr double kHeights[] = {10.0, 100.0, 300.0, 600.0, 1000.0, 1500.0, 2000.0, 3000.0};  // m above ground

    /// Moves the map with the aircraft and asks the next points at the aircraft's altitude. Cells that come in are empty until asked.
    void update(core::AirFunction const& air, core::GroundFunction const& ground, AirSubject const& subject, core::UtcSeconds time);
    std::span<WindLevel const> winds() const { return winds_; }
    /// Those asked so far that still lie in the map.
    std::vector<LiftPoint> lift() const;

private:
    struct Cell {
        glm::ivec2 at{INT32_MIN};  // which point of the lattice this one holds
        double up = 0.0;
        double altitude = 0.0;     // at which it was asked
        int asked = 0;
    };
    Cell& cellOf(glm::ivec2 at);

    std::vector<Cell> cells_ = std::vector<Cell>(kCells * kCells);
    std::vector<WindLevel> winds_;
    glm::ivec2 corner_{0};
    int next_ = 0, nextHeight_ = 0;
};

struct AirView {
    AirSubject subject;
    std::vector<WindLevel> winds;
    std::vector<LiftPoint> lift;
    CameraPose camera;
};

/// Arrows in the picture, the ladder of winds at the left edge, the map of lift at the right edge, with their units.
void drawAirOverlay(AirView const& view);
}  // namespace luftpost::ui
