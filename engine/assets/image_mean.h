// Pictures made smaller by a whole number: a pixel is the mean of what it covers.
#pragma once
#include "engine/assets/image.h"

namespace luftpost::assets {
/// sRGB -> linear (IEC 61966-2-1), both 0..1.
double linearOf(double encoded);

/// Of squares of `side` x `side` pixels, channel by channel; both sides of the picture are multiples of `side` >= 1.
FloatImage meanOf(FloatImage const& picture, int side);
/// The same of light: colours are decoded from sRGB and encoded again; a fourth channel is taken as it is.
Image meanOf(Image const& picture, int side);
}  // namespace luftpost::assets
