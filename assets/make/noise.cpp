// Writes the noise volumes of the clouds: `make_noise FOLDER`. The build runs it once.
#include <fmt/format.h>

#include <algorithm>
#include <exception>
#include <filesystem>
#include <thread>

#include "engine/weather/noise_volume.h"

int main(int argc, char** argv) try {
    if (argc != 2) {
        fmt::print(stderr, "usage: make_noise FOLDER\n");
        return 2;
    }
    std::filesystem::create_directories(argv[1]);
    int const workers = static_cast<int>(std::clamp(std::thread::hardware_concurrency(), 1u, 16u));
    luftpost::weather::writeNoise(luftpost::weather::makeNoise(luftpost::weather::kNoiseSeed, workers), argv[1]);
    return 0;
} catch (std::exception const& error) {
    fmt::print(stderr, "{}\n", error.what());
    return 1;
}
