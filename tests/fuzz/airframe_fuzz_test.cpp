// A broken airframe file is answered with core::Error, whatever is broken in it.
#include <gtest/gtest.h>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/flight/airframe.h"
#include "tests/fuzz/mutator.h"

namespace luftpost::flight {
TEST(AirframeFuzz, AnyDamageIsReadOrRefusedAndNeverACrash) {
    std::string const whole =
        core::readFile(std::string{LUFTPOST_SOURCE_DIR} + "/assets/airframes/mail_plane.json");
    std::vector<std::string> const pieces{"{",    "}",    "[", "]",     ",",      ":", "\"",
                                          "null", "true", "-", "1e999", "-1e308", "0", "[[[["};
    test::expectBoth(test::fuzz({{whole}, pieces}, [](std::string const& text) {
        try {
            parseAirframe(text, "plane.json");
            return true;
        } catch (core::Error const& error) {
            EXPECT_EQ(std::string{error.what()}.rfind("plane.json", 0), 0u);
            return false;
        }
    }));
}
}  // namespace luftpost::flight
