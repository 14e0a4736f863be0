// Hours worth seeing: the bundled list is whole, and a broken one is refused with its place.
#include "game/app/real_hours.h"

#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>

#include "engine/core/error.h"
#include "engine/weather/source.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;
namespace fs = std::filesystem;
fs::path const kAssets = fs::path{LUFTPOST_SOURCE_DIR} / "assets/weather";

TEST(RealHours, LieWithinTheirRecordingsAndSayWhy) {
    app::HoursFile const file = app::readHours(kAssets / "hours.json");
    EXPECT_GE(file.hours.size(), 6u);
    std::set<std::string> names;
    for (app::RealHour const& hour : file.hours) {
        weather::Field const field = weather::loadWeather("recorded:" + hour.recording.string(), hour.place);
        EXPECT_TRUE(field.covers(hour.time)) << hour.name;
        EXPECT_GT(hour.why.size(), 20u) << hour.name;
        EXPECT_TRUE(names.insert(hour.name).second) << hour.name << " twice";
    }
}

TEST(RealHours, NameEveryBundledRecordingWithAReason) {
    std::set<std::string> listed, there;
    for (app::BundledRecording const& recording : app::readHours(kAssets / "hours.json").recordings) listed.insert(recording.file.filename().string());
    for (auto const& entry : fs::directory_iterator{kAssets})
        if (entry.path().extension() == ".json" && entry.path().filename() != "hours.json") there.insert(entry.path().filename().string());
    EXPECT_EQ(listed, there);
}

TEST(RealHours, BeginAFlightInTheAirAtTheirPlaceLookingTheirWay) {
    for (app::RealHour const& hour : app::readHours(kAssets / "hours.json").hours) {
        app::FlightPlan const plan = app::planFor(hour, {});
        EXPECT_NEAR(plan.place.lat_deg, hour.place.lat_deg, 1e-9) << hour.name;
        EXPECT_EQ(plan.simulation.time, hour.time) << hour.name;
        EXPECT_FALSE(plan.simulation.start.runway) << hour.name;
        EXPECT_GT(plan.simulation.start.altitude, plan.place.altitude_m + 100.0) << hour.name;
        ASSERT_TRUE(hour.look_deg) << hour.name;
        EXPECT_NEAR(plan.simulation.start.heading, core::radians(hour.look_deg->x), 1e-12) << hour.name;
        EXPECT_EQ(plan.weatherSha256.size(), 64u) << hour.name;
    }
}

TEST(RealHours, ABrokenListIsRefusedWithItsPlace) {
    fs::path const& folder = tests::scratch();
    std::ofstream{folder / "day.json"} << "{}";
    auto const place = [&](std::string const& text) -> std::string {
        std::ofstream{folder / "hours.json"} << text;
        try {
            app::readHours(folder / "hours.json");
        } catch (core::Error const& error) {
            return error.what();
        }
        return "taken";
    };
    auto const expect = [&](std::string const& text, std::string const& word) { EXPECT_NE(place(text).find(word), std::string::npos) << text << "\n" << place(text); };
    std::string const head = R"({"format":"luftpost-hours-1","recordings":[],"hours":[)";
    std::string const good = R"({"name":"n","recording":"day.json","time":"2023-06-22T17:00Z","place":{"name":"p","lat":1,"lon":2},"why":"w"})";
    EXPECT_EQ(place(head + good + "]}"), "taken");
    expect("[]", "format");
    expect("{", "format");
    expect(R"({"format":"luftpost-hours-1","recordings":[]})", "\"hours\"");
    expect(R"({"format":"luftpost-hours-1","recordings":[{"file":"none.json","why":"w"}],"hours":[]})", "recordings[0].file");
    auto const changed = [&](std::string const& from, std::string const& to) {
        std::string text = head + good + "," + good + "]}";
        text.replace(text.rfind(from), from.size(), to);
        return text;
    };
    expect(changed("2023-06-22T17:00Z", "yesterday"), "hours[1].time");
    expect(changed("\"lat\":1", "\"lat\":91"), "hours[1].place.lat");
    expect(changed("\"why\":\"w\"", "\"why\":\"\""), "hours[1].why");
    expect(changed("day.json", "night.json"), "hours[1].recording");
}
}  // namespace
