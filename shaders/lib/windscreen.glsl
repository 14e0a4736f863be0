// Rain on the glass before the pilot.
//
// The glass is taken for a cylinder about the eye, unrolled: metres to the right and up. Beads sit where drops have struck it, each for some
// seconds, then another strikes elsewhere. Larger drops run as the air drives them, up the windscreen and back along the side
// windows, or down when the aircraft hardly moves, each with a trail. A drop is a lens of so short a focus that it shows the whole
// world upside down: the sky below, the land above, and a dark rim.
#ifndef LUFTPOST_WINDSCREEN_GLSL
#define LUFTPOST_WINDSCREEN_GLSL
#include "shaders/shared/language.glsl.h"
#include "shaders/lib/precipitation.glsl"
GLSL_BEGIN

GLSL_CONST float kGlassAway = 0.7f;        // m from the eye
GLSL_CONST float kSideWindow = 0.85f;      // rad from ahead: from here on the air drives drops back, not up
GLSL_CONST float kBeadCell = 0.008f;       // m
GLSL_CONST float kBead = 0.0026f;          // m, radius of the largest
GLSL_CONST float kRunnerColumn = 0.026f;   // m
GLSL_CONST float kRunnerCell = 0.15f;      // m along a column
GLSL_CONST float kRunner = 0.0034f;        // m

/// What lies on the glass at a place: `cover` 0..1 of it, and `slope`, from the drop's middle (0) to its rim (length 1), right and up.
struct GlassDrop {
    float cover;
    vec2 slope;
};

GLSL_FUNCTION GlassDrop noGlassDrop() {
    GlassDrop none;
    none.cover = 0.0f;
    none.slope = vec2(0.0f);
    return none;
}

/// Where a direction of the aircraft (x ahead, y up, z right) meets the glass: m to the right of ahead and up.
GLSL_FUNCTION vec2 glassPlace(vec3 direction) {
    float level = sqrt(direction.x * direction.x + direction.z * direction.z);
    return kGlassAway * vec2(atan(direction.z, direction.x), clamp(direction.y / max(level, 0.1f), -2.0f, 2.0f));
}

/// Which way the air drives water there, right and up.
GLSL_FUNCTION vec2 glassFlow(vec2 place) {
    if (abs(place.x) < kSideWindow * kGlassAway) return vec2(0.0f, 1.0f);
    return vec2(place.x < 0.0f ? -1.0f : 1.0f, 0.0f);
}

/// A bead; `wet` 0..1, `seconds` of the time.
GLSL_FUNCTION GlassDrop glassBead(vec2 place, float wet, float seconds) {
    vec2 cell = floor(place / kBeadCell);
    uint key = uint(int(cell.x) + 4096) * 7919u + uint(int(cell.y) + 4096) * 104729u;
    float lives = seconds / (4.0f + 9.0f * dropUnit(key)) + dropUnit(key + 1u);
    uint life = key + uint(int(floor(lives))) * 31337u;
    if (dropUnit(life + 2u) > 0.75f * wet) return noGlassDrop();
    float size = dropUnit(life + 3u);
    float dries = clamp((1.0f - fract(lives)) * 8.0f, 0.0f, 1.0f);
    float radius = kBead * (0.3f + 0.7f * size * size) * dries;
    float free = kBeadCell - 2.0f * radius;
    vec2 middle = cell * kBeadCell + vec2(radius) + free * vec2(dropUnit(life + 4u), dropUnit(life + 5u));
    GlassDrop drop;
    drop.slope = (place - middle) / max(radius, 1e-5f);
    float rim = length(drop.slope);
    drop.cover = rim < 1.0f ? 1.0f - smoothstep(0.8f, 1.0f, rim) : 0.0f;
    return drop;
}

/// A running drop and its trail; `slid`: m that drops have gone along `flow`.
GLSL_FUNCTION GlassDrop glassRunner(vec2 place, vec2 flow, float wet, float slid) {
    vec2 aside = vec2(flow.y, -flow.x);
    float across = dot(place, aside) / kRunnerColumn;
    float column = floor(across);
    uint key = uint(int(column) + 4096) * 15731u + (flow.y > 0.5f ? 17u : flow.x > 0.0f ? 29u : 43u);
    float along = dot(place, flow) - slid * (0.5f + dropUnit(key)) + kRunnerCell * dropUnit(key + 1u);
    float row = floor(along / kRunnerCell);
    uint cell = key + uint(int(row) + 65536) * 26699u;
    if (dropUnit(cell + 2u) > 0.8f * wet) return noGlassDrop();
    float radius = kRunner * (0.5f + 0.5f * dropUnit(cell + 3u));
    float bend = 0.06f * sin(dot(place, flow) * 70.0f + 6.2831853f * dropUnit(key + 4u));
    float sideways = (across - column - 0.3f - 0.4f * dropUnit(cell + 5u) - bend) * kRunnerColumn;
    float ahead = along - (row + 0.75f) * kRunnerCell;  // of the head's middle
    GlassDrop drop;
    float rim;
    if (ahead > -0.4f * radius) {
        vec2 at = vec2(ahead / 1.3f, sideways) / radius;
        drop.slope = at.x * flow + at.y * aside;
        rim = length(at);
        drop.cover = rim < 1.0f ? 1.0f - smoothstep(0.8f, 1.0f, rim) : 0.0f;
        return drop;
    }
    float behind = clamp(-ahead / (0.6f * kRunnerCell), 0.0f, 1.0f);
    rim = sideways / (radius * mix(0.75f, 0.3f, behind));
    drop.slope = rim * aside;
    drop.cover = abs(rim) < 1.0f ? 0.55f * (1.0f - behind) * (1.0f - rim * rim) : 0.0f;
    return drop;
}

/// The drop that lies at a place. `slid`: x: m that drops have gone up the windscreen (negative: down), y: back along the side windows.
GLSL_FUNCTION GlassDrop glassDrop(vec2 place, float wet, vec2 slid, float seconds) {
    vec2 flow = glassFlow(place);
    GlassDrop runner = glassRunner(place, flow, wet, flow.y > 0.5f ? slid.x : slid.y);
    GlassDrop bead = glassBead(place, wet, seconds);
    if (runner.cover > bead.cover) return runner;
    return bead;
}

/// What a drop shows at `slope`, seen along a ray whose sine of elevation is `up`: x: share of the sky in it (the rest is land), y: what its rim leaves of that.
GLSL_FUNCTION vec2 glassLens(vec2 slope, float up) {
    float turned = up - 1.1f * slope.y;
    float rim = dot(slope, slope);
    return vec2(clamp(0.5f + 2.5f * turned, 0.0f, 1.0f), 1.0f - 0.65f * rim * rim);
}

GLSL_END
#endif
