// How particles turn light: phase functions that can be asked and drawn from. Pure, any thread.
#pragma once
#include <array>

#include <glm/glm.hpp>

#include "engine/core/random.h"

namespace luftpost::sky {
/// A mixture of Henyey and Greenstein's lobes, or Rayleigh's function. Integrates to 1 over the sphere.
class Phase {
public:
    struct Lobe {
        float share;  // of the light; the shares add up to 1
        float g;      // asymmetry, -1 < g < 1
    };
    /// Up to three lobes; a share of 0 ends the list.
    explicit Phase(std::array<Lobe, 3> const& lobes) : lobes_{lobes} {}
    static Phase henyeyGreenstein(float g) { return Phase{{Lobe{1.0f, g}}}; }
    static Phase rayleigh();
    /// Droplets, whose forward lobe has the asymmetry g: shaders/lib/cloud_light.glsl's cloudPhase.
    static Phase cloud(float g);
    /// Haze: shaders/lib/atmosphere.glsl's hazePhase.
    static Phase haze();

    /// 1/sr, for the cosine of the angle between the way in and the way out.
    float at(float cosine) const;
    /// A cosine, drawn with that density.
    double draw(core::Random& random) const;

private:
    std::array<Lobe, 3> lobes_{};
    bool rayleigh_ = false;
};

/// The unit vector at this cosine from `direction` (unit), at a random angle around it.
glm::dvec3 turned(glm::dvec3 const& direction, double cosine, core::Random& random);

/// A unit vector above a plane, as often as Lambert's law sends light that way.
glm::dvec3 lambertian(glm::dvec3 const& normal, core::Random& random);

/// A unit vector of the sphere, all alike.
glm::dvec3 isotropic(core::Random& random);
}  // namespace luftpost::sky
