// What stands over one point: a pure function of field, place, time and seed, that the air, the plan and the cloud map
// ask. No GL, any thread.
#pragma once
#include <vector>

#include "engine/core/environment.h"
#include "engine/weather/cloud_pattern.h"
#include "engine/weather/cloud_settings.h"
#include "engine/weather/field.h"
#include "engine/weather/weather.h"
#include "shaders/shared/cloud.glsl.h"

namespace luftpost::weather {
/// Cloud columns of one weather: prepares the patterns of its layers once, answers for many points. Holds where the
/// weather hardly changes over the points asked for; uses + - x / sqrt alone.
class CloudColumns {
public:
    CloudColumns(Weather const& weather, unsigned seed, CloudSettings const& settings = {});

    /// The column over a point of the world, m east and north.
    glsl::CloudColumn at(double east, double north) const;

    /// The same for all points: every layer without its rank (1).
    glsl::CloudColumn const& bare() const { return bare_; }
    int layerCount() const { return static_cast<int>(patterns_.size()); }
    LayerPattern const& pattern(int layer) const { return patterns_[static_cast<std::size_t>(layer)]; }

private:
    glsl::CloudColumn bare_;  // all but the ranks
    std::vector<LayerPattern> patterns_;
    std::vector<glm::vec4> carried_;  // anvilWay of each
    double scale_ = 1.0;
};

/// The same for one point: asks the field there. About 2 us a layer.
glsl::CloudColumn cloudColumn(Field const& field, double east, double north, core::UtcSeconds time, unsigned seed);

/// The rank below which a layer of this genus, cover and thickness (m) has cloud, so that the share of the ground
/// with an optical depth above 0.3 (0.05 for Ci, Cc, Cs) is the cover. Rising with cover; below 0 for none, 1 and
/// more for a closed layer.
float calibratedCover(Genus genus, float cover, float thickness);

/// How far a layer's anvil is carried downwind of its towers: LayerShape's fibre of what has an anvil, nothing for others.
glm::vec4 anvilWay(Layer const& layer, CloudSettings const& settings = {});

/// Form and noise of the layers of a weather. `origin`: where the frame of `density`'s points lies in the world, m
/// east and north.
glsl::CloudShape cloudShape(Weather const& weather, unsigned seed, glm::dvec2 const& originEastNorth,
                            CloudSettings const& settings = {});
}  // namespace luftpost::weather
