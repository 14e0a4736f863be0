// A photograph beside the picture: how it is shown and what the comparison says.
#pragma once
#include <string>

#include <glm/glm.hpp>

namespace luftpost::ui {
enum class PhotoMode { hidden, over, split, beside };

struct PhotoView {
    PhotoMode mode = PhotoMode::over;
    double opacity = 0.5;  // 0..1, over the picture
    double split = 0.5;    // 0..1, the share of the width where the photograph begins
    bool operator==(PhotoView const&) const = default;
};

/// What there is to show; an empty name: no photograph was given.
struct PhotoState {
    std::string name;        // of the file
    std::string taken;       // "taken 2023-06-22 17:21 UTC, by EXIF", "taken at no known time"
    std::string comparison;  // "colours alike: 0.73 (...)"; empty: not yet made
    PhotoView view;
    glm::ivec2 size{0};      // pixels
};

/// Where the photograph stands in a picture of `size` pixels, its proportions kept: it fills the picture and what does not fit is cut.
/// The part of the photograph that is seen, as uv.
struct PhotoCrop {
    glm::vec2 uvFrom{0.0f}, uvTo{1.0f};
};
PhotoCrop photoCrop(glm::ivec2 photo, glm::vec2 size);

/// The texture of the photograph in Dear ImGui's lists (render::kPhotoTexture).
void drawPhoto(PhotoState const& photo);
}  // namespace luftpost::ui
