// Smoke: where it stands it hides what is behind, softly, and lets go of it at its rim.
#include "engine/render/renderer.h"
#include "engine/sky/sky_state.h"
#include "tests/gl/gl_fixture.h"

namespace {
using namespace luftpost;

class Puffs : public test::GlTest {};

TEST_F(Puffs, AreThickInTheMiddleAndNothingAtTheRim) {
    render::Renderer renderer{{.size = {256, 144}}};
    render::Snapshot snapshot;
    snapshot.still = true;
    snapshot.drawTerrain = false;
    snapshot.camera.positionWorld = {0.0, 300.0, 0.0};
    snapshot.sky.sunDirectionWorld = sky::directionWorld(core::radians(200.0), core::radians(50.0));
    renderer.draw(snapshot);
    auto const clear = renderer.readHdr();
    snapshot.puffs.push_back({.positionWorld = {0.0, 300.0, -30.0}, .radius = 5.0f, .colour = {0.9f, 0.1f, 0.1f, 1.0f}});
    renderer.draw(snapshot);
    auto const smoke = renderer.readHdr();
    EXPECT_GT(smoke.at(128, 72, 0), 2.0f * smoke.at(128, 72, 2)) << "red smoke";
    EXPECT_NEAR(smoke.at(20, 72, 2), clear.at(20, 72, 2), 1e-3f * clear.at(20, 72, 2)) << "far beside it the sky is as before";
    float const middle = clear.at(128, 72, 2) - smoke.at(128, 72, 2), half = clear.at(142, 72, 2) - smoke.at(142, 72, 2);
    EXPECT_GT(middle, half);
}
}  // namespace
