// A folder of its own for each test that writes files.
#pragma once
#include <cstdlib>
#include <filesystem>
#include <stdexcept>
#include <string>
#include <system_error>

#include <gtest/gtest.h>

namespace luftpost::tests {
/// The folder of the test that runs: made when it is first asked for, removed when the test ends, passed or failed.
class ScratchFolder : public testing::EmptyTestEventListener {
public:
    /// The one that hears of every test's end; gtest owns it.
    static ScratchFolder& ofThisProgram() {
        static ScratchFolder* const folder = [] {
            auto* const made = new ScratchFolder;
            testing::UnitTest::GetInstance()->listeners().Append(made);
            return made;
        }();
        return *folder;
    }

    std::filesystem::path const& path() {
        if (path_.empty()) {
            std::string name = testing::TempDir() + "luftpost_XXXXXX";
            if (!mkdtemp(name.data())) throw std::runtime_error{"no folder " + name};
            path_ = name;
        }
        return path_;
    }
    void OnTestEnd(testing::TestInfo const&) override {
        std::error_code ignored;  // what cannot be removed fails no test
        if (!path_.empty()) std::filesystem::remove_all(path_, ignored);
        path_.clear();
    }

private:
    std::filesystem::path path_;
};
/// Listens before the first test begins.
inline ScratchFolder& scratchFolder = ScratchFolder::ofThisProgram();

/// Empty when a test first asks; no other test, of this process or another, has the same.
inline std::filesystem::path const& scratch() { return ScratchFolder::ofThisProgram().path(); }
}  // namespace luftpost::tests
