// What every shader may know of the frame: block 0. Filled by the renderer (camera, time, picture), by the sky (light,
// exposure) and by the clouds (their shadow), uploaded once before the first pass.
//
// "World" on the GPU: x east, y up, z south, metres, RELATIVE TO THE CAMERA, bent by curvedFromFlat where it is far.
// Light: scene-linear Rec. 709 where the sun's irradiance above the air is 1. HDR targets hold radiance * preExposure.
//
// Only vec4, ivec4 and mat4 members, so that std140 and C++ lay the block out alike (a test asks the driver).
#ifndef LUFTPOST_FRAME_GLSL_H
#define LUFTPOST_FRAME_GLSL_H
#include "shaders/shared/language.glsl.h"
#include "shaders/shared/block.glsl.h"
GLSL_BEGIN

GLSL_CONST int kProjectionPerspective = 0;
GLSL_CONST int kProjectionPanorama = 1;  // equirectangular: azimuth 0..360 degrees from the left edge, zenith on top
GLSL_CONST int kProjectionDome = 2;      // equal area: zenith in the centre, north up, east left

GLSL_CONST int kDebugNormals = 1;    // bits of frame.mode.y
GLSL_CONST int kDebugWireframe = 2;

UNIFORM_BLOCK(FrameBlock, 0) {
    mat4 clipFromWorld;          // reversed depth: near / distance along the axis, 0 at infinity
    mat4 worldFromClip;
    mat4 previousClipFromWorld;  // takes a position relative to this frame's camera
    mat4 worldFromCamera;        // rotation; the camera looks along its -z
    vec4 viewport;               // width, height of the HDR target, 1 / width, 1 / height of the whole picture, pixels
    vec4 tile;                   // xy: where the target's lower left corner lies in the whole picture, pixels; 0 but for a tile
    vec4 projection;             // x, y: tangent of half the horizontal and vertical field of view; z: near plane; w: pixel angle, rad
    ivec4 mode;                  // x: kProjection...; y: bits of kDebug...; z: frame number; w: 1 for a still
    vec4 cameraWorld;            // xyz: position in the world, for what varies slowly (floats: half a metre at 4000 km)
    vec4 cameraMoved;            // xyz: position now less position in the previous frame
    vec4 time;                   // x: seconds of the simulation modulo 3600; y: seconds since the previous frame; z: UTC seconds of the day; w: seconds the eye had to adapt
    vec4 exposure;               // x: preExposure; y: display = tone map(radiance * y)

    vec4 sunDirection;           // xyz: unit, toward the sun; w: its angular radius
    vec4 sunIrradiance;          // rgb: after the air, at the camera's altitude, without clouds; w: share that clouds let through
    vec4 moonDirection;          // as the sun's
    vec4 moonIrradiance;         // as the sun's
    vec4 skyIrradiance;          // rgb: of the whole sky on a horizontal plane
    vec4 groundIrradiance;       // rgb: from below, on a plane that faces down

    vec4 wind;                   // xyz: 10 m above the ground, mean, m/s, where the air goes to; w: gust, m/s
    vec4 weather;                // x: visibility, m; y: precipitation, mm/h; z: share of it that is snow; w: wetness of the ground 0..1
    vec4 aircraft;               // xyz: the player's aircraft, relative to the camera; w: 1 when there is one
    mat4 modelShadowFromWorld;   // position relative to the camera -> 0..1 over the map of lib/model_shadow.glsl, z: 1 nearest the light
    vec4 modelShadow;            // x: 1 when there is a map; y, z: metres across and along the light; w: angular radius of the light
} BLOCK_NAME(frame);

GLSL_END
#endif
