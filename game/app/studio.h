// The studio: the flight stands still while the player sets up a picture of it. It has a camera and an hour of its own and stamps no input: when it
// closes, the flight goes on as if it had not been.
#pragma once
#include <memory>
#include <string>

#include "engine/render/tiled_picture.h"
#include "game/app/snapshot_builder.h"
#include "game/ui/devices.h"
#include "game/ui/studio_page.h"

namespace luftpost::app {
class Studio {
public:
    /// Begins with what the player sees: this camera, hour and exposure.
    Studio(ui::Cameras const& cameras, core::UtcSeconds utc, render::GraphicsSettings const& graphics);

    /// The camera goes where keys, mouse and gamepad say; not while a picture is being saved.
    void move(ui::DeviceReading const& reading, ui::CameraSubject const& subject, ui::GroundHeight const& ground, double wallSeconds);
    ui::CameraPose const& pose() const { return cameras_.pose(); }
    /// The hour that is shown.
    core::UtcSeconds utc() const;
    /// Puts the picture's own exposure into what is drawn.
    void expose(render::Snapshot& snapshot) const { snapshot.graphics.exposure_ev = static_cast<float>(view_.exposure_ev); }

    ui::StudioPage page(glm::ivec2 const& window) const;
    ui::StudioView const& view() const { return view_; }
    void setView(ui::StudioView const& view) { view_ = view; }

    /// The size of the whole that a saved picture's tiles take exposure and glow from, per side against the window's: no more pixels than a tile has.
    static float wholeResolution(glm::ivec2 const& window);
    /// Begins to save what `renderer` has just drawn whole. Throws core::Error when the file cannot be made.
    void save(render::Renderer& renderer, render::Snapshot const& snapshot, glm::ivec2 const& window, std::filesystem::path const& file);
    /// Draws the next tile. A disk that refuses ends it; the page says so.
    void saveNext();
    void stop();
    bool saving() const { return picture_ != nullptr; }
    void note(std::string text, bool bad);

private:
    ui::Cameras cameras_;
    ui::StudioView view_;
    core::UtcSeconds midnight_;
    std::unique_ptr<render::TiledPicture> picture_;
    std::string note_;
    bool noteIsBad_ = false;
};
}  // namespace luftpost::app
