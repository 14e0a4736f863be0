// Our font: it has what is written, and draws it inside its lines.
#include "game/ui/stroke_font.h"

#include <fmt/ranges.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <set>
#include <string>

namespace {
using namespace luftpost::ui;

TEST(StrokeFont, HasAsciiAndTheSignsOfTheGame) {
    std::set<char32_t> have;
    for (Glyph const& glyph : glyphs()) EXPECT_TRUE(have.insert(glyph.character).second) << "twice: " << static_cast<unsigned>(glyph.character);
    for (char32_t c = U' '; c < 127; ++c) EXPECT_TRUE(have.contains(c)) << static_cast<unsigned>(c);
    for (char32_t c : U"\u00b0\u2013\u2026\u2190\u2192\u2191\u2193\u2212\u00c4\u00d6\u00dc\u00e4\u00f6\u00fc\u00df\u00e9\u00e8\u00e7")
        EXPECT_TRUE(c == 0 || have.contains(c)) << static_cast<unsigned>(c);
}

TEST(StrokeFont, KeepsItsGlyphsWithinTheirBox) {
    for (Glyph const& glyph : glyphs())
        for (auto const& stroke : glyph.strokes)
            for (glm::vec2 const& point : stroke) {
                EXPECT_GE(point.x, -1.0f) << static_cast<unsigned>(glyph.character);
                EXPECT_LE(point.x, glyph.width + 1.0f) << static_cast<unsigned>(glyph.character);
                EXPECT_GE(point.y, kGlyphDescent) << static_cast<unsigned>(glyph.character);
                EXPECT_LE(point.y, kGlyphAscent) << static_cast<unsigned>(glyph.character);
            }
}

TEST(StrokeFont, TellsAllLettersApart) {
    std::set<std::string> pictures;
    std::size_t drawn = 0;
    for (Glyph const& glyph : glyphs()) {
        if (glyph.strokes.empty()) continue;
        GlyphPicture const picture = drawGlyph(glyph, 1.12f, 1.6f, 0.0f);  // as in the normal face at 720 lines
        EXPECT_GT(*std::max_element(picture.values.begin(), picture.values.end()), 200) << static_cast<unsigned>(glyph.character);
        pictures.insert(fmt::format("{} {} {} ", picture.offset_px.y, picture.width, fmt::join(picture.values, ",")));
        ++drawn;
    }
    EXPECT_EQ(pictures.size(), drawn);
}
}  // namespace
