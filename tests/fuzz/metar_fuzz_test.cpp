#include <gtest/gtest.h>

#include <cmath>

#include "engine/core/error.h"
#include "engine/weather/metar.h"
#include "engine/weather/source.h"
#include "tests/fuzz/mutator.h"

using namespace luftpost;
using namespace luftpost::weather;

namespace {
std::vector<std::string> const kReports{
    "METAR LSZB 010050Z AUTO 27012G23KT 240V300 8000 -SHRA FEW018CB BKN030 12/M01 Q1013 NOSIG=",
    "KCVG 012352Z 14011KT 1 1/2SM R35/3000V3500FT RA BR OVC006 04/04 A3014 RMK AO2 SLP212 CIG 005V008 P0005 60011 T00390039 10072 $",
    "URMO 292300Z AUTO /////MPS 9999 // ///////// ///// Q//// RMK QFE////////",
    "EGNT 292250Z 20004KT 160V250 0100 R25/0800U FG VV001 02/02 Q1022 BECMG 0800 BCFG",
    "CYYU 012300Z 13005G//KT M1/4SM -SHSN SCT032TCU OVC041 M02/M03 A2979 WS R18 RMK SC3SC5 SLP106",
    "ENQC 031950Z AUTO 13040KT 9999NDV //////CB ///TCU OVC020/// 07/03 Q1008 W///S5 RERA",
    "USTR 020000Z 16005MPS CAVOK DRSN M23/M25 Q1019 R30/450255 R34L/CLRD70 TEMPO 17010MPS 1000 SHSN",
    "LTAJ 292250Z 01010KT 9999 FEW 018CB BKN080 10/08 Q1015 NOSIG RMK RWY10 02012KT 6CU045 7AC080",
    "SVSA 291800Z NIL", "SAOR 01123Z 23005KT 8000 BKN004 18/17 Q1013 BLACKBLU"};

std::vector<std::string> const kFiles{
    "2024/03/01 00:50\n" + kReports[0] + "\n\n2024/03/01 00:53\n" + kReports[1] + "\n", "SASW31 LSSW 010050\n" + kReports[0] + "\nMETAR COR " + kReports[3] + "=\n",
    kReports[2] + "\n" + kReports[4] + "\n  " + kReports[5] + "\n" + kReports[2] + "\n" + kReports[9] + "\n",
    "#DEBUG\nstation\tvalid\tmetar\nCVG\t2024-03-01 00:52\t" + kReports[1] + "\nCVG\t2024-03-01 00:52\t" + kReports[1] + "\n",
    "station,valid,metar\nCVG,2024-03-01 00:52,\"" + kReports[1] + "\"\n",
    R"([{"rawOb":"METAR RJTT 121500Z 03005KT 5000 -RA FEW003 20/20 Q1023","obsTime":1789225200,"lat":35.5,"lon":139.7,"elev":5},{"rawOb":"VABB 060900Z 28012KT"}])"};

std::vector<std::string> const kWords{" ", "\n", "\t", "=", "/", "//", "////", "//////", "///", "M", "P", "-", "+", "VC", "RE", "KT", "MPS", "KMH", "SM", "1/2SM", "1 ",
                                      "9999", "CAVOK", "NSC", "NCD", "SKC", "CLR", "FEW", "SCT010", "BKN", "OVC999", "VV", "CB", "TCU", "Q", "A2992", "RMK ", "AO2", "SLP999",
                                      "P9999", "T19991999", "AUTO", "COR", "NIL", "METAR ", "TEMPO ", "R24/", "R/SNOCLO", "WS ALL RWY", "W19/S9", "BLU", "2AC070", "SC3", "FZRA",
                                      "TSGR", "+FC", "UP", "310000Z", "290259Z", "999999Z", "QFE", "99999", "\"", "[", "]", "{", "}", ",", "\"rawOb\":", "null", "1e999", "#"};

void expectWithin(std::optional<double> value, double least, double most) {
    EXPECT_TRUE(!value || (*value >= least && *value <= most)) << value.value_or(0.0);
}

void expectSound(std::string const& text) {
    auto const metar = decodeMetar(text);
    if (!metar) return;
    for (MetarNote const& note : metar->notes) ASSERT_LE(note.offset + note.length, text.size());
    Report const report = reportOf(*metar, 4000.0);
    expectWithin(report.speed_mps, 0.0, 150.0);
    expectWithin(report.gust_mps, 0.0, 150.0);
    expectWithin(report.from_deg, 0.0, 360.0);
    expectWithin(report.visibility_m, 0.0, 300000.0);
    expectWithin(report.temperature_c, -99.9, 65.0);
    expectWithin(report.pressure_hpa, 850.0, 1100.0);
    expectWithin(report.rate_mm_h, 0.0, 200000.0);
    for (ReportedLayer const& layer : report.layers.value_or(std::vector<ReportedLayer>{})) expectWithin(layer.cover, 0.0, 1.0);
}

/// What is taken must also make a recording that our own reader takes, and a field whose answers are numbers.
bool takes(std::string const& bytes) {
    try {
        Recording recording = parseSource(bytes, "fuzz", {.latest = 1677000000.0});
        if (!recording.unknownKeys.empty()) return true;
        EXPECT_EQ(recordingText(parseRecording(recordingText(recording), "again")), recordingText(recording)) << bytes;
        Field const field = fieldFrom(std::move(recording), {}, {});
        EXPECT_EQ(field.listedReports().size(), field.recording().order.size());
        Weather const weather = field.at(100.0, 200.0, 0.5 * (field.start() + field.end()));
        EXPECT_TRUE(std::isfinite(weather.temperature) && std::isfinite(weather.visibility) && std::isfinite(weather.windSurface.x)) << bytes;
        return true;
    } catch (core::Error const& error) {
        EXPECT_EQ(std::string{error.what()}.find('\n'), std::string::npos) << error.what();
        return false;
    }
}
}  // namespace

TEST(FuzzMetar, BrokenReportsAreReadAsFarAsTheyGo) {
    auto const score = test::fuzz({kReports, kWords, test::Mutator::Kind::text, 4096}, [](std::string const& text) {
        expectSound(text);
        return true;
    });
    EXPECT_GE(score.tried, 64u);
}

TEST(FuzzMetar, BrokenFilesAreRefusedOrReadNeverACrash) {
    for (std::string const& file : kFiles) EXPECT_TRUE(takes(file)) << file;
    test::expectBoth(test::fuzz({kFiles, kWords}, takes), 0.25);
}
