// Lines for the player fade in simulated time and do not outlive the flight that they belong to.
#include "game/app/messages.h"

#include <gtest/gtest.h>

namespace {
using namespace luftpost;

TEST(Messages, FadeAfterAWhile) {
    app::Messages messages;
    messages.say("Parcel released", ui::MessageKind::info, 100.0);
    auto const lines = messages.at(102.0);
    ASSERT_EQ(lines.size(), 1u);
    EXPECT_EQ(lines[0].text, "Parcel released");
    EXPECT_DOUBLE_EQ(lines[0].age, 2.0);
    EXPECT_TRUE(messages.at(100.1 + ui::kMessageSeconds).empty());
}

TEST(Messages, OfAFlightAreGoneWhenItBeginsAgain) {
    app::Messages messages;
    messages.say("Parcel released", ui::MessageKind::info, 100.0);
    EXPECT_TRUE(messages.at(0.0).empty());
    EXPECT_TRUE(messages.at(100.0).empty()) << "nor do they come back";
}
}  // namespace
