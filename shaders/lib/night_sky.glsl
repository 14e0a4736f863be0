// What shines through the air at night: the bright stars in their places, faint ones as many as there are, the Milky
// Way, and the discs of sun and moon. Radiances above the air, 1/sr, the sun's irradiance being 1.
#ifndef LUFTPOST_NIGHT_SKY_GLSL
#define LUFTPOST_NIGHT_SKY_GLSL
#include "shaders/shared/language.glsl.h"
GLSL_BEGIN

/// An integer hash (Wellons' lowbias32) and a float 0..1 of it.
GLSL_FUNCTION uint starHash(uint x) {
    x = (x ^ (x >> 16u)) * 0x7feb352du;
    x = (x ^ (x >> 15u)) * 0x846ca68bu;
    return x ^ (x >> 16u);
}
GLSL_FUNCTION float starUnit(uint x) { return float(x >> 8u) * (1.0f / 16777216.0f); }

/// The spot that a star of irradiance 1 makes `angle` from its place in a picture whose pixels are `pixel` wide.
GLSL_FUNCTION float starSpot(float angle, float pixel) {
    float width = max(0.6f * pixel, 0.00035f);
    return exp(-0.5f * angle * angle / (width * width)) / (6.2831853f * width * width);
}

/// Magnitude of the u-th of evenly drawn stars between `bright` and `faint`: the number brighter than m grows as
/// 10^(0.51 m) (Allen).
GLSL_FUNCTION float drawnMagnitude(float u, float bright, float faint) {
    float low = pow(10.0f, 0.51f * (bright - faint));
    return faint + log(low + u * (1.0f - low)) / (0.51f * 2.30258509f);
}

/// Cell of a grid of n x n per face of a cube, and the place in it (0..1).
struct CubeCell {
    uint key;
    vec2 place;
    vec2 corner;  // of the cell, -1..1 on the face
    int face;
};
GLSL_FUNCTION CubeCell cubeCell(vec3 d, float n) {
    vec3 a = abs(d);
    CubeCell cell;
    vec2 p;
    if (a.x >= a.y && a.x >= a.z) {
        cell.face = d.x > 0.0f ? 0 : 1;
        p = vec2(d.y, d.z) / a.x;
    } else if (a.y >= a.z) {
        cell.face = d.y > 0.0f ? 2 : 3;
        p = vec2(d.z, d.x) / a.y;
    } else {
        cell.face = d.z > 0.0f ? 4 : 5;
        p = vec2(d.x, d.y) / a.z;
    }
    vec2 at = clamp((p * 0.5f + vec2(0.5f)) * n, vec2(0.0f), vec2(n - 0.001f));
    vec2 whole = floor(at);
    cell.place = at - whole;
    cell.corner = whole / n * 2.0f - vec2(1.0f);
    cell.key = (uint(cell.face) * 4096u + uint(whole.y)) * 4096u + uint(whole.x);
    return cell;
}
GLSL_FUNCTION vec3 cubeDirection(int face, vec2 p) {
    float s = (face & 1) == 0 ? 1.0f : -1.0f;
    if (face < 2) return normalize(vec3(s, p.x, p.y));
    if (face < 4) return normalize(vec3(p.y, s, p.x));
    return normalize(vec3(p.x, p.y, s));
}

/// Some 9000 stars from magnitude 2.6 to 6.5 over the sphere: one or two in each of 6 x 28 x 28 cells, none of whose
/// spots crosses a border. `d`: J2000, unit.
GLSL_FUNCTION vec3 faintStars(vec3 d, float pixel) {
    CubeCell cell = cubeCell(d, 28.0f);
    vec3 sum = vec3(0.0f);
    for (uint i = 0u; i < 2u; ++i) {
        uint h = starHash(cell.key * 2u + i);
        vec2 at = vec2(0.1f) + 0.8f * vec2(starUnit(starHash(h + 1u)), starUnit(starHash(h + 2u)));
        vec3 place = cubeDirection(cell.face, cell.corner + at * (2.0f / 28.0f));
        float magnitude = drawnMagnitude(starUnit(starHash(h + 3u)), 2.6f, 6.5f);
        float warm = starUnit(starHash(h + 4u));
        vec3 colour = mix(vec3(0.82f, 0.97f, 1.35f), vec3(1.35f, 0.95f, 0.6f), warm * warm);
        float irradiance = 1.98e-11f * pow(10.0f, -0.4f * magnitude);
        sum += colour * irradiance * starSpot(length(place - d), pixel);
    }
    return sum;
}

