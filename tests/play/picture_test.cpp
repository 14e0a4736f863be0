// A drawn flight is the same flight, without a GL error, and its last frame can be kept.
#include "tests/play/program.h"

namespace {
using luftpost::tests::fileText;
using luftpost::tests::flight;
using luftpost::tests::scratch;

TEST(Picture, OfAHeadlessFlightIsDrawnWithoutAnErrorAndKept) {
    std::string const picture = (scratch() / "last.png").string();
    std::string const flown = "--headless --bot courier --seconds 2 --seed 3 ";
    auto const drawn = flight(flown + "--size 160x90 --frame-rate 5 --screenshot '" + picture + "'");
    EXPECT_EQ(drawn["frames"], 10);
    EXPECT_EQ(drawn["gl_errors"], 0);
    EXPECT_GT(drawn["frame_ms"]["p50"], 0.0);
    EXPECT_GT(drawn["memory"]["gpu_mb"], 1.0);
    EXPECT_LE(drawn["chunks"]["peak_bytes"], 160'000'000);
    EXPECT_EQ(fileText(picture).substr(1, 3), "PNG");
    EXPECT_EQ(drawn["state_hash"], flight(flown + "--no-render")["state_hash"]);
}
}  // namespace
