// Spectral light as linear Rec. 709. Pure, any thread.
#pragma once
#include <glm/glm.hpp>

namespace luftpost::sky {
inline constexpr int kWavelengths = 31;  // from 400 to 700 nm

/// nm, of the i-th of kWavelengths.
constexpr double wavelength_nm(int i) { return 400.0 + 10.0 * i; }

/// What a spectrum that is 1 at the i-th wavelength and 0 at the others adds to linear Rec. 709; all of them together give (1, 1, 1).
/// CIE 1931's colour matching by the fits of Wyman, Sloan and Shirley (2013). Components may be negative.
glm::dvec3 spectralColour(int i);

/// Refractive index of water at 20 C (Quan and Fry 1995, Applied Optics 34, 3477, no salt).
double waterIndex(double wavelength_nm);

/// Refractive index of ice (Warren and Brandt 2008: 1.3194, 1.3110, 1.3069 at 400, 550, 700 nm; a Cauchy curve through them).
double iceIndex(double wavelength_nm);
}  // namespace luftpost::sky
