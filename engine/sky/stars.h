// The brightest stars, and a lookup that finds those near a direction.
#pragma once
#include <array>
#include <span>
#include <vector>

#include <glm/glm.hpp>

namespace luftpost::sky {
/// Right ascension (hours) and declination (degrees), J2000; visual magnitude; colour index B - V.
struct Star {
    float ra_h, dec_deg, magnitude, colourIndex;
};

/// The stars brighter than magnitude 2.6 and a few that complete well-known figures. Source: Yale Bright Star
/// Catalogue, 5th edition (Hoffleit and Warren 1991), rounded.
std::span<Star const> brightStars();

/// Irradiance of a star above the air, the sun's being 1, Rec. 709: magnitude 0 gives 2.54e-6 lx (Allen), the colour
/// is that of a black body at Ballesteros' (2012) temperature of B - V.
glm::vec3 starIrradiance(float magnitude, float colourIndex);
/// Unit vector in the J2000 frame (x toward 0 h, z north).
glm::vec3 starDirection(Star const& star);

inline constexpr int kStarColumns = 32, kStarRows = 16;
/// Stars by cell of right ascension and declination, each in all cells that its glow (1 degree) reaches.
struct StarGrid {
    std::vector<glm::vec4> stars;                              // two each: xyz direction; rgb irradiance
    std::array<glm::ivec2, kStarColumns * kStarRows> cells{};  // first star, number of stars
};
StarGrid starGrid();
}  // namespace luftpost::sky
