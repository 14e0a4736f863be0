#include "game/app/studio.h"

#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "engine/core/error.h"
#include "engine/platform/input.h"

namespace luftpost::app {
namespace {
constexpr double kDay = 86400.0, kHour = 3600.0;  // s
constexpr double kPace = 0.25;         // of the free camera's: a picture is set up by metres
constexpr double kZoomPerNotch = 0.08;

/// The keys and the stick that fly the aircraft move the camera as well, for it stands still.
ui::CameraInput cameraInput(ui::DeviceReading const& reading) {
    using ui::FlightKey;
    ui::InputSample const& flight = reading.flight;
    auto const pair = [&](FlightKey less, FlightKey more) { return (flight.held(more) ? 1.0 : 0.0) - (flight.held(less) ? 1.0 : 0.0); };
    glm::dvec3 move = reading.camera.move;
    move += glm::dvec3{pair(FlightKey::rollLeft, FlightKey::rollRight), pair(FlightKey::yawLeft, FlightKey::yawRight), pair(FlightKey::thrustUp, FlightKey::thrustDown)};
    move += glm::dvec3{flight.pad.roll, flight.pad.thrust, flight.pad.pitch};
    ui::CameraInput input = reading.camera;
    input.move = kPace * glm::clamp(move, glm::dvec3{-1.0}, glm::dvec3{1.0});
    return input;
}

std::string moveCaps() {
    using platform::Key;
    std::vector<std::string> caps;
    for (Key key : {Key::w, Key::a, Key::s, Key::d, Key::q, Key::e}) caps.push_back(platform::keyLabel(key));
    return fmt::format("{}", fmt::join(caps, " "));
}
}  // namespace

Studio::Studio(ui::Cameras const& cameras, core::UtcSeconds utc, render::GraphicsSettings const& graphics)
    : cameras_{cameras}, midnight_{std::floor(utc / kDay) * kDay} {
    view_.hours = (utc - midnight_) / kHour;
    view_.fov_deg = core::degrees(cameras.pose().horizontalFov);
    view_.exposure_ev = graphics.exposure_ev;
    cameras_.select(ui::CameraMode::free);
}

void Studio::move(ui::DeviceReading const& reading, ui::CameraSubject const& subject, ui::GroundHeight const& ground, double wallSeconds) {
    if (saving()) return;
    ui::CameraInput const input = cameraInput(reading);
    view_.fov_deg = std::clamp(view_.fov_deg * std::exp(-kZoomPerNotch * input.zoom), ui::kNarrowestView_deg, ui::kWidestView_deg);
    cameras_.setFieldOfView(core::radians(view_.fov_deg));
    cameras_.advance(subject, input, ground, 0.0, wallSeconds);
}

core::UtcSeconds Studio::utc() const { return midnight_ + view_.hours * kHour; }

ui::StudioPage Studio::page(glm::ivec2 const& window) const {
    ui::StudioPage page{view_, window, {}, note_, noteIsBad_, moveCaps()};
    if (picture_) page.saved = picture_->share();
    return page;
}

float Studio::wholeResolution(glm::ivec2 const& window) {
    constexpr float kSide = render::TiledPicture::kTileSide;
    return std::min(1.0f, kSide / std::sqrt(static_cast<float>(window.x) * static_cast<float>(window.y)));
}

void Studio::save(render::Renderer& renderer, render::Snapshot const& snapshot, glm::ivec2 const& window, std::filesystem::path const& file) {
    note_.clear();
    picture_ = std::make_unique<render::TiledPicture>(renderer, snapshot, ui::picturePixels(view_.size, window), file);
}

void Studio::saveNext() {
    try {
        picture_->step();
        if (!picture_->finished()) return;
        note("Picture: " + picture_->file().string(), false);
    } catch (core::Error const& error) {
        note(error.what(), true);
    }
    picture_.reset();
}

void Studio::stop() {
    if (!picture_) return;
    picture_.reset();
    note("No picture: stopped.", false);
}

void Studio::note(std::string text, bool bad) {
    note_ = std::move(text);
    noteIsBad_ = bad;
}
}  // namespace luftpost::app
