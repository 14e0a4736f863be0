// Live weather against a server on this machine that behaves as badly as servers do: the flight goes on, and says why.
#include "tests/play/weather_server.h"

#include <cmath>
#include <regex>
#include <sstream>
#include <vector>

namespace {
using namespace luftpost::tests;

constexpr double kMostMemory_mb = 400.0;

std::string setting(std::string const& assignment) { return " --set weather." + assignment; }

/// Live weather of a server, asked for every second of flight.
std::string liveFrom(std::string const& url) {
    return " --weather live" + setting("openMeteoUrl=" + url) + setting("interval_s=1") + setting("timeout_s=1");
}

struct Flight {
    nlohmann::json report;
    std::string said;  // on standard output: the log
};

/// Flies without a window; the log must be whole and finite.
Flight fly(std::string const& arguments, int seconds, std::string const& command = "play --headless --no-render") {
    fs::path const folder = scratch(), report = folder / "report.json", log = folder / "log.csv";
    std::string const length = command.starts_with("play") ? " --seconds " + std::to_string(seconds) : "";
    Outcome const outcome = run(command + length + arguments + " --report '" + report.string() + "' --log '" + log.string() + "'");
    EXPECT_EQ(outcome.code, 0) << outcome.err;
    EXPECT_EQ(outcome.err, "");
    std::istringstream rows{fileText(log)};
    std::string row;
    int count = -1;  // the header
    for (; std::getline(rows, row); ++count) EXPECT_EQ(row.find("nan"), row.npos) << row;
    EXPECT_EQ(count, 10 * seconds + 1);
    return {nlohmann::json::parse(fileText(report), nullptr, false), outcome.out};
}

/// What a server does, and what the log says of it.
struct Trouble {
    char const* mode;
    char const* said;  // a regular expression
};

class Server : public testing::TestWithParam<Trouble> {};
TEST_P(Server, DoesNotStopTheFlightAndIsSaid) {
    WeatherServer const server;
    Flight const flight = fly(liveFrom(server.url(GetParam().mode)), 2);
    EXPECT_TRUE(std::regex_search(flight.said, std::regex{GetParam().said})) << flight.said;
    EXPECT_LT(flight.report["memory"]["rss_mb"], kMostMemory_mb);
    EXPECT_GE(server.requestCount(), 1);
    EXPECT_LE(server.requestCount(), 16) << "a server in trouble is left in peace";
}
INSTANTIATE_TEST_SUITE_P(Modes, Server,
                         testing::Values(Trouble{"slow", "Open-Meteo: .*(timed out|too slow)"}, Trouble{"silent", "Open-Meteo: .*timed out"},
                                         Trouble{"cut", "the answer was cut off"}, Trouble{"400", "HTTP 400: Parameter latitude is out of range"},
                                         Trouble{"401", "HTTP 401: The key is not valid"}, Trouble{"429", "HTTP 429: Minutely API request limit exceeded"},
                                         Trouble{"500", "HTTP 500"}, Trouble{"503", "HTTP 503"}, Trouble{"loop", "at most 3 redirections"},
                                         Trouble{"away", "Open-Meteo: .*(rotocol|expected)"}, Trouble{"html", "Open-Meteo: .*expected"},
                                         Trouble{"empty", "empty answer"}, Trouble{"wrong", "Open-Meteo: .*expected"}, Trouble{"nan", "Open-Meteo: .*expected"},
                                         Trouble{"huge", "at most 4194304 bytes"}, Trouble{"announced", "at most 4194304 bytes"},
                                         Trouble{"bomb", "at most 4194304 bytes"}),
                         [](auto const& trouble) { return std::string{trouble.param.mode}; });

class Success : public testing::TestWithParam<char const*> {};
TEST_P(Success, IsFlown) {
    WeatherServer const server;
    Flight const live = fly(liveFrom(server.url(GetParam())) + " --save-weather '" + (scratch() / "weather.json").string() + "'", 2);
    EXPECT_NE(live.said.find("brought a new forecast"), std::string::npos) << live.said;
    auto const saved = nlohmann::json::parse(fileText(scratch() / "weather.json"), nullptr, false);
    EXPECT_EQ(saved["format"], "luftpost-weather-1");
    EXPECT_NE(saved["source"].dump().find("Open-Meteo"), std::string::npos) << saved["source"];
}
INSTANTIATE_TEST_SUITE_P(Modes, Success, testing::Values("ok", "gzip", "redirect", "etag"));

/// What a flight in the live weather of another provider saves.
nlohmann::json savedFrom(std::string const& settings, std::string& said) {
    std::string const file = (scratch() / "weather.json").string();
    said = fly(" --weather live" + setting("interval_s=1") + settings + " --save-weather '" + file + "'", 2).said;
    return nlohmann::json::parse(fileText(file), nullptr, false);
}

TEST(LiveWeather, OfStationsAroundIsFlownTheNearestFirst) {
    WeatherServer const server;
    std::string said;
    auto const saved = savedFrom(setting("provider=metar") + setting("metarUrl=" + server.url("stations")), said);
    EXPECT_NE(said.find("brought a new forecast"), std::string::npos) << said;
    EXPECT_NE(server.requests().find("bbox="), std::string::npos) << server.requests();
    std::string const sites = saved["sites"].dump();
    EXPECT_NE(sites.find("LFSB"), std::string::npos) << sites.substr(0, 300);
    EXPECT_LT(sites.find("LFSB"), sites.find("LSZH"));
    EXPECT_LT(sites.find("LSZH"), sites.find("EFHK"));
}

TEST(LiveWeather, OfMeteoblueIsFlownAndTheKeyIsNotSaved) {
    WeatherServer const server;
    std::string said;
    auto const saved = savedFrom(setting("provider=meteoblue") + setting("meteoblueKey=Sesame5Open") + setting("meteoblueUrl=" + server.url("hours")), said);
    EXPECT_NE(said.find("brought a new forecast"), std::string::npos) << said;
    EXPECT_NE(saved["source"].dump().find("meteoblue"), std::string::npos) << saved["source"];
    EXPECT_EQ(saved.dump().find("Sesame5Open"), std::string::npos);
    EXPECT_NEAR(saved["sites"][0]["reports"][0]["temperature_c"].get<double>(), 12.5, 0.3);
}

TEST(LiveWeather, IsNotTakenFromAServerThatNobodyVouchesFor) {
    WeatherServer const server{true};
    Flight const flight = fly(liveFrom(server.url("ok")), 2);
    EXPECT_TRUE(std::regex_search(flight.said, std::regex{"Open-Meteo: .*certificate"})) << flight.said;
    EXPECT_EQ(server.requests(), "") << "nothing was told to it";
}

TEST(LiveWeather, WithoutAnyServerIsWaitedForInTheBundledWeather) {
    WeatherServer server;
    std::string const url = server.url("ok");
    server.stop();
    Flight const flight = fly(liveFrom(url), 2);
    EXPECT_NE(flight.said.find("Open-Meteo: "), std::string::npos) << flight.said;
    EXPECT_EQ(flight.report["seconds"], 2.0);
}

TEST(LiveWeather, ThatChangesIsFlownTheSameAgainWithoutTheServer) {
    std::string const replay = (scratch() / "flight.replay").string();
    nlohmann::json flown;
    {
        WeatherServer const server;
        flown = fly(liveFrom(server.url("changing")) + " --save-replay '" + replay + "'", 6).report;
        EXPECT_GE(server.requestCount(), 5);
    }
    auto const file = nlohmann::json::parse(fileText(replay), nullptr, false);
    std::size_t arrivals = 0;
    for (auto const& input : file["inputs"]) arrivals += input.contains("weather");
    EXPECT_GE(arrivals, 4u);
    EXPECT_EQ(file["plan"]["weather"]["mode"], "live");
    auto const again = fly(" --frame-rate 30 --workers 2", 6, "replay '" + replay + "'").report;
    EXPECT_EQ(again["state_hash"], flown["state_hash"]);
    EXPECT_EQ(again["state_hash"].size(), 6u);
}

TEST(LiveWeather, IsAskedForOnlyWhereItHasChanged) {
    WeatherServer const server;
    Flight const flight = fly(liveFrom(server.url("etag")), 4);
    EXPECT_NE(server.requests().find("\"one\""), std::string::npos) << server.requests();
    EXPECT_NE(flight.said.find("has nothing new"), std::string::npos) << flight.said;
}

TEST(LiveWeather, WaitsAsLongAsTheServerWishes) {
    WeatherServer const server;
    fly(liveFrom(server.url("429")), 20);
    EXPECT_EQ(server.requestCount(), 1) << "Retry-After is an hour";
}

TEST(LiveWeather, IsKeptForTheNextStartAndABrokenFileIsDropped) {
    std::string const kept = setting("cache=always");
    std::string url;
    fs::path const file = scratch() / "cache/luftpost/weather_open-meteo.json";
    {
        WeatherServer const server;
        url = server.url("ok");
        fly(liveFrom(url) + kept, 2);
        ASSERT_TRUE(fs::exists(file));
    }
    std::string const replay = (scratch() / "flight.replay").string();
    Flight const later = fly(liveFrom(url) + kept + " --save-replay '" + replay + "'", 2);
    EXPECT_NE(later.said.find("kept of 20"), std::string::npos) << later.said;
    EXPECT_EQ(nlohmann::json::parse(fileText(replay))["plan"]["weather"]["source"], "live");
    std::string text = fileText(file);
    text[text.size() / 2] ^= 1;
    writeText(file, text);
    Flight const broken = fly(liveFrom(url) + kept, 2);
    EXPECT_NE(broken.said.find("the kept weather is dropped"), std::string::npos) << broken.said;
    EXPECT_FALSE(fs::exists(file));
}

TEST(LiveWeather, IsNotKeptWithoutAWindow) {
    WeatherServer const server;
    fly(liveFrom(server.url("ok")), 2);
    EXPECT_FALSE(fs::exists(scratch() / "cache"));
}

TEST(LiveWeather, IsOffUntilItIsAskedFor) {
    WeatherServer const server;
    fly(setting("openMeteoUrl=" + server.url("ok")) + setting("interval_s=1"), 2);
    EXPECT_EQ(server.requests(), "");
    fly(setting("openMeteoUrl=" + server.url("ok")) + setting("live=true"), 2);
    EXPECT_EQ(server.requestCount(), 1);
}

TEST(LiveWeather, NeverShowsTheKey) {
    WeatherServer const server;
    fs::path const folder = scratch();
    std::string const key = "Sesame5Open";
    Flight const flight = fly(" --weather live" + setting("provider=meteoblue") + setting("meteoblueKey=" + key) + setting("meteoblueUrl=" + server.url("401")) +
                                  " --save-replay '" + (folder / "flight.replay").string() + "'",
                              2);
    EXPECT_NE(server.requests().find(key), std::string::npos) << "the server needs it";
    EXPECT_NE(flight.said.find("HTTP 401"), std::string::npos) << flight.said;
    for (auto const& entry : fs::directory_iterator{folder})
        if (entry.is_regular_file()) {
            EXPECT_EQ(fileText(entry.path()).find(key), std::string::npos) << entry.path();
        }
    Outcome const list = run("settings" + setting("meteoblueKey=" + key));
    EXPECT_EQ(list.out.find(key), std::string::npos);
    fly(" --weather live" + setting("provider=meteoblue") + setting("meteoblueUrl=" + server.url("401")), 2);
}

TEST(LiveWeather, OfAToolIsShownAndItsFailureIsOneLine) {
    WeatherServer const server;
    Outcome const shown = run("weather live --json" + setting("openMeteoUrl=" + server.url("ok")));
    ASSERT_EQ(shown.code, 0) << shown.err;
    auto const json = nlohmann::json::parse(shown.out, nullptr, false);
    EXPECT_EQ(json["source"]["mode"], "live");
    EXPECT_EQ(json["source"]["provider"].get<std::string>().find("Open-Meteo"), 0u) << json["source"];
    EXPECT_LT(json["source"]["age_s"], 60.0);
    EXPECT_GE(json["sites"].size(), 24u);
    for (char const* mode : {"429", "html", "cut"}) {
        Outcome const refused = run("weather live --json" + setting("openMeteoUrl=" + server.url(mode)));
        EXPECT_EQ(refused.code, 2);
        EXPECT_EQ(refused.complaints(), 1) << refused.err;
        EXPECT_NE(refused.err.find("Open-Meteo"), std::string::npos) << refused.err;
    }
}
}  // namespace
