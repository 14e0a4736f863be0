// Rain on the cockpit's glass, drawn: where it is wet, and nowhere else.
#include <glm/gtc/quaternion.hpp>
#include <optional>
#include <vector>

#include "engine/core/time.h"
#include "engine/render/renderer.h"
#include "engine/sky/sky_state.h"
#include "tests/gl/gl_fixture.h"

namespace luftpost::test {
namespace {
class WindscreenPass : public GlTest {
protected:
    /// The values of a still of the sky alone, in `rain` mm/h.
    std::vector<float> picture(std::optional<render::Windscreen> const& glass, double rain = 6.0) {
        render::Snapshot snapshot;
        snapshot.time = *core::parseUtc("2023-06-21T10:30Z");
        snapshot.sky = sky::skyState(snapshot.place, snapshot.time);
        snapshot.drawTerrain = snapshot.drawClouds = snapshot.dither = false;
        snapshot.still = true;
        snapshot.air.rain = rain;
        snapshot.windscreen = glass;
        renderer_.draw(snapshot);
        return renderer_.readHdr().values;
    }
    /// A glass through which the camera, looking north, sees ahead.
    static render::Windscreen glass(glm::vec3 const& cabin) {
        return {glm::angleAxis(0.5 * core::kPi, glm::dvec3{0.0, 1.0, 0.0}), 45.0, cabin};
    }

    render::Renderer renderer_{{.size = {160, 90}}};
};

TEST_F(WindscreenPass, PutsDropsBeforeTheSkyInRainAndOnlyThere) {
    std::vector<float> const none = picture(std::nullopt), wet = picture(glass(glm::vec3{1.0f}));
    std::size_t changed = 0;
    for (std::size_t i = 0; i < none.size(); i += 4) changed += none[i] != wet[i] || none[i + 2] != wet[i + 2];
    double const share = static_cast<double>(changed) / (static_cast<double>(none.size()) / 4.0);
    EXPECT_GT(share, 0.03);
    EXPECT_LT(share, 0.6) << "one has to see through";
    EXPECT_EQ(picture(glass(glm::vec3{1e12f})), none) << "what stands before the glass has no drops";
    EXPECT_EQ(picture(glass(glm::vec3{1.0f}), 0.0), picture(std::nullopt, 0.0)) << "dry";
}

TEST_F(WindscreenPass, ShowsTheSameDropsInAStillHoweverOftenItIsDrawn) {
    std::vector<float> const first = picture(glass(glm::vec3{1.0f}));
    EXPECT_EQ(picture(glass(glm::vec3{1.0f})), first);
}
}  // namespace
}  // namespace luftpost::test
