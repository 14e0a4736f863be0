// The calibrated cover of every genus. Written by assets/make/cover_table.cpp; do not edit.
#pragma once
#include <array>

namespace luftpost::weather::table {
/// Covers and thicknesses (m) of the table's rows and columns.
inline constexpr std::array<float, 9> kCovers{0.02f, 0.05f, 0.1f, 0.25f, 0.5f, 0.75f, 0.9f, 0.95f, 0.98f};
inline constexpr std::array<float, 3> kThicknesses{300.0f, 1000.0f, 3000.0f};
/// The rank's threshold, by genus, thickness and cover.
inline constexpr std::array<std::array<std::array<float, 9>, 3>, 11> kThresholds{};
}  // namespace luftpost::weather::table