GLSL_FUNCTION float skyNoise(vec3 p) {
    vec3 whole = floor(p);
    vec3 f = p - whole;
    f = f * f * (vec3(3.0f) - 2.0f * f);
    float sum = 0.0f;
    for (int i = 0; i < 8; ++i) {
        vec3 o = vec3(float(i & 1), float((i >> 1) & 1), float(i >> 2));
        vec3 c = whole + o;
        uint h = starHash(uint(int(c.x) + 512) + starHash(uint(int(c.y) + 512) + starHash(uint(int(c.z) + 512))));
        vec3 w = mix(vec3(1.0f) - f, f, o);
        sum += starUnit(h) * w.x * w.y * w.z;
    }
    return sum;
}

/// The Milky Way: a band about the galactic plane, brightest toward Sagittarius, with dark clouds in its middle. Some
/// 21 magnitudes per square arc second where it is bright, that is 4e-4 cd/m2.
GLSL_FUNCTION vec3 milkyWay(vec3 d) {
    const vec3 pole = vec3(-0.8677f, -0.1981f, 0.4560f);    // J2000: 12.857 h, +27.13 degrees
    const vec3 centre = vec3(-0.0549f, -0.8734f, -0.4839f);  // 17.760 h, -28.94 degrees
    float sinLatitude = dot(d, pole);
    float towardCentre = dot(d, centre);
    float cloud = 0.6f * skyNoise(d * 9.0f) + 0.3f * skyNoise(d * 21.0f) + 0.15f * skyNoise(d * 47.0f);
    float width = 0.13f + 0.06f * towardCentre;
    float band = exp(-abs(sinLatitude) / width) * (0.6f + 0.5f * towardCentre) * (0.35f + 1.3f * cloud);
    float dust = smoothstep(0.45f, 0.75f, 0.65f * skyNoise(d * 6.0f + vec3(7.0f)) + 0.35f * skyNoise(d * 17.0f)) *
                 exp(-sinLatitude * sinLatitude / 0.006f);
    return vec3(1.05f, 1.0f, 0.95f) * 2.6e-9f * band * (1.0f - 0.75f * dust);
}

/// The sun's disc `sine` from its middle (0..1 of the radius): limb darkening after Hestroffer and Magnan 1998; its mean
/// over the disc is 1.
GLSL_FUNCTION vec3 limbDarkening(float sine) {
    float mu = sqrt(max(1.0f - sine * sine, 1e-4f));
    vec3 alpha = vec3(0.43f, 0.52f, 0.64f);
    return vec3(pow(mu, alpha.x), pow(mu, alpha.y), pow(mu, alpha.z)) * (vec3(1.0f) + 0.5f * alpha);
}

/// One dark plain of the moon at (x, y) of the disc.
GLSL_FUNCTION float mare(vec2 p, vec2 at, float radius) {
    vec2 d = p - at;
    return exp(-(d.x * d.x + d.y * d.y) / (radius * radius));
}

/// Albedo of the moon's disc relative to its mean; `p`: -1..1, y toward its north. The large maria in their places.
GLSL_FUNCTION float moonAlbedo(vec2 p) {
    float dark = mare(p, vec2(-0.25f, 0.52f), 0.27f)     // Imbrium
                 + mare(p, vec2(0.27f, 0.46f), 0.17f)    // Serenitatis
                 + mare(p, vec2(0.49f, 0.15f), 0.22f)    // Tranquillitatis
                 + mare(p, vec2(0.81f, 0.29f), 0.10f)    // Crisium
                 + mare(p, vec2(0.74f, -0.08f), 0.15f)   // Fecunditatis
                 + mare(p, vec2(0.53f, -0.26f), 0.10f)   // Nectaris
                 + mare(p, vec2(-0.72f, 0.28f), 0.28f)   // Procellarum
                 + mare(p, vec2(-0.38f, 0.05f), 0.22f)   // Insularum
                 + mare(p, vec2(-0.25f, -0.35f), 0.22f)  // Nubium
                 + mare(p, vec2(-0.57f, -0.41f), 0.12f)  // Humorum
                 + mare(p, vec2(0.0f, 0.82f), 0.12f);    // Frigoris
    float rays = mare(p, vec2(-0.14f, -0.68f), 0.09f);   // Tycho
    return 1.12f - 0.42f * min(dark, 1.1f) + 0.2f * rays;
}

/// Radiance of the moon's surface, 1/sr, at (x, y) of its disc, the viewer along +z of the same frame and the sun toward
/// `sun`: Lommel and Seeliger's law, which makes the full moon flat; 4 kcd/m2 in its middle.
GLSL_FUNCTION vec3 moonRadiance(vec2 p, vec3 sun) {
    vec3 normal = vec3(p.x, p.y, sqrt(max(1.0f - p.x * p.x - p.y * p.y, 0.0f)));
    float lit = max(dot(normal, sun), 0.0f);
    float law = lit / max(lit + normal.z, 1e-3f);
    float earthshine = 1.5e-5f * max(-sun.z, 0.0f);
    return vec3(1.08f, 1.0f, 0.86f) * moonAlbedo(p) * (0.062f * law + earthshine);
}

GLSL_END
#endif
