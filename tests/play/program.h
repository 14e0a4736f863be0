// Runs the program as a script would, and reads what it wrote.
#pragma once
#include <sys/wait.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/scratch.h"

namespace luftpost::tests {
namespace fs = std::filesystem;

inline std::string fileText(fs::path const& file) {
    std::ifstream in{file};
    return {std::istreambuf_iterator<char>{in}, {}};
}
inline void writeText(fs::path const& file, std::string const& text) { std::ofstream{file} << text; }

struct Outcome {
    int code = -1;
    std::string out, err;
    /// Number of lines on standard error.
    std::ptrdiff_t complaints() const { return std::count(err.begin(), err.end(), '\n'); }
};

/// `environment` as in "NAME=value NAME=value"; the player's folders lie in the scratch folder.
inline Outcome run(std::string const& arguments, std::string const& environment = "") {
    fs::path const here = scratch();
    std::string const player = "XDG_CONFIG_HOME='" + (here / "config").string() + "' XDG_DATA_HOME='" +
                               (here / "data").string() + "' XDG_CACHE_HOME='" + (here / "cache").string() +
                               "' ";
    std::string const command = player + environment + " timeout 240 " + LUFTPOST_PROGRAM + " " + arguments +
                                " >'" + (here / "out").string() + "' 2>'" + (here / "err").string() + "'";
    int const status = std::system(command.c_str());
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, fileText(here / "out"), fileText(here / "err")};
}

/// Flies without a picture and gives the report.
inline nlohmann::json flight(std::string const& arguments, std::string const& environment = "") {
    fs::path const report = scratch() / "report.json";
    Outcome const outcome = run(arguments + " --report '" + report.string() + "'", environment);
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    return nlohmann::json::parse(fileText(report), nullptr, false);
}
}  // namespace luftpost::tests
