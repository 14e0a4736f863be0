// How a block is written once for C++ and GLSL: UNIFORM_BLOCK(Type, binding) { members } BLOCK_NAME(name);
// In C++ it is the struct Type, and `name` means nothing.
#ifndef LUFTPOST_BLOCK_GLSL_H
#define LUFTPOST_BLOCK_GLSL_H
#ifdef __cplusplus
#define UNIFORM_BLOCK(TYPE, BINDING) struct alignas(16) TYPE
#define BLOCK_NAME(NAME)
#else
#define UNIFORM_BLOCK(TYPE, BINDING) layout(std140, binding = BINDING) uniform TYPE
#define BLOCK_NAME(NAME) NAME
#endif
#endif
