// The atmosphere.
//
// PROBLEM. Along a ray from a point of the air, how much light of the sun (or the moon) comes toward us, and how much
// of what lies behind comes through? From the same two numbers follow the blue of the zenith, the pale horizon, the
// red sunset, the Earth's shadow, and the veil before a mountain thirty kilometres away.
//
// DERIVATION. The air scatters and absorbs. With extinction s(x) per metre, a path keeps the share
//     T = exp(- integral of s)                                                      (Beer and Lambert)
// and a point x of the ray toward v adds, per metre and per unit of the sun's irradiance above the air,
//     sum over constituents of  scattering_i(x) phase_i(v, l) T(x to the sun)       light scattered once
//   + sum over constituents of  scattering_i(x) psi(x)                              light scattered before
// where psi, the light that already went astray, is taken as isotropic. Light scattered twice, three times, ... is
// nearly a geometric series, so that psi = second / (1 - share): Hillaire, "A Scalable and Production Ready Sky and
// Atmosphere Rendering Technique", EGSR 2020. Constituents:
//   - molecules (Rayleigh), falling with a scale height of 8 km;
//   - haze, falling with 1.8 km from the height of the place, as thick as the reported visibility says; and a little
//     that is always there and thins with the air (optical depth 0.018: OPAC's free troposphere and stratosphere);
//   - fog, a grey layer a few hundred metres deep, for what visibility is worse than haze can be;
//   - ozone, which only absorbs, between 10 and 40 km: without it the zenith at dusk is yellow, not blue.
// The spectrum is carried as three numbers at the effective wavelengths of Rec. 709.
//
// Two integrals do not depend on the view and are kept as tables: the transmittance to the top of the air, a function
// of height and angle, and psi, a function of height and the sun's angle. Both mappings (value -> texture coordinate)
// and their inverses are below; C++ and the compute shaders make the same tables from them.
//
// FLOATS. The Earth's radius is 6.4 million metres, of which a float holds half a metre. So nothing here works with
// radii: a point is its height h above the sphere, a ray the cosine mu of its zenith angle, and squares of radii are
// subtracted on paper: (R+h)^2 - (R+s)^2 = (h-s)(2R+h+s).
#ifndef LUFTPOST_ATMOSPHERE_GLSL
#define LUFTPOST_ATMOSPHERE_GLSL
#include "shaders/shared/atmosphere.glsl.h"
#include "shaders/shared/sampler2d.glsl.h"
GLSL_BEGIN

GLSL_CONST float kAirPi = 3.14159265f;
GLSL_CONST float kPlanetRadius = 6371000.0f;  // m
GLSL_CONST float kAirTop = 100000.0f;         // m: what lies above scatters a millionth
GLSL_CONST float kAerialReach = 400000.0f;    // m: the horizon is 391 km away from 12 km up

// ---------------------------------------------------------------------------------------------------- the sphere

/// Height at distance t along a ray that starts at height h with zenith cosine mu. Good to 0.05 m at 400 km.
GLSL_FUNCTION float heightAlong(float h, float mu, float t) {
    float rise = h * (2.0f * kPlanetRadius + h) + t * (t + 2.0f * (kPlanetRadius + h) * mu);
    return rise / (kPlanetRadius + sqrt(max(kPlanetRadius * kPlanetRadius + rise, 0.0f)));
}

/// Cosine of the angle of a fixed direction (cosine `muStart` at the start) to the zenith at distance t. `nu` is the
/// cosine between ray and direction, `end` the height there.
GLSL_FUNCTION float zenithCosineAlong(float h, float muStart, float nu, float t, float end) {
    return clamp(((kPlanetRadius + h) * muStart + t * nu) / (kPlanetRadius + end), -1.0f, 1.0f);
}

/// Distance to the sphere of height s from below it (h <= s).
GLSL_FUNCTION float distanceOutward(float h, float mu, float s) {
    float b = (kPlanetRadius + h) * mu;
    float c = (h - s) * (2.0f * kPlanetRadius + h + s);
    float root = sqrt(max(b * b - c, 0.0f));
    return b > 0.0f ? -c / (b + root) : root - b;
}

