// Our own letters: strokes on a grid, drawn at any size. No font file is needed, and text is crisp from 720 lines to 4K.
#pragma once
#include <span>
#include <string>
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::ui {
/// Grid units: capitals are 10 high, small letters 7, the base line is 0, y up.
inline constexpr float kCapitalHeight = 10.0f;
inline constexpr float kGlyphBearing = 1.3f;   // free on either side of a glyph
inline constexpr float kGlyphAscent = 13.4f;   // highest accent
inline constexpr float kGlyphDescent = -3.9f;  // lowest tail, stroke included

/// One character: its strokes as polylines (arcs already sampled) and its width without bearings.
struct Glyph {
    char32_t character = 0;
    float width = 0.0f;
    std::vector<std::vector<glm::vec2>> strokes;

    float advance() const { return width + 2.0f * kGlyphBearing; }
};

/// All characters we can draw: ASCII, Latin accents of keyboards, and the signs the game uses.
std::vector<Glyph> const& glyphs();

/// A grey picture of one glyph: 255 inside strokes `width_px` wide, edges smoothed over one pixel and `soft_px` more.
struct GlyphPicture {
    int width = 0, height = 0;
    glm::vec2 offset_px{0.0f};  // from the pen at the base line to the upper left corner, y down
    std::vector<unsigned char> values;
};
GlyphPicture drawGlyph(Glyph const& glyph, float pixelsPerUnit, float width_px, float soft_px);
}  // namespace luftpost::ui
