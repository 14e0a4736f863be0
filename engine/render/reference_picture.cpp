#include "engine/render/reference_picture.h"

#include <algorithm>
#include <atomic>
#include <cmath>
#include <thread>

#include "engine/core/check.h"
#include "engine/render/reference_sky.h"
#include "engine/sky/light.h"
#include "shaders/lib/camera.glsl"
#include "shaders/lib/tone.glsl"

namespace luftpost::render {
namespace {
/// The direction through a place of the picture, 0..1 from the lower left.
glm::dvec3 directionThrough(Camera const& camera, glm::dvec2 const& unit, double aspect) {
    glm::vec2 const place{unit};
    if (camera.projection == Projection::panorama) return glm::dvec3{glsl::panoramaRay(place)};
    if (camera.projection == Projection::dome) return glm::dvec3{glsl::domeRay(place)};
    double const tangent = std::tan(0.5 * camera.horizontalFov);
    glm::dvec3 const ray{glsl::perspectiveRay(place, glm::vec2{glm::dvec2{tangent, tangent / aspect}})};
    return camera.worldFromCamera * glm::normalize(ray);
}

struct Pixel {
    glm::vec4 value{0.0f};
    double noise = 0.0;  // standard error of the luminance over the luminance
};

Pixel tracedPixel(ReferenceSky const& medium, Camera const& camera, glm::ivec2 const& at, glm::ivec2 const& size, int samples, int before) {
    core::Random mixer{static_cast<std::uint64_t>(at.y) << 32u | static_cast<std::uint64_t>(at.x)};
    core::Random turned{mixer.next() ^ static_cast<std::uint64_t>(before)};
    core::Random random{before > 0 ? turned.next() : turned.state()};
    glm::dvec4 sum{0.0};
    double squares = 0.0;
    auto const aspect = static_cast<double>(size.x) / size.y;
    sky::AirDraw const air = medium.airDraw({glm::dvec3{0.0}, glm::normalize(directionThrough(camera, (glm::dvec2{at} + 0.5) / glm::dvec2{size}, aspect))});
    for (int i = 0; i < samples; ++i) {
        glm::dvec2 const unit{(at.x + random.uniform(0.0, 1.0)) / size.x, (at.y + random.uniform(0.0, 1.0)) / size.y};
        sky::PathRay const ray{glm::dvec3{0.0}, glm::normalize(directionThrough(camera, unit, aspect))};
        sky::Seen const seen = sky::seen(medium, ray, air, random);
        sum += glm::dvec4{glm::vec4{seen.light, 1.0f - seen.through}};
        auto const y = static_cast<double>(sky::luminance(seen.light));
        squares += y * y;
    }
    double const count = samples;
    glm::dvec4 const mean = sum / count;
    auto const y = static_cast<double>(sky::luminance(glm::vec3{mean}));
    double const variance = std::max(squares / count - y * y, 0.0) / std::max(count - 1.0, 1.0);
    return {glm::vec4{mean}, y > 0.0 ? std::sqrt(variance) / y : 0.0};
}
}  // namespace

ReferencePicture referencePicture(Snapshot const& snapshot, glm::ivec2 const& size, int samples, weather::NoiseVolumes const& noise, int workers, int before) {
    ReferenceSky const medium{snapshot, noise, workers};
    ReferencePicture result{{size.x, size.y, 4, std::vector<float>(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y) * 4)}, 0.0, samples};
    std::vector<double> noises(static_cast<std::size_t>(size.x) * static_cast<std::size_t>(size.y));
    std::atomic<int> next{0};
    auto const work = [&] {
        for (int i = next++; i < size.x * size.y; i = next++) {
            glm::ivec2 const at{i % size.x, size.y - 1 - i / size.x};  // the image's first row is the top
            glm::vec2 const centre = (glm::vec2{at} + 0.5f) / glm::vec2{size};
            if (snapshot.camera.projection == Projection::dome && !glsl::insideDome(centre)) continue;
            Pixel const pixel = tracedPixel(medium, snapshot.camera, at, size, samples, before);
            auto const index = static_cast<std::size_t>(i);
            for (std::size_t k = 0; k < 4; ++k) result.image.values[4 * index + k] = pixel.value[static_cast<int>(k)];
            noises[index] = pixel.noise;
        }
    };
    {
        std::vector<std::jthread> threads;
        for (int i = 1; i < workers; ++i) threads.emplace_back(work);
        work();
    }
    std::erase(noises, 0.0);
    if (noises.empty()) return result;
    std::nth_element(noises.begin(), noises.begin() + static_cast<std::ptrdiff_t>(noises.size() / 2), noises.end());
    result.noise = noises[noises.size() / 2];
    return result;
}

ReferencePicture together(ReferencePicture const& a, ReferencePicture const& b) {
    CHECK(a.image.values.size() == b.image.values.size() && a.samples + b.samples > 0, "{} values and {}", a.image.values.size(), b.image.values.size());
    double const whole = static_cast<double>(a.samples) + b.samples, ofA = a.samples / whole, ofB = b.samples / whole;
    ReferencePicture result{a.image, std::hypot(ofA * a.noise, ofB * b.noise), a.samples + b.samples};
    for (std::size_t i = 0; i < result.image.values.size(); ++i)
        result.image.values[i] = static_cast<float>(ofA * static_cast<double>(a.image.values[i]) + ofB * static_cast<double>(b.image.values[i]));
    return result;
}

assets::Image developed(assets::FloatImage const& picture, float ev) {
    // The mean of logarithms, as the eye adapts: one sun does not darken the day.
    double logs = 0.0;
    int lit = 0;
    for (std::size_t i = 0; i < picture.values.size(); i += 4) {
        float const y = sky::luminance({picture.values[i], picture.values[i + 1], picture.values[i + 2]});
        if (y <= 0.0f) continue;
        logs += std::log(static_cast<double>(y));
        ++lit;
    }
    float const exposure = sky::exposureFor(lit > 0 ? static_cast<float>(std::exp(logs / lit)) : 1.0f) * std::exp2(ev);
    assets::Image image{picture.width, picture.height, 4, std::vector<std::uint8_t>(picture.values.size(), 255)};
    for (std::size_t i = 0; i < picture.values.size(); i += 4) {
        glm::vec3 const light = glsl::seenInTheDark({picture.values[i], picture.values[i + 1], picture.values[i + 2]}, static_cast<float>(sky::kSunIlluminance_lx));
        glm::vec3 const encoded = glsl::encodedForScreen(glsl::toneMapped(light * exposure));
        for (std::size_t k = 0; k < 3; ++k) image.values[i + k] = static_cast<std::uint8_t>(std::clamp(encoded[static_cast<int>(k)], 0.0f, 1.0f) * 255.0f + 0.5f);
    }
    return image;
}
}  // namespace luftpost::render