/// Distance to the sphere of height s from above it (h >= s); -1 where the ray misses it.
GLSL_FUNCTION float distanceInward(float h, float mu, float s) {
    float b = (kPlanetRadius + h) * mu;
    float c = (h - s) * (2.0f * kPlanetRadius + h + s);
    float discriminant = b * b - c;
    return (b < 0.0f && discriminant >= 0.0f) ? c / (sqrt(discriminant) - b) : -1.0f;
}

/// Cosine of the zenith angle under which the sea's horizon stands at height h.
GLSL_FUNCTION float horizonCosine(float h) {
    return -sqrt(max(h, 0.0f) * (2.0f * kPlanetRadius + max(h, 0.0f))) / (kPlanetRadius + max(h, 0.0f));
}

// ------------------------------------------------------------------------------------------------------- the air

/// What a metre of air does at one height: scattering of the three kinds and the extinction of all, per metre.
struct AirAt {
    vec3 rayleigh;
    vec3 haze;
    vec3 extinction;
};

GLSL_FUNCTION AirAt airAt(Atmosphere air, float h) {
    float above = max(h - air.fog.z, 0.0f);
    float thin = exp(-max(h, 0.0f) / air.rayleigh.w);
    vec3 haze = vec3(air.haze) * exp(-above / air.haze.w) + vec3(1.95e-6f, 2.25e-6f, 2.72e-6f) * thin;
    vec3 rayleigh = vec3(air.rayleigh) * thin;
    vec3 fog = vec3(air.fog.x * exp(-above / air.fog.y));
    vec3 ozone = vec3(air.ozone) * max(0.0f, 1.0f - abs(h - 25000.0f) / 15000.0f);
    AirAt result;
    result.rayleigh = rayleigh;
    result.haze = haze * air.fog.w + fog * air.ozone.w;
    result.extinction = rayleigh + haze + fog + ozone;
    return result;
}

/// Rayleigh's phase function, 1/sr: integrates to 1 over the sphere.
GLSL_FUNCTION float rayleighPhase(float nu) { return 3.0f / (16.0f * kAirPi) * (1.0f + nu * nu); }

/// Henyey and Greenstein's phase function, 1/sr.
GLSL_FUNCTION float lobePhase(float nu, float g) {
    float k = max(1.0f + g * g - 2.0f * g * nu, 1e-5f);
    return (1.0f - g * g) / (4.0f * kAirPi * k * sqrt(k));
}

/// Phase function of haze, 1/sr: three lobes fitted, within 30 % from 2 to 180 degrees, to Mie's theory for the
/// average continental aerosol of Hess, Koepke and Schult 1998 (OPAC) at 70 % humidity and 545 nm. One lobe alone cannot
/// do it: what makes the aureole leaves a third of the light at 60 degrees, and the zenith too dark by as much.
GLSL_CONST vec3 kHazeShares = vec3(0.955f, 0.025f, 0.02f);
GLSL_CONST vec3 kHazeLobes = vec3(0.67f, 0.97f, -0.4f);
GLSL_FUNCTION float hazePhase(float nu) {
    return kHazeShares.x * lobePhase(nu, kHazeLobes.x) + kHazeShares.y * lobePhase(nu, kHazeLobes.y) +
           kHazeShares.z * lobePhase(nu, kHazeLobes.z);
}

// ---------------------------------------------------------------------------------- table one: the transmittance

/// Texture coordinate of (h, mu): how long the ray is among all of its height, against the height's horizon distance
/// (Bruneton 2017). Half texels keep the borders on the texels' centres.
GLSL_FUNCTION vec2 transmittanceCoordinate(vec2 size, float h, float mu) {
    float toHorizon = sqrt(max(h, 0.0f) * (2.0f * kPlanetRadius + h));
    float topToHorizon = sqrt(kAirTop * (2.0f * kPlanetRadius + kAirTop));
    float shortest = kAirTop - h;
    float along = (distanceOutward(h, mu, kAirTop) - shortest) / (toHorizon + topToHorizon - shortest);
    vec2 unit = clamp(vec2(along, toHorizon / topToHorizon), vec2(0.0f), vec2(1.0f));
    return (unit * (size - vec2(1.0f)) + vec2(0.5f)) / size;
}

