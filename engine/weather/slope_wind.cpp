#include "engine/weather/slope_wind.h"

#include <cmath>

#include "engine/weather/ramp.h"

namespace luftpost::weather {
namespace {
constexpr double kFull = 130.0;  // m above ground: up to here a slope is felt in full
/// 1/k of each size of the relief, m: a size of which half a wave is 400 m, 800 m, 1.6 km; the last one ends the reach.
constexpr std::array<double, kReliefBands> kDepth{120.0, 200.0, 370.0, 680.0};
constexpr double kReach = 3.0;                 // depths
constexpr double kSpeedUp = 1.1;               // of k h: so that a ridge of bell shape comes near Taylor and Lee's 2 H/L
constexpr double kSlowest = -0.5, kFastest = 0.6;  // of the wind
constexpr double kSteepest = 0.5;              // a slope is followed ever less beyond
constexpr double kStableLoss = 0.6;            // of the lift near the ground
constexpr double kTurn = 0.3;                  // of the wind's part up the slope
constexpr double kRough = 0.10, kRotor = 0.25;  // of the wind, rms over steep ground and in a rotor

/// As exp(-(z - 130 m)/depth), but ending at three depths (kReach).
double reachOf(double height, double depth) {
    double const left = 1.0 - std::max(height - kFull, 0.0) / (kReach * depth);
    return left <= 0.0 ? 0.0 : left * left * left;
}

/// Goes over from x to its bounds without a kink.
double bounded(double x) {
    double const bound = x < 0.0 ? kSlowest : kFastest;
    return x / (1.0 + x / bound);
}
}  // namespace

int finestFelt(double height) {
    int finest = 0;
    while (finest < kReliefBands && height >= kFull + kReach * kDepth[static_cast<std::size_t>(finest)]) ++finest;
    return finest;
}

SlopeWind slopeWind(ReliefBands const& relief, glm::dvec2 wind, double height, double stable) {
    SlopeWind result;
    double const speed = glm::length(wind);
    if (!(speed > 0.0)) return result;
    glm::dvec2 felt{0.0};
    double crest = 0.0;
    for (std::size_t i = 0; i < relief.size(); ++i) {
        double const reach = reachOf(height, kDepth[i]);
        felt += reach * relief[i].slope;
        crest += reach * relief[i].height / kDepth[i];
    }
    double const steep = glm::length(felt), lee = -glm::dot(wind, felt) / speed;
    double const followed = 1.0 / std::sqrt(1.0 + steep * steep / (kSteepest * kSteepest));
    double const climbing = 1.0 - kStableLoss * stable * (1.0 - smooth(50.0, 350.0, height));
    result.lift = glm::dot(wind, felt) * followed * climbing;

    double const turn = kTurn * (1.0 + stable) * smooth(0.05, 0.4, steep);
    double const upSlope = steep > 0.0 ? glm::dot(wind, felt) / (steep * steep) : 0.0;
    result.wind = wind * bounded(kSpeedUp * crest) - felt * (turn * upSlope);

    double const rough = kRough * speed * smooth(0.05, 0.4, steep);
    double const rotor = kRotor * speed * smooth(0.12, 0.45, lee) * smooth(6.0, 14.0, speed);
    result.variance = rough * rough + rotor * rotor;
    return result;
}
}  // namespace luftpost::weather
