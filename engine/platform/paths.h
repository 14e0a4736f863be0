// Where the program's data and the player's files lie.
#pragma once
#include <filesystem>
#include <string_view>

namespace luftpost::platform {
/// The file `relative` of the product's data ("shaders/pass/sky.comp", "assets/models/plane.glb",
/// "generated/noise_shape.bin"). The data's root is LUFTPOST_DATA when set, else the folder beside the program,
/// else the installed prefix's share/luftpost, else the source folder; what the build generated ("generated/...")
/// is also looked for beside the program and in its build folder. Throws core::Error when the file is nowhere.
std::filesystem::path dataFile(std::string_view relative);

/// $XDG_CONFIG_HOME/luftpost, $XDG_DATA_HOME/luftpost, $XDG_CACHE_HOME/luftpost with their usual defaults.
/// The folders are not made here.
std::filesystem::path configFolder();
std::filesystem::path dataFolder();
std::filesystem::path cacheFolder();
}  // namespace luftpost::platform
