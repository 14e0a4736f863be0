// A flight as other programs read it.
#include "tests/play/program.h"

#include <sstream>
#include <vector>

namespace {
using luftpost::tests::fileText;
using luftpost::tests::flight;
namespace fs = std::filesystem;
using luftpost::tests::run;
using luftpost::tests::scratch;
using luftpost::tests::writeText;

/// The way and the marks of a file, by Python's XML reader: a file that is not well-formed is none.
nlohmann::json trackIn(fs::path const& file) {
    fs::path const found = scratch() / "track.json";
    std::string const command = std::string{"python3 '"} + LUFTPOST_SOURCE_DIR + "/tests/play/read_track.py' '" + file.string() + "' >'" + found.string() + "'";
    EXPECT_EQ(std::system(command.c_str()), 0) << file;
    return nlohmann::json::parse(fileText(found), nullptr, false);
}

/// Columns t_s, lat, lon, altitude of a row of the log.
std::vector<double> rowOf(std::string const& line) {
    std::istringstream in{line};
    std::vector<double> values;
    for (std::string cell; values.size() < 4 && std::getline(in, cell, ',');) values.push_back(std::stod(cell));
    return values;
}
std::vector<std::string> linesOf(std::string const& text) {
    std::istringstream in{text};
    std::vector<std::string> lines;
    for (std::string line; std::getline(in, line);) lines.push_back(line);
    return lines;
}

class Export : public testing::Test {
protected:
    std::string const replay_ = "'" + (scratch() / "flight.replay").string() + "'";
};

TEST_F(Export, HasTheFlightsPointsTimesAndParcels) {
    fs::path const log = scratch() / "log.csv";
    auto const flown = flight("play --headless --no-render --bot courier --seconds 60.5 --weather preset:calm --time 2023-06-23T18:40Z --save-replay " + replay_ + " --log '" +
                              log.string() + "'");
    auto const rows = linesOf(fileText(log));
    ASSERT_EQ(rows.size(), 607u);  // header, t = 0 ... 60.5
    ASSERT_GE(flown["drops"].size(), 1u);
    for (char const* name : {"way.kml", "way.gpx"}) {
        fs::path const file = scratch() / name;
        ASSERT_EQ(run("replay " + replay_ + " --export '" + file.string() + "'").code, 0);
        auto const track = trackIn(file);
        ASSERT_EQ(track["parts"].size(), 1u) << name;
        auto const& points = track["parts"][0];
        ASSERT_EQ(points.size(), 62u) << "a point a second, and the last half second";
        auto const expectAt = [&](nlohmann::json const& point, std::string const& row, char const* time) {
            auto const values = rowOf(row);
            EXPECT_NEAR(point[0], values[1], 1e-7) << name;
            EXPECT_NEAR(point[1], values[2], 1e-7) << name;
            EXPECT_NEAR(point[2], values[3], 0.01) << name;
            EXPECT_EQ(point[3], time) << name;
        };
        expectAt(points[0], rows[1], "2023-06-23T18:40:00Z");
        expectAt(points[30], rows[301], "2023-06-23T18:40:30Z");
        expectAt(points[61], rows[606], "2023-06-23T18:41:01Z");
        EXPECT_EQ(track["marks"][0][0], "Parcel 1 released");
        EXPECT_NEAR(track["marks"][0][3], flown["drops"][0]["release"]["altitude_m"], 0.01);
    }
}

TEST_F(Export, AsCsvIsTheLog) {
    fs::path const log = scratch() / "log.csv", exported = scratch() / "same.csv";
    flight("play --headless --no-render --seconds 2 --weather preset:calm --log '" + log.string() + "' --export '" + exported.string() + "' --save-replay " + replay_);
    EXPECT_EQ(fileText(exported), fileText(log));
    ASSERT_EQ(run("replay " + replay_ + " --export '" + exported.string() + "'").code, 0);
    EXPECT_EQ(fileText(exported), fileText(log));
}

TEST_F(Export, BeginsAnotherPartAfterACrash) {
    fs::path const file = scratch() / "way.gpx", dive = scratch() / "dive.csv";
    writeText(dive, "t_s,throttle,elevator,aileron,rudder,flaps,brakes,drop\n0,1,-0.3,0,0,0,0,0\n");
    auto const flown = flight("play --headless --no-render --assist sim --seconds 30 --weather preset:calm --input '" + dive.string() + "' --export '" + file.string() + "'");
    ASSERT_GE(flown["crashes"], 1);
    auto const track = trackIn(file);
    EXPECT_EQ(track["parts"].size(), flown["crashes"].get<std::size_t>() + 1);
    EXPECT_EQ(track["marks"][0][0], "Crash");
    auto const& last = track["parts"][0].back();
    EXPECT_NEAR(track["marks"][0][1], last[0], 1e-4) << "where the first part ends";
}

TEST_F(Export, RefusesAnotherEndingInOneLine) {
    for (char const* file : {"way.txt", "way", "way.KML2"}) {
        auto const outcome = run(std::string{"play --headless --no-render --seconds 1 --export "} + file);
        EXPECT_EQ(outcome.code, 2);
        EXPECT_EQ(outcome.complaints(), 1);
        EXPECT_NE(outcome.err.find("--export"), std::string::npos) << outcome.err;
        EXPECT_NE(outcome.err.find("FILE.gpx"), std::string::npos) << outcome.err;
        EXPECT_EQ(run(std::string{"replay r --export "} + file).code, 2);
    }
}
}  // namespace
