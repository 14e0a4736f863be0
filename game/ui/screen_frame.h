// Owner of the Dear ImGui context, its style and font: the game's menus and HUD are drawn between begin and end.
// Works with and without a window; no GL here: the renderer's ui pass uploads the font atlas and draws the lists.
#pragma once
#include <string>

#include <glm/glm.hpp>

struct ImGuiContext;
struct ImDrawData;
struct ImFont;

namespace luftpost::ui {
/// What the pointer and keyboard did since the last frame, in pixels of the framebuffer.
struct ScreenInput {
    glm::vec2 pointer_px{-1.0f};  // outside the window: negative
    bool buttons[3]{};            // left, right, middle held
    float wheel = 0.0f;           // notches
    std::u32string text;          // typed characters
    bool backspace = false, enter = false, tab = false, left = false, right = false, up = false, down = false;
    bool control = false;
};

class ScreenFrame {
public:
    ScreenFrame();
    ~ScreenFrame();
    ScreenFrame(ScreenFrame const&) = delete;
    ScreenFrame& operator=(ScreenFrame const&) = delete;

    /// Starts a frame of `size_px`; `userScale` (0.5..2) times height/720 sets the size of text. When the size of text
    /// changes, the font atlas is made anew and `fontVersion` counts up: the ui pass then uploads it again.
    void begin(glm::ivec2 size_px, float userScale, double seconds, ScreenInput const& input);
    /// Ends the frame. The lists stay valid until the next begin.
    ImDrawData* end();

    int fontVersion() const { return fontVersion_; }
    /// A text box has the focus: keys are text, not flight.
    bool wantsText() const;
    /// The pointer is over a menu: it is not for the camera.
    bool wantsPointer() const;

private:
    void makeFonts(float scale);

    ImGuiContext* context_ = nullptr;
    float scale_ = 0.0f;
    int fontVersion_ = 0;
};

/// The three sizes of our font and pixels per unit of layout (1 at 720 lines); valid between begin and end.
struct Fonts {
    ImFont* small = nullptr;   // 14
    ImFont* normal = nullptr;  // 17
    ImFont* large = nullptr;   // 28
    float scale = 1.0f;
};
Fonts const& fonts();
}  // namespace luftpost::ui