/// Inverse of transmittanceCoordinate: (h, mu) of a texture coordinate.
GLSL_FUNCTION vec2 transmittanceArgument(vec2 size, vec2 uv) {
    vec2 unit = clamp((uv * size - vec2(0.5f)) / (size - vec2(1.0f)), vec2(0.0f), vec2(1.0f));
    float topToHorizon = sqrt(kAirTop * (2.0f * kPlanetRadius + kAirTop));
    float toHorizon = unit.y * topToHorizon;
    float h = toHorizon * toHorizon / (kPlanetRadius + sqrt(kPlanetRadius * kPlanetRadius + toHorizon * toHorizon));
    float shortest = kAirTop - h;
    float d = shortest + unit.x * (toHorizon + topToHorizon - shortest);
    float mu = d <= 0.0f ? 1.0f
                         : ((kAirTop - h) * (2.0f * kPlanetRadius + kAirTop + h) - d * d) /
                               (2.0f * d * (kPlanetRadius + h));
    return vec2(h, clamp(mu, -1.0f, 1.0f));
}

/// Optical depth along the ray over `distance`, with steps that grow with the square of their number.
GLSL_FUNCTION vec3 opticalDepth(Atmosphere air, float h, float mu, float distance, int steps) {
    vec3 depth = vec3(0.0f);
    float start = 0.0f;
    for (int i = 0; i < steps; ++i) {
        float share = float(i + 1) / float(steps);
        float end = distance * share * share;
        depth += airAt(air, heightAlong(h, mu, 0.5f * (start + end))).extinction * (end - start);
        start = end;
    }
    return depth;
}

/// Transmittance from height h along mu to the top of the air, the ground left out: one texel of table one.
GLSL_FUNCTION vec3 transmittanceToTopExact(Atmosphere air, float h, float mu) {
    return exp(-opticalDepth(air, h, mu, distanceOutward(h, mu, kAirTop), 48));
}

/// The same from the table.
GLSL_FUNCTION vec3 transmittanceToTop(sampler2D table, vec2 size, float h, float mu) {
    return vec3(textureLod(table, transmittanceCoordinate(size, clamp(h, 0.0f, kAirTop), mu), 0.0f));
}

GLSL_CONST float kTransmittanceWidth = 256.0f;
GLSL_CONST float kTransmittanceHeight = 64.0f;

/// Share of a light's disc (angular radius `radius`) that comes through the air to height h, where its zenith angle
/// has the cosine mu: the disc sinks behind the horizon bit by bit.
GLSL_FUNCTION vec3 lightThroughAir(sampler2D transmittance, vec2 size, float h, float mu, float radius) {
    float horizon = horizonCosine(h);
    float visible = smoothstep(-radius, radius, mu - horizon);
    return visible > 0.0f ? visible * transmittanceToTop(transmittance, size, h, max(mu, horizon)) : vec3(0.0f);
}

// ------------------------------------------------------------------------- table two: light scattered many times

GLSL_CONST float kNoTwilight = 0.42f;  // sine of the sun's depression at which nothing is left of its light

/// Texture coordinate of (h, cosine of the light's zenith angle): finest near the ground and at sunset. A half of the table for
/// the twenty degrees of twilight, over which the light falls by half a decade every degree and a half.
GLSL_FUNCTION vec2 multipleCoordinate(vec2 size, float h, float mu) {
    float below = clamp(-mu / kNoTwilight, 0.0f, 1.0f);
    float x = mu < 0.0f ? 0.5f - 0.5f * pow(below, 2.0f / 3.0f) : 0.5f + 0.5f * sqrt(mu);
    vec2 unit = clamp(vec2(x, sqrt(max(h, 0.0f) / kAirTop)), vec2(0.0f), vec2(1.0f));
    return (unit * (size - vec2(1.0f)) + vec2(0.5f)) / size;
}

GLSL_FUNCTION vec2 multipleArgument(vec2 size, vec2 uv) {
    vec2 unit = clamp((uv * size - vec2(0.5f)) / (size - vec2(1.0f)), vec2(0.0f), vec2(1.0f));
    float x = 2.0f * unit.x - 1.0f;
    return vec2(kAirTop * unit.y * unit.y, x < 0.0f ? -kNoTwilight * pow(-x, 1.5f) : x * x);
}

GLSL_CONST vec3 kLandColour = vec3(1.0f, 1.03f, 0.72f);  // of the land in the mean, over its albedo

