// Draws Dear ImGui's lists into a plain picture, so that HUD and menus can be looked at without GL.
#pragma once
#include <imgui.h>

#include <algorithm>
#include <cmath>
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::test {
/// Display-encoded RGB, rows from the top.
struct Picture {
    int width = 0, height = 0;
    std::vector<glm::vec3> pixels;

    Picture(int w, int h, glm::vec3 fill) : width{w}, height{h}, pixels(static_cast<std::size_t>(w) * static_cast<std::size_t>(h), fill) {}
    glm::vec3& at(int x, int y) { return pixels[static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)]; }
};

namespace detail {
inline glm::vec4 unpack(ImU32 c) {
    return glm::vec4{static_cast<float>(c & 255), static_cast<float>(c >> 8 & 255), static_cast<float>(c >> 16 & 255), static_cast<float>(c >> 24 & 255)} / 255.0f;
}

inline float atlasAlpha(ImFontAtlas const& atlas, float u, float v) {  // bilinear, as a sampler does
    float const x = u * static_cast<float>(atlas.TexWidth) - 0.5f, y = v * static_cast<float>(atlas.TexHeight) - 0.5f;
    int const i = static_cast<int>(std::floor(x)), j = static_cast<int>(std::floor(y));
    auto const texel = [&](int a, int b) {
        a = std::clamp(a, 0, atlas.TexWidth - 1), b = std::clamp(b, 0, atlas.TexHeight - 1);
        return static_cast<float>(atlas.TexPixelsAlpha8[b * atlas.TexWidth + a]) / 255.0f;
    };
    float const s = x - static_cast<float>(i), t = y - static_cast<float>(j);
    return (texel(i, j) * (1 - s) + texel(i + 1, j) * s) * (1 - t) + (texel(i, j + 1) * (1 - s) + texel(i + 1, j + 1) * s) * t;
}

inline float edge(ImVec2 a, ImVec2 b, float x, float y) { return (b.x - a.x) * (y - a.y) - (b.y - a.y) * (x - a.x); }

inline bool topLeft(ImVec2 a, ImVec2 b) { return (a.y == b.y && b.x > a.x) || b.y < a.y; }

inline void triangle(Picture& picture, ImFontAtlas const& atlas, ImDrawVert a, ImDrawVert b, ImDrawVert c, ImVec4 const& clip) {
    float area = edge(a.pos, b.pos, c.pos.x, c.pos.y);
    if (area == 0.0f) return;
    if (area < 0.0f) std::swap(b, c), area = -area;
    auto const low = [](float p, float q, float r, float limit) { return static_cast<int>(std::floor(std::max(std::min({p, q, r}), limit))); };
    auto const high = [](float p, float q, float r, float limit) { return static_cast<int>(std::ceil(std::min(std::max({p, q, r}), limit))); };
    int const x1 = std::min(high(a.pos.x, b.pos.x, c.pos.x, clip.z), picture.width), y1 = std::min(high(a.pos.y, b.pos.y, c.pos.y, clip.w), picture.height);
    for (int y = std::max(0, low(a.pos.y, b.pos.y, c.pos.y, clip.y)); y < y1; ++y)
        for (int x = std::max(0, low(a.pos.x, b.pos.x, c.pos.x, clip.x)); x < x1; ++x) {
            float const px = static_cast<float>(x) + 0.5f, py = static_cast<float>(y) + 0.5f;
            float const wa = edge(b.pos, c.pos, px, py), wb = edge(c.pos, a.pos, px, py), wc = edge(a.pos, b.pos, px, py);
            auto const in = [](float w, ImVec2 p, ImVec2 q) { return w > 0.0f || (w == 0.0f && topLeft(p, q)); };
            if (!in(wa, b.pos, c.pos) || !in(wb, c.pos, a.pos) || !in(wc, a.pos, b.pos)) continue;
            float const sa = wa / area, sb = wb / area, sc = wc / area;
            glm::vec4 colour = unpack(a.col) * sa + unpack(b.col) * sb + unpack(c.col) * sc;
            colour.w *= atlasAlpha(atlas, a.uv.x * sa + b.uv.x * sb + c.uv.x * sc, a.uv.y * sa + b.uv.y * sb + c.uv.y * sc);
            picture.at(x, y) = glm::mix(picture.at(x, y), glm::vec3{colour}, colour.w);
        }
}
}  // namespace detail

/// Draws over `picture`, which has ImGui's display size.
inline void drawLists(Picture& picture, ImDrawData const& data) {
    ImFontAtlas const& atlas = *ImGui::GetIO().Fonts;
    for (int l = 0; l < data.CmdListsCount; ++l) {
        ImDrawList const& list = *data.CmdLists[l];
        for (ImDrawCmd const& command : list.CmdBuffer)
            for (unsigned i = 0; i + 2 < command.ElemCount; i += 3) {
                auto const vertex = [&](unsigned k) {
                    return list.VtxBuffer[static_cast<int>(list.IdxBuffer[static_cast<int>(command.IdxOffset + i + k)] + command.VtxOffset)];
                };
                detail::triangle(picture, atlas, vertex(0), vertex(1), vertex(2), command.ClipRect);
            }
    }
}
}  // namespace luftpost::test
