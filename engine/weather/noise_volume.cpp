#include "engine/weather/noise_volume.h"

#include <array>
#include <atomic>
#include <cstring>
#include <thread>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "shaders/lib/noise.glsl"

namespace luftpost::weather {
namespace {
constexpr std::array<char, 4> kMagic{'L', 'P', 'N', '1'};
constexpr std::size_t kHeaderBytes = 16;  // magic, width, height, depth: 32-bit, little endian

std::size_t texelCount(glm::ivec3 const& size) {
    return static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * static_cast<std::size_t>(size.z);
}

/// The next level: the mean of the texels that it covers.
std::vector<std::uint8_t> halved(std::vector<std::uint8_t> const& texels, std::size_t channels, glm::ivec3 const& size, glm::ivec3 const& half) {
    std::vector<std::uint8_t> result(texelCount(half) * channels);
    glm::ivec3 const step = size / half;  // 2, or 1 where the side is 1 already
    unsigned const count = static_cast<unsigned>(step.x * step.y * step.z);
    auto const at = [channels](glm::ivec3 const& s, int x, int y, int z) {
        return static_cast<std::size_t>((z * s.y + y) * s.x + x) * channels;
    };
    for (int z = 0; z < half.z; ++z)
        for (int y = 0; y < half.y; ++y)
            for (int x = 0; x < half.x; ++x)
                for (std::size_t channel = 0; channel < channels; ++channel) {
                    unsigned sum = count / 2;
                    for (int dz = 0; dz < step.z; ++dz)
                        for (int dy = 0; dy < step.y; ++dy)
                            for (int dx = 0; dx < step.x; ++dx)
                                sum += texels[at(size, x * step.x + dx, y * step.y + dy, z * step.z + dz) + channel];
                    result[at(half, x, y, z) + channel] = static_cast<std::uint8_t>(sum / count);
                }
    return result;
}

std::uint8_t byteOf(float unit) { return static_cast<std::uint8_t>(glm::clamp(unit, 0.0f, 1.0f) * 255.0f + 0.5f); }

/// Fills a volume slice by slice on `workers` threads; `noise` takes the centre of a texel, 0..1 each way; its first `channels` are kept.
template <class Noise>
NoiseVolume filled(glm::ivec3 const& size, int channels, int workers, Noise noise) {
    std::vector<std::uint8_t> texels(texelCount(size) * static_cast<std::size_t>(channels));
    std::atomic<int> nextRow{0};
    auto const work = [&] {
        for (int row = nextRow++; row < size.y * size.z; row = nextRow++)
            for (int x = 0; x < size.x; ++x) {
                glm::vec3 const texel{x, row % size.y, row / size.y};
                glm::vec4 const value = noise((texel + 0.5f) / glm::vec3{size});
                std::uint8_t* const out = &texels[(static_cast<std::size_t>(row) * static_cast<std::size_t>(size.x) +
                                                   static_cast<std::size_t>(x)) * static_cast<std::size_t>(channels)];
                for (int channel = 0; channel < channels; ++channel) out[channel] = byteOf(value[channel]);
            }
    };
    std::vector<std::jthread> threads;
    for (int i = 1; i < workers; ++i) threads.emplace_back(work);
    work();
    threads.clear();
    return NoiseVolume{size, channels, std::move(texels)};
}

void writeVolume(NoiseVolume const& volume, std::filesystem::path const& file) {
    std::string bytes(kHeaderBytes, '\0');
    glm::ivec3 const size = volume.size();
    std::memcpy(bytes.data(), kMagic.data(), 4);
    std::memcpy(bytes.data() + 4, &size, 12);
    std::vector<std::uint8_t> const& texels = volume.texels(0);
    bytes.append(reinterpret_cast<char const*>(texels.data()), texels.size());
    core::writeFileAtomically(file, bytes);
}

NoiseVolume loadVolume(std::filesystem::path const& file, glm::ivec3 const& expected, int channels) {
    std::string const bytes = core::readFile(file);
    glm::ivec3 size{0};
    if (bytes.size() >= kHeaderBytes) std::memcpy(&size, bytes.data() + 4, 12);
    if (size != expected || std::memcmp(bytes.data(), kMagic.data(), 4) != 0 ||
        bytes.size() != kHeaderBytes + texelCount(size) * static_cast<std::size_t>(channels))
        throw core::Error{file.string(), "header",
                          fmt::format("expected a noise volume of {} x {} x {}, {} channels", expected.x, expected.y, expected.z, channels)};
    return NoiseVolume{size, channels, {bytes.begin() + kHeaderBytes, bytes.end()}};
}

constexpr glm::ivec3 kShape{kShapeSize};
constexpr glm::ivec3 kDetail{kDetailSize};
constexpr glm::ivec3 kCurl{kCurlSize, kCurlSize, 1};
}  // namespace

NoiseVolume::NoiseVolume(glm::ivec3 const& size, int channels, std::vector<std::uint8_t> texels) : channels_{channels} {
    CHECK(texels.size() == texelCount(size) * static_cast<std::size_t>(channels), "{} bytes for {} texels", texels.size(), texelCount(size));
    texels_.push_back(std::move(texels));
    std::vector<glm::ivec3> sizes{size};
    while (sizes.back() != glm::ivec3{1}) {
        glm::ivec3 const half = glm::max(sizes.back() / 2, glm::ivec3{1});
        texels_.push_back(halved(texels_.back(), static_cast<std::size_t>(channels), sizes.back(), half));
        sizes.push_back(half);
    }
    for (std::size_t i = 0; i < sizes.size(); ++i) levels_.push_back({texels_[i].data(), sizes[i]});
}

NoiseVolumes makeNoise(unsigned seed, int workers) {
    return {filled(kShape, 1, workers, [=](glm::vec3 const& unit) { return glm::vec4{glsl::billowNoise(unit, seed), 0.0f, 0.0f, 0.0f}; }),
            filled(kDetail, 1, workers, [=](glm::vec3 const& unit) { return glm::vec4{glsl::detailNoise(unit, seed), 0.0f, 0.0f, 0.0f}; }),
            filled(kCurl, 4, workers, [=](glm::vec3 const& unit) {
                return glsl::curlNoise(glm::vec2{unit.x, unit.y}, seed) * 0.5f + 0.5f;
            })};
}

void writeNoise(NoiseVolumes const& volumes, std::filesystem::path const& folder) {
    writeVolume(volumes.shape, folder / "noise_shape.bin");
    writeVolume(volumes.detail, folder / "noise_detail.bin");
    writeVolume(volumes.curl, folder / "noise_curl.bin");
}

NoiseVolumes loadNoise(std::filesystem::path const& folder) {
    return {loadVolume(folder / "noise_shape.bin", kShape, 1), loadVolume(folder / "noise_detail.bin", kDetail, 1),
            loadVolume(folder / "noise_curl.bin", kCurl, 4)};
}
}  // namespace luftpost::weather
