// A broken airframe file is answered with core::Error, whatever is broken in it.
#include <gtest/gtest.h>

#include <random>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/flight/airframe.h"

namespace luftpost::flight {
TEST(AirframeFuzz, AnyDamageIsReadOrRefusedAndNeverACrash) {
    std::string const whole =
        core::readFile(std::string{LUFTPOST_SOURCE_DIR} + "/assets/airframes/mail_plane.json");
    std::mt19937 random{11};
    std::string const pieces[] = {"{",    "}",    "[", "]",     ",",      ":", "\"",
                                  "null", "true", "-", "1e999", "-1e308", "0", "[[[["};
    int refused = 0;
    for (int round = 0; round < 3000; ++round) {
        std::string text = whole;
        int const changes = 1 + static_cast<int>(random() % 4);
        for (int i = 0; i < changes; ++i) {
            std::size_t const at = random() % text.size();
            switch (random() % 4) {
                case 0:
                    text[at] = static_cast<char>(random() % 256);
                    break;
                case 1:
                    text.erase(at, 1 + random() % 40);
                    break;
                case 2:
                    text.insert(at, pieces[random() % std::size(pieces)]);
                    break;
                default:
                    text.resize(at + 1);
                    break;
            }
        }
        try {
            parseAirframe(text, "plane.json");
        } catch (core::Error const& error) {
            ++refused;
            EXPECT_EQ(std::string{error.what()}.rfind("plane.json", 0), 0u);
        }
    }
    EXPECT_GT(refused, 1500);
    EXPECT_LT(refused, 3000) << "some damage (a digit) leaves an airframe";
}
}  // namespace luftpost::flight
