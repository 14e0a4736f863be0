// The same frame with and without a window. Opens a window where there is a display; elsewhere it starts a virtual
// screen (Xvfb) for the time of the test.
#include <optional>
#include <thread>

#include "engine/assets/mesh.h"
#include "engine/assets/model.h"
#include "engine/render/renderer.h"
#include "engine/sky/sky_state.h"
#include "tests/gl/gl_fixture.h"
#include "tests/gl/virtual_screen.h"

namespace {
using namespace luftpost;

class Window : public ::testing::Test {
protected:
    void SetUp() override {
        if (platform::hasDisplay()) return;
        screen_.emplace();
        ASSERT_TRUE(screen_->ready()) << "expected Xvfb (Debian: xvfb)";
    }
    void TearDown() override { EXPECT_EQ(gl::errorCount(), errorsBefore_) << gl::lastError(); }

    static assets::Image frame(platform::Surface& surface) {
        render::Renderer renderer{{.size = {256, 144}}};
        render::Snapshot snapshot;
        snapshot.still = true;
        snapshot.drawTerrain = false;
        snapshot.camera.positionWorld = {0.0, 300.0, 0.0};
        snapshot.sky.sunDirectionWorld = sky::directionWorld(core::radians(120.0), core::radians(30.0));
        render::ModelInstance ring;
        ring.model = renderer.addModel(assets::modelOf(assets::meshOf(assets::torus(2.0f, 0.6f), 40, 16), {}, "ring"));
        ring.positionWorld = snapshot.camera.positionWorld + glm::dvec3{0.0, -1.0, -6.0};
        snapshot.models.push_back(ring);
        renderer.draw(snapshot);
        if (surface.hasWindow()) renderer.present(surface.size());
        surface.swap();
        return renderer.readPixels();
    }

    std::optional<test::VirtualScreen> screen_;
    int errorsBefore_ = gl::errorCount();
};

TEST_F(Window, ShowsTheFrameThatIsDrawnWithoutOne) {
    auto const without = [] {
        auto surface = platform::openHeadless({256, 144});
        gl::prepareContext();
        return frame(*surface);
    }();
    auto const with = [] {
        auto surface = platform::openWindow({.size = {256, 144}, .verticalSync = false});
        gl::prepareContext();
        EXPECT_TRUE(surface->hasWindow());
        return frame(*surface);
    }();
    test::headless().makeCurrent();
    ASSERT_EQ(without.values.size(), with.values.size());
    int worst = 0;
    for (std::size_t i = 0; i < with.values.size(); ++i)
        worst = std::max(worst, std::abs(with.values[i] - without.values[i]));
    EXPECT_EQ(worst, 0) << "one driver draws both";
}

TEST_F(Window, TellsItsSizeFocusAndKeysAndGoesFullScreenAndBack) {
    platform::openHeadless({1, 1}).reset();  // no context of EGL stays current while GLX makes one so
    auto surface = platform::openWindow({.size = {320, 200}, .verticalSync = false});
    gl::prepareContext();
    EXPECT_EQ(surface->size(), (glm::ivec2{320, 200}));
    EXPECT_GT(surface->contentScale(), 0.0f);
    EXPECT_TRUE(surface->poll().keys.empty());
    EXPECT_FALSE(surface->closeRequested());
    surface->setFullScreen(true);
    EXPECT_TRUE(surface->fullScreen());
    surface->setFullScreen(false);
    EXPECT_FALSE(surface->fullScreen());
    EXPECT_EQ(platform::keyLabel(platform::Key::w), "W") << "the virtual screen has a US layout";
    surface.reset();
    test::headless().makeCurrent();
}

TEST(KeyNames, TokensAndKeysAreOneToOne) {
    int named = 0;
    for (int number = 0; number < platform::kKeys; ++number) {
        auto const key = static_cast<platform::Key>(number);
        std::string const token = platform::keyToken(key);
        if (token.empty()) continue;
        EXPECT_EQ(platform::keyFromToken(token), key) << token;
        ++named;
    }
    EXPECT_GT(named, 95);
    EXPECT_FALSE(platform::keyFromToken("nonsense").has_value());
    EXPECT_EQ(platform::keyLabel(platform::Key::pageUp), "Page Up");
    EXPECT_EQ(platform::keyLabel(platform::Key::f1), "F1");
}
}  // namespace
