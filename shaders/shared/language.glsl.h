// The ground that C++ and GLSL share: included first by every block of shaders/shared and every function of
// shaders/lib. In C++ the code lives in namespace luftpost::glsl and GLM plays the part of the built-in types.
// Shared code uses literals with f, no swizzles, explicit casts, no array constructors, OUT(T) for out-parameters.
#ifndef LUFTPOST_LANGUAGE_GLSL_H
#define LUFTPOST_LANGUAGE_GLSL_H
#ifdef __cplusplus
#include <array>
#include <cmath>
#include <cstdint>
#include <glm/glm.hpp>
#define GLSL_BEGIN namespace luftpost::glsl { using namespace glm; using uint = unsigned int;
#define GLSL_END }
#define GLSL_FUNCTION inline
#define GLSL_INLINE [[gnu::always_inline]] inline  // for loops over points that must become vector code
#define GLSL_CONST inline constexpr
#define OUT(T) T&
#define INOUT(T) T&
#else
#define GLSL_BEGIN
#define GLSL_END
#define GLSL_FUNCTION
#define GLSL_INLINE
#define GLSL_CONST const
#define OUT(T) out T
#define INOUT(T) inout T
#endif
#endif
