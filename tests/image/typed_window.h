// The game in a window that a test types into; it brings its own screen where there is no display.
#pragma once
#include <gtest/gtest.h>

#include <memory>
#include <optional>
#include <vector>

#include "engine/gl/context.h"
#include "engine/platform/surface.h"
#include "game/app/game.h"
#include "tests/gl/virtual_screen.h"

namespace luftpost::test {
/// A window whose keys the test presses.
class TypedWindow : public platform::Surface {
public:
    explicit TypedWindow(glm::ivec2 const& size) : window_{platform::openWindow({.size = size, .verticalSync = false})} {}
    void makeCurrent() override { window_->makeCurrent(); }
    void swap() override { window_->swap(); }
    glm::ivec2 size() const override { return window_->size(); }
    bool hasWindow() const override { return true; }
    platform::Input const& poll() override {
        window_->poll();
        input_.keys.clear();
        for (platform::Key key : typed_) input_.keys.push_back({.key = key, .pressed = true});
        typed_.clear();
        return input_;
    }
    void type(platform::Key key) { typed_.push_back(key); }
    void hold(platform::Key key, bool on) { input_.held[static_cast<std::size_t>(key)] = on; }

private:
    std::unique_ptr<platform::Surface> window_;
    platform::Input input_;
    std::vector<platform::Key> typed_;
};

/// A test whose games are played in a window of `kSize`; an error of GL fails it.
class WindowTest : public testing::Test {
protected:
    static constexpr glm::ivec2 kSize{192, 108};

    void SetUp() override {
        if (!platform::hasDisplay()) {
            screen_.emplace();
            ASSERT_TRUE(screen_->ready()) << "expected Xvfb (Debian: xvfb)";
        }
        window_.emplace(kSize);
        gl::prepareContext();
    }
    void TearDown() override {
        game_.reset();
        EXPECT_EQ(gl::errorCount(), 0) << gl::lastError();
    }

    /// A flight of so many seconds, as the command line would ask for it.
    static app::PlayOptions flightOf(std::string const& seconds, std::string const& weather) {
        app::PlayTexts texts;
        texts.headless = true;
        texts.seconds = seconds;
        app::CommonOptions common;
        common.weather = weather;
        common.size = kSize;
        return app::playOptions(texts, common);
    }
    void begin(app::PlayOptions const& options) { game_.emplace(options, *window_); }
    void frames(int number) {
        for (int i = 0; i < number; ++i) game_->frame(clock_.step(0.1, game_->paused(), game_->pace()));
    }
    /// Down and up again.
    void type(platform::Key key) {
        window_->type(key);
        frames(1);
    }
    app::Simulation const& simulation() { return game_->session().simulation(); }

    std::optional<VirtualScreen> screen_;
    std::optional<TypedWindow> window_;
    std::optional<app::Game> game_;
    app::FrameClock clock_;
};
}  // namespace luftpost::test
