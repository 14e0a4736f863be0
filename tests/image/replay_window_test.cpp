// A replay in its window, as a player watches it.
#include <gtest/gtest.h>

#include "tests/image/typed_window.h"

namespace {
using namespace luftpost;
using platform::Key;

class ReplayWindow : public test::WindowTest {};

TEST_F(ReplayWindow, GoesBackAndOnPausesAndLeavesByKeysAndKeepsTheFlight) {
    app::PlayOptions options = flightOf("12", "preset:calm");
    options.run.watch = true;
    app::Session straight{options.session};
    while (straight.simulation().tick() < 12 * core::kTicksPerSecond) straight.tick();
    begin(options);
    for (int i = 0; i < 5; ++i) type(Key::w), frames(1);  // as fast as it goes
    EXPECT_EQ(game_->pace(), 16.0);
    frames(10);
    EXPECT_EQ(simulation().seconds(), 12.0) << "and no farther";
    EXPECT_TRUE(game_->paused());
    EXPECT_FALSE(game_->over()) << "its window stays";
    EXPECT_EQ(simulation().stateHash(), straight.simulation().stateHash());
    type(Key::a);
    EXPECT_EQ(simulation().seconds(), 2.0) << "ten seconds back";
    type(Key::c);
    type(Key::d);
    EXPECT_EQ(simulation().seconds(), 12.0);
    EXPECT_EQ(simulation().stateHash(), straight.simulation().stateHash()) << "no key of the viewer flies";
    type(Key::space);
    EXPECT_FALSE(game_->paused());
    EXPECT_LT(simulation().seconds(), 5.0) << "from the beginning";
    type(Key::escape);
    EXPECT_TRUE(game_->over());
}
}  // namespace
