// The studio in the game as a player has it: a window, keys, pictures on the disk.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <optional>
#include <vector>

#include "engine/assets/image.h"
#include "engine/gl/context.h"
#include "game/app/game.h"
#include "game/ui/studio_page.h"
#include "tests/image/typed_window.h"

namespace {
using namespace luftpost;
using platform::Key;
using test::TypedWindow;

class Studio : public ::testing::Test {
protected:
    static constexpr glm::ivec2 kSize{192, 108};

    void SetUp() override {
        if (!platform::hasDisplay()) {
            screen_.emplace();
            ASSERT_TRUE(screen_->ready()) << "expected Xvfb (Debian: xvfb)";
        }
        std::filesystem::remove_all(folder_);
        setenv("XDG_DATA_HOME", folder_.c_str(), 1);
        surface_.emplace(kSize);
        gl::prepareContext();
        app::PlayTexts texts;
        texts.headless = true;
        texts.seconds = "5";
        app::CommonOptions common;
        common.weather = "preset:fair";
        common.size = kSize;
        game_.emplace(app::playOptions(texts, common), *surface_);
    }
    void TearDown() override {
        game_.reset();
        EXPECT_EQ(gl::errorCount(), 0) << gl::lastError();
        surface_.reset();
        unsetenv("XDG_DATA_HOME");
        std::filesystem::remove_all(folder_);
    }

    void frames(int number) {
        for (int i = 0; i < number; ++i) game_->frame(clock_.step(0.1, game_->paused()));
    }
    void type(Key key) {
        surface_->type(key);
        frames(1);
    }
    std::string hash() { return game_->session().simulation().stateHash(); }
    /// Those that are finished.
    std::vector<std::filesystem::path> pictures() const {
        std::vector<std::filesystem::path> files;
        if (std::filesystem::path const pictures = folder_ / "luftpost" / "pictures"; std::filesystem::exists(pictures))
            for (auto const& entry : std::filesystem::directory_iterator{pictures})
                if (entry.path().extension() == ".png") files.push_back(entry.path());
        return files;
    }

    std::filesystem::path folder_ = std::filesystem::temp_directory_path() / "luftpost_studio_test";
    std::optional<test::VirtualScreen> screen_;
    std::optional<TypedWindow> surface_;
    std::optional<app::Game> game_;
    app::FrameClock clock_;
};

TEST_F(Studio, LeavesTheFlightAsItWasAndItsPictureInTheFolder) {
    frames(2);
    std::string const before = hash();
    long long const tick = game_->session().simulation().tick();
    type(Key::f6);
    EXPECT_TRUE(game_->paused());
    surface_->hold(Key::a, true);  // the camera's now, not the aircraft's
    type(Key::c);
    type(Key::f4);
    frames(2);
    surface_->hold(Key::a, false);
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
    EXPECT_EQ(other.simulation().stateHash(), hash());
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
