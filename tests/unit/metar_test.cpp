#include <gtest/gtest.h>

#include <cmath>

#include "engine/weather/metar.h"

using namespace luftpost::weather;

namespace {
constexpr double kKnot = 1852.0 / 3600.0;

Metar read(std::string const& text) {
    auto const metar = decodeMetar(text);
    EXPECT_TRUE(metar) << text;
    return metar.value_or(Metar{});
}

/// The report with the aerodrome at 100 m.
Report report(std::string const& text) { return reportOf(read(text), 100.0); }

std::string notes(std::string const& text) {
    std::string all;
    for (MetarNote const& note : read(text).notes) all += text.substr(note.offset, note.length) + " " + note.what + "; ";
    return all;
}

double filledNumber(Report const& report, std::string const& place) {
    auto const found = report.filled.find(place);
    return found == report.filled.end() ? std::nan("") : std::get<double>(found->second);
}
std::string filledWord(Report const& report, std::string const& place) {
    auto const found = report.filled.find(place);
    return found == report.filled.end() ? "" : std::get<std::string>(found->second);
}

void expectCovers(Report const& report, std::vector<double> const& covers) {
    ASSERT_TRUE(report.layers);
    ASSERT_EQ(report.layers->size(), covers.size());
    for (std::size_t i = 0; i < covers.size(); ++i) EXPECT_NEAR((*report.layers)[i].cover.value_or(-1.0), covers[i], 1e-12) << "layer " << i;
}
}  // namespace

TEST(Metar, ASwissReportIsReadWhole) {
    Metar const metar = read("METAR LSZB 010050Z AUTO 27012G23KT 240V300 8000 -SHRA FEW018CB BKN030 12/M01 Q1013 NOSIG=");
    EXPECT_EQ(metar.station, "LSZB");
    EXPECT_TRUE(metar.automatic);
    ASSERT_TRUE(metar.time);
    EXPECT_EQ(metar.time->day * 10000 + metar.time->hour * 100 + metar.time->minute, 10050);
    EXPECT_TRUE(metar.notes.empty());
    Report const r = reportOf(metar, 509.0);
    EXPECT_NEAR(*r.speed_mps, 12 * kKnot, 1e-9);
    EXPECT_NEAR(*r.gust_mps, 23 * kKnot, 1e-9);
    EXPECT_EQ(r.from_deg, 270.0);
    EXPECT_EQ(r.visibility_m, 8000.0);
    EXPECT_FALSE(r.visibilityIsMinimum);
    EXPECT_EQ(r.precipitationKind, Precipitation::Rain);
    EXPECT_FALSE(r.rate_mm_h) << "intensity is no figure";
    EXPECT_EQ(filledNumber(r, "precipitation.rate_mm_h"), 1.0);
    EXPECT_EQ(r.thunder, false);
    expectCovers(r, {1.5 / 8, 0.75});
    EXPECT_EQ((*r.layers)[0].genus, Genus::Cb);
    EXPECT_NEAR(*(*r.layers)[0].base_m, 509.0 + 548.64, 1e-9);
    EXPECT_FALSE((*r.layers)[1].genus);
    EXPECT_EQ(r.temperature_c, 12.0);
    EXPECT_EQ(r.dew_point_c, -1.0);
    EXPECT_EQ(r.pressure_hpa, 1013.0);
}

TEST(Metar, AnAmericanReportTakesWhatItsRemarksKnowBetter) {
    Report const r = report("KCVG 012352Z 14011KT 3SM RA BR OVC006 04/04 A3014 RMK AO2 SLP212 CIG 005V008 P0005 60011 T00390039 10072 20039 56009 $");
    EXPECT_NEAR(*r.visibility_m, 3 * 1609.344, 1e-9);
    EXPECT_EQ(r.temperature_c, 3.9);
    EXPECT_EQ(r.dew_point_c, 3.9);
    EXPECT_EQ(r.pressure_hpa, 1021.2);
    EXPECT_NEAR(*r.rate_mm_h, 1.27, 1e-12);
    EXPECT_EQ(r.interval_s, 3600.0);
    EXPECT_FALSE(r.filled.contains("precipitation.rate_mm_h"));
}

