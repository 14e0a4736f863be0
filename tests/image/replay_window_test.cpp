// A replay in its window, as a player watches it.
#include <gtest/gtest.h>

#include "engine/gl/context.h"
#include "game/app/game.h"
#include "tests/image/typed_window.h"

namespace {
using namespace luftpost;
using platform::Key;

TEST(ReplayWindow, GoesBackAndOnPausesAndLeavesByKeysAndKeepsTheFlight) {
    std::optional<test::VirtualScreen> screen;
    if (!platform::hasDisplay()) {
        screen.emplace();
        ASSERT_TRUE(screen->ready()) << "expected Xvfb (Debian: xvfb)";
    }
    glm::ivec2 const size{160, 90};
    test::TypedWindow window{size};
    gl::prepareContext();
    app::PlayTexts texts;
    texts.headless = true;
    texts.seconds = "12";
    app::CommonOptions common;
    common.weather = "preset:calm";
    common.size = size;
    app::PlayOptions options = app::playOptions(texts, common);
    options.run.watch = true;
    app::Session straight{options.session};
    while (straight.simulation().tick() < 12 * core::kTicksPerSecond) straight.tick();
    {
        app::Game game{options, window};
        app::FrameClock clock;
        auto const frame = [&] { game.frame(clock.step(0.1, game.paused(), game.pace())); };
        auto const type = [&](Key key) {  // down and up again
            window.type(key);
            frame();
        };
        auto const seconds = [&] { return game.session().simulation().seconds(); };
        for (int i = 0; i < 5; ++i) type(Key::w), frame();  // as fast as it goes
        EXPECT_EQ(game.pace(), 16.0);
        for (int i = 0; i < 10; ++i) frame();
        EXPECT_EQ(seconds(), 12.0) << "and no farther";
        EXPECT_TRUE(game.paused());
        EXPECT_FALSE(game.over()) << "its window stays";
        EXPECT_EQ(game.session().simulation().stateHash(), straight.simulation().stateHash());
        type(Key::a);
        EXPECT_EQ(seconds(), 2.0) << "ten seconds back";
        type(Key::c);
        type(Key::d);
        EXPECT_EQ(seconds(), 12.0);
        EXPECT_EQ(game.session().simulation().stateHash(), straight.simulation().stateHash()) << "no key of the viewer flies";
        type(Key::space);
        EXPECT_FALSE(game.paused());
        EXPECT_LT(seconds(), 5.0) << "from the beginning";
        type(Key::escape);
        EXPECT_TRUE(game.over());
    }
    EXPECT_EQ(gl::errorCount(), 0) << gl::lastError();
}
}  // namespace
