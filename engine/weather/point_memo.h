// What a pure function gave at the nodes of a lattice, remembered. Any thread may ask and fill it: an entry is one word, and
// whoever writes it writes the same.
#pragma once
#include <atomic>
#include <cstdint>
#include <memory>

namespace luftpost::weather {
class PointMemo {
public:
    /// Values lie in low..high; they are kept (and given back, also the first time) to 23 bits of that range.
    PointMemo(double low, double high)
        : low_{low}, step_{(high - low) / kSteps}, entries_{std::make_unique<std::atomic<std::uint64_t>[]>(kEntries)} {}

    /// The value at `key` (its lower 52 bits), by `compute()` unless it is remembered.
    template <typename Compute>
    double at(std::uint64_t key, Compute const& compute) const {
        std::uint64_t const mixed = mix(key & kKeyMask);
        std::uint64_t const tag = mixed >> kIndexBits;
        std::atomic<std::uint64_t>& entry = entries_[mixed & (kEntries - 1)];
        std::uint64_t const found = entry.load(std::memory_order_relaxed);
        if ((found & 1u) && found >> 24 == tag) return valueOf((found >> 1) & kSteps);
        double const scaled = (compute() - low_) / step_ + 0.5;
        double const held = scaled > 0.0 ? scaled : 0.0;
        auto const steps = static_cast<std::uint64_t>(held < static_cast<double>(kSteps) ? held : static_cast<double>(kSteps));
        entry.store(tag << 24 | steps << 1 | 1u, std::memory_order_relaxed);
        return valueOf(steps);
    }

    /// A key of two node numbers and a third: 15 bits each of the first two, 22 of the third.
    static std::uint64_t key(std::int64_t x, std::int64_t y, std::int64_t z) {
        return (static_cast<std::uint64_t>(x) & 0x7FFFu) | (static_cast<std::uint64_t>(y) & 0x7FFFu) << 15 |
               (static_cast<std::uint64_t>(z) & 0x3FFFFFu) << 30;
    }
    /// A key of two node numbers of 26 bits each.
    static std::uint64_t key(std::int64_t x, std::int64_t y) {
        return (static_cast<std::uint64_t>(x) & 0x3FFFFFFu) | (static_cast<std::uint64_t>(y) & 0x3FFFFFFu) << 26;
    }

private:
    static constexpr int kKeyBits = 52, kIndexBits = 12;  // 40 bits of tag beside 23 of value and one "there is one"
    static constexpr std::uint64_t kEntries = 1u << kIndexBits, kKeyMask = (std::uint64_t{1} << kKeyBits) - 1;
    static constexpr std::uint64_t kSteps = (1u << 23) - 1;

    /// One to one on 52 bits, so that tag and index together are the key: no two keys are ever taken for each other.
    static std::uint64_t mix(std::uint64_t x) {
        x = (x * 0x9E3779B97F4A7C15u) & kKeyMask;
        x ^= x >> 27;
        x = (x * 0xBF58476D1CE4E5B9u) & kKeyMask;
        return x ^ (x >> 25);
    }
    double valueOf(std::uint64_t steps) const { return low_ + static_cast<double>(steps) * step_; }

    double low_, step_;
    std::unique_ptr<std::atomic<std::uint64_t>[]> entries_;
};
}  // namespace luftpost::weather
