// The floors of the house: a floor includes only floors below it, and gl* is called in engine/gl alone.
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <set>
#include <string>

namespace {
namespace fs = std::filesystem;
fs::path const kRoot = LUFTPOST_SOURCE_DIR;

using Floors = std::map<std::string, std::set<std::string>>;
// What each floor may include; itself is always allowed, and so are the engine's core and shaders/.
Floors const kMayInclude{
    {"engine/core", {}},
    {"engine/platform", {}},
    {"engine/audio", {"engine/platform"}},
    {"engine/assets", {}},
    {"engine/flight", {}},
    {"engine/weather", {}},
    {"engine/terrain", {}},
    {"engine/sky", {}},
    {"engine/gl", {"engine/platform", "engine/assets"}},
    {"engine/render",
     {"engine/gl", "engine/sky", "engine/terrain", "engine/weather", "engine/assets", "engine/platform"}},
    {"game/delivery", {}},
    {"game/ui", {"game/delivery", "engine/render", "engine/flight", "engine/weather", "engine/audio", "engine/platform",
                 "engine/sky", "engine/terrain"}},
    {"game/bot", {"game/ui", "game/delivery", "engine/flight"}},
    {"game/app", {"game/bot", "game/ui", "game/delivery", "engine/render", "engine/gl", "engine/sky", "engine/terrain",
                  "engine/weather", "engine/flight", "engine/assets", "engine/audio", "engine/platform"}}};

std::string text(fs::path const& file) {
    std::ifstream in{file};
    return {std::istreambuf_iterator<char>{in}, {}};
}

std::string floorOf(std::string const& path) {
    auto const second = path.find('/', path.find('/') + 1);
    return path.substr(0, second);
}

template <class Visit>
void forEachSource(Visit visit) {
    for (char const* top : {"engine", "game"})
        for (auto const& entry : fs::recursive_directory_iterator{kRoot / top})
            if (entry.path().extension() == ".cpp" || entry.path().extension() == ".h")
                visit(fs::relative(entry.path(), kRoot).generic_string(), text(entry.path()));
}

TEST(Floors, IncludeOnlyFloorsBelowThem) {
    std::regex const include{R"re(#include\s+"((?:engine|game)/[^"]+)")re"};
    int seen = 0;
    forEachSource([&](std::string const& path, std::string const& source) {
        std::string const floor = floorOf(path);
        ASSERT_TRUE(kMayInclude.contains(floor)) << path << " lies on no known floor";
        for (std::sregex_iterator it{source.begin(), source.end(), include}, end; it != end; ++it, ++seen) {
            std::string const target = floorOf((*it)[1]);
            bool const allowed =
                target == floor || target == "engine/core" || kMayInclude.at(floor).contains(target);
            EXPECT_TRUE(allowed) << path << " includes " << (*it)[1];
        }
    });
    EXPECT_GT(seen, 0);
}

TEST(Floors, CallGlInEngineGlAlone) {
    std::regex const call{R"(\bgl[A-Z]\w*\s*\()"};
    std::regex const epoxy{R"(#include\s+<epoxy/gl\.h>)"};
    forEachSource([&](std::string const& path, std::string const& source) {
        if (floorOf(path) == "engine/gl") return;
        std::smatch found;
        EXPECT_FALSE(std::regex_search(source, found, call)) << path << " calls " << found.str();
        EXPECT_FALSE(std::regex_search(source, epoxy)) << path << " includes the GL header";
    });
}
}  // namespace
