#include <gtest/gtest.h>

#include "engine/core/time.h"

using namespace luftpost;

TEST(Time, IsoTextAndSecondsAreEachOthersInverse) {
    EXPECT_EQ(core::parseUtc("1970-01-01T00:00Z"), 0.0);
    EXPECT_EQ(core::parseUtc("2023-06-23T18:40Z"), 1687545600.0);
    EXPECT_EQ(core::parseUtc("2024-02-29T23:59:59Z"), 1709251199.0);
    EXPECT_EQ(core::parseUtc("1969-12-31T23:59:59.5Z"), -0.5);
    for (double time = -3.0e9; time < 6.0e9; time += 86399.0 * 77)
        EXPECT_EQ(core::parseUtc(core::formatUtc(time)), time) << core::formatUtc(time);
}

TEST(Time, TextIsRoundedToTheNearestSecond) {
    EXPECT_EQ(core::formatUtc(1687545600.4), "2023-06-23T18:40:00Z");
    EXPECT_EQ(core::formatUtc(1687545599.6), "2023-06-23T18:40:00Z");
}

TEST(Time, WhatIsNotExactlyUtcIsRefused) {
    for (char const* text : {"", "2023-06-23", "2023-06-23T18:40", "2023-06-23 18:40Z", "2023-06-23T18:40+00:00", "2023-02-29T00:00Z",
                             "2023-13-01T00:00Z", "2023-00-01T00:00Z", "2023-06-31T00:00Z", "2023-06-00T00:00Z", "2023-06-23T24:00Z",
                             "2023-06-23T18:60Z", "2023-06-23T18:40:60Z", "2023-06-23T18:40:5Z", "2023-06-23T18:40:05.Z",
                             "2023-06-23T18:40Zx", "23-06-23T18:40Z", "2023-6-23T18:40Z", "2023-06-23T18:40z"})
        EXPECT_FALSE(core::parseUtc(text)) << text;
}
