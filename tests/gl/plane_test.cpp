// The aircraft as the player sees it: the model of the data, its moving parts, its shadow.
#include <fmt/format.h>

#include <algorithm>
#include <cstdlib>
#include <utility>
#include <vector>

#include <glm/gtc/matrix_transform.hpp>

#include "engine/assets/mesh.h"
#include "engine/assets/model.h"
#include "engine/render/renderer.h"
#include "engine/sky/sky_state.h"
#include "tests/gl/gl_fixture.h"

namespace {
using namespace luftpost;

class Plane : public test::GlTest {
protected:
    Plane() : renderer_{{.size = size()}} {
        snapshot_.still = true;
        snapshot_.dither = false;
        snapshot_.drawTerrain = false;
        snapshot_.sky.sunDirectionWorld = sky::directionWorld(core::radians(140.0), core::radians(40.0));
        snapshot_.aircraftWorld = {0.0, 320.0, 0.0};
        snapshot_.hasAircraft = true;
        lookFrom({7.0, 2.5, 8.0}, snapshot_.aircraftWorld);
        plane_.model = renderer_.loadModel("plane");
        plane_.positionWorld = snapshot_.aircraftWorld;
        plane_.castsShadow = true;
    }
    static glm::ivec2 size() {
        return std::getenv("LUFTPOST_KEEP_PICTURES") ? glm::ivec2{960, 540} : glm::ivec2{256, 144};
    }
    void lookFrom(glm::dvec3 const& offset, glm::dvec3 const& target) {
        snapshot_.camera.positionWorld = target + offset;
        snapshot_.camera.worldFromCamera =
            glm::conjugate(glm::quat_cast(glm::lookAt(glm::dvec3{0.0}, -offset, glm::dvec3{0.0, 1.0, 0.0})));
        snapshot_.camera.horizontalFov = 1.0;
    }
    assets::Image draw(std::string const& name) {
        snapshot_.models = {plane_};
        if (floor_.model != render::ModelId::none) snapshot_.models.push_back(floor_);
        renderer_.draw(snapshot_);
        assets::Image image = renderer_.readPixels();
        if (char const* folder = std::getenv("LUFTPOST_KEEP_PICTURES"))
            assets::writePng(std::string{folder} + "/" + name + ".png", image);
        return image;
    }
    /// A white plate `below` metres under the aircraft, seen where the shadow falls, with and without it.
    std::pair<assets::Image, assets::Image> drawnAbove(double below) {
        if (floor_.model == render::ModelId::none) {
            assets::Material white;
            white.metallic = 0.0f;
            auto plate = assets::meshOf(assets::grid(600.0f, 600.0f), 4, 4);
            floor_.model = renderer_.addModel(assets::modelOf(std::move(plate), white, "floor"));
        }
        floor_.positionWorld = snapshot_.aircraftWorld - glm::dvec3{0.0, below, 0.0};
        glm::dvec3 const sun = snapshot_.sky.sunDirectionWorld;
        lookFrom({-2.0, 9.0, 14.0}, snapshot_.aircraftWorld - sun * (below / sun.y));
        plane_.castsShadow = false;
        assets::Image const lit = draw("floor_lit");
        plane_.castsShadow = true;
        return {lit, draw(fmt::format("floor_{}", below))};
    }
    /// Of the pixels that a shadow darkens, the share that it darkens by less than half of the most.
    static double partShare(std::pair<assets::Image, assets::Image> const& pictures) {
        auto const& [lit, shadowed] = pictures;
        std::vector<int> drops;
        for (std::size_t i = 0; i < lit.values.size(); i += 4)
            if (int const drop = lit.values[i] - shadowed.values[i]; drop > 4) drops.push_back(drop);
        if (drops.size() < 200) return -1.0;
        int const most = *std::ranges::max_element(drops);
        auto const part = std::ranges::count_if(drops, [&](int drop) { return drop < most / 2; });
        return static_cast<double>(part) / static_cast<double>(drops.size());
    }
    static int different(assets::Image const& a, assets::Image const& b) {
        int count = 0;
        for (std::size_t i = 0; i < a.values.size(); i += 4) count += std::abs(a.values[i + 1] - b.values[i + 1]) > 4;
        return count;
    }

    render::Renderer renderer_;
    render::Snapshot snapshot_;
    render::ModelInstance plane_, floor_;
};

TEST_F(Plane, IsSeenAndItsSurfacesAndPropellerMove) {
    assets::Image const rest = draw("plane");
    plane_.poses = {{.node = "aileron_left", .rotation = glm::angleAxis(0.35f, glm::vec3{0, 0, 1})},
                    {.node = "aileron_right", .rotation = glm::angleAxis(-0.35f, glm::vec3{0, 0, 1})},
                    {.node = "rudder", .rotation = glm::angleAxis(0.4f, glm::vec3{0, 1, 0})},
                    {.node = "propeller", .rotation = glm::angleAxis(0.8f, glm::vec3{1, 0, 0})}};
    assets::Image const moved = draw("plane_moved");
    plane_.poses = {{.node = "plane", .scale = glm::vec3{0.0f}}};
    assets::Image const hidden = draw("plane_hidden");
    int const pixels = static_cast<int>(rest.values.size() / 4);
    EXPECT_GT(different(rest, hidden), pixels / 20) << "the plane covers much of the picture";
    EXPECT_GT(different(rest, moved), pixels / 2000);
    EXPECT_LT(different(rest, moved), pixels / 10) << "only its surfaces and propeller moved";
}

TEST_F(Plane, ThrowsAShadowThatGrowsSofterWithHeight) {
    double const near = partShare(drawnAbove(15.0)), far = partShare(drawnAbove(150.0));
    EXPECT_GT(near, 0.0);
    EXPECT_LT(near, 0.35);
    EXPECT_GT(far, 0.5) << "150 m up the sun's disc makes the edge 2 m wide";
}
}  // namespace
