// The fixed piece of GPU work by which the times of other machines are scaled.
#pragma once

namespace luftpost::render {
struct YardstickResult {
    double milliseconds = 0.0;  // median of the repeats
    double cloud = 0.0;         // mean opacity of the picture it makes: the same everywhere
};

/// Runs the march of shaders/pass/yardstick.comp at 1280 x 720 `repeats` times. GL thread; throws core::Error when the
/// shader does not load.
YardstickResult yardstick(int repeats);
}  // namespace luftpost::render
