// How the aircraft answers the stick under the settings as they are, beside how it answers under the defaults. Between
// ScreenFrame::begin and end.
#pragma once
#include <vector>

namespace luftpost::ui {
struct ResponsePoint {
    double t = 0.0;                                      // s
    double aileron = 0.0, elevator = 0.0, rudder = 0.0;  // the stick, -1..1
    double bank = 0.0;                                   // rad
    double pitchRate = 0.0, yawRate = 0.0;               // rad/s
    double throttle = 0.0;                               // of the engine, after the assist
};
struct ResponseCurves {
    std::vector<ResponsePoint> now, usual;
};

/// Three graphs over one time: the bank, the pitch rate and the yaw rate, with the stick that asked for them.
void drawResponse(ResponseCurves const& curves);
/// Its height, for those who lay it out.
float responseHeight();
}  // namespace luftpost::ui