TEST(Metar, WindIsReadInEveryUnitAndWithEveryGap) {
    struct Case {
        std::string group;
        double speed, gust, from;  // -1: none
    };
    for (auto const& [group, speed, gust, from] : std::vector<Case>{{"00000KT", 0, -1, -1},
                                                                    {"VRB02MPS", 2, -1, -1},
                                                                    {"24006G09MPS", 6, 9, 240},
                                                                    {"36036KMH", 10, -1, 360},
                                                                    {"/////KT", -1, -1, -1},
                                                                    {"///05KT", 5 * kKnot, -1, -1},
                                                                    {"14040G//KT", 40 * kKnot, -1, 140},
                                                                    {"270P99GP99KT", 99 * kKnot, 99 * kKnot, 270},
                                                                    {"180100G120KT", 100 * kKnot, 120 * kKnot, 180}}) {
        Report const r = report("EGLL 010050Z " + group + " 9999");
        EXPECT_NEAR(r.speed_mps.value_or(-1.0), speed, 1e-9) << group;
        EXPECT_NEAR(r.gust_mps.value_or(-1.0), gust, 1e-9) << group;
        EXPECT_EQ(r.from_deg.value_or(-1.0), from) << group;
    }
}

TEST(Metar, AWindThatIsNoneIsNamedAndStaysUnknown) {
    for (std::string const group : {"37010KT", "2010KT", "VRB3KT", "27010G5KT", "27010KTS", "270999KT"}) {
        Report const r = report("EGLL 010050Z " + group + " 9999 10/05 Q1013");
        EXPECT_FALSE(r.speed_mps) << group;
        EXPECT_FALSE(notes("EGLL 010050Z " + group + " 9999").empty()) << group;
    }
    EXPECT_EQ(notes("KLSV 231158Z 05010G14 10SM CLR"), "05010G14 is a wind without a unit, taken as knots; ");
    EXPECT_NEAR(*report("KLSV 231158Z 05010G14 10SM CLR").gust_mps, 14 * kKnot, 1e-9);
    EXPECT_FALSE(report("UUEE 231158Z 05010 9999").speed_mps) << "there it might be metres a second";
}

TEST(Metar, VisibilityIsReadInMetresKilometresAndMiles) {
    struct Case {
        std::string groups;
        double metres;
        bool minimum;
    };
    for (auto const& [groups, metres, minimum] : std::vector<Case>{{"9999", 10000, true},
                                                                   {"9999NDV", 10000, true},
                                                                   {"CAVOK", 10000, true},
                                                                   {"0350", 350, false},
                                                                   {"0000", 0, false},
                                                                   {"4000 2000NE", 4000, false},
                                                                   {"1400 1000", 1400, false},
                                                                   {"0400W", 400, false},
                                                                   {"10KM", 10000, false},
                                                                   {"10SM", 16093.44, true},
                                                                   {"P6SM", 9656.064, true},
                                                                   {"15SM", 24140.16, false},
                                                                   {"1 1/2SM", 2414.016, false},
                                                                   {"11/2SM", 2414.016, false},
                                                                   {"3/4SM", 1207.008, false},
                                                                   {"M1/4SM", 402.336, false},
                                                                   {"////", -1, false},
                                                                   {"////SM", -1, false}}) {
        Report const r = report("EGLL 010050Z 27010KT " + groups + " 10/05 Q1013");
        EXPECT_NEAR(r.visibility_m.value_or(-1.0), metres, 1e-6) << groups;
        EXPECT_EQ(r.visibilityIsMinimum, minimum) << groups;
        EXPECT_EQ(notes("EGLL 010050Z 27010KT " + groups), "") << groups;
    }
    EXPECT_EQ(notes("EGLL 010050Z 27010KT 4000 6000"), "6000 is a second visibility; ");
    EXPECT_EQ(notes("EGLL 010050Z 27010KT 1/0SM"), "1/0SM is no visibility; ");
}

