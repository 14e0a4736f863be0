// A picture in tiles against the same picture whole.
#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <filesystem>

#include "engine/assets/model.h"
#include "engine/render/tiled_picture.h"
#include "engine/weather/source.h"
#include "tests/gl/gl_fixture.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;

/// Differences of two pictures in steps of 1/255.
struct Difference {
    double mean = 0.0, most = 0.0, share = 0.0;  // share: of values that differ by more than 2
};
Difference differenceOf(assets::Image const& a, assets::Image const& b) {
    Difference difference;
    for (std::size_t i = 0; i < a.values.size(); ++i) {
        double const by = std::abs(static_cast<int>(a.values[i]) - static_cast<int>(b.values[i]));
        difference.mean += by / static_cast<double>(a.values.size());
        difference.most = std::max(difference.most, by);
        if (by > 2.0) difference.share += 1.0 / static_cast<double>(a.values.size());
    }
    return difference;
}

/// All that one screen can hold: low sun in the picture with its glow, broken cloud, showers, land, trees, water, a model with its shadow, smoke.
class Tiles : public test::GlTest {
protected:
    static constexpr glm::ivec2 kSize{230, 130};
    static constexpr core::UtcSeconds kNow = 1687539600.0;  // 2023-06-23T17:00Z

    Tiles() : renderer_{{.size = kSize}}, field_{weather::loadWeather("preset:showers", {}, {})} {
        snapshot_.still = true;
        snapshot_.time = kNow;
        snapshot_.place = field_.place();
        snapshot_.sky = sky::skyState(snapshot_.place, kNow);
        snapshot_.field = &field_;
        snapshot_.camera.positionWorld = {0.0, snapshot_.place.altitude_m + 90.0, 0.0};
        glm::dvec3 const sun = snapshot_.sky.sunDirectionWorld;
        snapshot_.camera.worldFromCamera = glm::angleAxis(std::atan2(-sun.x, -sun.z) - 0.2, glm::dvec3{0.0, 1.0, 0.0});
        snapshot_.weather = field_.at(0.0, 0.0, kNow);
        snapshot_.air.rain = 2.0;
        putModel();
    }

    void putModel() {
        glm::dvec3 const ahead = snapshot_.camera.worldFromCamera * glm::dvec3{0.0, 0.0, -1.0};
        render::ModelInstance plane;
        plane.model = renderer_.loadModel("plane");
        plane.positionWorld = snapshot_.camera.positionWorld + 14.0 * ahead - glm::dvec3{0.0, 1.0, 0.0};
        plane.castsShadow = true;
        snapshot_.models.push_back(plane);
        snapshot_.puffs.push_back({plane.positionWorld + 6.0 * ahead, 4.0f, {0.9f, 0.3f, 0.1f, 0.6f}});
    }

    /// The picture put together from tiles of `side`, with the exposure and the glow of the one drawn last.
    assets::Image tiled(glm::ivec2 const& size, int side) {
        assets::Image picture{size.x, size.y, 4, {}};
        picture.values.resize(picture.index(0, size.y, 0));
        for (render::Tile const& tile : render::tilesOf(size, side)) {
            renderer_.drawTile(snapshot_, tile);
            assets::Image const part = renderer_.readTilePixels();
            int const top = size.y - tile.corner.y - tile.size.y;
            for (int y = 0; y < part.height; ++y)
                std::copy_n(&part.at(0, y, 0), 4 * part.width, &picture.at(tile.corner.x, top + y, 0));
        }
        return picture;
    }

    void keep(assets::Image const& picture, std::string const& name) {
        if (char const* folder = std::getenv("LUFTPOST_KEEP_PICTURES")) assets::writePng(std::string{folder} + "/" + name + ".png", picture);
    }

    render::Renderer renderer_;
    weather::Field field_;
    render::Snapshot snapshot_;
};

TEST_F(Tiles, AreTheVeryPictureThatIsDrawnWhole) {
    renderer_.draw(snapshot_);
    assets::Image const whole = renderer_.readPixels();
    assets::Image const parts = tiled(kSize, 64);
    keep(whole, "tiles_whole");
    keep(parts, "tiles_parts");
    Difference const difference = differenceOf(whole, parts);
    // A triangle's edge is rounded anew in every tile: a pixel on it may be the other side's.
    EXPECT_LT(difference.mean, 0.02) << "of 255";
    EXPECT_LT(difference.share, 0.001) << "of the values differ by more than 2 of 255, at most by " << difference.most;
}

TEST_F(Tiles, TakeExposureAndGlowFromASmallerPictureOfTheSameView) {
    renderer_.draw(snapshot_);
    assets::Image const whole = renderer_.readPixels();
    renderer_.resize(kSize / 2);
    renderer_.draw(snapshot_);
    assets::Image const parts = tiled(kSize, 128);
    keep(parts, "tiles_from_half");
    Difference const difference = differenceOf(whole, parts);
    EXPECT_LT(difference.mean, 1.0) << "of 255: other pixels are measured, and the glow has half as many";
}

TEST_F(Tiles, MakeAPanoramaWithoutSeams) {
    snapshot_.camera.projection = render::Projection::panorama;
    snapshot_.models.clear();
    glm::ivec2 const size{192, 96};
    renderer_.resize(size);
    renderer_.draw(snapshot_);
    assets::Image const whole = renderer_.readPixels();
    assets::Image const parts = tiled(size, 64);
    keep(parts, "tiles_panorama");
    Difference const difference = differenceOf(whole, parts);
    EXPECT_LT(difference.mean, 0.02) << "of 255";
    EXPECT_LT(difference.share, 0.001) << "of the values differ by more than 2 of 255, at most by " << difference.most;
}

TEST_F(Tiles, LeaveTheWindowsPictureAsItWas) {
    renderer_.draw(snapshot_);
    assets::Image const before = renderer_.readPixels();
    renderer_.drawTile(snapshot_, {{4096, 2304}, {512, 512}, {64, 64}});
    renderer_.drawMenus(snapshot_);
    EXPECT_EQ(before.values, renderer_.readPixels().values);
}

TEST_F(Tiles, AreWrittenBandByBandAsTheSamePicture) {
    std::filesystem::path const& folder = tests::scratch();
    glm::ivec2 const size{700, 530};  // four tiles
    snapshot_.drawClouds = false;
    renderer_.draw(snapshot_);
    for (char const* name : {"tiles.png", "tiles.exr"}) {
        render::TiledPicture picture{renderer_, snapshot_, size, folder / name};
        EXPECT_EQ(picture.share(), 0.0);
        picture.step();
        EXPECT_EQ(picture.share(), 0.25);
        picture.finish();
        EXPECT_TRUE(picture.finished());
        EXPECT_EQ(picture.share(), 1.0);
    }
    EXPECT_EQ(assets::readImage(folder / "tiles.png").values, tiled(size, render::TiledPicture::kTileSide).values);
    assets::FloatImage const linear = assets::readFloatImage(folder / "tiles.exr");
    EXPECT_EQ(linear.width, size.x);
    EXPECT_EQ(linear.height, size.y);
    assets::FloatImage const last = renderer_.readTileHdr();  // of the lower right tile
    EXPECT_EQ(last.at(last.width - 1, last.height - 1, 1), linear.at(size.x - 1, size.y - 1, 1));
}
}  // namespace