/// What the air at an altitude lies over: land, or the tops of clouds with the land that is seen between them.
struct AirFloor {
    float altitude;
    vec3 land;     // albedo of what is seen between the clouds
    float clouds;  // albedo of the clouds under an even sky; under a sun of zenith cosine m it is 1.14 - 0.21 m times that (two
                   // streams, where it is 0.78)
};

/// Over a closed sheet the sky is half as bright again as over land: much of the light that the sheet sends up comes down again.
GLSL_FUNCTION AirFloor floorUnder(Atmosphere air, float h) {
    float over = air.cover.w > 0.0f ? smoothstep(0.9f * air.cover.z, 1.1f * air.cover.z, h) : 0.0f;
    float clouds = over * air.cover.w, through = 1.0f - clouds;
    vec3 land = kLandColour * air.ground.w;
    AirFloor result;
    result.altitude = min(over * air.cover.z, h);
    result.land = through * through * land / (vec3(1.0f) - clouds * land);
    result.clouds = clouds;
    return result;
}

/// What one direction adds to a texel of table two: light scattered twice and the share that is scattered on.
struct TwiceScattered {
    vec3 light;       // by air and land
    vec3 share;       // the same of an even light
    vec3 cloudLight;  // by clouds below
    vec3 cloudShare;
};

GLSL_FUNCTION TwiceScattered twiceScatteredAlong(Atmosphere air, sampler2D transmittance, vec2 size, float h, float mu,
                                                 float muLight, float nu) {
    TwiceScattered sum;
    sum.light = vec3(0.0f);
    sum.share = vec3(0.0f);
    sum.cloudLight = vec3(0.0f);
    sum.cloudShare = vec3(0.0f);
    AirFloor under = floorUnder(air, h);
    float toFloor = distanceInward(h, mu, under.altitude);
    float reach = toFloor >= 0.0f ? toFloor : distanceOutward(h, mu, kAirTop);
    vec3 through = vec3(1.0f);
    float start = 0.0f;
    for (int i = 0; i < 20; ++i) {
        float portion = float(i + 1) / 20.0f;
        float end = reach * portion * portion;
        float t = 0.5f * (start + end);
        float height = max(heightAlong(h, mu, t), 0.0f);
        AirAt here = airAt(air, height);
        vec3 stepThrough = exp(-here.extinction * (end - start));
        vec3 kept = through * (vec3(1.0f) - stepThrough) / max(here.extinction, vec3(1e-12f));
        vec3 scattering = here.rayleigh + here.haze;
        float muHere = zenithCosineAlong(h, muLight, nu, t, height);
        vec3 once = here.rayleigh * rayleighPhase(nu) + here.haze * lobePhase(nu, 0.67f);
        sum.light += kept * once * lightThroughAir(transmittance, size, height, muHere, 0.00465f);
        sum.share += kept * scattering;
        through *= stepThrough;
        start = end;
    }
    if (toFloor >= 0.0f) {
        float muHere = zenithCosineAlong(h, muLight, nu, toFloor, under.altitude);
        vec3 onFloor = lightThroughAir(transmittance, size, under.altitude, muHere, 0.00465f) * max(muHere, 0.0f);
        sum.light += through * onFloor * under.land / kAirPi;
        sum.share += through * under.land;  // a plane under an even psi sends back this share of it
        sum.cloudLight = through * onFloor * under.clouds * (1.14f - 0.21f * muHere) / kAirPi;
        sum.cloudShare = through * under.clouds;
    }
    return sum;
}

