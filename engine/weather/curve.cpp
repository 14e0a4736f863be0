#include "engine/weather/curve.h"

#include <algorithm>

#include "engine/core/check.h"

namespace luftpost::weather {
namespace {
constexpr double kRampShare = 0.2;       // of the interval
constexpr double kRampLongest = 600.0;   // s

/// Slope at a knot between two pieces of widths h0, h1 and secants d0, d1.
double harmonicSlope(double h0, double d0, double h1, double d1) {
    if (d0 * d1 <= 0.0) return 0.0;
    double const w0 = 2.0 * h1 + h0, w1 = h1 + 2.0 * h0;
    return (w0 + w1) / (w0 / d0 + w1 / d1);
}
}  // namespace

Curve::Curve(std::vector<double> times, std::vector<double> values) : times_{std::move(times)}, values_{std::move(values)} {
    std::size_t const n = times_.size();
    CHECK(n > 0 && values_.size() == n, "{} times for {} values", n, values_.size());
    slopes_.assign(n, 0.0);
    integrals_.assign(n, 0.0);
    std::vector<double> widths, secants;
    for (std::size_t k = 0; k + 1 < n; ++k) {
        widths.push_back(times_[k + 1] - times_[k]);
        CHECK(widths[k] > 0.0, "knot {} is not after knot {}", k + 1, k);
        secants.push_back((values_[k + 1] - values_[k]) / widths[k]);
    }
    for (std::size_t k = 1; k + 1 < n; ++k) slopes_[k] = harmonicSlope(widths[k - 1], secants[k - 1], widths[k], secants[k]);
    // The ends start from the nearest secant, which keeps the end pieces monotone.
    if (n > 1) {
        slopes_[0] = secants[0];
        slopes_[n - 1] = secants[n - 2];
    }
    for (std::size_t k = 0; k + 1 < n; ++k) integrals_[k + 1] = integrals_[k] + integralOver(k, 1.0);
}

Curve::Spot Curve::spotOf(double time) const {
    auto const after = std::upper_bound(times_.begin(), times_.end(), time);
    auto const last = static_cast<std::ptrdiff_t>(times_.size()) - 2;
    auto const piece = static_cast<std::size_t>(std::clamp<std::ptrdiff_t>(after - times_.begin() - 1, 0, last));
    double const width = times_[piece + 1] - times_[piece];
    return {piece, width, (time - times_[piece]) / width};
}

double Curve::at(double time) const {
    if (!(time > times_.front())) return values_.front();
    if (!(time < times_.back())) return values_.back();
    auto const [k, width, u] = spotOf(time);
    double const rise = values_[k + 1] - values_[k];
    double const m0 = slopes_[k] * width, m1 = slopes_[k + 1] * width;
    return values_[k] + u * (m0 + u * (3.0 * rise - 2.0 * m0 - m1 + u * (m0 + m1 - 2.0 * rise)));
}

double Curve::slopeAt(double time) const {
    if (time < times_.front() || time > times_.back() || times_.size() == 1) return 0.0;
    auto const [k, width, u] = spotOf(time);
    double const rise = values_[k + 1] - values_[k];
    double const m0 = slopes_[k] * width, m1 = slopes_[k + 1] * width;
    return (m0 + u * (2.0 * (3.0 * rise - 2.0 * m0 - m1) + u * 3.0 * (m0 + m1 - 2.0 * rise))) / width;
}

double Curve::integralOver(std::size_t k, double u) const {
    double const width = times_[k + 1] - times_[k];
    double const rise = values_[k + 1] - values_[k];
    double const m0 = slopes_[k] * width, m1 = slopes_[k + 1] * width;
    double const square = 3.0 * rise - 2.0 * m0 - m1, cube = m0 + m1 - 2.0 * rise;
    return width * u * (values_[k] + u * (m0 / 2.0 + u * (square / 3.0 + u * cube / 4.0)));
}

double Curve::integralTo(double time) const {
    if (!(time > times_.front())) return values_.front() * (time - times_.front());
    if (!(time < times_.back())) return integrals_.back() + values_.back() * (time - times_.back());
    auto const [k, width, u] = spotOf(time);
    return integrals_[k] + integralOver(k, u);
}

SumCurve::SumCurve(std::vector<double> const& edges, std::vector<double> const& rates) {
    CHECK(edges.size() == rates.size() + 1, "{} edges for {} intervals", edges.size(), rates.size());
    std::vector<double> sums{0.0};
    for (std::size_t k = 0; k < rates.size(); ++k) sums.push_back(sums[k] + rates[k] * (edges[k + 1] - edges[k]));
    sums_ = Curve{edges, sums};
}

double SumCurve::rateAt(double time) const {
    return std::max(0.0, sums_.slopeAt(std::clamp(time, sums_.times().front(), sums_.times().back())));
}

MaximumCurve::MaximumCurve(std::vector<double> ends, std::vector<double> maxima) : ends_{std::move(ends)}, maxima_{std::move(maxima)} {
    CHECK(!ends_.empty() && ends_.size() == maxima_.size(), "{} ends for {} maxima", ends_.size(), maxima_.size());
}

double MaximumCurve::at(double time) const {
    if (!(time > ends_.front())) return maxima_.front();
    if (!(time < ends_.back())) return maxima_.back();
    auto const k = static_cast<std::size_t>(std::lower_bound(ends_.begin(), ends_.end(), time) - ends_.begin());
    double const ramp = std::min(kRampShare * (ends_[k] - ends_[k - 1]), kRampLongest);
    double const u = std::clamp((time - ends_[k - 1]) / ramp, 0.0, 1.0);
    return maxima_[k - 1] + (maxima_[k] - maxima_[k - 1]) * u * u * (3.0 - 2.0 * u);
}
}  // namespace luftpost::weather
