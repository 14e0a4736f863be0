#include "engine/render/cloud_field.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/weather/cloud_column.h"
#include "engine/weather/field.h"

namespace luftpost::render {
namespace {
constexpr double kReach = 40'000.0;  // m
constexpr double kBeside = 1.6;      // widths of a front: there it has not come, or has passed

glm::vec4 columnOf(glsl::LayerColumn const& c) { return {c.cover, c.base, c.top, c.water}; }

/// The layer of another place that is the same as this one; where there is none, this one without cover.
glm::vec4 sameLayer(weather::Weather const& there, glsl::CloudColumn const& columns, weather::Layer const& layer, glm::vec4 here) {
    for (int i = 0; i < there.layerCount; ++i)
        if (there.layers[static_cast<std::size_t>(i)].pattern == layer.pattern) return columnOf(columns.layers[i]);
    here.x = -0.3f;
    return here;
}

/// The bare columns of another place, each layer of here found again.
struct Elsewhere {
    Snapshot const& snapshot;
    weather::Weather const& sky;
    std::array<glsl::LayerField, weather::kMaxLayers> const& here;

    std::array<glm::vec4, weather::kMaxLayers> at(glm::dvec2 offset) const {
        glm::dvec3 const& camera = snapshot.camera.positionWorld;
        weather::Weather const there = snapshot.field->at(camera.x + offset.x, -camera.z + offset.y, snapshot.time);
        glsl::CloudColumn const columns = weather::CloudColumns{there, snapshot.seed, snapshot.clouds}.bare();
        std::array<glm::vec4, weather::kMaxLayers> values{};
        for (std::size_t i = 0; i < static_cast<std::size_t>(sky.layerCount); ++i)
            values[i] = sameLayer(there, columns, sky.layers[i], here[i].centre);
        return values;
    }
};

void widen(glsl::LayerField& field, glm::vec4 const& value) {
    field.low = glm::min(field.low, value);
    field.high = glm::max(field.high, value);
}

/// A ramp across the line of a front, level on both sides.
void layAlong(weather::FrontNear const& front, Elsewhere const& elsewhere, std::array<glsl::LayerField, weather::kMaxLayers>& fields) {
    constexpr double kRampShare = 1.6; // of its 10 to 90 %: the straight ramp from 0 to 1
    auto const ahead = elsewhere.at(front.toward * (-front.distance + kBeside * front.width));
    auto const behind = elsewhere.at(front.toward * (-front.distance - kBeside * front.width));
    double const ramp = kRampShare * front.width;
    for (std::size_t i = 0; i < fields.size(); ++i) {
        glm::vec4 const change = ahead[i] - behind[i];
        fields[i].low = glm::min(ahead[i], behind[i]);
        fields[i].high = glm::max(ahead[i], behind[i]);
        fields[i].centre = behind[i] + change * static_cast<float>(0.5 + front.distance / ramp);
        fields[i].eastward = change * static_cast<float>(front.toward.x / ramp);
        fields[i].southward = change * static_cast<float>(-front.toward.y / ramp);
    }
}
}  // namespace

weather::Weather skyAround(Snapshot const& snapshot) {
    weather::Weather sky = snapshot.weather;
    if (snapshot.field == nullptr) return sky;
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    std::vector<glm::dvec2> offsets{{kReach, 0.0}, {-kReach, 0.0}, {0.0, kReach}, {0.0, -kReach}};
    if (auto const front = snapshot.field->front(camera.x, -camera.z, snapshot.time); front && std::abs(front->distance) < kReach)
        offsets = {front->toward * (-front->distance - kBeside * front->width), front->toward * (-front->distance + kBeside * front->width)};
    for (glm::dvec2 const offset : offsets) {
        weather::Weather const there = snapshot.field->at(camera.x + offset.x, -camera.z + offset.y, snapshot.time);
        for (int i = 0; i < there.layerCount && sky.layerCount < weather::kMaxLayers; ++i) {
            weather::Layer layer = there.layers[static_cast<std::size_t>(i)];
            auto const known = sky.layers.begin() + sky.layerCount;
            if (std::any_of(sky.layers.begin(), known, [&](weather::Layer const& l) { return l.pattern == layer.pattern; })) continue;
            layer.cover = 0.0f;
            sky.layers[static_cast<std::size_t>(sky.layerCount++)] = layer;
        }
    }
    std::stable_sort(sky.layers.begin(), sky.layers.begin() + sky.layerCount, [](auto const& a, auto const& b) { return a.base < b.base; });
    return sky;
}

std::array<glsl::LayerField, weather::kMaxLayers> layerFields(Snapshot const& snapshot, weather::Weather const& sky) {
    std::array<glsl::LayerField, weather::kMaxLayers> fields{};
    glm::dvec3 const& camera = snapshot.camera.positionWorld;
    glsl::CloudColumn const here = weather::CloudColumns{sky, snapshot.seed, snapshot.clouds}.bare();
    for (std::size_t i = 0; i < fields.size(); ++i) {
        glm::vec4 const v = columnOf(here.layers[i]);
        fields[i] = {v, glm::vec4{0.0f}, glm::vec4{0.0f}, v, v};
    }
    if (snapshot.field == nullptr) return fields;
    Elsewhere const elsewhere{snapshot, sky, fields};
    auto const front = snapshot.field->front(camera.x, -camera.z, snapshot.time);
    if (front && std::abs(front->distance) < kReach) {
        std::array<glsl::LayerField, weather::kMaxLayers> across = fields;
        layAlong(*front, elsewhere, across);
        return across;
    }
    auto const east = elsewhere.at({kReach, 0.0}), west = elsewhere.at({-kReach, 0.0});
    auto const north = elsewhere.at({0.0, kReach}), south = elsewhere.at({0.0, -kReach});
    for (std::size_t i = 0; i < static_cast<std::size_t>(sky.layerCount); ++i) {
        for (glm::vec4 const& value : {east[i], west[i], north[i], south[i]}) widen(fields[i], value);
        fields[i].eastward = (east[i] - west[i]) / static_cast<float>(2.0 * kReach);
        fields[i].southward = (south[i] - north[i]) / static_cast<float>(2.0 * kReach);
    }
    return fields;
}
}  // namespace luftpost::render
