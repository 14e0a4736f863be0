// A quantity over time: a monotone piecewise cubic through its knots. Pure arithmetic (+ - * /), so that every machine gets
// the same bits; immutable after construction.
#pragma once
#include <vector>

namespace luftpost::weather {
/// Fritsch and Butland (1984): cubic Hermite pieces whose slopes at the knots are weighted harmonic means of the secants'
/// (0 at an extremum): passes through every knot, once differentiable, never beyond its two neighbours. Outside the
/// knots the end value is held.
class Curve {
public:
    Curve() = default;
    /// `times` strictly ascending, as many as `values`, at least one.
    Curve(std::vector<double> times, std::vector<double> values);

    double at(double time) const;
    /// Its derivative; 0 outside the knots.
    double slopeAt(double time) const;
    /// Its integral from the first knot to `time` in closed form (negative before it; the held ends count).
    double integralTo(double time) const;

    std::vector<double> const& times() const { return times_; }
    std::vector<double> const& values() const { return values_; }

private:
    struct Spot {
        std::size_t piece;
        double width, u;  // u 0..1 within the piece
    };
    Spot spotOf(double time) const;
    double integralOver(std::size_t piece, double u) const;

    std::vector<double> times_, values_, slopes_, integrals_;  // integrals_[k]: from knot 0 to knot k
};

/// A rate whose integral over every interval is what was measured there: the slope of a monotone curve through the sums.
/// Continuous, never negative, the end value held.
class SumCurve {
public:
    SumCurve() = default;
    /// Interval k reaches from edges[k] to edges[k + 1] (strictly ascending) and has the mean rate rates[k] >= 0.
    SumCurve(std::vector<double> const& edges, std::vector<double> const& rates);
    double rateAt(double time) const;

private:
    Curve sums_;
};

/// The largest value of each interval: within the first part of an interval it goes over from the last one's value, then it
/// holds, so that at the interval's end it is exactly what was reported.
class MaximumCurve {
public:
    MaximumCurve() = default;
    /// maxima[k] holds for the interval that ends at ends[k] (strictly ascending).
    MaximumCurve(std::vector<double> ends, std::vector<double> maxima);
    double at(double time) const;

private:
    std::vector<double> ends_, maxima_;
};
}  // namespace luftpost::weather