TEST(Metar, WeatherGroupsSayWhatFallsAndWhetherItThunders) {
    using enum Precipitation;
    struct Case {
        std::string groups;
        Precipitation kind;
        bool thunder;
    };
    for (auto const& [groups, kind, thunder] : std::vector<Case>{{"", None, false},       {"-DZ", Drizzle, false},   {"+RA", Rain, false},
                                                                 {"-RADZ", Rain, false},  {"SHSN", Snow, false},     {"SG", Snow, false},
                                                                 {"RASN", Sleet, false},  {"-PLRA", Sleet, false},   {"+TSRAGR", Hail, true},
                                                                 {"SHGS", Hail, false},   {"FZDZ", FreezingRain, false}, {"UP", Unknown, false},
                                                                 {"TS", None, true},      {"VCTS", None, true},      {"VCSH", None, false},
                                                                 {"DRSN BLSN", None, false}, {"FZFG", None, false},  {"BR -RA", Rain, false},
                                                                 {"RERA RETS", None, false}, {"HZ FU", None, false}, {"+FC", None, false}}) {
        Report const r = report("EGLL 010050Z 27010KT 4000 " + groups + " OVC010 10/05 Q1013");
        EXPECT_EQ(r.precipitationKind, kind) << groups;
        EXPECT_EQ(r.thunder, thunder) << groups;
        EXPECT_EQ(notes("EGLL 010050Z 27010KT 4000 " + groups + " OVC010"), "") << groups;
    }
}

TEST(Metar, SilenceAboutTheWeatherIsNothingOnlyWhereSomebodyOrASensorLooks) {
    auto const expect = [](std::string const& text, std::optional<Precipitation> kind, std::optional<bool> thunder) {
        Report const r = report(text);
        EXPECT_EQ(r.precipitationKind, kind) << text;
        EXPECT_EQ(r.thunder, thunder) << text;
    };
    expect("EGLL 010050Z 27010KT 9999 OVC010 10/05 Q1013", Precipitation::None, false);
    expect("EGLL 010050Z 27010KT", std::nullopt, std::nullopt);
    expect("EGLL 010050Z NIL", std::nullopt, std::nullopt);
    expect("EGLL 010050Z AUTO 27010KT 9999 // OVC010 10/05 Q1013", std::nullopt, std::nullopt);
    expect("EGLL 010050Z AUTO 27010KT 9999 OVC010/// 10/05 Q1013", Precipitation::None, std::nullopt);
    expect("EGLL 010050Z AUTO 27010KT 9999 NCD 10/05 Q1013", Precipitation::None, false);
    expect("KSDY 010050Z AUTO 27010KT 10SM CLR 10/05 A2992 RMK AO2", Precipitation::None, false);
    expect("KSDY 010050Z AUTO 27010KT 10SM CLR 10/05 A2992 RMK AO1", std::nullopt, std::nullopt);
    expect("KSDY 010050Z AUTO 27010KT 10SM CLR 10/05 A2992 RMK AO2 TSNO", Precipitation::None, std::nullopt);
    expect("KSDY 010050Z AUTO 27010KT 10SM CLR 10/05 A2992 RMK AO2 PWINO", std::nullopt, false);
    expect("EGLL 010050Z 27010KT 9999 -RAQ OVC010 10/05 Q1013", std::nullopt, std::nullopt);
}

TEST(Metar, LayersAreTheirOwnSharesAndAmericanOnesIncludeThoseBelow) {
    expectCovers(report("EGLL 010050Z 27010KT 9999 FEW010 SCT020 BKN030 10/05 Q1013"), {1.5 / 8, 3.5 / 8, 0.75});
    expectCovers(report("KCVG 010050Z 27010KT 10SM FEW010 SCT020 BKN030 OVC050 10/05 A2992"),
                 {1.5 / 8, (3.5 - 1.5) / (8 - 1.5), (6 - 3.5) / (8 - 3.5), 1.0});
    expectCovers(report("PAFA 010050Z 27010KT 10SM FEW023 FEW040 10/05 A2992"), {1.5 / 8, 0.0});
    Report const hidden = report("KCVG 010050Z 27010KT 10SM OVC010 OVC020 10/05 A2992");
    EXPECT_FALSE((*hidden.layers)[1].cover) << "above a closed layer nobody sees";
}

