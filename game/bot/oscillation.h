// Period and damping of a damped oscillation, read from a record as one reads a strip chart.
#pragma once
#include <vector>

namespace luftpost::bot {
struct Oscillation {
    double period = 0.0;   // s; 0: none was seen
    double damping = 0.0;  // share of the critical
};
/// From the first two extremes about `mean` of a record with a value every `step` seconds.
Oscillation oscillation(std::vector<double> const& record, double step, double mean);
}  // namespace luftpost::bot
