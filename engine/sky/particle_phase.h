// How drops, droplets and ice crystals scatter: the phase functions in which rainbow, cloud bow, glory and halo stand. Computed from
// the refractive indices alone. Pure, any thread.
#pragma once
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::sky {
inline constexpr int kPhaseAngles = 1801;  // 0 to 180 degrees of scattering in steps of a tenth

/// By scattering angle, linear Rec. 709, 1/sr.
using PhaseTable = std::vector<glm::vec4>;

/// Rain drops, by geometric optics: rays that are mirrored, pass, and come back after one and two reflections inside (the two bows),
/// blurred by the sun's disc and by diffraction. Light that goes past a drop and is bent by less than a degree is not in it. Integrates to 1.
PhaseTable rainPhase();

/// Cloud droplets of an effective radius (m) by Mie's series: cloud bow and glory. Only from 110 degrees on, 0 below; there it is the
/// true phase function, of which the whole integrates to 1.
PhaseTable dropletPhase(double effectiveRadius);

/// Hexagonal ice columns in all directions, by geometric optics: the halos of 22 and 46 degrees. Diffraction apart. Integrates to 1.
PhaseTable icePhase();
}  // namespace luftpost::sky
