// Which part of a picture a work group takes. GLSL alone, compute shaders.
#ifndef LUFTPOST_GROUPS_GLSL
#define LUFTPOST_GROUPS_GLSL

/// The work group with its row moved. Software GL deals the groups out in as many stretches as it has threads: in their own
/// order one thread would get the sky with the clouds and another the land. The prime strews the rows of each stretch over the picture;
/// no picture has that many rows of groups, or a multiple, so that each comes once.
uvec2 strewnGroup() { return uvec2(gl_WorkGroupID.x, gl_WorkGroupID.y * 1279u % gl_NumWorkGroups.y); }

/// The pixel of an invocation in groups of 8 x 8.
ivec2 strewnPixel() { return ivec2(strewnGroup() * 8u + gl_LocalInvocationID.xy); }
#endif
