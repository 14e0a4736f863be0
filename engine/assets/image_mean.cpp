#include "engine/assets/image_mean.h"

#include <array>
#include <cmath>

#include "engine/core/check.h"
#include "shaders/lib/tone.glsl"

namespace luftpost::assets {
namespace {
/// `value(stored)` is what is averaged, `stored(mean, channel)` what is kept of it.
template <class T, class Value, class Stored>
ImageOf<T> means(ImageOf<T> const& picture, int side, Value const& value, Stored const& stored) {
    CHECK(side >= 1 && picture.width % side == 0 && picture.height % side == 0, "squares that do not fill the picture");
    if (side == 1) return picture;
    ImageOf<T> result{picture.width / side, picture.height / side, picture.channels, {}};
    result.values.resize(result.index(0, result.height, 0));
    double const share = 1.0 / (static_cast<double>(side) * side);
    for (int y = 0; y < result.height; ++y)
        for (int x = 0; x < result.width; ++x)
            for (int channel = 0; channel < picture.channels; ++channel) {
                double sum = 0.0;
                for (int j = 0; j < side; ++j)
                    for (int i = 0; i < side; ++i) sum += value(picture.at(side * x + i, side * y + j, channel), channel);
                result.at(x, y, channel) = stored(share * sum, channel);
            }
    return result;
}
}  // namespace

double linearOf(double encoded) { return encoded <= 0.04045 ? encoded / 12.92 : std::pow((encoded + 0.055) / 1.055, 2.4); }

FloatImage meanOf(FloatImage const& picture, int side) {
    return means(picture, side, [](float value, int) { return static_cast<double>(value); }, [](double mean, int) { return static_cast<float>(mean); });
}

Image meanOf(Image const& picture, int side) {
    std::array<double, 256> light{};
    for (std::size_t i = 0; i < light.size(); ++i) light[i] = linearOf(static_cast<double>(i) / 255.0);
    constexpr int kAlpha = 3;
    return means(picture, side, [&](std::uint8_t value, int channel) { return channel == kAlpha ? value / 255.0 : light[value]; },
                 [](double mean, int channel) {
                     double const encoded = channel == kAlpha ? mean : static_cast<double>(glsl::encodedChannel(static_cast<float>(mean)));
                     return static_cast<std::uint8_t>(std::lround(255.0 * encoded));
                 });
}
}  // namespace luftpost::assets
