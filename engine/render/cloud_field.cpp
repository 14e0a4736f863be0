#include "engine/render/cloud_field.h"

#include "engine/weather/cloud_column.h"
#include "engine/weather/field.h"

namespace luftpost::render {
namespace {
constexpr double kReach = 40'000.0;  // m

glm::vec4 columnOf(glsl::LayerColumn const& c) { return {c.cover, c.base, c.top, c.water}; }

/// The layer of another place that is the same as this one; where there is none, this one without cover.
glm::vec4 sameLayer(weather::Weather const& there, glsl::CloudColumn const& columns, weather::Layer const& layer, glm::vec4 here) {
    for (int i = 0; i < there.layerCount; ++i)
        if (there.layers[static_cast<std::size_t>(i)].pattern == layer.pattern) return columnOf(columns.layers[i]);
    here.x = -0.3f;
    return here;
}
}  // namespace

std::array<glsl::LayerField, weather::kMaxLayers> layerFields(Snapshot const& snapshot) {
    std::array<glsl::LayerField, weather::kMaxLayers> fields{};
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    glsl::CloudColumn const here = weather::CloudColumns{snapshot.weather, snapshot.seed, snapshot.clouds}.bare();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        glm::vec4 const v = columnOf(here.layers[i]);
        fields[i] = {v, glm::vec4{0.0f}, glm::vec4{0.0f}, v, v};
    }
    if (snapshot.field == nullptr) return fields;
    std::array<glm::dvec2, 4> const offsets{{{kReach, 0.0}, {-kReach, 0.0}, {0.0, kReach}, {0.0, -kReach}}};  // east, north
    std::array<std::array<glm::vec4, 4>, weather::kMaxLayers> around{};
    for (std::size_t k = 0; k < offsets.size(); ++k) {
        weather::Weather const there = snapshot.field->at(camera.x + offsets[k].x, -camera.z + offsets[k].y, snapshot.time);
        glsl::CloudColumn const columns = weather::CloudColumns{there, snapshot.seed, snapshot.clouds}.bare();
        for (int i = 0; i < snapshot.weather.layerCount; ++i) {
            auto const layer = static_cast<std::size_t>(i);
            glm::vec4 const v = sameLayer(there, columns, snapshot.weather.layers[layer], fields[layer].centre);
            around[layer][k] = v;
            fields[layer].low = glm::min(fields[layer].low, v);
            fields[layer].high = glm::max(fields[layer].high, v);
        }
    }
    for (std::size_t i = 0; i < static_cast<std::size_t>(snapshot.weather.layerCount); ++i) {
        fields[i].eastward = (around[i][0] - around[i][1]) / static_cast<float>(2.0 * kReach);
        fields[i].southward = (around[i][3] - around[i][2]) / static_cast<float>(2.0 * kReach);
    }
    return fields;
}
}  // namespace luftpost::render
