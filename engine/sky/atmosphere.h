// The air of one place and hour, the light in it: the C++ build of shaders/lib/atmosphere.glsl with its tables.
#pragma once
#include <vector>

#include <glm/glm.hpp>

#include "engine/sky/sky_state.h"
#include "shaders/shared/atmosphere.glsl.h"
#include "shaders/shared/sampler2d.glsl.h"

namespace luftpost::sky {
/// What the weather says of the air, SI.
struct AirConditions {
    double visibility = 6.0e4;       // m, 5 % contrast, near the ground
    double groundAltitude = 0.0;     // m above sea level: where haze and fog lie
    double fogDepth = 220.0;         // m: scale height of what is thicker than haze
    double cloudBase = 1.0e5;        // m above sea level: of the clouds that `cover` counts
    double cover = 0.0;              // 0..1: share of the sky under cloud, each layer weighed by how dense it is
    double closedShare = 0.25;       // share of the clear day's light that comes down where these clouds close the sky
    double groundAlbedo = 0.18;      // of the land around
    double landCover = 0.0;          // as `cover`, but over the land: less than `cover` counts as that
    double cloudTop = 1.0e5;         // m above sea level: of the clouds that reflect most
    double cloudAlbedo = 0.0;        // share of the light from above that all clouds send back, in the mean over the land
    bool operator==(AirConditions const&) const = default;
};

/// Optical properties of that air. Molecules: Teillet 1990 (Applied Optics 29, 1897); ozone 300 Dobson units with the
/// Chappuis band of Serdyuchenko 2014; haze extinction by Koschmieder, 3.0 / visibility less the molecules', with an
/// Angstrom exponent of 1.2; what is thicker than a visibility of 12 km lies in a shallow layer of fog.
glsl::Atmosphere atmosphere(AirConditions const& conditions);

/// Share of the clear day's global irradiance under `cover` of clouds that leave `closedShare` where they close the sky
/// (Kasten and Czeplak 1980, Solar Energy 24, 177: a quarter in the mean of all).
double globalShareUnder(double cover, double closedShare = 0.25);
/// Share of the direct beam that comes through `cover` in the mean over the land: less than the gaps from above, since
/// clouds have sides.
double directShareUnder(double cover);

/// The two tables of an atmosphere on the CPU, and what follows from them. Immutable once made (some 10 ms of work);
/// all functions are pure and may be called from any thread.
class AtmosphereTables {
public:
    explicit AtmosphereTables(glsl::Atmosphere const& air);

    glsl::Atmosphere const& air() const { return air_; }
    /// Share of a light above the air that reaches `altitude` from elevation `elevation` (rad); its disc sinks.
    glm::vec3 direct(double altitude, double elevation, double angularRadius) const;
    /// Radiance of the sky toward `direction` per unit irradiance of a light at `light` (both world, unit), 1/sr.
    glm::vec3 radiance(double altitude, glm::dvec3 const& direction, glm::dvec3 const& light) const;
    /// Irradiance of the sky alone on a horizontal plane, per unit irradiance of a light at `elevation` (rad).
    glm::vec3 skyIrradiance(double altitude, double elevation) const;
    /// Transmittance of the air over `distance` toward a direction of this elevation (rad).
    glm::vec3 transmittance(double altitude, double elevation, double distance) const;

private:
    glsl::sampler2D transmittanceTable() const;
    glsl::sampler2D multipleTable() const;

    glsl::Atmosphere air_;
    std::vector<glm::vec4> transmittance_;
    std::vector<glm::vec4> multiple_;
};
}  // namespace luftpost::sky