/// psi at height h under a light of irradiance 1 whose zenith angle has the cosine muLight, and in w the share of it that comes from
/// clouds below: one texel of table two, the mean over n x n directions. They stand closer near the horizontal, where in deep
/// twilight all light comes from.
GLSL_FUNCTION vec4 multipleExact(Atmosphere air, sampler2D transmittance, vec2 size, float h, float muLight, int n) {
    vec3 light = vec3(0.0f);
    vec3 share = vec3(0.0f);
    vec3 cloudLight = vec3(0.0f);
    vec3 cloudShare = vec3(0.0f);
    float sinLight = sqrt(max(1.0f - muLight * muLight, 0.0f));
    for (int i = 0; i < n * n; ++i) {
        float x = 2.0f * (float(i / n) + 0.5f) / float(n) - 1.0f;
        float mu = x * abs(x);
        float weight = 2.0f * abs(x) / float(n * n);
        float azimuth = kAirPi * (float(i % n) + 0.5f) / float(n);
        float nu = mu * muLight + sqrt(1.0f - mu * mu) * sinLight * cos(azimuth);
        TwiceScattered one = twiceScatteredAlong(air, transmittance, size, h, mu, muLight, nu);
        light += one.light * weight;
        share += one.share * weight;
        cloudLight += one.cloudLight * weight;
        cloudShare += one.cloudShare * weight;
    }
    // What clouds send up meets air, never clouds again; of what the air then turns, they get their share.
    vec3 even = (light + share * cloudLight) / max(vec3(1.0f) - share * (vec3(1.0f) + cloudShare), vec3(0.05f));
    vec3 up = cloudLight + cloudShare * even;
    return vec4(even + up, up.y / max(even.y + up.y, 1e-20f));
}

GLSL_FUNCTION vec4 multipleScattering(sampler2D table, vec2 size, float h, float muLight) {
    return textureLod(table, multipleCoordinate(size, clamp(h, 0.0f, kAirTop), muLight), 0.0f);
}

GLSL_CONST float kMultipleSize = 32.0f;

// ------------------------------------------------------------------------------------------- light along a ray

/// The two tables as one argument is not possible in GLSL (samplers cannot be members), so every function below takes
/// both and their sizes.
struct AirLight {
    vec3 radiance;       // toward the eye, of a light whose irradiance above the air is 1
    vec3 transmittance;  // of the air on the way
};

// Haze sends light that went astray on, not evenly: much of it was turned but once, and little. How much, and how far, fitted
// to the path tracer (sky/path_tracer) at five heights of the sun.
GLSL_CONST float kAgainShare = 0.3f;
GLSL_CONST float kAgainLobe = 0.4f;
// It runs more level than upright, where its ways are longest: a level ray meets more of it.
GLSL_CONST float kLevelMore = 1.14f;
GLSL_CONST float kUprightLess = 0.38f;

// What clouds below send up comes from all of the lower half, so that its mean cosine to the zenith is a half; haze turns it little: to first
// order, with a mean cosine of 0.62, three times that, times a half.
GLSL_CONST float kHazeUpward = 0.93f;

/// Share of the altitude h that counts as under the clouds; inside them one sees cloud, no air.
GLSL_FUNCTION float underClouds(Atmosphere air, float h) { return 1.0f - smoothstep(air.cover.x, 1.3f * air.cover.x + 1.0f, h); }

/// Share of the direct light that reaches altitude h in the mean over the land.
GLSL_FUNCTION float directShare(Atmosphere air, float h) { return mix(1.0f, air.cover.y, underClouds(air, h)); }

/// Direct light that one metre of air sends along a ray, nothing in its way.
GLSL_FUNCTION vec3 scatteredOnce(AirAt here, sampler2D transmittance, vec2 size, float h, float muLight, float nu) {
    vec3 light = lightThroughAir(transmittance, size, h, muLight, 0.00465f);
    return (here.rayleigh * rayleighPhase(nu) + here.haze * hazePhase(nu)) * light;
}

/// Radiance that one metre at height h sends along a ray, before the way back: scattered once and many times. Under
/// clouds the direct light is dimmed, and the astray light is that of the clouds' grey undersides and the land.
GLSL_FUNCTION vec3 sourceAt(Atmosphere air, sampler2D transmittance, vec2 size, sampler2D multiple, vec2 multipleSize,
                            AirAt here, float h, float mu, float muLight, float nu) {
    vec4 psi = multipleScattering(multiple, multipleSize, h, muLight);
    float upward = 1.0f - kHazeUpward * psi.w * mu;
    float again = mix(1.0f, 4.0f * kAirPi * lobePhase(nu, kAgainLobe), kAgainShare);
    float level = kLevelMore - kUprightLess * max(mu, 0.0f);
    vec3 open = vec3(psi) * (here.rayleigh + here.haze * again * upward) * level;
    vec3 under = vec3(air.under) * (here.rayleigh + here.haze);
    return scatteredOnce(here, transmittance, size, h, muLight, nu) * directShare(air, h) +
           mix(open, under, vec3(underClouds(air, h) * air.under.w));
}

