// Photographs: when they were taken, which is nearest, and how alike colours are.
#include "engine/assets/photo.h"

#include <gtest/gtest.h>

#include <array>
#include <fstream>

#include "engine/core/error.h"
#include "engine/core/time.h"
#include "game/app/colour_comparison.h"
#include "game/app/photo_box.h"
#include "game/ui/photo_view.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;
namespace fs = std::filesystem;

assets::Image flat(int width, int height, std::array<std::uint8_t, 3> rgb) {
    assets::Image image{width, height, 3, {}};
    for (int i = 0; i < width * height; ++i) image.values.insert(image.values.end(), rgb.begin(), rgb.end());
    return image;
}

/// Left half one colour, right half another.
assets::Image halves(int width, int height, std::array<std::uint8_t, 3> left, std::array<std::uint8_t, 3> right) {
    assets::Image image = flat(width, height, left);
    for (int y = 0; y < height; ++y)
        for (int x = width / 2; x < width; ++x)
            for (int c = 0; c < 3; ++c) image.at(x, y, c) = right[static_cast<std::size_t>(c)];
    return image;
}

TEST(Photo, TellsItsTimeFromExif) {
    EXPECT_EQ(assets::exifTime("2023:06:22 19:20:05", "+02:00"), core::parseUtc("2023-06-22T17:20:05Z"));
    EXPECT_EQ(assets::exifTime("2023:06:22 17:20:05", ""), core::parseUtc("2023-06-22T17:20:05Z"));
    EXPECT_EQ(assets::exifTime("2023:06:22 17:20:05", "-03:30"), core::parseUtc("2023-06-22T20:50:05Z"));
    for (char const* text : {"", "2023-06-22 17:20:05", "2023:13:22 17:20:05", "    :  :     :  :  ", "2023:06:22", "2023:06:22 17:20:05Z"})
        EXPECT_FALSE(assets::exifTime(text, "")) << text;
}

TEST(Photo, TellsItsTimeFromItsName) {
    auto const expected = core::parseUtc("2023-06-22T17:20:00Z");
    for (char const* name : {"2023-06-22T17-20Z", "20230622_1720", "IMG_20230622_172000", "basel 2023-06-22 17.20.00 west", "202306221720"})
        EXPECT_EQ(assets::timeInName(name), expected) << name;
    for (char const* name : {"", "IMG_0042", "2023-06-22", "99999999999999", "20231399_1720"}) EXPECT_FALSE(assets::timeInName(name)) << name;
}

TEST(Photo, NearestInTimeIsChosenAndOneWithoutATimeLast) {
    std::vector<assets::PhotoFile> const photos{{"a", std::nullopt, ""}, {"b", 1000.0, "name"}, {"c", 2000.0, "name"}};
    EXPECT_EQ(assets::nearestPhoto(photos, 0.0), 1u);
    EXPECT_EQ(assets::nearestPhoto(photos, 1499.0), 1u);
    EXPECT_EQ(assets::nearestPhoto(photos, 1501.0), 2u);
    EXPECT_EQ(assets::nearestPhoto(std::span{photos}.first(1), 5.0), 0u);
}

TEST(Photo, AFolderGivesItsImagesAndABadOneIsRefused) {
    fs::path const& folder = tests::scratch();
    EXPECT_THROW(assets::findPhotos(folder), core::Error);
    EXPECT_THROW(assets::findPhotos(folder / "none.jpg"), core::Error);
    assets::writePng(folder / "20230622_1720.png", flat(4, 3, {10, 20, 30}));
    assets::writePng(folder / "20230622_1820.png", flat(4, 3, {10, 20, 30}));
    std::ofstream{folder / "notes.txt"} << "no image";
    std::vector<assets::PhotoFile> const photos = app::photosOption(folder, *core::parseUtc("2023-06-22T18:00Z"));
    ASSERT_EQ(photos.size(), 2u);
    EXPECT_EQ(photos[1].taken, core::parseUtc("2023-06-22T18:20Z"));
    EXPECT_EQ(photos[1].saidBy, "its name");
    std::ofstream{folder / "20230622_1920.png"} << "no image either";
    EXPECT_THROW(assets::findPhotos(folder), core::Error);
}

