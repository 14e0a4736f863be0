// `luftpost terrain`: the land's heights as a picture.
#include <CLI/CLI.hpp>
#include <filesystem>
#include <string>
#include <vector>

#include "engine/assets/image.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/terrain/land.h"
#include "game/app/commands.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
namespace {
struct TerrainTexts {
    std::string extent;
    std::filesystem::path output;
};

/// Heights in metres of a square `extent` metres wide around the origin, at each pixel's centre, first row north: what
/// wheels meet, so a lake's face where there is a lake.
assets::FloatImage heightPicture(terrain::Land const& land, double extent, glm::ivec2 const& size) {
    assets::FloatImage image{size.x, size.y, 1, {}};
    auto const width = static_cast<std::size_t>(size.x);
    image.values.reserve(width * static_cast<std::size_t>(size.y));
    std::vector<double> east(width), north(width), heights(width);
    for (std::size_t x = 0; x < width; ++x) east[x] = extent * ((static_cast<double>(x) + 0.5) / size.x - 0.5);
    for (int y = 0; y < size.y; ++y) {
        std::fill(north.begin(), north.end(), extent * (0.5 - (y + 0.5) / size.y));
        land.heights(east, north, heights);
        for (double height : heights) image.values.push_back(static_cast<float>(std::max(height, land.waterLevel())));
    }
    return image;
}

int runTerrain(TerrainTexts const& texts, CommonOptions const& common) {
    double const extent = numberOption("--extent", texts.extent, 1.0, 2.0e7);
    if (texts.output.extension() != ".exr")
        throw core::Error{"-o", "", "expected FILE.exr, found " + texts.output.string()};
    core::checkOutputFolder("-o", texts.output);
    terrain::Land const land{common.seed.value_or(1u), weatherField(common).place().altitude_m};
    assets::writeExr(texts.output, heightPicture(land, extent, common.size));
    return 0;
}
}  // namespace

void addTerrainCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    auto const texts = std::make_shared<TerrainTexts>();
    CLI::App* terrain = app.add_subcommand("terrain", "heights of the land, metres, one channel, north up");
    terrain->add_option("--extent", texts->extent, "side of the square around the place, metres")->required();
    terrain->add_option("-o", texts->output, "FILE.exr of --size pixels")->required();
    terrain->callback([texts, &common, &chosen] { chosen = [texts, &common] { return runTerrain(*texts, common); }; });
}
}  // namespace luftpost::app
