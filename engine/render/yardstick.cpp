#include "engine/render/yardstick.h"

#include <algorithm>
#include <cmath>
#include <vector>

#include "engine/gl/context.h"
#include "engine/gl/draw.h"
#include "engine/gl/program_library.h"
#include "engine/gl/query.h"
#include "engine/gl/texture.h"

namespace luftpost::render {
namespace {
constexpr int kSide = 64;

/// Smooth noise of whole numbers alone, so that every machine has the same.
gl::Texture3D noiseVolume() {
    auto const cell = [](unsigned x, unsigned y, unsigned z) {
        unsigned h = (x % 8) * 73856093u ^ (y % 8) * 19349663u ^ (z % 8) * 83492791u;
        h = (h ^ h >> 13) * 1274126177u;
        return (h ^ h >> 16) & 255u;
    };
    std::vector<std::uint8_t> texels;
    for (unsigned z = 0; z < kSide; ++z)
        for (unsigned y = 0; y < kSide; ++y)
            for (unsigned x = 0; x < kSide; ++x) {
                unsigned sum = 0;
                for (unsigned corner = 0; corner < 8; ++corner) {
                    unsigned const cx = corner & 1, cy = corner >> 1 & 1, cz = corner >> 2;
                    unsigned const weight = (cx ? x % 8 : 8 - x % 8) * (cy ? y % 8 : 8 - y % 8) * (cz ? z % 8 : 8 - z % 8);
                    sum += weight * cell(x / 8 + cx, y / 8 + cy, z / 8 + cz);
                }
                texels.push_back(static_cast<std::uint8_t>(sum / 512));
            }
    gl::Texture3D volume{gl::Format::r8, glm::ivec3{kSide}, 1, "yardstick"};
    volume.upload<std::uint8_t>(texels);
    volume.setSampling(gl::Filter::linear, gl::Filter::linear, gl::Wrap::repeat);
    return volume;
}
}  // namespace

YardstickResult yardstick(int repeats) {
    gl::ProgramLibrary programs;
    gl::Program const& program = programs.compute("yardstick");
    gl::Texture3D const noise = noiseVolume();
    gl::Texture2D const picture{gl::Format::rgba16f, {1280, 720}, 1, "yardstick"};
    gl::Query start = gl::Query::timestamp(), end = gl::Query::timestamp();
    std::vector<double> times;
    for (int i = 0; i <= repeats; ++i) {  // the first one warms up
        program.use();
        noise.bind(0);
        picture.bindImage(0, gl::Access::write);
        gl::finish();
        start.record();
        gl::finish();  // software GL takes the timestamp only when it gets to it
        gl::dispatchOver(picture.size(), {8, 8});
        gl::finish();
        end.record();
        gl::finish();
        if (i > 0) times.push_back(static_cast<double>(end.wait() - start.wait()) * 1e-6);
    }
    std::ranges::sort(times);
    gl::barrier(gl::Barrier::all);
    std::vector<float> const values = picture.readFloats();
    double cloud = 0.0;
    for (std::size_t i = 3; i < values.size(); i += 4) cloud += static_cast<double>(values[i]);
    return {times[times.size() / 2], cloud / (static_cast<double>(values.size()) / 4.0)};
}
}  // namespace luftpost::render
