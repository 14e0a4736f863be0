// The figures of docs/genera.md are those that the game draws with.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "engine/core/file.h"
#include "engine/weather/genera.h"

namespace luftpost::weather {
TEST(GeneraPage, HasTheFiguresThatTheGameDrawsWith) {
    std::string const page = core::readFile(std::string{LUFTPOST_SOURCE_DIR} + "/docs/genera.md");
    for (int i = 0; i < kGenera; ++i) {
        GenusRow const& row = genusRow(static_cast<Genus>(i));
        std::string const line = fmt::format("| {} | {:.0f} | {:.0f} | {:.3g} | {:.0f} | {} | {:.1f} |\n", row.name, row.base, row.thickness, row.water * 1e3,
                                             row.radius * 1e6, row.ice ? "crystals" : "droplets", row.extinction * 1e3);
        EXPECT_NE(page.find(line), std::string::npos) << "expected " << line;
    }
}
}  // namespace luftpost::weather
