// The light of what falls, floats and flashes along one ray. GLSL alone.
#ifndef LUFTPOST_WEATHER_LIGHT_GLSL
#define LUFTPOST_WEATHER_LIGHT_GLSL
#include "shaders/lib/cloud_march.glsl"
#include "shaders/lib/cloud_shadow.glsl"
#include "shaders/lib/falling.glsl"
#include "shaders/lib/lightning.glsl"
#include "shaders/lib/sky_optics.glsl"

layout(binding = 26) uniform sampler2D phaseTable;

struct LightRay {
    vec3 direction;  // world, unit
    float land;      // m to what was drawn, 1e9: nothing
    float cloud;     // m to the clouds of this pixel
    float through;   // transmittance of all of them
    vec2 pixel;
};

vec2 phaseSize() { return vec2(textureSize(phaseTable, 0)); }

/// Irradiance of the key light at an altitude, clouds left out.
vec3 keyAt(KeyLight key, float altitude) {
    return key.above * lightThroughAir(skyTransmittanceTable, vec2(textureSize(skyTransmittanceTable, 0)), altitude, key.toward.y, key.radius);
}

/// mm/h of rain and of snow at a place, about in the mean over `length` m.
vec2 fallingAt(vec3 p, float length) {
    float rate = 0.0;
    for (int layer = 0; layer < clouds.march.x; ++layer) {
        LayerFall fall = falling.falls[layer];
        if (fall.shower.x <= 0.0) continue;
        float coarse;
        float base = columnAt(layer, p.xz, coarse).base;
        if (p.y > base + 400.0) continue;
        LayerColumn source = columnAt(layer, p.xz + fallLag(fall, base - p.y), coarse);
        float blur = min(0.5 * length / clouds.shapes[layer].body.x, 0.3);
        float cover = clamp(source.cover - clouds.shapes[layer].body.y, 0.0, 1.0);
        rate += rateBelow(fall, showerRoot(fall, p.xz), showerDepth(source.rank, cover, fall.shower.w, blur), p.y) * (1.0 - fallSmooth(base, base + 400.0, p.y));
    }
    float liquid = liquidShare(falling.fallAll, p.y);
    return rate * vec2(liquid, 1.0 - liquid);
}

/// Where along the ray something may fall: between the ground and the highest base.
vec2 fallingStretch(LightRay ray) {
    const float kFarthest = 70000.0;  // m
    float h = frame.cameraWorld.y;
    vec2 top = crossings(h, ray.direction.y, falling.optics.y);
    vec2 stretch = h > falling.optics.y ? top : vec2(0.0, top.y);
    if (stretch.y <= 0.0) return vec2(0.0);
    float low = crossings(h, ray.direction.y, min(falling.fallAll.melting.z, h - 0.5)).x;
    if (low > 0.0) stretch.y = min(stretch.y, low);
    return vec2(max(stretch.x, 0.0), min(stretch.y, min(ray.land, max(stretch.x, 0.0) + kFarthest)));
}

/// What falls along a ray. Light is as much of the beam or of the light around as is scattered toward the eye, air left out.
struct Fallen {
    vec3 light;      // radiance, the bows apart
    float through;   // transmittance
    vec3 lit;        // sunlight that all the rain of the ray meets: times bowExcess it is the bows' radiance
    float distance;  // m, mean of what veils
};

/// The report's own rate is in the air's visibility already: what is more than that veils; the bows are of all of it. `samples` along the ray.
Fallen alongFalling(LightRay ray, KeyLight key, int samples) {
    Fallen sum = Fallen(vec3(0.0), 1.0, vec3(0.0), 1.0e4);
    vec2 stretch = fallingStretch(ray);
    if (stretch.y <= stretch.x) return sum;
    float h = frame.cameraWorld.y;
    float cosine = dot(ray.direction, key.toward);
    vec3 beam = keyAt(key, falling.fallAll.melting.z + 800.0);
    vec3 veil = max(tabledPhase(phaseTable, phaseSize(), cosine, kRainRow) - bowExcess(phaseTable, phaseSize(), cosine), vec3(0.0));
    vec3 around = 0.5 * (frame.skyIrradiance.rgb + frame.groundIrradiance.rgb) / 3.14159265;
    float everywhere = falling.fallAll.melting.w;
    float bowThrough = 1.0;
    float weights = 0.0;
    float middle = 0.0;
    float before = stretch.x;
    float place = fract(52.9829189 * fract(0.06711056 * ray.pixel.x + 0.00583715 * ray.pixel.y));  // of a sample in its step
    for (int i = 0; i < samples && sum.through > 0.01; ++i) {
        float share = (float(i) + 1.0) / float(samples);
        float after = stretch.x + (stretch.y - stretch.x) * share * sqrt(share);
        float length = after - before;
        float t = before + place * length;
        before = after;
        vec3 p = placeAt(ray.direction, t, h);
        vec2 fall = fallingAt(p, length);
        float rate = fall.x + fall.y;
        if (rate <= 1e-3) continue;
        float seen = t < ray.cloud ? 1.0 : ray.through;
        float rain = fallingExtinction(fall.x, 0.0);
        float all = rain + fallingExtinction(0.0, fall.y);
        vec2 usual = fall * min(everywhere / rate, 1.0);
        float extra = max(all - fallingExtinction(usual.x, usual.y), 0.0);
        float open = cloudShadow(p);
        float taken = seen * (1.0 - exp(-extra * length));
        sum.light += sum.through * taken * (beam * open * veil + around * (0.35 + 0.65 * open));
        sum.lit += seen * bowThrough * (1.0 - exp(-rain * length)) * open * beam;
        weights += sum.through * taken;
        middle += sum.through * taken * t;
        sum.through *= 1.0 - taken;
        bowThrough *= exp(-all * length);
    }
    sum.distance = weights > 1e-5 ? middle / weights : 0.5 * (stretch.x + stretch.y);
    return sum;
}

