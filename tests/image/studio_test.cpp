// The studio in the game as a player has it: a window, keys, pictures on the disk.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <vector>

#include "engine/assets/image.h"
#include "game/ui/studio_page.h"
#include "tests/image/typed_window.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;
using platform::Key;

class Studio : public test::WindowTest {
protected:
    void SetUp() override {
        WindowTest::SetUp();
        setenv("XDG_DATA_HOME", folder_.c_str(), 1);
        begin(flightOf("5", "preset:fair"));
    }
    void TearDown() override {
        WindowTest::TearDown();
        unsetenv("XDG_DATA_HOME");
    }

    /// Those that are finished.
    std::vector<std::filesystem::path> pictures() const {
        std::vector<std::filesystem::path> files;
        if (std::filesystem::path const pictures = folder_ / "luftpost" / "pictures"; std::filesystem::exists(pictures))
            for (auto const& entry : std::filesystem::directory_iterator{pictures})
                if (entry.path().extension() == ".png") files.push_back(entry.path());
        return files;
    }

    std::filesystem::path folder_ = tests::scratch();
};

TEST_F(Studio, LeavesTheFlightAsItWasAndItsPictureInTheFolder) {
    frames(2);
    std::string const before = simulation().stateHash();
    long long const tick = simulation().tick();
    type(Key::f6);
    EXPECT_TRUE(game_->paused());
    window_->hold(Key::a, true);  // the camera's now, not the aircraft's
    type(Key::c);
    type(Key::f4);
    frames(2);
    window_->hold(Key::a, false);
    type(Key::f12);
    for (int i = 0; i < 600 && pictures().empty(); ++i) frames(1);
    ASSERT_EQ(pictures().size(), 1u);
    frames(3);
    assets::Image const picture = assets::readImage(pictures().front());
    EXPECT_EQ(glm::ivec2(picture.width, picture.height), kSize);
    type(Key::escape);
    EXPECT_FALSE(game_->paused());
    EXPECT_FALSE(game_->over());
    app::Session& session = game_->session();
    EXPECT_TRUE(session.replay().inputs.empty()) << "nothing was stamped";
    EXPECT_GE(session.simulation().tick(), tick);
    // Flown on, it comes to the same state as a flight without a studio.
    app::SessionOptions plain;
    plain.plan = session.replay().plan;
    app::Session other{plain};
    while (other.simulation().tick() < tick) other.tick();
    EXPECT_EQ(other.simulation().stateHash(), before);
    frames(2);
    while (other.simulation().tick() < session.simulation().tick()) other.tick();
    EXPECT_EQ(other.simulation().stateHash(), simulation().stateHash());
}

TEST(PictureSize, FitsTheNamedSizesInTheWindowsShape) {
    using ui::PictureSize;
    EXPECT_EQ(ui::picturePixels(PictureSize::window, {1281, 721}), glm::ivec2(1281, 721));
    EXPECT_EQ(ui::picturePixels(PictureSize::fourK, {1280, 720}), glm::ivec2(3840, 2160));
    EXPECT_EQ(ui::picturePixels(PictureSize::eightK, {1280, 720}), glm::ivec2(7680, 4320));
    EXPECT_EQ(ui::picturePixels(PictureSize::eightK, {1280, 800}), glm::ivec2(6912, 4320));
    EXPECT_EQ(ui::picturePixels(PictureSize::fourK, {2560, 720}), glm::ivec2(3840, 1080));
}
}  // namespace
