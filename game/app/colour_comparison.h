// How alike the colours of two pictures are, wherever in the picture they stand.
#pragma once
#include <string>

#include "engine/assets/image.h"

namespace luftpost::app {
/// Of two pictures brought to the same size.
struct ColourComparison {
    /// Histogram intersection in CIELAB (sum over bins of the smaller share; bins of 10 in L*, a*, b*, each pixel shared linearly
    /// between its eight nearest): 0 no colour in common, 1 the same shares of the same colours.
    double alike = 0.0;
    /// Earth mover's distance between the histograms of each coordinate, in its own units (L* 0..100, a* + is red, b* + is yellow):
    /// how far the picture's values must be moved on average. 0: none.
    double lightness = 0.0, redGreen = 0.0, yellowBlue = 0.0;
};

/// Mean of the pixels under each point of a picture of `width` x `height`; the middle of `image` is taken in that shape, what
/// stands over is cut. RGB, alpha left out.
assets::Image resampled(assets::Image const& image, int width, int height);

/// Points across at which two pictures are compared.
inline constexpr int kComparedWidth = 256;

/// `photo` is cut to the shape of `picture`, both are reduced to kComparedWidth points across. Display-encoded sRGB, D65.
ColourComparison compareColours(assets::Image const& picture, assets::Image const& photo);

/// "colours alike 0.731 (CIELAB histogram intersection, 0..1); to move: L* 4.1, a* 0.8, b* 3.2"
std::string comparisonText(ColourComparison const& comparison);

/// Both at the size of `picture`, left the picture, right the photograph: an image twice as wide, 4 channels.
assets::Image sideBySide(assets::Image const& picture, assets::Image const& photo);
}  // namespace luftpost::app
