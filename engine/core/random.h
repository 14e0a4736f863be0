// Dice: the same throws on every machine, the state one number that can be saved and hashed.
#pragma once
#include <cstdint>

namespace luftpost::core {
/// SplitMix64 (Steele, Lea, Flood 2014): every state is good, every seed gives another sequence.
class Random {
public:
    explicit Random(std::uint64_t state) : state_{state} {}

    std::uint64_t next() {
        state_ += 0x9e3779b97f4a7c15u;
        std::uint64_t z = state_;
        z = (z ^ (z >> 30u)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27u)) * 0x94d049bb133111ebu;
        return z ^ (z >> 31u);
    }
    /// min <= result < max.
    double uniform(double min, double max) {
        return min + (max - min) * (static_cast<double>(next() >> 11u) * 0x1.0p-53);
    }
    std::uint64_t below(std::uint64_t count) { return next() % count; }
    std::uint64_t state() const { return state_; }

private:
    std::uint64_t state_;
};
}  // namespace luftpost::core