TEST(ColourComparison, IsOneForThePictureItselfAtAnySize) {
    assets::Image const image = halves(640, 360, {200, 120, 40}, {30, 60, 160});
    app::ColourComparison const same = app::compareColours(image, halves(1280, 720, {200, 120, 40}, {30, 60, 160}));
    EXPECT_NEAR(same.alike, 1.0, 1e-9);
    EXPECT_NEAR(same.lightness + same.redGreen + same.yellowBlue, 0.0, 1e-9);
    app::ColourComparison const turned = app::compareColours(image, halves(640, 360, {30, 60, 160}, {200, 120, 40}));
    EXPECT_NEAR(turned.alike, 1.0, 1e-6) << "where a colour stands does not count";
}

TEST(ColourComparison, IsNothingForBlackAndWhiteAndHalfForHalf) {
    app::ColourComparison const apart = app::compareColours(flat(64, 36, {0, 0, 0}), flat(64, 36, {255, 255, 255}));
    EXPECT_NEAR(apart.alike, 0.0, 1e-9);
    EXPECT_NEAR(apart.lightness, 100.0, 1.0);  // from L* 0 to 100
    app::ColourComparison const half = app::compareColours(flat(64, 36, {0, 0, 0}), halves(64, 36, {0, 0, 0}, {255, 255, 255}));
    EXPECT_NEAR(half.alike, 0.5, 0.01);
    EXPECT_NEAR(half.lightness, 50.0, 1.0);
}

TEST(ColourComparison, MovesWithTheColourThatIsOff) {
    // sRGB (119, 119, 119) is L* 50; red and blue shift a* and b*.
    app::ColourComparison const warm = app::compareColours(flat(64, 36, {119, 119, 119}), flat(64, 36, {150, 110, 80}));
    EXPECT_GT(warm.yellowBlue, 15.0);
    EXPECT_LT(warm.lightness, 5.0);
    app::ColourComparison const slight = app::compareColours(flat(64, 36, {119, 119, 119}), flat(64, 36, {122, 122, 122}));
    EXPECT_GT(slight.alike, 0.85) << "a hair's difference is no other colour";
}

TEST(ColourComparison, CutsThePhotographToThePicturesShape) {
    assets::Image tall = flat(100, 300, {10, 200, 10});
    for (int y = 100; y < 200; ++y)
        for (int x = 0; x < 100; ++x)
            for (int c = 0; c < 3; ++c) tall.at(x, y, c) = 90;
    EXPECT_GT(app::compareColours(flat(90, 90, {90, 90, 90}), tall).alike, 0.98) << "a row of its edge is blended with the next; whole it would be 1/3";
    assets::Image const both = app::sideBySide(flat(90, 60, {1, 2, 3}), tall);
    EXPECT_EQ(both.width, 180);
    EXPECT_EQ(both.at(10, 10, 2), 3);
    EXPECT_EQ(both.at(100, 10, 0), 90);
}

TEST(PhotoView, FillsThePictureAndKeepsTheProportions) {
    ui::PhotoCrop const wide = ui::photoCrop({2000, 500}, {1280.0f, 720.0f});
    EXPECT_EQ(wide.uvFrom.y, 0.0f);
    EXPECT_EQ(wide.uvTo.y, 1.0f);
    EXPECT_NEAR((wide.uvTo.x - wide.uvFrom.x) * 2000.0f / 500.0f, 1280.0f / 720.0f, 1e-4f);
    EXPECT_NEAR(wide.uvFrom.x + wide.uvTo.x, 1.0f, 1e-6f);
    ui::PhotoCrop const tall = ui::photoCrop({500, 2000}, {1280.0f, 720.0f});
    EXPECT_NEAR(500.0f / ((tall.uvTo.y - tall.uvFrom.y) * 2000.0f), 1280.0f / 720.0f, 1e-4f);
}
}  // namespace
