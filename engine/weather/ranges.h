// What a quantity of a report can be, in the units of a report: a recording and every source are held to the same.
#pragma once

namespace luftpost::weather {
struct Range {
    double low, high;
};
inline constexpr Range kCover{0.0, 1.0}, kCloudHeight{-500.0, 30000.0}, kAltitude{-500.0, 50000.0}, kElevation{-500.0, 9000.0},
    kSpeed{0.0, 150.0}, kDegrees{0.0, 360.0}, kTemperature{-100.0, 70.0}, kDewPoint{-150.0, 70.0}, kVisibility{0.0, 300000.0},
    kPressure{800.0, 1100.0}, kRate{0.0, 2000.0}, kInterval{1.0, 172800.0}, kLatitude{-90.0, 90.0}, kLongitude{-180.0, 180.0},
    kVerticalVisibility{0.0, 30000.0}, kCape{0.0, 20000.0}, kFreezingLevel{-2000.0, 12000.0}, kSnowDepth{0.0, 50.0},
    kRadiation{-50.0, 2000.0}, kLongwave{0.0, 1000.0}, kWeatherCode{0.0, 99.0};
}  // namespace luftpost::weather
