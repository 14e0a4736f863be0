// Genera where nobody named them: the rules on composed skies, and their score against an observer.
#include <fmt/format.h>
#include <gtest/gtest.h>

#include <array>
#include <fstream>
#include <map>
#include <sstream>

#include "engine/core/time.h"
#include "engine/weather/diagnosis.h"
#include "engine/weather/genera.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
std::string const kObserver = std::string{LUFTPOST_SOURCE_DIR} + "/../shared/weather/meteoswiss/BAS_observer_2023-01_07.csv";
constexpr std::array kWmo0500{Genus::Ci, Genus::Cc, Genus::Cs, Genus::Ac, Genus::As, Genus::Ns, Genus::Sc, Genus::St, Genus::Cu, Genus::Cb};

struct Look {
    Genus seen;
    Report report;  // okta, temperature, dew point, radiation, rain and hour: no genus
};

std::optional<double> number(std::string const& cell) { return cell.empty() ? std::nullopt : std::optional{std::stod(cell)}; }

/// The looks in which the observer named a genus.
std::vector<Look> looks() {
    std::ifstream file{kObserver};
    std::string line;
    std::getline(file, line);
    std::vector<Look> all;
    while (std::getline(file, line)) {
        std::vector<std::string> cells;
        std::stringstream stream{line};
        for (std::string cell; std::getline(stream, cell, ',');) cells.push_back(cell);
        if (cells.size() < 15 || cells[2].empty()) continue;
        Look look;
        look.seen = kWmo0500.at(static_cast<std::size_t>(std::stoi(cells[2])));
        std::string const& t = cells[0];
        look.report.time = *core::parseUtc(fmt::format("{}-{}-{}T{}:{}Z", t.substr(0, 4), t.substr(4, 2), t.substr(6, 2), t.substr(8, 2), t.substr(10, 2)));
        if (auto const okta = number(cells[1])) look.report.coverTotal = *okta / 8.0;
        look.report.radiation_w_m2 = number(cells[7]);
        look.report.longwave_w_m2 = number(cells[10]);
        look.report.temperature_c = number(cells[11]);
        look.report.dew_point_c = number(cells[12]);
        if (auto const rain = number(cells[14])) look.report.rate_mm_h = 6.0 * *rain;
        all.push_back(look);
    }
    return all;
}

/// What the rules make of it; nothing for a clear sky.
std::optional<Genus> diagnosed(Report const& report) {
    Site const site{"Basel / Binningen", 47.541, 7.584, 316.0, {report}};
    auto const full = fullReports(site);
    if (full[0].layers.empty()) return std::nullopt;
    return full[0].layers[0].genus;
}

Signs summerNoon() {
    Signs s;
    s.elevation = 300.0;
    s.spread = 9.0;
    s.temperature = 295.0;
    s.dewPoint = 286.0;
    s.sunSine = 0.8;
    return s;
}

std::vector<Genus> generaOf(Signs const& s) {
    std::vector<Genus> genera;
    for (FullLayer const& layer : diagnosedLayers(s)) genera.push_back(layer.genus);
    return genera;
}
}  // namespace

TEST(Diagnosis, AgreesWithTheObserverAtBaselMoreThanAlwaysStratocumulusAndMoreThanTheLookBefore) {
    auto const all = looks();
    if (all.empty()) GTEST_SKIP() << "no " << kObserver;
    std::map<std::pair<Genus, std::string>, int> table;
    std::map<Genus, int> counts;
    int right = 0, always = 0, persistent = 0, scored = 0;
    for (Look const& look : all) ++counts[look.seen];
    for (std::size_t i = 0; i < all.size(); ++i) {
        auto const found = diagnosed(all[i].report);
        ++table[{all[i].seen, found ? std::string{genusName(*found)} : "none"}];
        if (counts[all[i].seen] < 10) continue;
        ++scored;
        right += found == all[i].seen;
        always += all[i].seen == Genus::Sc;
        persistent += i > 0 && all[i - 1].seen == all[i].seen;
    }
    for (auto const& [pair, count] : table) std::printf("%s seen, %s found: %d\n", std::string{genusName(pair.first)}.c_str(), pair.second.c_str(), count);
    std::printf("%d scored: right %.3f, always Sc %.3f, as before %.3f\n", scored, 1.0 * right / scored, 1.0 * always / scored, 1.0 * persistent / scored);
    ASSERT_GT(scored, 200);
    EXPECT_GT(right, always + scored / 10);
    EXPECT_GT(right, persistent + scored / 10);
}