/// The picture behind what falls, and its own light before it.
vec3 behindFalling(vec3 radiance, Fallen fallen, LightRay ray, KeyLight key) {
    AirLight air = airBefore(ray.direction, fallen.distance);
    vec3 bow = fallen.lit * bowExcess(phaseTable, phaseSize(), dot(ray.direction, key.toward));
    return radiance * fallen.through + (fallen.light + bow) * air.transmittance + air.radiance * (1.0 - fallen.through);
}

/// Cloud bow and glory where sunlit droplets are looked at from the sun's side.
vec3 gloryLight(LightRay ray, KeyLight key) {
    float cosine = dot(ray.direction, key.toward);
    if (cosine > -0.4 || ray.through > 0.98 || ray.cloud > ray.land) return vec3(0.0);
    vec3 excess = gloryExcess(phaseTable, phaseSize(), cosine, cloudPhase(cosine, clouds.light.x));
    vec3 p = placeAt(ray.direction, ray.cloud, frame.cameraWorld.y);
    float liquid = 1.0 - fallSmooth(1500.0, 4500.0, p.y - falling.fallAll.melting.x);
    float thickness = 0.5 * (1.0 - ray.through * ray.through);  // light goes in and comes back the same way
    return excess * keyAt(key, p.y) * (cloudShadow(p) * liquid * thickness) * airBefore(ray.direction, ray.cloud).transmittance;
}

/// Optical depth along the ray of a sheet of fibres where it crosses the middle of its layer at `t`.
float sheetAlong(int layer, vec3 direction, float t) {
    vec3 p = placeAt(direction, t, frame.cameraWorld.y);
    float coarse;
    LayerColumn column = columnAt(layer, p.xz, coarse);
    float slope = max(abs(inFlatFrame(direction, direction, p).y), 0.03);
    float lod = log2(max(t * frame.projection.w / slope * clouds.shapes[layer].fibre.w * 128.0, 1.0));
    return sheetDepth(p, column, clouds.shapes[layer], cloudCurlNoise, lod) / slope * (1.0 - coarse);
}

/// Halo and sun dogs in sheets of ice.
vec3 haloLight(LightRay ray, KeyLight key) {
    const float kClearCrystals = 0.5;  // share of them that are whole prisms
    const float kPlates = 2.5;
    float cosine = dot(ray.direction, key.toward);
    if (cosine < 0.5 || cosine > 0.97) return vec3(0.0);
    vec3 sum = vec3(0.0);
    int sheets = sheetLayers();
    if (sheets != 0) do {
        int layer = findLSB(sheets);
        sheets &= sheets - 1;
        vec4 extent = clouds.shapes[layer].extent;
        float altitude = 0.5 * (extent.x + extent.y);
        vec2 cross = crossings(frame.cameraWorld.y, ray.direction.y, altitude);
        float t = cross.x > 0.0 ? cross.x : cross.y;
        bool met = t > 0.0 && t <= ray.land;
        if (!met) t = 1.0e4;
        float depth = sheetAlong(layer, ray.direction, t);
        vec3 phase = kClearCrystals * (0.5 * haloExcess(phaseTable, phaseSize(), cosine) + kPlates * sunDogs(ray.direction, key.toward));
        // What of it is seen through the clouds before the sheet.
        float before = min(ray.through * exp(depth), 1.0);
        float flux = met ? depth * exp(-depth) * before : 0.0;
        sum += flux * phase * keyAt(key, altitude) * airBefore(ray.direction, t).transmittance;
    } while (sheets != 0);
    return sum;
}

/// Lightning: the cloud around it, and its channel.
vec3 strokeLight(LightRay ray) {
    const vec3 kColour = vec3(0.92, 0.96, 1.12);
    vec3 sum = vec3(0.0);
    float h = frame.cameraWorld.y;
    vec3 place = placeAt(ray.direction, min(ray.cloud, 3.0e5), h);
    for (int i = 0; i < int(falling.optics.z); ++i) {
        Stroke stroke = falling.strokes[i];
        if (ray.through < 0.99 && ray.cloud < ray.land)
            sum += (1.0 - ray.through) * strokeIrradiance(stroke.source.w, distance(place, stroke.source.xyz)) / 3.14159265 *
                   kColour * airBefore(ray.direction, ray.cloud).transmittance;
        if (stroke.ground.w < 0.5) continue;
        vec3 from = stroke.source.xyz - vec3(0.0, h, 0.0);
        vec3 to = stroke.ground.xyz - vec3(0.0, h, 0.0);
        float near;
        if (angleToStretch(ray.direction, from, to, near) > 0.3) continue;
        float least = 4.0;
        float reach = 0.0;
        vec3 a = from;
        for (int k = 1; k <= kChannelJoints; ++k) {
            vec3 b = channelJoint(from, to, stroke.form.x, k);
            float there;
            float angle = angleToStretch(ray.direction, a, b, there);
            if (angle < least) {
                least = angle;
                reach = there;
            }
            a = b;
        }
        if (reach > ray.land) continue;
        float seen = reach < ray.cloud ? 1.0 : ray.through;
        // What the whole channel sends comes from a band a pixel wide at least, and a little of it from the haze around.
        float width = max(0.6 * frame.projection.w * reach, 1.5);
        float away = least * reach;
        float share = exp(-away * away / (width * width)) / (1.77 * width) + 0.03 * exp(-away / 25.0) / 50.0;
        sum += seen * stroke.source.w * share / distance(from, to) * kColour * airBefore(ray.direction, reach).transmittance;
    }
    return sum;
}
#endif
