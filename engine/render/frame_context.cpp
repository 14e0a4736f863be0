#include "engine/render/frame_context.h"

namespace luftpost::render {
Targets::Targets(glm::ivec2 const& pixels)
    : size{pixels},
      colour{gl::Format::rgba16f, pixels, 1, "HDR colour"},
      depth{gl::Format::depth32f, pixels, 1, "depth"},
      motion{gl::Format::rg16f, pixels, 1, "motion"},
      opaque{{&colour, &motion}, &depth, "opaque"},
      blended{{&colour}, &depth, "blended"},
      colourOnly{{&colour}, nullptr, "colour only"} {
    depth.setSampling(gl::Filter::nearest, gl::Filter::nearest, gl::Wrap::clampToEdge);
    motion.setSampling(gl::Filter::nearest, gl::Filter::nearest, gl::Wrap::clampToEdge);
}
}  // namespace luftpost::render
