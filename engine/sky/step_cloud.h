// A textbook's cloud: a slab of equal columns side by side, periodic, infinite across, without air or ground. Radiative
// transfer codes are compared on such clouds (I3RC: Cahalan et al. 2005, BAMS 86, 1275), so ours is proven on them.
#pragma once
#include <cstdint>
#include <vector>

#include "engine/sky/path_tracer.h"

namespace luftpost::sky {
struct StepCloud {
    std::vector<double> depths;    // optical depth of each column, x rising; at least one, none negative
    double width = 500.0;          // m, of all columns together
    double thickness = 250.0;      // m
    double g = 0.85;               // Henyey and Greenstein's, -1 < g < 1
    double albedo = 1.0;           // of one scattering, 0..1
    double sunZenith = 0.0;        // rad, below pi / 2; the light goes toward +x
};

/// By column, over the flux that falls on one.
struct StepCloudFluxes {
    std::vector<double> reflectance, transmittance, absorptance;
};

/// Follows photons from the sun through the cloud on `workers` threads. The same figures for the same seed with any
/// number of workers. A relative noise of 0.22 % of each column in 20 million photons over 32 columns.
StepCloudFluxes photonFluxes(StepCloud const& cloud, std::int64_t photons, std::uint64_t seed, int workers);

/// The same the other way round: paths from the top and from the bottom that connect to the sun. `paths` for each column
/// and side. No absorptance.
StepCloudFluxes pathFluxes(StepCloud const& cloud, std::int64_t paths, std::uint64_t seed, int workers);

/// Radiance that comes to the middle of the cloud's top out of the cloud, where all around is of radiance 1 and the ways are
/// closed by connections to it, as those to the sun are: 1, whatever the cloud, where it absorbs nothing.
double furnaceRadiance(StepCloud const& cloud, std::int64_t paths, std::uint64_t seed);
}  // namespace luftpost::sky
