// A compute program that asks for the clouds' density, made twice.
#pragma once
#include <string>

#include "engine/gl/program_library.h"
#include "engine/render/cloud_scene.h"

namespace luftpost::render {
/// With towers and anvils (lib/cloud.glsl's CLOUD_TOWERS) and without: where no layer has them, their branches still cost software GL
/// their whole price and a GPU its registers. Both are made at once, so that no storm ever waits for a compiler. Throws core::Error.
class CloudProgram {
public:
    CloudProgram(gl::ProgramLibrary& programs, std::string const& name, gl::ProgramLibrary::Defines const& defines = {})
        : whole_{programs.compute(name, defines)}, plain_{programs.compute(name, withoutTowers(defines))} {}

    gl::Program const& of(CloudScene const& scene) const { return scene.hasTowers() ? whole_ : plain_; }

private:
    static gl::ProgramLibrary::Defines withoutTowers(gl::ProgramLibrary::Defines defines) {
        defines.emplace_back("CLOUD_TOWERS false");
        return defines;
    }

    gl::Program const& whole_;
    gl::Program const& plain_;
};
}  // namespace luftpost::render
