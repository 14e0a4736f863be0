// A game's window that a test types into; it brings its own screen where there is no display.
#pragma once
#include <memory>
#include <optional>
#include <vector>

#include "engine/gl/context.h"
#include "engine/platform/surface.h"
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
}  // namespace luftpost::test
