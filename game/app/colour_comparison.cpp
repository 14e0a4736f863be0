#include "game/app/colour_comparison.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include <glm/glm.hpp>

#include "engine/assets/image_mean.h"
#include "engine/core/check.h"

namespace luftpost::app {
namespace {
// Bins of 10: L* 0..100, a* and b* -100..100.
constexpr double kBin = 10.0;
constexpr int kLightBins = 11, kHueBins = 21;
constexpr int kFine = 256;  // bins of one coordinate for the distance

double curve(double t) { return t > 216.0 / 24389.0 ? std::cbrt(t) : (24389.0 / 27.0 * t + 16.0) / 116.0; }

/// L*, a*, b* of display-encoded sRGB, white D65 (IEC 61966-2-1, CIE 15).
glm::dvec3 labOf(std::uint8_t const* rgb) {
    glm::dvec3 const c{assets::linearOf(rgb[0] / 255.0), assets::linearOf(rgb[1] / 255.0), assets::linearOf(rgb[2] / 255.0)};
    double const x = curve((0.4124 * c.x + 0.3576 * c.y + 0.1805 * c.z) / 0.95047);
    double const y = curve(0.2126 * c.x + 0.7152 * c.y + 0.0722 * c.z);
    double const z = curve((0.0193 * c.x + 0.1192 * c.y + 0.9505 * c.z) / 1.08883);
    return {116.0 * y - 16.0, 500.0 * (x - y), 200.0 * (y - z)};
}

struct Histogram {
    std::vector<double> joint = std::vector<double>(kLightBins * kHueBins * kHueBins);
    std::array<std::vector<double>, 3> single{std::vector<double>(kFine), std::vector<double>(kFine), std::vector<double>(kFine)};

    void add(glm::dvec3 const& lab, double share) {
        glm::dvec3 const at = glm::clamp(glm::dvec3{lab.x / kBin, lab.y / kBin + 10.0, lab.z / kBin + 10.0}, glm::dvec3{0.0},
                                         glm::dvec3{kLightBins - 1.001, kHueBins - 1.001, kHueBins - 1.001});
        glm::ivec3 const low{at};
        glm::dvec3 const part = at - glm::dvec3{low};
        for (int corner = 0; corner < 8; ++corner) {
            glm::ivec3 const far{corner & 1, corner >> 1 & 1, corner >> 2 & 1}, bin = low + far;
            double weight = share;
            for (int i = 0; i < 3; ++i) weight *= far[i] ? part[i] : 1.0 - part[i];
            joint[static_cast<std::size_t>((bin.x * kHueBins + bin.y) * kHueBins + bin.z)] += weight;
        }
        for (int i = 0; i < 3; ++i) {
            double const unit = i == 0 ? lab[i] / 100.0 : (lab[i] + 100.0) / 200.0;
            single[static_cast<std::size_t>(i)][static_cast<std::size_t>(std::clamp(unit, 0.0, 0.9999) * kFine)] += share;
        }
    }
};

Histogram histogramOf(assets::Image const& image) {
    Histogram histogram;
    double const share = 1.0 / (static_cast<double>(image.width) * image.height);
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) histogram.add(labOf(&image.at(x, y, 0)), share);
    return histogram;
}

/// In one dimension: the sum of the cumulated differences, in units of a coordinate `range` wide.
double earthMovers(std::vector<double> const& a, std::vector<double> const& b, double range) {
    double moved = 0.0, open = 0.0;
    for (std::size_t i = 0; i < a.size(); ++i) moved += std::abs(open += a[i] - b[i]);
    return moved * range / static_cast<double>(a.size());
}
}  // namespace

assets::Image resampled(assets::Image const& image, int width, int height) {
    CHECK(width > 0 && height > 0 && image.width > 0 && image.channels >= 3, "an image of {} x {}", width, height);
    double const step = std::min(static_cast<double>(image.width) / width, static_cast<double>(image.height) / height);
    double const left = 0.5 * (image.width - step * width), top = 0.5 * (image.height - step * height);
    auto const pixels = [](double from, double to, int size) {  // at least one: where it grows, the one under the point
        if (to - from < 1.0) from = std::floor(0.5 * (from + to)), to = from + 1.0;
        int const low = std::clamp(static_cast<int>(std::floor(from + 0.5)), 0, size - 1);
        return std::pair{low, std::clamp(static_cast<int>(std::floor(to + 0.5)), low + 1, size)};
    };
    assets::Image result{width, height, 3, {}};
    result.values.resize(result.index(0, height, 0));
    for (int y = 0; y < height; ++y) {
        auto const [y0, y1] = pixels(top + step * y, top + step * (y + 1), image.height);
        for (int x = 0; x < width; ++x) {
            auto const [x0, x1] = pixels(left + step * x, left + step * (x + 1), image.width);
            std::array<unsigned long, 3> sum{};
            for (int v = y0; v < y1; ++v)
                for (int u = x0; u < x1; ++u)
                    for (int c = 0; c < 3; ++c) sum[static_cast<std::size_t>(c)] += image.at(u, v, c);
            auto const count = static_cast<unsigned long>(y1 - y0) * static_cast<unsigned long>(x1 - x0);
            for (int c = 0; c < 3; ++c) result.at(x, y, c) = static_cast<std::uint8_t>((sum[static_cast<std::size_t>(c)] + count / 2) / count);
        }
    }
    return result;
}

ColourComparison compareColours(assets::Image const& picture, assets::Image const& photo) {
    int const height = std::max(1, static_cast<int>(std::lround(static_cast<double>(kComparedWidth) * picture.height / picture.width)));
    Histogram const a = histogramOf(resampled(picture, kComparedWidth, height)), b = histogramOf(resampled(photo, kComparedWidth, height));
    ColourComparison comparison;
    for (std::size_t i = 0; i < a.joint.size(); ++i) comparison.alike += std::min(a.joint[i], b.joint[i]);
    comparison.lightness = earthMovers(a.single[0], b.single[0], 100.0);
    comparison.redGreen = earthMovers(a.single[1], b.single[1], 200.0);
    comparison.yellowBlue = earthMovers(a.single[2], b.single[2], 200.0);
    return comparison;
}

std::string comparisonText(ColourComparison const& c) {
    return fmt::format("colours alike {:.3f} (CIELAB histogram intersection, 0..1); to move: L* {:.1f}, a* {:.1f}, b* {:.1f}", c.alike, c.lightness,
                       c.redGreen, c.yellowBlue);
}

assets::Image sideBySide(assets::Image const& picture, assets::Image const& photo) {
    assets::Image const right = resampled(photo, picture.width, picture.height);
    assets::Image both{2 * picture.width, picture.height, 4, {}};
    both.values.assign(both.index(0, both.height, 0), 255);
    for (int y = 0; y < picture.height; ++y)
        for (int x = 0; x < picture.width; ++x)
            for (int c = 0; c < 3; ++c) {
                both.at(x, y, c) = picture.at(x, y, c);
                both.at(picture.width + x, y, c) = right.at(x, y, c);
            }
    return both;
}
}  // namespace luftpost::app
