// Reads a group from left to right. Private to the METAR's files.
#pragma once
#include <cstddef>
#include <initializer_list>
#include <optional>
#include <string_view>

namespace luftpost::weather {
class MetarScan {
public:
    explicit MetarScan(std::string_view text) : rest_{text} {}

    bool done() const { return rest_.empty(); }
    std::string_view rest() const { return rest_; }

    /// Goes over a literal if it stands here.
    bool take(std::string_view literal) {
        if (!rest_.starts_with(literal)) return false;
        rest_.remove_prefix(literal.size());
        return true;
    }

    /// Goes over the first of the words that stands here; its place in the list, or nothing.
    std::optional<std::size_t> takeOneOf(std::initializer_list<std::string_view> words) {
        std::size_t i = 0;
        for (std::string_view const word : words) {
            if (take(word)) return i;
            ++i;
        }
        return std::nullopt;
    }

    /// As many digits as stand here, if they are `least` to `most`; else nothing, and stays.
    std::optional<int> digits(std::size_t least, std::size_t most) {
        std::size_t count = 0;
        int value = 0;
        while (count < rest_.size() && count <= most && rest_[count] >= '0' && rest_[count] <= '9') value = value * 10 + (rest_[count++] - '0');
        if (count < least || count > most) return std::nullopt;
        rest_.remove_prefix(count);
        return value;
    }

    /// Exactly `count` digits, whatever follows.
    std::optional<int> exactly(std::size_t count) {
        if (rest_.size() < count) return std::nullopt;
        MetarScan head{rest_.substr(0, count)};
        auto const value = head.digits(count, count);
        if (value) rest_.remove_prefix(count);
        return value;
    }

private:
    std::string_view rest_;
};
}  // namespace luftpost::weather
