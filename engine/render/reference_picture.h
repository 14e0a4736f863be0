// The picture that the path tracer makes of a snapshot. No GL.
#pragma once
#include <functional>

#include "engine/assets/image.h"
#include "engine/render/snapshot.h"
#include "engine/weather/noise_volume.h"

namespace luftpost::render {
struct ReferencePicture {
    assets::FloatImage image;  // as Renderer::readHdr: R, G, B radiance, A = 1 - transmittance of the clouds; 0 outside a dome
    double noise = 0.0;        // median over the picture of a pixel's standard error over its luminance
    int samples = 0;           // ways of each pixel
};

/// `samples` ways for every pixel, spread over it, on `workers` threads: the same picture with any number of them. `before`: how many ways
/// other pictures of the same sky have gone already, that together with this one shall make a quieter one: it throws other dice. Pure.
ReferencePicture referencePicture(Snapshot const& snapshot, glm::ivec2 const& size, int samples, weather::NoiseVolumes const& noise, int workers, int before = 0);
/// Two pictures of the same sky, of the same size, by other dice: their mean, each by its samples.
ReferencePicture together(ReferencePicture const& a, ReferencePicture const& b);
/// The picture as a screen shows it: exposed for its mean luminance, `ev` stops brighter, tone-mapped, encoded.
assets::Image developed(assets::FloatImage const& picture, float ev);
}  // namespace luftpost::render
