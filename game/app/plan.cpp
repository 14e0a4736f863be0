#include "game/app/plan.h"

#include <algorithm>
#include <thread>

#include "engine/assets/image.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
void writePlan(weather::Field const& field, weather::PlanRequest const& request, std::filesystem::path const& file) {
    int const seed = request.settings.noise;
    int const workers = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 32u));
    weather::NoiseVolumes const noise =
        seed == static_cast<int>(weather::kNoiseSeed)
            ? noiseVolumes()
            : weather::makeNoise(static_cast<unsigned>(seed), workers);
    assets::FloatImage image{request.size.x, request.size.y, 1, weather::cloudPlan(field, request, noise, workers)};
    assets::writeExr(file, image);
}
}  // namespace luftpost::app
