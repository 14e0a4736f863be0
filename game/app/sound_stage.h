// What the flight sounds like: loads the sounds and hands each frame to the mixer.
#pragma once
#include "engine/audio/mixer.h"
#include "game/app/simulation.h"
#include "game/ui/camera.h"

namespace luftpost::app {
class SoundStage {
public:
    /// Loads all sounds of the data. Without a sound device all is silent. Throws core::Error for a broken
    /// file.
    SoundStage();

    void note(FlightEventAt const& event);
    void click() { events_.push_back({audio::Event::click, {}, true, 0.5f}); }
    /// Plays this frame and the events noted since the last.
    void play(Simulation const& simulation, ui::CameraPose const& camera, bool inside, bool paused,
              audio::AudioSettings const& settings, double wallSeconds);

private:
    void noteFlaps(double flaps);
    void noteThunder(Simulation const& simulation, weather::Weather const& weather, glm::dvec3 const& eyeWorld);

    double recession(double distance, double passed);

    audio::Mixer mixer_;
    double distance_ = 0.0;       // m, from ear to aircraft in the latest frame
    double since_ = 0.0;          // s of flight then
    double recession_ = 0.0;      // m/s, smoothed
    double climbBeat_ = 0.0;      // beats of the climb's tone
    double flaps_ = 0.0;          // of the latest frame
    core::UtcSeconds heardUntil_ = 0.0;  // thunder that came until then has been played
    std::vector<audio::SoundEvent> events_;
};
}  // namespace luftpost::app
