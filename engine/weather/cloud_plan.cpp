#include "engine/weather/cloud_plan.h"

#include <atomic>
#include <thread>

#include "engine/weather/cloud_column.h"
#include "engine/weather/cloud_depth.h"

namespace luftpost::weather {
namespace {
/// The columns and shapes of one weather.
struct Sky {
    Sky(Weather const& weather, PlanRequest const& request)
        : columns{weather, request.seed, request.settings},
          shape{cloudShape(weather, request.seed, glm::dvec2{0.0}, request.settings)} {}
    float depth(double east, double north, NoiseVolumes const& noise) const {
        return columnDepth(columns.at(east, north), shape, {static_cast<float>(east), static_cast<float>(-north)}, noise);
    }
    CloudColumns columns;
    glsl::CloudShape shape;
};
}  // namespace

std::vector<float> cloudPlan(Field const& field, PlanRequest const& request, NoiseVolumes const& noise, int workers) {
    std::vector<float> depths(static_cast<std::size_t>(request.size.x) * static_cast<std::size_t>(request.size.y));
    bool const sameEverywhere = field.reports().size() == 1;
    Sky const middle{field.at(0.0, 0.0, request.time), request};
    std::atomic<int> nextRow{0};
    auto const work = [&] {
        for (int y = nextRow++; y < request.size.y; y = nextRow++)
            for (int x = 0; x < request.size.x; ++x) {
                double const east = ((x + 0.5) / request.size.x - 0.5) * request.width;
                double const north = (0.5 - (y + 0.5) / request.size.y) * request.width;
                depths[static_cast<std::size_t>(y) * static_cast<std::size_t>(request.size.x) + static_cast<std::size_t>(x)] =
                    sameEverywhere ? middle.depth(east, north, noise)
                                   : Sky{field.at(east, north, request.time), request}.depth(east, north, noise);
            }
    };
    std::vector<std::jthread> threads;
    for (int i = 1; i < workers; ++i) threads.emplace_back(work);
    work();
    threads.clear();
    return depths;
}
}  // namespace luftpost::weather
