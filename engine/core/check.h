// CHECK: a programmer's mistake ends the program with a message, in every build.
#pragma once
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <string_view>

namespace luftpost::core {
[[noreturn]] inline void checkFailed(char const* file, int line, char const* condition, std::string_view message) {
    fmt::print(stderr, "{}:{}: CHECK({}) failed: {}\n", file, line, condition, message);
    std::abort();
}
}  // namespace luftpost::core

/// CHECK(condition, "format {}", values...): on in every build.
#define CHECK(condition, ...)                                                                          \
    do {                                                                                               \
        if (!(condition)) [[unlikely]]                                                                 \
            ::luftpost::core::checkFailed(__FILE__, __LINE__, #condition, ::fmt::format(__VA_ARGS__)); \
    } while (false)
