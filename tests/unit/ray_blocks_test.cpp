// How many rays of the clouds a frame marches, by how long frames take.
#include "engine/render/ray_blocks.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <deque>

namespace {
using namespace luftpost::render;

/// Plays frames of one length and gives the side of the last one.
int sideAfter(double frameSeconds, double weatherRate = 1.0, int frames = 200, RayBlocks blocks = {}) {
    for (int i = 0; i < frames; ++i) blocks.note(frameSeconds, frameSeconds * weatherRate);
    return blocks.side(4);
}

TEST(RayBlocks, AreSmallerTheFewerFramesThereAre) {
    EXPECT_EQ(sideAfter(1.0 / 144.0), 4);
    EXPECT_EQ(sideAfter(1.0 / 60.0), 4);
    EXPECT_EQ(sideAfter(1.0 / 30.0), 4);
    EXPECT_EQ(sideAfter(1.0 / 29.0), 2);
    EXPECT_EQ(sideAfter(1.0 / 10.0), 2);
    EXPECT_EQ(sideAfter(1.0 / 5.0), 1);
}

TEST(RayBlocks, NoRayIsEverOlderThanHalfASecond) {
    for (double rate = 2.0; rate <= 120.0; rate += 1.0) {
        int const side = sideAfter(1.0 / rate);
        EXPECT_LE((side * side - 1) / rate, 0.5 + 1e-9) << rate << " frames a second";
    }
}

TEST(RayBlocks, AreSmallerWhereTheWeathersClockRuns) {
    EXPECT_EQ(sideAfter(1.0 / 60.0, 60.0), 4);
    EXPECT_EQ(sideAfter(1.0 / 60.0, 300.0), 2);
    EXPECT_EQ(sideAfter(1.0 / 60.0, 600.0), 1);
}

TEST(RayBlocks, NeitherFollowOneSlowFrameNorGoToAndFro) {
    RayBlocks blocks;
    for (int i = 0; i < 60; ++i) blocks.note(1.0 / 60.0, 1.0 / 60.0);
    blocks.note(0.1, 0.1);
    EXPECT_EQ(blocks.side(4), 4);
    int changes = 0, before = 4;
    for (int i = 0; i < 400; ++i) {
        double const frame = i % 2 ? 1.0 / 29.0 : 1.0 / 31.0;
        blocks.note(frame, frame);
        changes += blocks.side(4) != before;
        before = blocks.side(4);
    }
    EXPECT_LE(changes, 1);
}

TEST(RayBlocks, AFlightThatStandsStillSaysNothing) {
    RayBlocks blocks;
    for (int i = 0; i < 60; ++i) blocks.note(0.1, 0.1);
    ASSERT_EQ(blocks.side(4), 2);
    for (int i = 0; i < 600; ++i) blocks.note(0.0, 0.0);
    EXPECT_EQ(blocks.side(4), 2);
}

TEST(RayBlocks, AreNeverWiderThanTheSettingSays) {
    EXPECT_EQ(RayBlocks{}.side(blockSide(1.0f)), 1);
    EXPECT_EQ(RayBlocks{}.side(blockSide(0.25f)), 2);
    EXPECT_EQ(RayBlocks{}.side(blockSide(0.0625f)), 4);
}
}  // namespace
