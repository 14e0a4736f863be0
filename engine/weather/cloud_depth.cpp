#include "engine/weather/cloud_depth.h"

#include <algorithm>

#include "shaders/lib/cloud.glsl"

namespace luftpost::weather {
namespace {
constexpr float kStep = 30.0f;  // m, of the midpoint rule
}

float layerDepth(glsl::LayerColumn const& c, glsl::LayerShape const& shape, glm::vec2 const& place,
                 NoiseVolumes const& noise) {
    if (shape.extent.z < 0.5f || std::max(c.cover - c.rank + shape.look.y, shape.body.z > 0.0f ? c.cover - c.anvil + glsl::anvilFray(c.cover) : -1.0f) <= 0.0f) return 0.0f;
    glm::vec3 p{place.x, 0.0f, place.y};
    if (shape.look.z > 0.5f) return glsl::sheetDepth(p, c, shape, noise.curl.plane(), 0.0f);
    float const thickness = c.top - c.base;
    int const steps = std::clamp(static_cast<int>(thickness / kStep) + 1, 8, 64);
    float const step = thickness / static_cast<float>(steps);
    float sum = 0.0f;
    for (int i = 0; i < steps; ++i) {
        p.y = c.base + step * (static_cast<float>(i) + 0.5f);
        sum += step * glsl::layerSample(p, c, shape, noise.shape.sampler(), noise.detail.sampler(), noise.curl.plane(), 0.0f).extinction;
    }
    return sum;
}

float columnDepth(glsl::CloudColumn const& column, glsl::CloudShape const& shape, glm::vec2 const& place,
                  NoiseVolumes const& noise) {
    float sum = 0.0f;
    for (int i = 0; i < glsl::kCloudLayers; ++i) sum += layerDepth(column.layers[i], shape.layers[i], place, noise);
    return sum;
}

float coverDepth(Genus genus) {
    bool const high = genus == Genus::Ci || genus == Genus::Cc || genus == Genus::Cs;
    return high ? 0.05f : 0.3f;
}
}  // namespace luftpost::weather
