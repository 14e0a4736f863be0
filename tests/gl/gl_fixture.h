// A headless context for GL tests; any GL error fails the test that made it.
#pragma once
#include <gtest/gtest.h>

#include "engine/gl/context.h"
#include "engine/platform/surface.h"

namespace luftpost::test {
/// The one context of the test program.
inline platform::Surface& headless() {
    static std::unique_ptr<platform::Surface> const surface = [] {
        auto made = platform::openHeadless({256, 144});
        gl::prepareContext();
        return made;
    }();
    return *surface;
}

class GlTest : public ::testing::Test {
protected:
    /// The context is current before the members of a derived fixture are made.
    GlTest() {
        headless().makeCurrent();
        errorsBefore_ = gl::errorCount();
    }
    void TearDown() override { EXPECT_EQ(gl::errorCount(), errorsBefore_) << gl::lastError(); }
    void expectErrors(int count) { errorsBefore_ += count; }

private:
    int errorsBefore_ = 0;
};
}  // namespace luftpost::test
