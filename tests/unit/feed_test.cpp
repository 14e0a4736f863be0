// The parts of live weather that need no server: when to ask, what is kept, how a request ends.
#include <arpa/inet.h>
#include <gtest/gtest.h>
#include <sys/socket.h>
#include <unistd.h>

#include <chrono>
#include <filesystem>
#include <thread>

#include "engine/core/file.h"
#include "engine/core/time.h"
#include "engine/platform/http.h"
#include "engine/weather/presets.h"
#include "game/app/feed_cache.h"
#include "game/app/feed_schedule.h"
#include "tests/support/scratch.h"

using namespace luftpost;
using namespace luftpost::app;

namespace {
constexpr FeedPlace kBasel{47.54, 7.58}, kNear{47.60, 7.70}, kFar{47.90, 7.58};

TEST(FeedSchedule, AsksAtOnceThenAfterTheInterval) {
    FeedSchedule schedule{900.0, 1};
    EXPECT_TRUE(schedule.due(0.0, kBasel));
    schedule.succeeded(100.0, kBasel);
    EXPECT_FALSE(schedule.due(999.0, kBasel));
    EXPECT_TRUE(schedule.due(100.0 + 900.0 * 1.05, kBasel));
}

TEST(FeedSchedule, AsksSoonerFarFromWhereItAskedLast) {
    FeedSchedule schedule{900.0, 1};
    schedule.succeeded(100.0, kBasel);
    EXPECT_FALSE(schedule.due(200.0, kNear));
    EXPECT_TRUE(schedule.due(200.0, kFar));
    EXPECT_FALSE(schedule.due(110.0, kFar)) << "not at every step of a fast journey";
}

TEST(FeedSchedule, WaitsLongerAfterEachFailureUpToTheInterval) {
    FeedSchedule schedule{900.0, 7};
    double now = 0.0, before = 0.0;
    for (double const expected : {30.0, 60.0, 120.0, 240.0, 480.0, 900.0, 900.0}) {
        schedule.failed(now, kBasel, {}, false);
        double const waited = schedule.next() - now;
        EXPECT_GE(waited, 0.75 * expected);
        EXPECT_LE(waited, 1.25 * expected);
        EXPECT_NE(waited, before) << "chance keeps many players apart";
        EXPECT_FALSE(schedule.due(now + 0.5 * waited, kFar)) << "a failing server is not asked for another place at once";
        before = waited;
        now = schedule.next();
    }
    schedule.succeeded(now, kBasel);
    schedule.failed(now, kBasel, {}, false);
    EXPECT_LE(schedule.next() - now, 1.25 * 30.0) << "an answer forgives";
}

TEST(FeedSchedule, HonoursTheServersWishWithinReasonAndARefusal) {
    FeedSchedule schedule{900.0, 7};
    schedule.failed(0.0, kBasel, 5000.0, true);
    EXPECT_DOUBLE_EQ(schedule.next(), 5000.0);
    schedule.failed(0.0, kBasel, 1.0e9, true);
    EXPECT_DOUBLE_EQ(schedule.next(), FeedSchedule::kLongestWish);
    FeedSchedule other{900.0, 7};
    other.failed(0.0, kBasel, {}, true);
    EXPECT_GE(other.next(), 0.75 * 900.0) << "a wrong key does not become right in half a minute";
}

TEST(FeedSchedule, AsksAgainWhenTheClockWasSetBack) {
    FeedSchedule schedule{900.0, 1};
    schedule.succeeded(1.0e6, kBasel);
    EXPECT_TRUE(schedule.due(100.0, kBasel));
}

TEST(Interval, IsNeverBelowTheProvidersLimitAtItsOwnServer) {
    WeatherSettings settings;
    settings.interval = 1;
    EXPECT_EQ(intervalOf(settings), 60.0);
    settings.openMeteoUrl = "http://127.0.0.1:1234/";
    EXPECT_EQ(intervalOf(settings), 1.0);
    settings.provider = WeatherProvider::meteoblue;
    EXPECT_EQ(intervalOf(settings), 600.0);
}

TEST(News, OfReportsAreGoodForAnHour) {
    WeatherNews news;
    news.lastReport = 10000.0;
    EXPECT_EQ(news.givenAt(5000.0), 5000.0) << "a forecast is of when it was asked for";
    EXPECT_EQ(news.givenAt(20000.0), 13600.0) << "an old report does not become new by being fetched";
}

TEST(Distance, IsTheShortWayRoundTheEarth) {
    EXPECT_NEAR(distance({0.0, 179.9}, {0.0, -179.9}), 22240.0, 100.0);
    EXPECT_NEAR(distance(kBasel, kFar), 40030.0, 100.0);
}

KeptNews keptNews() {
    KeptNews kept;
    kept.news.recording = weather::recordingText(*weather::presetRecording("fair", weather::PlaceWish{47.0, 8.0, 400.0}));
    kept.news.place = kBasel;
    kept.asked = 1.7e9;
    return kept;
}

TEST(FeedCache, KeepsWhatItWasGiven) {
    auto const file = tests::scratch() / "kept.json";
    writeKept(file, keptNews());
    auto const back = readKept(file);
    ASSERT_TRUE(back);
    EXPECT_EQ(back->news.recording, keptNews().news.recording);
    EXPECT_EQ(back->news.place.lat_deg, kBasel.lat_deg);
    EXPECT_EQ(back->asked, 1.7e9);
    EXPECT_GT(back->news.lastReport, 0.0);
}

TEST(FeedCache, DropsWhatIsBroken) {
    auto const file = tests::scratch() / "broken.json";
    writeKept(file, keptNews());
    std::string const good = core::readFile(file);
    for (std::size_t at = 0; at < good.size(); at += 97) {
        std::string bad = good;
        bad[at] = static_cast<char>(bad[at] ^ 2);
        core::writeFileAtomically(file, bad);
        if (auto const kept = readKept(file)) {
            EXPECT_EQ(kept->news.recording, keptNews().news.recording) << "the weather itself is never another";
        } else {
            EXPECT_FALSE(std::filesystem::exists(file));
        }
    }
    core::writeFileAtomically(file, good.substr(0, good.size() / 2));
    EXPECT_FALSE(readKept(file));
    EXPECT_FALSE(std::filesystem::exists(file));
    EXPECT_FALSE(readKept(file)) << "a missing file keeps nothing";
}

/// A port of this machine that takes calls and never says a word.
class SilentServer {
public:
    SilentServer() : socket_{::socket(AF_INET, SOCK_STREAM, 0)} {
        sockaddr_in address{};
        address.sin_family = AF_INET;
        address.sin_addr.s_addr = htonl(INADDR_LOOPBACK);
        socklen_t size = sizeof address;
        EXPECT_EQ(::bind(socket_, reinterpret_cast<sockaddr*>(&address), size), 0);
        EXPECT_EQ(::listen(socket_, 4), 0);
        ::getsockname(socket_, reinterpret_cast<sockaddr*>(&address), &size);
        url = "http://127.0.0.1:" + std::to_string(ntohs(address.sin_port)) + "/?apikey=sesame";
    }
    ~SilentServer() { ::close(socket_); }
    std::string url;

private:
    int socket_;
};

double secondsOf(auto const& action) {
    auto const before = std::chrono::steady_clock::now();
    action();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - before).count();
}

