// What the weather's page offers.
#include "game/app/weather_desk.h"

#include <gtest/gtest.h>

#include <algorithm>

#include "tests/support/session.h"

using namespace luftpost;
using namespace luftpost::app;

namespace {
Session sessionOver(char const* source) { return Session{tests::flying(tests::planOver(source))}; }
}  // namespace

TEST(WeatherDesk, OffersTheFileOfTheCommandLineInWhateverFormatItIs) {
    std::filesystem::path const file = tests::scratch() / "report.metar";
    core::writeFileAtomically(file, "2024/05/01 11:50\nLSZH 011150Z 24008KT 9999 FEW030 SCT045 12/08 Q1015\n");
    Session const session = sessionOver("preset:fair");
    auto const offered = [&](std::string const& given) {
        auto const sources = WeatherDesk{given}.menu(session).sources;
        return std::any_of(sources.begin(), sources.end(), [&](auto const& source) { return source.source == given; });
    };
    EXPECT_TRUE(offered("recorded:" + file.string()));
    EXPECT_TRUE(offered("preset:storm"));
    EXPECT_FALSE(offered("recorded:" + file.string() + ".gone"));
}