/// Adds the air between distances `start` and `end` of the ray to `sum`. The source is constant in the step, and its
/// own extinction is integrated in closed form, so that a step through fog loses nothing.
GLSL_FUNCTION AirLight addAir(AirLight sum, Atmosphere air, sampler2D transmittance, vec2 size, sampler2D multiple,
                              vec2 multipleSize, float h, float mu, float muLight, float nu, float start, float end) {
    float t = 0.5f * (start + end);
    float height = max(heightAlong(h, mu, t), 0.0f);
    AirAt here = airAt(air, height);
    vec3 through = exp(-here.extinction * (end - start));
    float muHere = zenithCosineAlong(h, muLight, nu, t, height);
    vec3 source = sourceAt(air, transmittance, size, multiple, multipleSize, here, height, mu, muHere, nu);
    AirLight result;
    result.radiance = sum.radiance +
                      sum.transmittance * source * (vec3(1.0f) - through) / max(here.extinction, vec3(1e-12f));
    result.transmittance = sum.transmittance * through;
    return result;
}

/// Light of the air from height h along mu: to the top of the air, or to the sea where the ray goes down. `nu` is the
/// cosine between ray and light, `muLight` that of the light's zenith angle at the start.
GLSL_FUNCTION AirLight airLight(Atmosphere air, sampler2D transmittance, vec2 size, sampler2D multiple,
                                vec2 multipleSize, float h, float mu, float muLight, float nu, int steps) {
    AirLight sum;
    sum.radiance = vec3(0.0f);
    sum.transmittance = vec3(1.0f);
    float toGround = distanceInward(h, mu, 0.0f);
    float reach = toGround >= 0.0f ? toGround : distanceOutward(h, mu, kAirTop);
    float start = 0.0f;
    for (int i = 0; i < steps; ++i) {
        float share = float(i + 1) / float(steps);
        float end = reach * share * share;
        sum = addAir(sum, air, transmittance, size, multiple, multipleSize, h, mu, muLight, nu, start, end);
        start = end;
    }
    return sum;
}

// ----------------------------------------------------------------------- tables three and four: around the camera
// The sky's radiance is kept by direction, the air's light before land and clouds by direction and distance. Both use
// the same two coordinates, with the sun's azimuth in the middle of x and the horizon in the middle of y, each finest
// there. (Not by screen position: so the tables outlive a turn of the head and serve panoramas and mirrors too.)

/// Elevation -> 0..1 with the horizon of height h at 0.5.
GLSL_FUNCTION float elevationCoordinate(float h, float elevation) {
    float horizon = asin(horizonCosine(h));
    float up = elevation - horizon;
    float range = up >= 0.0f ? 0.5f * kAirPi - horizon : 0.5f * kAirPi + horizon;
    return 0.5f + 0.5f * sign(up) * sqrt(min(abs(up) / range, 1.0f));
}

GLSL_FUNCTION float elevationArgument(float h, float coordinate) {
    float horizon = asin(horizonCosine(h));
    float x = 2.0f * coordinate - 1.0f;
    float range = x >= 0.0f ? 0.5f * kAirPi - horizon : 0.5f * kAirPi + horizon;
    return clamp(horizon + x * abs(x) * range, -0.5f * kAirPi, 0.5f * kAirPi);
}

/// Azimuth from the sun's, -pi..pi, -> 0..1 with the sun at 0.5, seven times finer there than opposite; the table's
/// ends are neighbours (its x wraps), for the moon knows no symmetry about the sun.
GLSL_FUNCTION float azimuthCoordinate(float fromSun) {
    float x = fromSun / kAirPi;
    return 0.5f + 0.5f * x * (1.4f - 0.4f * x * x);
}
/// Its inverse by Newton's method.
GLSL_FUNCTION float azimuthArgument(float coordinate) {
    float s = 2.0f * coordinate - 1.0f;
    float x = s;
    for (int i = 0; i < 6; ++i) x -= (x * (1.4f - 0.4f * x * x) - s) / (1.4f - 1.2f * x * x);
    return x * kAirPi;
}