TEST(Http, IsGivenUpAtOnceWhenNobodyWaitsAnyMore) {
    SilentServer const server;
    std::atomic<bool> abort = false;
    platform::HttpAnswer answer;
    std::thread caller{[&] { answer = platform::httpGet({.url = server.url}, abort); }};
    std::this_thread::sleep_for(std::chrono::milliseconds{100});
    EXPECT_LT(secondsOf([&] {
                  abort = true;
                  caller.join();
              }),
              0.2);
    EXPECT_TRUE(answer.aborted);
    EXPECT_EQ(answer.status, 0);
}

TEST(Http, KeepsItsTimeOutAndNamesNoKey) {
    SilentServer const server;
    std::atomic<bool> const goOn = false;
    platform::HttpAnswer answer;
    EXPECT_LT(secondsOf([&] { answer = platform::httpGet({.url = server.url, .total_s = 0.3}, goOn); }), 1.0);
    EXPECT_EQ(answer.status, 0);
    EXPECT_NE(answer.error, "");
    EXPECT_EQ(answer.error.find("sesame"), std::string::npos) << answer.error;
}

TEST(Http, FetchesNothingButHttp) {
    std::atomic<bool> const goOn = false;
    for (char const* url : {"file:///etc/hostname", "ftp://127.0.0.1/x", "gopher://127.0.0.1/", "", "not an address", "http://"}) {
        platform::HttpAnswer const answer = platform::httpGet({.url = url}, goOn);
        EXPECT_EQ(answer.status, 0) << url;
        EXPECT_NE(answer.error, "") << url;
    }
}
}  // namespace
