#include "game/app/plan.h"

#include "engine/assets/image.h"
#include "game/app/options.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
void writePlan(weather::Field const& field, weather::PlanRequest const& request, std::filesystem::path const& file) {
    weather::NoiseVolumes const noise = noiseVolumes(request.settings.noise);
    assets::FloatImage image{request.size.x, request.size.y, 1, weather::cloudPlan(field, request, noise, toolWorkers())};
    assets::writeExr(file, image);
}
}  // namespace luftpost::app
