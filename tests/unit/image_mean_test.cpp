// Pictures made smaller by a whole number.
#include <gtest/gtest.h>

#include "engine/assets/image_mean.h"

namespace {
using namespace luftpost::assets;

TEST(ImageMean, IsTheMeanOfLinearValues) {
    FloatImage const picture{4, 2, 1, {1.0f, 3.0f, 0.0f, 0.0f, 5.0f, 7.0f, 0.0f, 8.0f}};
    FloatImage const half = meanOf(picture, 2);
    ASSERT_EQ(half.width, 2);
    ASSERT_EQ(half.height, 1);
    EXPECT_EQ(half.values, (std::vector<float>{4.0f, 2.0f}));
}

// Half of the light of white is sRGB 188, not 128; alpha is no light.
TEST(ImageMean, MixesLightAndNotCodes) {
    Image const picture{2, 2, 4, {255, 0, 10, 255, 0, 0, 10, 0, 255, 255, 10, 255, 0, 0, 10, 0}};
    Image const pixel = meanOf(picture, 2);
    EXPECT_EQ(pixel.values, (std::vector<std::uint8_t>{188, 137, 10, 128}));
}

TEST(ImageMean, LeavesAPictureAsItIsBySquaresOfOne) {
    Image picture{256, 1, 1, {}};
    for (int i = 0; i < 256; ++i) picture.values.push_back(static_cast<std::uint8_t>(i));
    EXPECT_EQ(meanOf(picture, 1).values, picture.values);
    Image twice{512, 2, 1, {}};
    for (int i = 0; i < 1024; ++i) twice.values.push_back(static_cast<std::uint8_t>(i % 512 / 2));
    EXPECT_EQ(meanOf(twice, 2).values, picture.values) << "every code comes back";
}

TEST(ImageMean, DecodesByTheStandard) {
    EXPECT_EQ(linearOf(0.0), 0.0);
    EXPECT_NEAR(linearOf(1.0), 1.0, 1e-12);
    EXPECT_NEAR(linearOf(0.5), 0.21404, 1e-5);
    EXPECT_NEAR(linearOf(0.04), 0.04 / 12.92, 1e-12);
}
}  // namespace
