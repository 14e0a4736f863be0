// FNV-1a over the bits of numbers: two flights with one hash were the same flight.
#pragma once
#include <fmt/format.h>

#include <bit>
#include <cstdint>
#include <string>

namespace luftpost::app {
class StateHash {
public:
    void take(double value) { take(std::bit_cast<std::uint64_t>(value)); }
    void take(std::uint64_t bits) {
        for (int shift = 0; shift < 64; shift += 8)
            state_ = (state_ ^ ((bits >> shift) & 0xffu)) * 0x100000001b3u;
    }
    /// 16 hex digits.
    std::string text() const { return fmt::format("{:016x}", state_); }

private:
    std::uint64_t state_ = 0xcbf29ce484222325u;
};
}  // namespace luftpost::app