TEST(Metar, CloudsWithGapsAreReadAsFarAsTheyGo) {
    Report const r = report("EGLL 010050Z AUTO 27010KT 9999 FEW/// SCT018/// ///030 //////TCU ///CB 10/05 Q1013");
    ASSERT_TRUE(r.layers);
    ASSERT_EQ(r.layers->size(), 5u);
    auto const& layers = *r.layers;
    EXPECT_EQ(layers[0].cover, 1.5 / 8);
    EXPECT_FALSE(layers[0].base_m);
    EXPECT_NEAR(*layers[1].base_m, 100 + 548.64, 1e-9);
    EXPECT_FALSE(layers[2].cover);
    EXPECT_NEAR(*layers[2].base_m, 100 + 914.4, 1e-9);
    EXPECT_EQ(layers[3].genus, Genus::Cu);
    EXPECT_EQ(layers[4].genus, Genus::Cb);
    Report const towering = report("EGLL 010050Z 27010KT 9999 SCT020TCU 10/05 Q1013");
    EXPECT_EQ((*towering.layers)[0].genus, Genus::Cu);
    EXPECT_FALSE((*towering.layers)[0].top_m);
    EXPECT_NEAR(filledNumber(towering, "layers[0].top_m"), 100 + 609.6 + 4000, 1e-9);
    Report const blank = report("HUTO 031100Z 24008KT 9000 RA BKN016 FEW 018CB 22/18 Q1019");
    EXPECT_EQ((*blank.layers)[1].genus, Genus::Cb);
    EXPECT_EQ(notes("HUTO 031100Z 24008KT 9000 RA BKN016 FEW 018CB 22/18 Q1019"), "FEW 018CB has a blank in it; ");
}

TEST(Metar, NoCloudReachesAsFarAsTheWordSays) {
    struct Case {
        std::string text;
        bool said;
        std::optional<double> to;
    };
    for (auto const& [text, said, to] : std::vector<Case>{{"EGLL 010050Z 27010KT CAVOK 10/05 Q1013", true, 100 + 1524.0},
                                                          {"EGLL 010050Z 27010KT 9999 NSC 10/05 Q1013", true, 100 + 1524.0},
                                                          {"EGLL 010050Z AUTO 27010KT 9999 NCD 10/05 Q1013", true, 100 + 1524.0},
                                                          {"KCVG 010050Z 27010KT 10SM CLR 10/05 A2992", true, 100 + 3657.6},
                                                          {"KCVG 010050Z 27010KT 10SM SKC 10/05 A2992", true, std::nullopt},
                                                          {"EGLL 010050Z AUTO 27010KT 9999 ////// 10/05 Q1013", false, std::nullopt},
                                                          {"URMO 292300Z AUTO /////MPS 9999 // ///////// ///// Q////", false, std::nullopt},
                                                          {"EGLL 010050Z 27010KT 9999 10/05 Q1013", false, std::nullopt}}) {
        Report const r = report(text);
        EXPECT_EQ(r.layers.has_value(), said) << text;
        EXPECT_TRUE(!said || r.layers->empty()) << text;
        EXPECT_EQ(r.layersTo_m.has_value(), to.has_value()) << text;
        EXPECT_NEAR(r.layersTo_m.value_or(0.0), to.value_or(0.0), 1e-9) << text;
    }
    EXPECT_FALSE(report("KCVG 010050Z 27010KT 10SM FEW250 10/05 A2992").layersTo_m) << "the observer sees the whole sky";
    EXPECT_NEAR(*report("KCVG 010050Z AUTO 27010KT 10SM FEW030 10/05 A2992").layersTo_m, 3757.6, 1e-9);
    EXPECT_NEAR(*report("EGLL 010050Z 27010KT 9999 FEW030 BKN100 10/05 Q1013").layersTo_m, 3148.0, 1e-9);
}

TEST(Metar, AnObscuredSkyIsFogFromTheGroundOrCloudAboveWhatFalls) {
    Report const fog = report("EGLL 010050Z 27010KT 0200 FG VV001 05/05 Q1026");
    EXPECT_FALSE(fog.layers);
    EXPECT_NEAR(*fog.verticalVisibility_m, 30.48, 1e-9);
    EXPECT_EQ(filledWord(fog, "layers[0].genus"), "fog");
    EXPECT_EQ(filledNumber(fog, "layers[0].base_m"), 100.0);
    Report const snow = report("CYYU 010050Z 27010KT 1/2SM +SN VV005 M05/M06 A2980");
    EXPECT_EQ(filledWord(snow, "layers[0].genus"), "St");
    EXPECT_NEAR(filledNumber(snow, "layers[0].base_m"), 100 + 152.4, 1e-9);
    Report const unknown = report("OJAI 292300Z 10003KT 0500 FG VV/// 07/07 Q1016");
    EXPECT_FALSE(unknown.verticalVisibility_m);
    EXPECT_EQ(filledWord(unknown, "layers[0].genus"), "fog");
}

