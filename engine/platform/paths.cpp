#include "engine/platform/paths.h"

#include <cstdlib>
#include <vector>

#include "engine/core/error.h"

namespace luftpost::platform {
namespace {
namespace fs = std::filesystem;

fs::path programFolder() {
    std::error_code error;
    fs::path const program = fs::read_symlink("/proc/self/exe", error);
    return error ? fs::path{"."} : program.parent_path();
}

/// The data's roots in the order of preference; the first that holds `shaders` is the root.
fs::path dataRoot() {
    if (char const* named = std::getenv("LUFTPOST_DATA"); named && *named) return named;
    fs::path const beside = programFolder();
    for (fs::path const& root : {beside, beside / "../share/luftpost", fs::path{LUFTPOST_SOURCE_DIR}}) {
        std::error_code error;
        if (fs::is_directory(root / "shaders", error)) return root;
    }
    return LUFTPOST_SOURCE_DIR;
}

fs::path playerFolder(char const* variable, char const* fallback) {
    if (char const* named = std::getenv(variable); named && *named) return fs::path{named} / "luftpost";
    char const* home = std::getenv("HOME");
    return fs::path{home && *home ? home : "/tmp"} / fallback / "luftpost";
}
}  // namespace

fs::path dataFile(std::string_view relative) {
    std::vector<fs::path> roots{dataRoot()};
    if (relative.starts_with("generated/")) {
        roots.push_back(programFolder());
        roots.emplace_back(LUFTPOST_BUILD_DIR);
    }
    for (fs::path const& root : roots) {
        std::error_code error;
        if (fs::exists(root / relative, error)) return root / relative;
    }
    throw core::Error{(roots.front() / relative).string(), "",
                      "expected a file of the game's data here (LUFTPOST_DATA names another folder)"};
}

fs::path configFolder() { return playerFolder("XDG_CONFIG_HOME", ".config"); }
fs::path dataFolder() { return playerFolder("XDG_DATA_HOME", ".local/share"); }
fs::path cacheFolder() { return playerFolder("XDG_CACHE_HOME", ".cache"); }
}  // namespace luftpost::platform
