// Sound files (libsndfile: WAV, FLAC, Ogg) as plain data.
#pragma once
#include <cstdint>
#include <filesystem>
#include <vector>

namespace luftpost::assets {
struct Sound {
    std::vector<std::int16_t> samples;  // mono; several channels are averaged
    int rate = 0;                       // samples a second
};

/// Throws core::Error naming the file and what was expected. At most ten minutes.
Sound readSound(std::filesystem::path const& file);
}  // namespace luftpost::assets
