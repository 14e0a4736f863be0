// What a ray through the clouds costs grows by less than the way that it goes in them: thicker layers, and the same layer seen farther away.
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <glm/gtc/matrix_transform.hpp>
#include <vector>

#include "engine/core/time.h"
#include "engine/render/renderer.h"
#include "engine/sky/sky_state.h"
#include "tests/bench/one_layer.h"
#include "tests/gl/gl_fixture.h"

namespace luftpost::test {
namespace {
class MarchCost : public GlTest {};

constexpr double kBase = 1000.0, kEye = 200.0;  // m; the base is one_layer.h's

/// ms, the least of some frames of every ray: other programs can only make it longer.
double marchTime(render::Renderer& renderer, weather::Field const& field, double elevation_rad, double fieldOfView_rad) {
    render::Snapshot snapshot;
    snapshot.field = &field;
    snapshot.place = field.place();
    snapshot.time = *core::parseUtc("2023-06-21T10:30Z");
    snapshot.drawTerrain = false;
    snapshot.clouds.rays = 1.0f;
    snapshot.weather = field.at(0.0, 0.0, snapshot.time);
    snapshot.sky = sky::skyState(snapshot.place, snapshot.time);
    glm::dvec3 const ahead = sky::directionWorld(core::radians(60.0), elevation_rad);
    snapshot.camera.worldFromCamera = glm::conjugate(glm::quat_cast(glm::lookAt(glm::dvec3{0.0}, ahead, glm::dvec3{0.0, 1.0, 0.0})));
    snapshot.camera.positionWorld = {0.0, kEye, 0.0};
    snapshot.camera.horizontalFov = fieldOfView_rad;
    snapshot.still = true;
    renderer.draw(snapshot);
    snapshot.still = false;
    renderer.setTiming(true);
    double least = 1e9;
    for (int i = 0; i < 8; ++i) {
        renderer.draw(snapshot);
        for (render::PassTime const& pass : renderer.passTimes())
            if (pass.name == "cloud march") least = std::min(least, pass.milliseconds);
    }
    renderer.setTiming(false);
    return least;
}

TEST_F(MarchCost, GrowsByLessThanTheThicknessOfALayer) {
    render::Renderer renderer{{.size = {160, 90}}};
    std::vector<double> times;
    for (double thickness : {500.0, 1000.0, 2000.0, 4000.0}) {
        weather::Field const field = tests::fieldOfOneLayer(weather::Genus::Cu, 0.4f, thickness);
        times.push_back(marchTime(renderer, field, core::radians(15.0), core::radians(60.0)));
    }
    fmt::print("500, 1000, 2000, 4000 m: {:.1f} ms\n", fmt::join(times, ", "));
    EXPECT_LT(times[3] / times[0], 3.0);
}

TEST_F(MarchCost, GrowsByLessThanTheDistanceAtWhichALayerIsSeen) {
    render::Renderer renderer{{.size = {160, 90}}};
    weather::Field const field = tests::fieldOfOneLayer(weather::Genus::Cu, 0.4f, 1000.0);
    std::vector<double> times;
    for (double away : {2'000.0, 8'000.0, 32'000.0})
        times.push_back(marchTime(renderer, field, std::asin((kBase - kEye) / away), core::radians(2.0)));
    fmt::print("2, 8, 32 km: {:.1f} ms\n", fmt::join(times, ", "));
    EXPECT_LT(times[1] / times[0], 2.0);
    EXPECT_LT(times[2] / times[0], 2.0);
}
}  // namespace
}  // namespace luftpost::test