/// Azimuth of `direction` seen from the azimuth of `toward` (both world: x east, y up, z south), -pi..pi, clockwise.
GLSL_FUNCTION float azimuthFrom(vec3 direction, vec3 toward) {
    float along = direction.x * toward.x + direction.z * toward.z;
    float across = toward.x * direction.z - toward.z * direction.x;
    return (abs(along) + abs(across)) > 0.0f ? atan(across, along) : 0.0f;
}

/// The direction whose azimuth from `toward` and elevation are given: inverse of azimuthFrom.
GLSL_FUNCTION vec3 directionFrom(float azimuth, float elevation, vec3 toward) {
    float level = sqrt(toward.x * toward.x + toward.z * toward.z);
    vec2 ahead = level > 1e-6f ? vec2(toward.x, toward.z) / level : vec2(1.0f, 0.0f);
    vec2 turned = vec2(ahead.x * cos(azimuth) - ahead.y * sin(azimuth), ahead.x * sin(azimuth) + ahead.y * cos(azimuth));
    return vec3(turned.x * cos(elevation), sin(elevation), turned.y * cos(elevation));
}

/// Texture coordinate in the sky table. Texels of sky and of ground beside the horizon are not mixed.
GLSL_FUNCTION vec2 skyCoordinate(vec2 size, float h, vec3 direction, vec3 sun) {
    float y = elevationCoordinate(h, asin(clamp(direction.y, -1.0f, 1.0f)));
    float guard = 0.5f / size.y;
    y = y >= 0.5f ? clamp(y, 0.5f + guard, 1.0f - guard) : clamp(y, guard, 0.5f - guard);
    return vec2(azimuthCoordinate(azimuthFrom(direction, sun)), y);
}

GLSL_FUNCTION vec3 skyDirection(float h, vec2 uv, vec3 sun) {
    return directionFrom(azimuthArgument(uv.x), elevationArgument(h, uv.y), sun);
}

/// Distance of slice k of the aerial table's n: 0, then thirteen metres, growing with the cube to kAerialReach.
GLSL_FUNCTION float aerialDistance(float slice, float slices) {
    float share = slice / (slices - 1.0f);
    return kAerialReach * share * share * share;
}

GLSL_FUNCTION vec3 aerialCoordinate(vec3 size, float h, vec3 direction, vec3 sun, float distance) {
    float share = pow(clamp(distance / kAerialReach, 0.0f, 1.0f), 1.0f / 3.0f);
    float y = elevationCoordinate(h, asin(clamp(direction.y, -1.0f, 1.0f)));
    return vec3(azimuthCoordinate(azimuthFrom(direction, sun)), clamp(y, 0.5f / size.y, 1.0f - 0.5f / size.y),
                (share * (size.z - 1.0f) + 0.5f) / size.z);
}

// Table five: by what share the clouds' shade dims the air's light, by direction and distance, in the two coordinates of the others;
// its last slice is that of the whole sky.
GLSL_CONST float kShadeReach = 44000.0f;  // m: so far the grids of optical depth know the clouds

/// Distance of slice k of the table's n - 1: its square root is spaced evenly.
GLSL_FUNCTION float shadeDistance(float slice, float slices) {
    float share = slice / (slices - 2.0f);
    return kShadeReach * share * share;
}

/// Third coordinate of a distance, and of the sky.
GLSL_FUNCTION float shadeCoordinate(float slices, float distance) {
    return (sqrt(clamp(distance / kShadeReach, 0.0f, 1.0f)) * (slices - 2.0f) + 0.5f) / slices;
}
GLSL_FUNCTION float shadeOfSky(float slices) { return (slices - 0.5f) / slices; }

// Table six: what is above and below a cloud, by its altitude.
GLSL_CONST float kAroundHighest = 16000.0f;  // m

/// Altitude of column i of the table's n, whose square root is spaced evenly, and back, as a texture coordinate.
GLSL_FUNCTION float aroundAltitude(float i, float n) {
    float share = i / (n - 1.0f);
    return kAroundHighest * share * share;
}
GLSL_FUNCTION float aroundCoordinate(float h, float n) {
    return (sqrt(clamp(h / kAroundHighest, 0.0f, 1.0f)) * (n - 1.0f) + 0.5f) / n;
}

GLSL_END
#endif
