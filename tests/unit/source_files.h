// What the tests of the sources share: real files beside the repo, and what a reader complains of.
#pragma once
#include <filesystem>
#include <string>

#include "engine/core/error.h"

namespace luftpost::tests {
/// A file of the real data beside the repo; tests that read it are skipped where it is not there.
inline std::filesystem::path sharedWeather(std::string const& sourceFolder, std::string const& name) {
    return std::filesystem::path{sourceFolder}.parent_path() / "shared/weather" / name;
}

template <typename Read>
std::string complaintOf(Read const& read) {
    try {
        read();
    } catch (core::Error const& error) {
        return error.what();
    }
    return "no complaint";
}
}  // namespace luftpost::tests
