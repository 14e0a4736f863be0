// The studio's page: what a picture is taken with, while the flight stands still. Draws from plain data and answers with what the player asked for.
// Main thread, between ScreenFrame::begin and end.
#pragma once
#include <array>
#include <optional>
#include <string>

#include <glm/glm.hpp>

namespace luftpost::ui {
/// How large the picture becomes: as the window, or as much as fits 3840 x 2160 or 7680 x 4320 in the window's shape.
enum class PictureSize { window, fourK, eightK };
inline constexpr std::array<glm::ivec2, 3> kPictureBounds{glm::ivec2{0}, glm::ivec2{3840, 2160}, glm::ivec2{7680, 4320}};
/// Pixels of the picture of a window of so many; even.
glm::ivec2 picturePixels(PictureSize size, glm::ivec2 const& window);

/// What the player sets. Only the picture knows of it: the flight keeps its own time and cameras.
struct StudioView {
    double hours = 12.0;        // UTC, of the flight's day
    double fov_deg = 75.0;      // horizontal
    double exposure_ev = 0.0;   // stops, added to the automatic exposure
    bool thirds = false;        // lines that help to compose
    PictureSize size = PictureSize::window;
    bool linear = false;        // an EXR, scene-linear, in place of a PNG
};
inline constexpr double kNarrowestView_deg = 8.0, kWidestView_deg = 120.0;

struct StudioPage {
    StudioView view;
    glm::ivec2 window{1280, 720};    // pixels
    std::optional<double> saved;     // share of the picture that is drawn, while it is being saved
    std::string note;                // where the latest picture is, or why there is none
    bool noteIsBad = false;
    std::string moveCaps;            // "W A S D Q E"
};
struct StudioAnswer {
    StudioView view;
    bool save = false, stop = false, close = false;
};
StudioAnswer drawStudioPage(StudioPage const& page);
}  // namespace luftpost::ui
