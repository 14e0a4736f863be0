// The land on the GPU: no hole under the horizon, and where the height function says it is.
#include <random>

#include "shaders/lib/curvature.glsl"
#include "tests/gl/gl_fixture.h"
#include "tests/gl/land_picture.h"

namespace luftpost::render {
namespace {
class LandTest : public test::GlTest {};
}  // namespace
}  // namespace luftpost::render
