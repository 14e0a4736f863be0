// The gusts against MIL-F-8785C: rms along long tracks and spectra, and what stability takes from them.
#include <gtest/gtest.h>

#include <cmath>
#include <complex>
#include <vector>

#include "engine/core/frames.h"
#include "engine/core/time.h"
#include "engine/weather/air.h"
#include "engine/weather/turbulence.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
constexpr double kFoot = 0.3048, kKnot = 0.514444;

/// Overcast high up and no sun to speak of: nothing but the wind stirs this air, neutral.
Field windyField(double knots) {
    Report report;
    report.time = *core::parseUtc("2023-12-21T12:00Z");
    report.speed_mps = knots * kKnot;
    report.gust_mps = 1.567 * knots * kKnot;  // so that W20 is the wind
    report.from_deg = 270.0;
    report.temperature_c = 3.0;
    report.dew_point_c = -4.0;
    report.pressure_hpa = 1013.25;
    report.precipitationKind = Precipitation::None;
    report.rate_mm_h = 0.0;
    report.layers.emplace();
    report.layers->push_back({Genus::As, 1.0, 4500.0, 6000.0});
    Site site;
    site.name = "flat land";
    site.lat_deg = 47.5;
    site.lon_deg = 7.6;
    site.elevation_m = 300.0;
    site.reports.push_back(report);
    Recording recording;
    recording.name = recording.file = "windy";
    recording.sites.push_back(site);
    return fieldFrom(recording, Origin{}, std::nullopt);
}
core::GroundSample flat(double, double) { return {300.0, {0.0, 1.0, 0.0}, core::Surface::grass}; }

/// The vertical wind along 60 km in steps of 10 m, in one of several directions.
std::vector<double> track(AirInstant const& air, double height, int run) {
    std::vector<double> w;
    double const bearing = 0.4 + 0.7 * run;
    for (int i = 0; i < 6000; ++i)
        w.push_back(air.at({10.0 * i * std::cos(bearing) + 4000.0 * run, 300.0 + height, 10.0 * i * std::sin(bearing) - 70000.0 * run}).windWorld.y);
    return w;
}
double rmsAt(AirInstant const& air, double height) {
    double squares = 0.0;
    int count = 0;
    for (int run = 0; run < 5; ++run)
        for (double const w : track(air, height, run)) squares += w * w, ++count;
    return std::sqrt(squares / count);
}
}  // namespace

// "At 500 ft: W20 25 ft/s gives 2.5 ft/s, 50 gives 5.05, 75 gives 7.6"; light, moderate, severe: W20 15, 30, 45 kt, above 2000 ft 5, 10, 20 ft/s.
TEST(Turbulence, HasTheSpecifiedRmsAlongLongFlightsInAllSeverities) {
    struct Severity {
        double knots, high;  // kt, ft/s
    };
    for (Severity const s : {Severity{15.0, 5.0}, Severity{30.0, 10.0}, Severity{45.0, 20.0}, Severity{25.0 * kFoot / kKnot, 25.0 * kFoot / kKnot / 3.0}}) {
        Field const field = windyField(s.knots);
        Air const air{field, flat, 3};
        AirInstant const now = air.instant(field.start());
        double const low = 0.1 * s.knots * kKnot, high = s.high * kFoot;
        EXPECT_NEAR(rmsAt(now, 152.4), low, 0.1 * low) << s.knots;
        EXPECT_NEAR(rmsAt(now, 1500.0 * kFoot), 0.5 * (low + high), 0.1 * 0.5 * (low + high)) << s.knots;
        EXPECT_NEAR(rmsAt(now, 2000.0 * kFoot), high, 0.1 * high) << s.knots;
        EXPECT_NEAR(now.at({0.0, 452.4, 0.0}).turbulence, low, 0.1 * low);
    }
}

namespace {
/// One-sided power of a record at a wave number (1/m), Hann window.
double powerAt(std::vector<double> const& record, double step, double k) {
    std::complex<double> sum = 0.0;
    double const n = static_cast<double>(record.size());
    for (std::size_t i = 0; i < record.size(); ++i) {
        double const x = static_cast<double>(i);
        sum += record[i] * (0.5 - 0.5 * std::cos(2.0 * core::kPi * x / n)) * std::polar(1.0, -k * step * x);
    }
    return std::norm(sum) * step / (0.375 * n * core::kPi);
}
}  // namespace

TEST(Turbulence, HasDrydensSpectrumOfVerticalGusts) {
    for (double const height : {152.4, 700.0}) {
        Gustiness const g = drydenGustiness(10.0, height);
        double const length = g.lengthVertical;
        double logHigh = 0.0, logLow = 0.0;
        for (double const lk : {0.3, 0.6, 1.2, 2.5, 5.0, 10.0}) {
            double power = 0.0;
            for (int run = 0; run < 16; ++run) {
                std::vector<double> w;
                double const bearing = 0.3 + 0.9 * run;
                for (int i = 0; i < 4096; ++i)
                    w.push_back(gustAt({6.0 * i * std::cos(bearing) + 3777.0 * run, height, 6.0 * i * std::sin(bearing) - 51171.0 * run}, g, 5).y);
                for (double const beside : {0.93, 1.0, 1.07}) power += powerAt(w, 6.0, beside * lk / length) / 48.0;
            }
            double const a = lk * lk, dryden = g.sigmaVertical * g.sigmaVertical * length / core::kPi * (1.0 + 3.0 * a) / ((1.0 + a) * (1.0 + a));
            EXPECT_GT(power, 0.5 * dryden) << height << " m, L k = " << lk;
            EXPECT_LT(power, 1.7 * dryden) << height << " m, L k = " << lk;
            if (lk == 2.5) logLow = std::log(power);
            if (lk == 10.0) logHigh = std::log(power);
        }
        EXPECT_NEAR((logHigh - logLow) / std::log(4.0), -2.0, 0.35) << "slope of the spectrum at " << height;
    }
}

TEST(Turbulence, AStableNightIsSmootherAloftButNotAtTheGround) {
    AirStability const night{0.3, 1.0};
    EXPECT_EQ(drydenGustiness(5.0, 20.0, night).sigmaVertical, drydenGustiness(5.0, 20.0).sigmaVertical);
    EXPECT_LT(drydenGustiness(5.0, 400.0, night).sigmaVertical, 0.4 * drydenGustiness(5.0, 400.0).sigmaVertical);
}
