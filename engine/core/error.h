// The one exception type: the world said no while loading. Caught in main (exit 2) and in shader hot reload.
#pragma once
#include <fmt/format.h>

#include <stdexcept>
#include <string>

namespace luftpost::core {
/// One line: the file (or option), the place in it, what was expected (and what was found).
/// what() reads "FILE: PLACE: EXPECTED"; an empty place is left out.
class Error : public std::runtime_error {
public:
    Error(std::string const& file, std::string const& place, std::string const& expected)
        : std::runtime_error{place.empty() ? fmt::format("{}: {}", file, expected)
                                           : fmt::format("{}: {}: {}", file, place, expected)} {}
};
}  // namespace luftpost::core
