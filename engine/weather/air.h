// The air: the one function air(position, time). Wind with gusts and turbulence, lift and sink, density, temperature,
// pressure, visibility, icing. Pure: the same bits for the same field, seed, position and time, on any thread.
#pragma once
#include <memory>

#include "engine/core/environment.h"
#include "engine/weather/field.h"

namespace luftpost::weather {
class AirInstant;

class Air {
public:
    /// Keeps references: `field` must outlive the air. `ground` is asked on a coarse lattice and remembered.
    Air(Field const& field, core::GroundFunction ground, unsigned seed);
    ~Air();
    Air(Air&&) noexcept;
    Air& operator=(Air&&) noexcept;

    /// The air at one moment: prepare it once a tick, then ask it at many points. Cheap to copy; valid while the Air lives.
    AirInstant instant(core::UtcSeconds time) const;

    /// The same in one call, for a single point.
    core::AirSample at(glm::dvec3 const& positionWorld, core::UtcSeconds time) const;

private:
    friend class AirInstant;
    struct Data;
    std::unique_ptr<Data> data_;
};

class AirInstant {
public:
    /// positionWorld in m; below the ground it is taken as on the ground.
    core::AirSample at(glm::dvec3 const& positionWorld) const;
    core::UtcSeconds time() const { return time_; }

private:
    friend class Air;
    AirInstant(Air::Data const& data, core::UtcSeconds time);
    Air::Data const* data_;
    core::UtcSeconds time_;
};
}  // namespace luftpost::weather