TEST(Metar, TemperaturesAreReadWithTheirGaps) {
    struct Case {
        std::string group;
        double temperature, dewPoint;  // -99: none
    };
    for (auto const& [group, temperature, dewPoint] : std::vector<Case>{
             {"13/07", 13, 7}, {"M05/M11", -5, -11}, {"M00/M02", 0, -2}, {"13/", 13, -99}, {"13///", 13, -99}, {"/////", -99, -99}, {"XX/XX", -99, -99}}) {
        Report const r = report("SVSA 291800Z 27010KT 9999 BKN050 " + group + " Q1013");
        EXPECT_EQ(r.temperature_c.value_or(-99.0), temperature) << group;
        EXPECT_EQ(r.dew_point_c.value_or(-99.0), dewPoint) << group;
        EXPECT_FALSE(r.temperature_c && std::signbit(*r.temperature_c) && *r.temperature_c == 0.0) << group;
    }
    EXPECT_EQ(notes("SVSA 291800Z /////KT 9999 BKN050 XX/XX Q////"), "XX/XX is no temperature and dew point; ");
    EXPECT_EQ(report("KNUC 012356Z AUTO 30020G33KT 10SM BKN023 13/ A2982 RMK AO2 T0128").temperature_c, 12.8);
    EXPECT_EQ(report("KNUC 012356Z 30020KT 10SM CLR 13/05 A2982 RMK AO2 T05280050").temperature_c, 13.0) << "52.8 is not near 13";
}

TEST(Metar, PressureIsTheSeaLevelsWhereItIsSaid) {
    EXPECT_EQ(report("EGLL 010050Z 27010KT 9999 10/05 Q0987").pressure_hpa, 987.0);
    EXPECT_NEAR(*report("KCVG 010050Z 27010KT 10SM 10/05 A2992").pressure_hpa, 1013.2, 0.01);
    EXPECT_EQ(report("MZBZ 020000Z VRB02KT 9999 SCT023 27/23 A2999 Q1015 NOSIG").pressure_hpa, 1015.0);
    EXPECT_EQ(report("KPAE 010050Z 27010KT 10SM 10/05 A3083 RMK SLP477").pressure_hpa, 1047.7);
    EXPECT_EQ(report("PASC 012353Z 09006KT 2SM M17/M19 A2948 RMK AO2 SLP985").pressure_hpa, 998.5);
    EXPECT_EQ(report("KCVG 010050Z 27010KT 10SM 10/05 RMK SLPNO").pressure_hpa, std::nullopt);
    EXPECT_EQ(report("EGLL 010050Z 27010KT 9999 10/05 Q////").pressure_hpa, std::nullopt);
    EXPECT_EQ(notes("EGLL 010050Z 27010KT 9999 10/05 Q2013"), "Q2013 is no pressure; ");
}

TEST(Metar, AmountsOfTheLastHourAreRatesAndATraceIsNoFigure) {
    EXPECT_NEAR(*report("KCVG 012152Z 14010KT 4SM -RA OVC016 04/04 A3016 RMK AO2 P0003").rate_mm_h, 0.762, 1e-12);
    Report const trace = report("KCVG 011652Z 17005KT 10SM -RA OVC085 04/M06 A3026 RMK AO2 P0000");
    EXPECT_FALSE(trace.rate_mm_h);
    EXPECT_EQ(filledNumber(trace, "precipitation.rate_mm_h"), 1.0);
    Report const special = report("KCVG 012222Z 13009KT 4SM -DZ OVC012 04/04 A3016 RMK AO2 P0003");
    EXPECT_EQ(special.interval_s, 29 * 60.0) << "since the hourly report at 53";
    EXPECT_FALSE(report("EGLL 012152Z 14010KT 4000 -RA OVC016 04/04 Q1016 RMK P0003").rate_mm_h) << "an American group";
}

