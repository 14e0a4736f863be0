// The air: the one function air(position, time). Wind with gusts and turbulence, lift and sink, density, temperature,
// pressure, visibility, icing, rain, snow and hail. Pure: the same bits for the same field, seed, settings, position and time, on any thread.
#pragma once
#include <memory>

#include "engine/core/environment.h"
#include "engine/weather/cloud_settings.h"
#include "engine/weather/field.h"

namespace luftpost::weather {
class AirInstant;
struct NoiseVolumes;

class Air {
public:
    /// Keeps references: `field` and `noise` must outlive the air. `ground` is asked at the nodes of lattices and remembered.
    /// With `noise` the visibility and the icing inside clouds come from the density that is drawn; without it clouds dim
    /// nothing.
    Air(Field const& field, core::GroundFunction ground, unsigned seed, NoiseVolumes const* noise = nullptr);

    /// The air at one moment: prepare it once a tick, then ask it at many points. Cheap to copy. The
    /// settings that move clouds move their lift with them.
    AirInstant instant(core::UtcSeconds time, CloudSettings const& settings = {}) const;

    /// The same in one call, for a single point.
    core::AirSample at(glm::dvec3 const& positionWorld, core::UtcSeconds time) const;

private:
    friend class AirInstant;
    struct Data;
    std::shared_ptr<Data const> data_;
};

class AirInstant {
public:
    /// positionWorld in m; the wind below the ground is that on the ground. About a microsecond.
    core::AirSample at(glm::dvec3 const& positionWorld) const;
    core::UtcSeconds time() const;

private:
    friend class Air;
    struct Now;
    AirInstant(std::shared_ptr<Air::Data const> data, std::shared_ptr<Now const> now);
    std::shared_ptr<Air::Data const> data_;
    std::shared_ptr<Now const> now_;
};
}  // namespace luftpost::weather
