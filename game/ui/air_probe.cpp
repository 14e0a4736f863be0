#include <algorithm>
#include <cmath>

#include "game/ui/air_overlay.h"

namespace luftpost::ui {
namespace {
constexpr double kNewest = 0.25;         // share of the newest answer in the mean: turbulence averages out
constexpr double kAnotherLevel = 150.0;  // m: a cell asked so far above or below begins anew

glm::ivec2 latticeOf(glm::dvec2 eastNorth) { return glm::ivec2{glm::floor(eastNorth / AirProbe::kCell)}; }
int wrapped(int i) { return (i % AirProbe::kCells + AirProbe::kCells) % AirProbe::kCells; }
}  // namespace

AirProbe::Cell& AirProbe::cellOf(glm::ivec2 at) {
    Cell& cell = cells_[static_cast<std::size_t>(wrapped(at.y) * kCells + wrapped(at.x))];
    if (cell.at != at) cell = {.at = at};
    return cell;
}

void AirProbe::update(core::AirFunction const& air, core::GroundFunction const& ground, AirSubject const& subject, core::UtcSeconds time) {
    glm::dvec2 const here{subject.positionWorld.x, -subject.positionWorld.z};
    glm::dvec2 const ahead{std::sin(subject.heading), std::cos(subject.heading)};
    corner_ = latticeOf(here + kAhead * ahead) - glm::ivec2{kCells / 2};
    double const altitude = subject.positionWorld.y;
    for (int i = 0; i < kAskedPerFrame; ++i, next_ = (next_ + 1) % (kCells * kCells)) {
        glm::ivec2 const at = corner_ + glm::ivec2{next_ % kCells, next_ / kCells};
        Cell& cell = cellOf(at);
        glm::dvec2 const point = (glm::dvec2{at} + 0.5) * kCell;
        if (std::abs(cell.altitude - altitude) > kAnotherLevel) cell.asked = 0;
        double const up = air({point.x, altitude, -point.y}, time).windWorld.y;
        cell.up = cell.asked == 0 ? up : glm::mix(cell.up, up, kNewest);
        cell.altitude = altitude;
        ++cell.asked;
    }
    double const floor = ground(here.x, here.y).height;
    if (winds_.empty()) winds_.resize(std::size(kHeights));
    bool const first = winds_.back().altitude == 0.0;
    for (std::size_t i = 0; i < winds_.size(); ++i) {
        if (!first && static_cast<int>(i) != nextHeight_) continue;
        double const level = floor + kHeights[i];
        glm::dvec3 const wind = air({subject.positionWorld.x, level, subject.positionWorld.z}, time).windWorld;
        glm::dvec2 const now{wind.x, -wind.z};
        winds_[i] = {kHeights[i], level, first ? now : glm::mix(winds_[i].wind, now, kNewest)};
    }
    nextHeight_ = (nextHeight_ + 1) % static_cast<int>(winds_.size());
}

std::vector<LiftPoint> AirProbe::lift() const {
    std::vector<LiftPoint> points;
    for (Cell const& cell : cells_) {
        glm::ivec2 const in = cell.at - corner_;
        if (cell.asked == 0 || in.x < 0 || in.y < 0 || in.x >= kCells || in.y >= kCells) continue;
        points.push_back({(glm::dvec2{cell.at} + 0.5) * kCell, cell.up});
    }
    return points;
}
}  // namespace luftpost::ui
