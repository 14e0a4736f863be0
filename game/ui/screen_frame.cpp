#include "game/ui/screen_frame.h"

#include <imgui.h>
#include <imgui_internal.h>

#include <algorithm>
#include <cmath>
#include <cstring>

#include "engine/core/check.h"
#include "game/ui/stroke_font.h"

namespace luftpost::ui {
namespace {
Fonts theFonts;

constexpr float kUnitShare = 0.066f;       // of the line's height: one unit of the glyph grid
constexpr float kBaseLineShare = 0.80f;    // of the line's height, from its top
constexpr float kStrokeUnits = 1.42f;

/// What the atlas builder needs to know of one font; it travels as the font's "file".
struct FaceData {
    float size_px = 0.0f;
    float stroke_px = 0.0f;
    float soft_px = 0.0f;
};

/// Rows of pictures from the left, each row as high as its highest: glyphs of one font are alike.
class Shelves {
public:
    explicit Shelves(int width) : width_{width} {}
    glm::ivec2 place(int w, int h) {
        if (x_ + w + 1 > width_) x_ = 1, y_ += row_ + 1, row_ = 0;
        glm::ivec2 const at{x_, y_};
        x_ += w + 1, row_ = std::max(row_, h);
        return at;
    }
    int height() const { return y_ + row_ + 1; }

private:
    int width_, x_ = 1, y_ = 1, row_ = 0;
};

struct Placed {
    ImFont* font;
    Glyph const* glyph;
    GlyphPicture picture;
    glm::ivec2 at;
    float unit_px;
    float base_px;
};

std::vector<Placed> placeGlyphs(ImFontAtlas& atlas, Shelves& shelves) {
    std::vector<Placed> placed;
    for (ImFontConfig& config : atlas.ConfigData) {
        FaceData face;
        CHECK(config.FontDataSize == sizeof face, "font data of {} bytes", config.FontDataSize);
        std::memcpy(&face, config.FontData, sizeof face);
        float const base = std::round(kBaseLineShare * face.size_px);
        ImFontAtlasBuildSetupFont(&atlas, config.DstFont, &config, base, base - face.size_px);
        for (Glyph const& glyph : glyphs()) {
            float const unit = kUnitShare * face.size_px;
            GlyphPicture picture = drawGlyph(glyph, unit, face.stroke_px, face.soft_px);
            glm::ivec2 const at = shelves.place(picture.width, picture.height);
            placed.push_back({config.DstFont, &glyph, std::move(picture), at, unit, base});
        }
    }
    return placed;
}

void addGlyph(ImFontAtlas const& atlas, Placed const& p) {
    float const wide = static_cast<float>(atlas.TexWidth), high = static_cast<float>(atlas.TexHeight);
    auto const x = static_cast<float>(p.at.x), y = static_cast<float>(p.at.y);
    auto const w = static_cast<float>(p.picture.width), h = static_cast<float>(p.picture.height);
    glm::vec2 const corner = p.picture.offset_px + glm::vec2{0.0f, p.base_px};
    float const advance = std::round(p.glyph->advance() * p.unit_px);
    p.font->AddGlyph(nullptr, static_cast<ImWchar>(p.glyph->character), corner.x, corner.y, corner.x + w, corner.y + h, x / wide,
                     y / high, (x + w) / wide, (y + h) / high, advance);
}

/// Dear ImGui's hook for a builder of our own instead of a reader of font files.
bool buildAtlas(ImFontAtlas* atlas) {
    ImFontAtlasBuildInit(atlas);
    atlas->TexWidth = 1024;
    Shelves shelves{atlas->TexWidth};
    std::vector<Placed> const placed = placeGlyphs(*atlas, shelves);
    for (ImFontAtlasCustomRect& rect : atlas->CustomRects) {
        glm::ivec2 const at = shelves.place(rect.Width, rect.Height);
        rect.X = static_cast<unsigned short>(at.x), rect.Y = static_cast<unsigned short>(at.y);
    }
    atlas->TexHeight = ImUpperPowerOfTwo(shelves.height());
    atlas->TexUvScale = ImVec2{1.0f / static_cast<float>(atlas->TexWidth), 1.0f / static_cast<float>(atlas->TexHeight)};
    auto const bytes = static_cast<std::size_t>(atlas->TexWidth) * static_cast<std::size_t>(atlas->TexHeight);
    atlas->TexPixelsAlpha8 = static_cast<unsigned char*>(IM_ALLOC(bytes));
    std::memset(atlas->TexPixelsAlpha8, 0, bytes);
    for (Placed const& p : placed) {
        for (int row = 0; row < p.picture.height; ++row)
            std::memcpy(atlas->TexPixelsAlpha8 + (p.at.y + row) * atlas->TexWidth + p.at.x,
                        p.picture.values.data() + row * p.picture.width, static_cast<std::size_t>(p.picture.width));
        addGlyph(*atlas, p);
    }
    ImFontAtlasBuildFinish(atlas);
    return true;
}

ImFont* addFont(ImFontAtlas& atlas, FaceData const& face) {
    static ImWchar const kRange[] = {0x20, 0x2713, 0};
    ImFontConfig config;
    config.FontData = const_cast<FaceData*>(&face);  // copied, since the atlas does not own it
    config.FontDataSize = sizeof face;
    config.FontDataOwnedByAtlas = false;
    config.SizePixels = face.size_px;
    config.GlyphRanges = kRange;
    config.EllipsisChar = 0x2026;
    return atlas.AddFont(&config);
}

Face makeFace(ImFontAtlas& atlas, float size) {
    float const size_px = std::round(size);
    float const stroke = std::max(kStrokeUnits * kUnitShare * size_px, 1.25f);
    Face face;
    face.size_px = size_px;
    face.letters = addFont(atlas, {size_px, stroke, 0.0f});
    face.halo = addFont(atlas, {size_px, stroke + 0.9f + 0.07f * size_px, 0.6f + 0.08f * size_px});
    return face;
}

void setStyle(float scale) {
    ImGuiStyle style;
    style.WindowRounding = 10.0f, style.ChildRounding = 8.0f, style.FrameRounding = 6.0f, style.PopupRounding = 8.0f;
    style.GrabRounding = 6.0f, style.ScrollbarRounding = 6.0f, style.TabRounding = 6.0f;
    style.WindowPadding = {18.0f, 14.0f}, style.FramePadding = {9.0f, 5.0f}, style.ItemSpacing = {9.0f, 8.0f};
    style.WindowBorderSize = 1.0f, style.FrameBorderSize = 0.0f, style.PopupBorderSize = 1.0f;
    style.ScrollbarSize = 12.0f, style.GrabMinSize = 14.0f, style.WindowTitleAlign = {0.0f, 0.5f};
    style.ScaleAllSizes(scale);
    auto const set = [&](ImGuiCol which, unsigned rgb, float alpha) {
        style.Colors[which] = {static_cast<float>(rgb >> 16 & 255) / 255.0f, static_cast<float>(rgb >> 8 & 255) / 255.0f,
                               static_cast<float>(rgb & 255) / 255.0f, alpha};
    };
    // Ink blue-black, paper, post yellow: the colours of the aircraft at dusk.
    unsigned const ink = 0x14181f, paper = 0xf7f0de, yellow = 0xfaba16, slate = 0x2b323d, steel = 0x3b4554;
    set(ImGuiCol_Text, paper, 1.0f), set(ImGuiCol_TextDisabled, 0xa9a494, 1.0f);
    set(ImGuiCol_WindowBg, ink, 0.93f), set(ImGuiCol_PopupBg, ink, 0.97f), set(ImGuiCol_ChildBg, ink, 0.0f);
    set(ImGuiCol_Border, yellow, 0.22f), set(ImGuiCol_Separator, paper, 0.14f);
    set(ImGuiCol_FrameBg, slate, 0.95f), set(ImGuiCol_FrameBgHovered, steel, 1.0f), set(ImGuiCol_FrameBgActive, steel, 1.0f);
    set(ImGuiCol_TitleBg, ink, 0.95f), set(ImGuiCol_TitleBgActive, 0x1c222c, 1.0f);
    set(ImGuiCol_Button, slate, 1.0f), set(ImGuiCol_ButtonHovered, 0x7a5c10, 1.0f), set(ImGuiCol_ButtonActive, 0xa87a0c, 1.0f);
    set(ImGuiCol_Header, 0x7a5c10, 0.7f), set(ImGuiCol_HeaderHovered, 0x7a5c10, 0.9f), set(ImGuiCol_HeaderActive, 0xa87a0c, 1.0f);
    set(ImGuiCol_SliderGrab, yellow, 1.0f), set(ImGuiCol_SliderGrabActive, 0xffd560, 1.0f), set(ImGuiCol_CheckMark, yellow, 1.0f);
    set(ImGuiCol_Tab, slate, 1.0f), set(ImGuiCol_TabHovered, 0x8f6a0e, 1.0f), set(ImGuiCol_TabActive, 0x8f6a0e, 1.0f);
    set(ImGuiCol_ScrollbarBg, ink, 0.0f), set(ImGuiCol_ScrollbarGrab, steel, 1.0f), set(ImGuiCol_NavHighlight, yellow, 0.9f);
    set(ImGuiCol_ResizeGrip, yellow, 0.25f), set(ImGuiCol_ResizeGripHovered, yellow, 0.6f), set(ImGuiCol_ResizeGripActive, yellow, 0.9f);
    ImGui::GetStyle() = style;
}
}  // namespace

Fonts const& fonts() { return theFonts; }

ScreenFrame::ScreenFrame() : context_{ImGui::CreateContext()} {
    ImGuiIO& io = ImGui::GetIO();
    io.IniFilename = nullptr;
    io.LogFilename = nullptr;
    io.BackendRendererName = "luftpost";
    io.BackendFlags |= ImGuiBackendFlags_RendererHasVtxOffset;
    io.ConfigFlags |= ImGuiConfigFlags_NoMouseCursorChange;
    io.Fonts->Flags |= ImFontAtlasFlags_NoMouseCursors;
    using platform::Key;
    auto const map = [&](ImGuiKey to, Key from) { io.KeyMap[to] = static_cast<int>(from); };
    map(ImGuiKey_Tab, Key::tab), map(ImGuiKey_LeftArrow, Key::left), map(ImGuiKey_RightArrow, Key::right);
    map(ImGuiKey_UpArrow, Key::up), map(ImGuiKey_DownArrow, Key::down), map(ImGuiKey_Home, Key::home);
    map(ImGuiKey_End, Key::end), map(ImGuiKey_Backspace, Key::backspace), map(ImGuiKey_Delete, Key::del);
    map(ImGuiKey_Enter, Key::enter), map(ImGuiKey_Escape, Key::escape), map(ImGuiKey_A, Key::a);
    map(ImGuiKey_C, Key::c), map(ImGuiKey_V, Key::v), map(ImGuiKey_X, Key::x), map(ImGuiKey_Z, Key::z);
}

ScreenFrame::~ScreenFrame() {
    ImGui::DestroyContext(context_);
    theFonts = {};
}

void ScreenFrame::makeFonts(float scale) {
    static ImFontBuilderIO const kBuilder{&buildAtlas};
    ImFontAtlas& atlas = *ImGui::GetIO().Fonts;
    atlas.Clear();
    atlas.FontBuilderIO = &kBuilder;
    theFonts.normal = makeFace(atlas, 17.0f * scale);
    theFonts.small = makeFace(atlas, 14.0f * scale);
    theFonts.large = makeFace(atlas, 27.0f * scale);
    theFonts.scale = scale;
    atlas.Build();
    setStyle(scale);
    scale_ = scale;
    ++fontVersion_;
}

void ScreenFrame::feed(platform::Input const& input) {
    ImGuiIO& io = ImGui::GetIO();
    io.MousePos = {static_cast<float>(input.mouse.x), static_cast<float>(input.mouse.y)};
    for (std::size_t i = 0; i < input.mouseHeld.size(); ++i) io.MouseDown[i] = input.mouseHeld[i];
    for (platform::MouseButtonEvent const& event : input.mouseButtons)  // a click within one frame is a click
        if (event.pressed) io.MouseDown[static_cast<int>(event.button)] = true;
    io.MouseWheel += static_cast<float>(input.scrolled.y);
    for (char32_t c : input.text) io.AddInputCharacter(static_cast<unsigned>(c));
    for (std::size_t i = 0; i < input.held.size(); ++i) io.KeysDown[i] = input.held[i];
    using platform::Key;
    io.KeyCtrl = input.isHeld(Key::leftControl) || input.isHeld(Key::rightControl);
    io.KeyShift = input.isHeld(Key::leftShift) || input.isHeld(Key::rightShift);
    io.KeyAlt = input.isHeld(Key::leftAlt) || input.isHeld(Key::rightAlt);
}

void ScreenFrame::begin(glm::ivec2 size_px, float userScale, double seconds, platform::Input const* input) {
    ImGui::SetCurrentContext(context_);
    // Quarter steps: a window being resized does not make the font anew at every pixel.
    float const wanted = std::max(0.5f, std::round(4.0f * userScale * static_cast<float>(size_px.y) / 180.0f) / 16.0f);
    if (wanted != scale_) makeFonts(wanted);
    ImGuiIO& io = ImGui::GetIO();
    io.DisplaySize = {static_cast<float>(size_px.x), static_cast<float>(size_px.y)};
    io.DeltaTime = std::max(1e-4f, static_cast<float>(seconds));
    if (input) feed(*input);
    ImGui::NewFrame();
}

ImDrawData* ScreenFrame::end() {
    ImGui::Render();
    return ImGui::GetDrawData();
}

bool ScreenFrame::wantsText() const { return ImGui::GetIO().WantTextInput; }
bool ScreenFrame::wantsPointer() const { return ImGui::GetIO().WantCaptureMouse; }
}  // namespace luftpost::ui
