#include "game/ui/stroke_font.h"

#include <algorithm>
#include <cmath>
#include <sstream>
#include <string_view>

#include "engine/core/check.h"

namespace luftpost::ui {
namespace {
// Strokes are separated by '|'; a stroke is points "x,y" and arcs "@cx,cy,rx,ry,from,to" (degrees, counter-clockwise from
// +x), joined in order.
struct Drawn {
    char32_t character;
    float width;
    char const* strokes;
};
constexpr Drawn kDrawn[] = {
    {U' ', 1.2f, ""},
    {U'!', 0.0f, "0,10 0,3.4|0,0 0,0.05"},
    {U'"', 2.2f, "0,10 0,7.6|2.2,10 2.2,7.6"},
    {U'#', 6.4f, "1.6,0 2.6,10|4.2,0 5.2,10|0,3.3 6.2,3.3|0.4,6.7 6.6,6.7"},
    {U'$', 5.8f, "@2.9,7.1,2.7,2.0,28,270 @2.9,2.95,2.9,2.15,90,-152|2.9,11.2 2.9,-1.2"},
    {U'%', 9.0f, "@1.9,7.8,1.9,2.2,0,360|@7.1,2.2,1.9,2.2,0,360|7.4,10 1.6,0"},
    {U'&', 7.4f, "7.4,0 1.6,6.4 @2.9,7.9,2.0,2.1,215,-40 @2.9,2.7,2.9,2.7,135,310 7.0,4.4"},
    {U'\'', 0.0f, "0,10 0,7.6"},
    {U'(', 2.4f, "@4.6,4.3,4.6,8.0,128,232"},
    {U')', 2.4f, "@-2.2,4.3,4.6,8.0,52,-52"},
    {U'*', 4.4f, "2.2,10 2.2,5|0,8.8 4.4,6.2|0,6.2 4.4,8.8"},
    {U'+', 6.0f, "0,4.6 6,4.6|3,1.6 3,7.6"},
    {U',', 0.6f, "0.6,0.2 0,-2"},
    {U'-', 3.4f, "0,4.2 3.4,4.2"},
    {U'.', 0.0f, "0,0 0,0.05"},
    {U'/', 4.2f, "0,-1.2 4.2,11.2"},
    {U'0', 5.8f, "5.8,6.8 @2.9,6.8,2.9,3.2,0,180 @2.9,3.2,2.9,3.2,180,360 5.8,6.8"},
    {U'1', 5.8f, "0.9,7.7 3.4,10 3.4,0"},
    {U'2', 5.8f, "@2.9,7.1,2.75,2.9,160,-38 0.2,0 5.8,0"},
    {U'3', 5.8f, "@2.8,7.6,2.5,2.4,150,-90 @2.8,2.6,3.0,2.6,90,-150"},
    {U'4', 5.8f, "4.4,0 4.4,10 0,2.8 6,2.8"},
    {U'5', 5.8f, "5.2,10 1,10 0.6,5.45 @2.7,3.2,3.0,3.2,135,-150"},
    {U'6', 5.8f, "@2.9,3.1,2.9,3.1,0,360|0,3.1 @4.9,3.3,4.9,6.7,180,100"},
    {U'7', 5.8f, "0,10 5.8,10 2,0"},
    {U'8', 5.8f, "@2.9,7.65,2.4,2.35,-90,270|@2.9,2.65,2.9,2.65,90,450"},
    {U'9', 5.8f, "@2.9,6.9,2.9,3.1,0,360|5.8,6.9 @0.9,6.7,4.9,6.7,0,-80"},
    {U':', 0.0f, "0,0.3 0,0.35|0,6 0,6.05"},
    {U';', 0.6f, "0.6,0.2 0,-2|0.4,6 0.4,6.05"},
    {U'<', 5.0f, "5,8 0,4.6 5,1.2"},
    {U'=', 5.6f, "0,3.2 5.6,3.2|0,6.2 5.6,6.2"},
    {U'>', 5.0f, "0,8 5,4.6 0,1.2"},
    {U'?', 4.8f, "@2.4,7.5,2.4,2.5,165,-45 2.4,4.6 2.4,3.2|2.4,0 2.4,0.05"},
    {U'@', 9.4f, "@4.8,4.4,1.9,2.2,0,360|6.7,6.6 6.7,3.4 @8.0,3.4,1.3,1.3,180,360 9.4,4.6 @4.7,4.4,4.7,5.2,0,300"},
    {U'A', 7.0f, "0,0 3.5,10 7,0|1.15,3.2 5.85,3.2"},
    {U'B', 6.1f, "0,5.3 3.4,5.3 @3.4,7.65,2.3,2.35,-90,90 0,10 0,0 3.5,0 @3.5,2.65,2.6,2.65,-90,90"},
    {U'C', 6.5f, "@3.6,6.5,3.6,3.5,38,180 @3.6,3.5,3.6,3.5,180,322"},
    {U'D', 6.7f, "0,0 0,10 2.8,10 @2.8,6.1,3.9,3.9,90,0 @2.8,3.9,3.9,3.9,0,-90 0,0"},
    {U'E', 5.3f, "5.3,0 0,0 0,10 5.3,10|0,5.2 4.6,5.2"},
    {U'F', 5.1f, "0,0 0,10 5.1,10|0,5.2 4.4,5.2"},
    {U'G', 7.1f, "@3.6,6.5,3.6,3.5,38,180 @3.6,3.5,3.5,3.5,180,360 7.1,4.7 4.4,4.7"},
    {U'H', 6.6f, "0,0 0,10|6.6,0 6.6,10|0,5.2 6.6,5.2"},
    {U'I', 0.0f, "0,0 0,10"},
    {U'J', 4.4f, "4.4,10 4.4,2.6 @2.2,2.6,2.2,2.6,0,-170"},
    {U'K', 6.2f, "0,0 0,10|5.9,10 0,4.2|2.1,6.2 6.3,0"},
    {U'L', 4.9f, "0,10 0,0 4.9,0"},
    {U'M', 8.0f, "0,0 0,10 4,3.4 8,10 8,0"},
    {U'N', 6.8f, "0,0 0,10 6.8,0 6.8,10"},
    {U'O', 7.2f, "7.2,6.4 @3.6,6.4,3.6,3.6,0,180 @3.6,3.6,3.6,3.6,180,360 7.2,6.4"},
    {U'P', 6.1f, "0,0 0,10 3.4,10 @3.4,7.3,2.7,2.7,90,-90 0,4.6"},
    {U'Q', 7.2f, "7.2,6.4 @3.6,6.4,3.6,3.6,0,180 @3.6,3.6,3.6,3.6,180,360 7.2,6.4|4.4,2.6 7.4,-0.8"},
    {U'R', 6.3f, "0,0 0,10 3.4,10 @3.4,7.3,2.7,2.7,90,-90 0,4.6|3.2,4.6 6.4,0"},
    {U'S', 6.1f, "@3.05,7.6,2.8,2.4,28,270 @3.05,2.6,3.05,2.6,90,-152"},
    {U'T', 6.4f, "0,10 6.4,10|3.2,10 3.2,0"},
    {U'U', 6.6f, "0,10 0,3.3 @3.3,3.3,3.3,3.3,180,360 6.6,10"},
    {U'V', 7.0f, "0,10 3.5,0 7,10"},
    {U'W', 10.0f, "0,10 2.5,0 5,8.4 7.5,0 10,10"},
    {U'X', 6.6f, "0,0 6.6,10|0,10 6.6,0"},
    {U'Y', 6.8f, "0,10 3.4,4.9 6.8,10|3.4,4.9 3.4,0"},
    {U'Z', 6.2f, "0,10 6.2,10 0,0 6.2,0"},
    {U'[', 2.2f, "2.2,11.4 0,11.4 0,-2.4 2.2,-2.4"},
    {U'\\', 4.2f, "4.2,-1.2 0,11.2"},
    {U']', 2.2f, "0,11.4 2.2,11.4 2.2,-2.4 0,-2.4"},
    {U'^', 4.4f, "0,7 2.2,10 4.4,7"},
    {U'_', 6.0f, "0,-1.4 6,-1.4"},
    {U'`', 1.6f, "0,10.4 1.6,8.4"},
    {U'a', 5.2f, "@2.6,4.5,2.6,2.5,150,0 5.2,0|5.2,4.1 2.2,4.1 @2.1,2.05,2.1,2.05,90,270 2.5,0 @2.5,2.5,2.7,2.5,270,350"},
    {U'b', 5.7f, "0,10.4 0,0|@2.85,3.5,2.85,3.5,180,-180"},
    {U'c', 4.9f, "@2.9,3.5,2.9,3.5,48,312"},
    {U'd', 5.7f, "5.7,10.4 5.7,0|@2.85,3.5,2.85,3.5,0,360"},
    {U'e', 5.6f, "0,3.7 5.6,3.7 @2.8,3.5,2.8,3.5,4,316"},
    {U'f', 3.5f, "3.7,10.4 3.2,10.4 @3.2,8.5,1.9,1.9,90,180 1.3,0|0,6.8 3.4,6.8"},
    {U'g', 5.7f, "@2.85,3.5,2.85,3.5,0,360|5.7,7 5.7,-0.5 @2.85,-0.5,2.85,2.5,0,-145"},
    {U'h', 5.2f, "0,10.4 0,0|0,4.3 @2.6,4.4,2.6,2.6,180,0 5.2,0"},
    {U'i', 0.0f, "0,7 0,0|0,9.7 0,9.75"},
    {U'j', 1.5f, "1.5,7 1.5,-1.4 @0,-1.4,1.5,1.6,0,-85|1.5,9.7 1.5,9.75"},
    {U'k', 4.9f, "0,10.4 0,0|4.7,7 0,2.7|1.7,4.3 5,0"},
    {U'l', 1.4f, "0,10.4 0,1.6 @1.6,1.6,1.6,1.6,180,265"},
    {U'm', 8.6f, "0,7 0,0|0,4.7 @2.15,4.85,2.15,2.15,180,0 4.3,0|4.3,4.7 @6.45,4.85,2.15,2.15,180,0 8.6,0"},
    {U'n', 5.2f, "0,7 0,0|0,4.3 @2.6,4.4,2.6,2.6,180,0 5.2,0"},
    {U'o', 5.8f, "@2.9,3.5,2.9,3.5,0,360"},
    {U'p', 5.7f, "0,7 0,-3|@2.85,3.5,2.85,3.5,180,-180"},
    {U'q', 5.7f, "5.7,7 5.7,-3|@2.85,3.5,2.85,3.5,0,360"},
    {U'r', 3.3f, "0,7 0,0|0,4.2 @2.8,4.2,2.8,2.8,180,78"},
    {U's', 4.6f, "@2.3,5.25,2.1,1.75,25,270 @2.3,1.75,2.3,1.75,90,-155"},
    {U't', 3.6f, "1.3,9.4 1.3,1.9 @3.2,1.9,1.9,1.9,180,270 3.7,0|0,6.8 3.5,6.8"},
    {U'u', 5.2f, "0,7 0,2.6 @2.6,2.6,2.6,2.6,180,360|5.2,7 5.2,0"},
    {U'v', 5.4f, "0,7 2.7,0 5.4,7"},
    {U'w', 8.2f, "0,7 2.05,0 4.1,6.2 6.15,0 8.2,7"},
    {U'x', 5.0f, "0,0 5,7|0,7 5,0"},
    {U'y', 5.4f, "0,7 2.75,0.2|5.4,7 1.6,-3"},
    {U'z', 4.8f, "0,7 4.8,7 0,0 4.8,0"},
    {U'{', 2.8f, "2.8,11.4 @2.8,10,1.4,1.4,90,180 1.4,6 0,4.5 1.4,3 1.4,-1 @2.8,-1,1.4,1.4,180,270"},
    {U'|', 0.0f, "0,11.4 0,-2.4"},
    {U'}', 2.8f, "0,11.4 @0,10,1.4,1.4,90,0 1.4,6 2.8,4.5 1.4,3 1.4,-1 @0,-1,1.4,1.4,0,-90"},
    {U'~', 6.0f, "@1.5,4.2,1.5,1.2,180,0 @4.5,4.2,1.5,1.2,180,360"},
    {U'\u00b0', 2.8f, "@1.4,8.6,1.4,1.4,0,360"},
    {U'\u00b1', 6.0f, "0,5.6 6,5.6|3,2.6 3,8.6|0,0.6 6,0.6"},
    {U'\u00b2', 3.2f, "@1.6,8.6,1.5,1.4,160,-40 0,5.2 3.2,5.2"},
    {U'\u00b5', 5.4f, "0,7 0,-3|0,2.6 @2.6,2.6,2.6,2.6,180,360|5.2,7 5.2,0"},
    {U'\u00b7', 0.0f, "0,4.4 0,4.45"},
    {U'\u00c6', 9.4f, "0,0 4.6,10 9.4,10|4.9,10 4.9,0 9.4,0|4.9,5.2 8.8,5.2|1.5,3.2 4.9,3.2"},
    {U'\u00d7', 4.6f, "0,2.2 4.6,6.8|0,6.8 4.6,2.2"},
    {U'\u00d8', 7.2f, "7.2,6.4 @3.6,6.4,3.6,3.6,0,180 @3.6,3.6,3.6,3.6,180,360 7.2,6.4|0.4,-0.4 6.8,10.4"},
    {U'\u00df', 5.6f, "0,0 0,7.8 @2.5,7.8,2.5,2.5,180,-80 2.7,5.4 @3.0,2.7,2.6,2.7,90,-115"},
    {U'\u00e6', 9.4f, "@2.5,4.5,2.3,2.5,150,0 4.8,2.4 @2.4,2.0,2.4,2.0,0,360|4.8,3.7 9.6,3.7 @7.2,3.5,2.4,3.5,4,180 @7.2,3.5,2.4,3.5,180,316"},
    {U'\u00f8', 5.8f, "@2.9,3.5,2.9,3.5,0,360|0.2,-0.6 5.6,7.6"},
    {U'\u2013', 5.4f, "0,4.2 5.4,4.2"},
    {U'\u2014', 8.6f, "0,4.2 8.6,4.2"},
    {U'\u2022', 1.6f, "0.8,4.4 0.8,4.45|0.4,4.4 1.2,4.4|0.8,4.0 0.8,4.8"},
    {U'\u2026', 6.4f, "0,0 0,0.05|3.2,0 3.2,0.05|6.4,0 6.4,0.05"},
    {U'\u2190', 7.0f, "7,4.6 0,4.6|3,7.6 0,4.6 3,1.6"},
    {U'\u2191', 6.0f, "3,0 3,9|0,6 3,9 6,6"},
    {U'\u2192', 7.0f, "0,4.6 7,4.6|4,7.6 7,4.6 4,1.6"},
    {U'\u2193', 6.0f, "3,9 3,0|0,3 3,0 6,3"},
    {U'\u2212', 6.0f, "0,4.6 6,4.6"},
    {U'\u2713', 6.6f, "0,4.4 2.4,1.4 6.6,9"},
};

enum class Mark { dieresis, acute, grave, circumflex, tilde, ring, cedilla, caron };
struct Accented {
    char32_t character, base;
    Mark mark;
};
constexpr Accented kAccented[] = {
    {U'\u00c4', U'A', Mark::dieresis}, {U'\u00d6', U'O', Mark::dieresis}, {U'\u00dc', U'U', Mark::dieresis},
    {U'\u00e4', U'a', Mark::dieresis}, {U'\u00f6', U'o', Mark::dieresis}, {U'\u00fc', U'u', Mark::dieresis},
    {U'\u00c0', U'A', Mark::grave},    {U'\u00c1', U'A', Mark::acute},    {U'\u00c2', U'A', Mark::circumflex},
    {U'\u00c5', U'A', Mark::ring},     {U'\u00c7', U'C', Mark::cedilla},  {U'\u00c8', U'E', Mark::grave},
    {U'\u00c9', U'E', Mark::acute},    {U'\u00ca', U'E', Mark::circumflex}, {U'\u00d1', U'N', Mark::tilde},
    {U'\u00d3', U'O', Mark::acute},    {U'\u00d9', U'U', Mark::grave},    {U'\u00da', U'U', Mark::acute},
    {U'\u00e0', U'a', Mark::grave},    {U'\u00e1', U'a', Mark::acute},    {U'\u00e2', U'a', Mark::circumflex},
    {U'\u00e5', U'a', Mark::ring},     {U'\u00e7', U'c', Mark::cedilla},  {U'\u00e8', U'e', Mark::grave},
    {U'\u00e9', U'e', Mark::acute},    {U'\u00ea', U'e', Mark::circumflex}, {U'\u00eb', U'e', Mark::dieresis},
    {U'\u00f1', U'n', Mark::tilde},    {U'\u00f2', U'o', Mark::grave},    {U'\u00f3', U'o', Mark::acute},
    {U'\u00f4', U'o', Mark::circumflex}, {U'\u00f9', U'u', Mark::grave},  {U'\u00fa', U'u', Mark::acute},
    {U'\u0160', U'S', Mark::caron},    {U'\u0161', U's', Mark::caron},    {U'\u017d', U'Z', Mark::caron},
    {U'\u017e', U'z', Mark::caron},    {U'\u010c', U'C', Mark::caron},    {U'\u010d', U'c', Mark::caron}};

char const* strokesOf(Mark mark) {  // about x = 0, over y = 0
    switch (mark) {
        case Mark::dieresis: return "-1.4,1.2 -1.4,1.25|1.4,1.2 1.4,1.25";
        case Mark::acute: return "-0.5,0.5 0.9,2.1";
        case Mark::grave: return "0.5,0.5 -0.9,2.1";
        case Mark::circumflex: return "-1.6,0.5 0,1.9 1.6,0.5";
        case Mark::caron: return "-1.6,1.9 0,0.5 1.6,1.9";
        case Mark::tilde: return "@-0.9,1.0,0.9,0.7,180,0 @0.9,1.0,0.9,0.7,180,360";
        case Mark::ring: return "@0,1.2,1.0,1.0,0,360";
        case Mark::cedilla: return "0,-0.4 0.4,-1.4 @0,-2.0,0.9,0.8,60,-120";
    }
    return "";
}

void appendArc(std::vector<glm::vec2>& stroke, float const (&v)[6]) {
    int const steps = std::max(4, static_cast<int>(std::abs(v[5] - v[4]) / 9.0f));
    for (int i = 0; i <= steps; ++i) {
        float const angle = glm::radians(v[4] + (v[5] - v[4]) * static_cast<float>(i) / static_cast<float>(steps));
        stroke.emplace_back(v[0] + v[2] * std::cos(angle), v[1] + v[3] * std::sin(angle));
    }
}

std::vector<glm::vec2> parseStroke(std::string const& text) {
    std::vector<glm::vec2> stroke;
    std::istringstream words{text};
    for (std::string word; words >> word;) {
        bool const arc = word.front() == '@';
        std::replace(word.begin(), word.end(), ',', ' ');
        std::istringstream numbers{arc ? word.substr(1) : word};
        float v[6]{};
        int count = 0;
        while (count < 6 && numbers >> v[count]) ++count;
        CHECK(count == (arc ? 6 : 2), "glyph stroke '{}'", text);
        if (arc)
            appendArc(stroke, v);
        else
            stroke.emplace_back(v[0], v[1]);
    }
    return stroke;
}

std::vector<std::vector<glm::vec2>> parseStrokes(char const* text) {
    std::vector<std::vector<glm::vec2>> strokes;
    std::istringstream pieces{text};
    for (std::string piece; std::getline(pieces, piece, '|');) strokes.push_back(parseStroke(piece));
    return strokes;
}

Glyph accented(Glyph base, Accented const& accent) {
    bool const capital = accent.base < U'a';
    glm::vec2 const at{0.5f * base.width, accent.mark == Mark::cedilla ? 0.0f : capital ? 10.6f : 7.9f};
    for (auto stroke : parseStrokes(strokesOf(accent.mark))) {
        for (glm::vec2& point : stroke) point += at;
        base.strokes.push_back(std::move(stroke));
    }
    base.character = accent.character;
    return base;
}

std::vector<Glyph> makeGlyphs() {
    std::vector<Glyph> all;
    for (Drawn const& drawn : kDrawn) all.push_back({drawn.character, drawn.width, parseStrokes(drawn.strokes)});
    std::size_t const plain = all.size();
    for (Accented const& accent : kAccented)
        for (std::size_t i = 0; i < plain; ++i)
            if (all[i].character == accent.base) {
                all.push_back(accented(all[i], accent));
                break;
            }
    return all;
}

float distanceToSegment(glm::vec2 p, glm::vec2 a, glm::vec2 b) {
    glm::vec2 const along = b - a;
    float const span = std::max(glm::dot(along, along), 1e-12f);
    return glm::length(p - a - along * std::clamp(glm::dot(p - a, along) / span, 0.0f, 1.0f));
}
}  // namespace

std::vector<Glyph> const& glyphs() {
    static std::vector<Glyph> const all = makeGlyphs();
    return all;
}

GlyphPicture drawGlyph(Glyph const& glyph, float pixelsPerUnit, float width_px, float soft_px) {
    GlyphPicture picture;
    if (glyph.strokes.empty()) return picture;
    glm::vec2 low{1e9f}, high{-1e9f};  // pixels from the pen, y down
    auto const place = [&](glm::vec2 p) { return glm::vec2{kGlyphBearing + p.x, -p.y} * pixelsPerUnit; };
    for (auto const& stroke : glyph.strokes)
        for (glm::vec2 const& point : stroke) low = glm::min(low, place(point)), high = glm::max(high, place(point));
    float const reach = 0.5f * width_px + soft_px + 1.0f;
    low = glm::floor(low - reach), high = glm::ceil(high + reach);
    picture.offset_px = low;
    picture.width = static_cast<int>(high.x - low.x), picture.height = static_cast<int>(high.y - low.y);
    picture.values.resize(static_cast<std::size_t>(picture.width) * static_cast<std::size_t>(picture.height));
    for (std::size_t i = 0; i < picture.values.size(); ++i) {
        auto const columns = static_cast<std::size_t>(picture.width);
        glm::vec2 const at = low + glm::vec2{static_cast<float>(i % columns), static_cast<float>(i / columns)} + 0.5f;
        float nearest = 1e9f;
        for (auto const& stroke : glyph.strokes)
            for (std::size_t k = 0; k + 1 < stroke.size(); ++k)
                nearest = std::min(nearest, distanceToSegment(at, place(stroke[k]), place(stroke[k + 1])));
        float const inside = (0.5f * width_px + 0.5f + soft_px - nearest) / (1.0f + soft_px);
        picture.values[i] = static_cast<unsigned char>(std::lround(255.0f * std::clamp(inside, 0.0f, 1.0f)));
    }
    return picture;
}
}  // namespace luftpost::ui