TEST(Metar, GeneraOfTheRemarksAreFilledIn) {
    Report const canadian = report("CYYU 012300Z 13005KT 4SM -SHSN SCT032 OVC041 M02/M03 A2979 RMK CU3SC5 SLP106");
    EXPECT_FALSE((*canadian.layers)[0].genus);
    EXPECT_EQ(filledWord(canadian, "layers[0].genus"), "Cu");
    EXPECT_EQ(filledWord(canadian, "layers[1].genus"), "Sc");
    Report const turkish = report("LTAJ 292250Z 01010KT 9999 BKN045 BKN080 10/08 Q1015 NOSIG RMK RWY10 02012KT 6CU045 7AC080");
    EXPECT_EQ(filledWord(turkish, "layers[1].genus"), "Ac");
    Report const fewer = report("CYHK 020000Z 04014KT 4SM IC FEW022 SCT040 M30/M34 A2974 RMK SC2 SLP082");
    EXPECT_FALSE(fewer.filled.contains("layers[0].genus")) << "one genus for two layers: whose?";
}

TEST(Metar, WhatIsNoPartOfTheObservationChangesNothing) {
    Report const r = report("LOWL 031950Z 28003KT 3900 0400W R26/P1500D R09L/0650 BCFG FEW001 05/05 Q1032 WS R26 W07/S5 R34L/CLRD70 R30/450255 BLU "
                            "BECMG 33030G50KT 0800 +TSRA OVC001CB 20/20 Q0980 RMK A2800 T02000200");
    EXPECT_NEAR(*r.speed_mps, 3 * kKnot, 1e-9);
    EXPECT_EQ(r.visibility_m, 3900.0);
    EXPECT_EQ(r.precipitationKind, Precipitation::None);
    EXPECT_EQ(r.layers->size(), 1u);
    EXPECT_EQ(r.temperature_c, 5.0) << "20.0 of the remark is not near 5";
    EXPECT_EQ(r.pressure_hpa, 1032.0);
}

TEST(Metar, EveryGroupThatSaysNothingOfTheAirIsKnown) {
    for (std::string const group :
         {"240V300", "R35/3000V3500FT", "R06/5000VP6000FT", "R16/0250V0300U", "R24/P2000", "R25/0800U", "R24//////", "R19/39//31", "R09/D", "R34L/CLRD70",
          "R/SNOCLO", "SNOCLO", "88290592", "WS R18", "WS ALL RWY", "WS TKOF RWY18L", "W07/S5", "W///S9", "W19/H75", "BLU", "YLO2", "BLACKBLU", "BLACK", "///",
          "NOSIG", "RTD", "CCA", "COR", "RE//", "QFE 773/5", "QFE742/0989", "2AC070"})
        EXPECT_EQ(notes("EGLL 010050Z 27010KT 9999 OVC010 10/05 Q1013 " + group), "") << group;
}

TEST(Metar, WhatIsNoGroupIsNamedWithItsPlace) {
    EXPECT_EQ(notes("MGRT 020000Z 00000KT 8000 SCT080 29/24 Q1015 HZ VOL. SANTA MARIA EN ACTIVIDAD RMK FREE TEXT"),
              "VOL. SANTA MARIA EN ACTIVIDAD is no group of a METAR; ");
    EXPECT_EQ(notes("EGLL 010050Z 27010KT 9999 BKNO20 10/5 Q1013"), "BKNO20 is no cloud; 10/5 is no temperature and dew point; ");
    EXPECT_EQ(notes("SAOR 01123Z 23005KT 8000 BKN004 18/17 Q1013"), "01123Z is no day and time; ");
    EXPECT_EQ(notes("EGLL 010050Z 27010KT 9999 FEW999 10/05 Q1013"), "FEW999 is no cloud; ");
    for (std::string const time : {"001200Z", "321200Z", "012400Z", "011260Z", "0112Z"})
        EXPECT_FALSE(read("EGLL " + time + " 27010KT 9999").time) << time;
    for (std::string const text : {"", "METAR", "EGLL", "AAXX 11124 78859 12480", "TAF EGLL 010500Z 0106/0212", "metar egll", "hello world 1234"})
        EXPECT_FALSE(decodeMetar(text)) << text;
}
