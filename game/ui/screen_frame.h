// Owner of the Dear ImGui context, its style and font: the game's menus and HUD are drawn between begin and end.
// Works with and without a window; no GL here: the renderer's ui pass uploads the font atlas and draws the lists.
#pragma once
#include <glm/glm.hpp>

#include "engine/platform/input.h"

struct ImGuiContext;
struct ImDrawData;
struct ImFont;

namespace luftpost::ui {
class ScreenFrame {
public:
    ScreenFrame();
    ~ScreenFrame();
    ScreenFrame(ScreenFrame const&) = delete;
    ScreenFrame& operator=(ScreenFrame const&) = delete;

    /// Starts a frame of `size_px`; `userScale` (0.5..2) times height/720 sets the size of text. When the size of text
    /// changes, the font atlas is made anew and `fontVersion` counts up: the ui pass then uploads it again. `input` may
    /// be null (no window); its pixels are those of `size_px`.
    void begin(glm::ivec2 size_px, float userScale, double seconds, platform::Input const* input);
    /// Ends the frame. The lists stay valid until the next begin.
    ImDrawData* end();

    int fontVersion() const { return fontVersion_; }
    /// A text box has the focus: keys are text, not flight.
    bool wantsText() const;
    /// The pointer is over a menu: it is not for the camera.
    bool wantsPointer() const;

private:
    void makeFonts(float scale);
    void feed(platform::Input const& input);

    ImGuiContext* context_ = nullptr;
    float scale_ = 0.0f;
    int fontVersion_ = 0;
};

/// One size of our font: the letters, and the same letters with a wide soft edge to lie under them.
struct Face {
    ImFont* letters = nullptr;
    ImFont* halo = nullptr;
    float size_px = 0.0f;
};
/// The sizes of text and pixels per unit of layout (1 at 720 lines); valid between begin and end.
struct Fonts {
    Face small, normal, large;
    float scale = 1.0f;
};
Fonts const& fonts();
}  // namespace luftpost::ui