TEST(Diagnosis, TellsLowFromHighByWhatTheSkyGivesBack) {
    Report r;
    r.time = *core::parseUtc("2023-02-10T05:50Z");
    r.temperature_c = 3.0;
    r.dew_point_c = 1.0;
    r.rate_mm_h = 0.0;
    r.coverTotal = 1.0;
    r.longwave_w_m2 = 315.0;  // nearly as much as a black sky of 3 C
    EXPECT_EQ(diagnosed(r), Genus::St);
    r.coverTotal = 0.25;
    r.longwave_w_m2 = 238.0;
    EXPECT_EQ(diagnosed(r), Genus::Ci);
    r.coverTotal = 0.0;
    EXPECT_EQ(diagnosed(r), std::nullopt);
}

TEST(Diagnosis, OfCoverByLevelFollowsTheFirstRule) {
    Signs s = summerNoon();
    s.low = 0.4;
    s.cape = 300.0;
    EXPECT_EQ(generaOf(s), std::vector{Genus::Cu});
    s.high = 0.5;
    EXPECT_EQ(generaOf(s), (std::vector{Genus::Cu, Genus::Ci}));
    s.high = 0.9;
    EXPECT_EQ(generaOf(s), (std::vector{Genus::Cu, Genus::Cs}));
    s.code = 95;
    s.low = 0.7;
    EXPECT_EQ(generaOf(s).front(), Genus::Cb);
    Signs rain = summerNoon();
    rain.low = 0.8;
    rain.mid = 0.9;
    rain.rate = 1.5;
    rain.spread = 1.0;
    EXPECT_EQ(generaOf(rain), std::vector{Genus::Ns});
    rain.rate = 0.0;
    rain.low = 0.0;
    EXPECT_EQ(generaOf(rain), std::vector{Genus::As});
    rain.mid = 0.5;
    EXPECT_EQ(generaOf(rain), std::vector{Genus::Ac});
    Signs low = summerNoon();
    low.day = false;
    low.low = 0.9;
    low.spread = 0.8;
    low.windSpeed = 2.0;
    EXPECT_EQ(generaOf(low), std::vector{Genus::St});
    low.spread = 6.0;
    EXPECT_EQ(generaOf(low), std::vector{Genus::Sc});
    low.code = 45;
    EXPECT_EQ(generaOf(low), std::vector{Genus::Fog});
    EXPECT_TRUE(generaOf(summerNoon()).empty());
}

TEST(Diagnosis, CoverComesFromTheSunByDayAndFromTheSkyByNight) {
    Signs s = summerNoon();
    double const clear = 1098.0 * 0.8 * std::exp(-0.057 / 0.8);
    for (double const okta : {1.0, 4.0, 7.0, 8.0}) {
        s.radiation = clear * (1.0 - 0.75 * std::pow(okta / 8.0, 3.4));
        EXPECT_NEAR(*coverFromRadiation(s), okta / 8.0, 1e-6);
    }
    Signs night = summerNoon();
    night.sunSine = -0.5;
    EXPECT_EQ(coverFromRadiation(night), std::nullopt);
    night.longwave = 5.67e-8 * 295.0 * 295.0 * 295.0 * 295.0;
    EXPECT_EQ(*coverFromRadiation(night), 1.0);
}
