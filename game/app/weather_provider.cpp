#include "game/app/weather_provider.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "engine/core/error.h"
#include "engine/core/frames.h"
#include "engine/core/time.h"
#include "engine/weather/meteoblue.h"
#include "engine/weather/open_meteo.h"
#include "engine/weather/source.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
namespace {
constexpr std::size_t kMostBytes = 4u << 20;  // of an answer; a usual one has 0.1 MB
constexpr std::size_t kMostStations = 8;      // the nearest ones
constexpr double kReach = 80'000.0;           // m, of the stations that are asked for
constexpr double kWideReach = 250'000.0;      // m, where none is so near
constexpr double kGrid_deg = 0.02;            // places are asked for so closely: near ones share an answer
constexpr double kHoursBack = 3.0;            // h of METARs, so that the curves have a beginning

constexpr ProviderFacts kFacts[] = {
    {"Open-Meteo", "Weather data by Open-Meteo.com", "CC BY 4.0, for free and non-commercial use: 600 requests a minute, 10,000 a day", 60},
    {"aviationweather.gov", "METAR by aviationweather.gov (NOAA)", "public domain: 100 requests a minute", 60},
    {"meteoblue", "Weather data by meteoblue", "with the player's own key, which pays for each request", 600}};

double metresOfDegree() { return core::radians(1.0) * core::kEarthRadius; }

std::string metarUrl(std::string const& base, FeedPlace const& place, double reach) {
    double const north = reach / metresOfDegree();
    double const east = std::min(north / std::max(std::cos(core::radians(place.lat_deg)), 0.05), 90.0);
    auto const latitude = [&](double offset) { return std::clamp(place.lat_deg + offset, -90.0, 90.0); };
    auto const longitude = [&](double offset) { return std::clamp(place.lon_deg + offset, -180.0, 180.0); };
    return fmt::format("{}{}bbox={:.3f},{:.3f},{:.3f},{:.3f}&format=json&hours={:.0f}", base, base.find('?') == base.npos ? '?' : '&', latitude(-north),
                       longitude(-east), latitude(north), longitude(east), kHoursBack);
}

std::string urlOf(WeatherSettings const& settings, FeedPlace const& place, double reach) {
    switch (settings.provider) {
        case WeatherProvider::openMeteo:
            return weather::openMeteoUrl(settings.openMeteoUrl, place.lat_deg, place.lon_deg);
        case WeatherProvider::metar:
            return metarUrl(settings.metarUrl, place, reach);
        case WeatherProvider::meteoblue:
            return weather::meteoblueUrl(settings.meteoblueUrl, settings.meteoblueKey, place.lat_deg, place.lon_deg, {});
    }
    return {};
}

/// In one line, printable, of bearable length, without the key.
std::string forEyes(std::string text, std::string const& key) {
    for (std::size_t at = 0; !key.empty() && (at = text.find(key)) != text.npos;) text.replace(at, key.size(), "(key)");
    std::replace_if(text.begin(), text.end(), [](unsigned char c) { return c < 0x20 || c >= 0x7F; }, ' ');
    constexpr std::size_t kMost = 160;
    if (text.size() > kMost) text = text.substr(0, kMost) + "...";
    return text;
}

/// What a server says with a status that is no success: "HTTP 429: Minutely API request limit exceeded".
std::string refusal(platform::HttpAnswer const& answer) {
    auto const json = nlohmann::json::parse(answer.body, nullptr, false);
    if (json.is_object())
        for (char const* key : {"reason", "error_message", "message", "error"})
            if (auto const found = json.find(key); found != json.end() && found->is_string())
                return fmt::format("HTTP {}: {}", answer.status, found->get<std::string>());
    return fmt::format("HTTP {}", answer.status);
}

/// The nearest stations that have a place; all where none has.
void keepNearest(weather::Recording& recording, FeedPlace const& place) {
    auto const apart = [&](weather::Site const& site) {
        return site.lat_deg && site.lon_deg ? distance(place, {*site.lat_deg, *site.lon_deg}) : 1.0e9;
    };
    std::stable_sort(recording.sites.begin(), recording.sites.end(), [&](auto const& a, auto const& b) { return apart(a) < apart(b); });
    if (recording.sites.size() > kMostStations) recording.sites.erase(recording.sites.begin() + kMostStations, recording.sites.end());
    recording.order.clear();
}

WeatherNews newsOf(std::string const& body, std::string_view provider, FeedPlace const& place, core::UtcSeconds now) {
    weather::Recording recording = weather::parseSource(body, std::string{provider}, sourceContext(now));
    if (recording.sites.empty() || recording.sites.front().reports.empty()) throw core::Error(std::string{provider}, "", "expected reports, found none");
    keepNearest(recording, place);
    return {weather::recordingText(recording), lastReport(recording), place};
}

bool hasKey(WeatherSettings const& settings) { return settings.provider != WeatherProvider::meteoblue || !settings.meteoblueKey.empty(); }

/// What came, read.
Fetched understood(platform::HttpAnswer const& answer, WeatherSettings const& settings, FeedPlace const& place, core::UtcSeconds now) {
    ProviderFacts const& facts = factsOf(settings.provider);
    Fetched fetched;
    fetched.retryAfter_s = answer.retryAfter_s;
    fetched.refused = answer.status >= 400 && answer.status < 500;
    auto const say = [&](std::string const& what) { fetched.error = forEyes(fmt::format("{}: {}", facts.name, what), settings.meteoblueKey); };
    if (!answer.error.empty()) {
        say(answer.error);
    } else if (answer.status == 304) {
        fetched.unchanged = true;
    } else if (answer.status == 204 || (answer.status == 200 && answer.body.empty())) {
        say("an empty answer: nothing is reported here");
    } else if (answer.status != 200) {
        say(refusal(answer));
    } else {
        try {
            fetched.news = newsOf(answer.body, facts.name, place, now);
        } catch (std::exception const& error) {  // core::Error, or what a library says of bytes that are no text
            fetched.error = forEyes(error.what(), settings.meteoblueKey);
        }
    }
    return fetched;
}
}  // namespace

ProviderFacts const& factsOf(WeatherProvider provider) { return kFacts[static_cast<std::size_t>(provider)]; }

double distance(FeedPlace const& a, FeedPlace const& b) {
    double const turn = b.lon_deg - a.lon_deg;
    double const east = (turn - 360.0 * std::floor((turn + 180.0) / 360.0)) * std::cos(core::radians(0.5 * (a.lat_deg + b.lat_deg)));
    return std::hypot(east, b.lat_deg - a.lat_deg) * metresOfDegree();
}

core::UtcSeconds lastReport(weather::Recording const& recording) {
    core::UtcSeconds last = recording.sites.front().reports.back().time;
    for (weather::Site const& site : recording.sites) last = std::max(last, site.reports.back().time);
    return last;
}

double intervalOf(WeatherSettings const& settings) {
    WeatherSettings const usual;
    bool const own = settings.provider == WeatherProvider::openMeteo ? settings.openMeteoUrl == usual.openMeteoUrl
                     : settings.provider == WeatherProvider::metar   ? settings.metarUrl == usual.metarUrl
                                                                     : settings.meteoblueUrl == usual.meteoblueUrl;
    return std::max(settings.interval, own ? factsOf(settings.provider).shortestInterval : 1);
}

bool isStale(core::UtcSeconds given, core::UtcSeconds now, WeatherSettings const& settings) { return now - given > 2.0 * intervalOf(settings); }

Fetched fetchWeather(WeatherSettings const& settings, FeedPlace const& aircraft, core::UtcSeconds now, Validators& validators,
                     std::atomic<bool> const& abort) {
    Fetched fetched;
    if (!hasKey(settings)) {
        fetched.error = "meteoblue: expected a key (setting weather.meteoblueKey)";
        fetched.refused = true;
        return fetched;
    }
    FeedPlace const place{std::round(aircraft.lat_deg / kGrid_deg) * kGrid_deg, std::round(aircraft.lon_deg / kGrid_deg) * kGrid_deg};
    platform::HttpRequest request;
    request.mostBytes = kMostBytes;
    request.total_s = static_cast<double>(settings.timeout);
    request.connect_s = std::min(request.connect_s, request.total_s);
    request.silent_s = std::min(request.silent_s, request.total_s);
    request.url = urlOf(settings, place, kReach);
    if (validators.url == request.url) {
        request.etag = validators.etag;
        request.lastModified = validators.lastModified;
    }
    platform::HttpAnswer answer = platform::httpGet(request, abort);
    if (answer.status == 204 && settings.provider == WeatherProvider::metar) {
        request.url = urlOf(settings, place, kWideReach);
        answer = platform::httpGet(request, abort);
    }
    fetched = understood(answer, settings, place, now);
    if (fetched.news) validators = {answer.etag, answer.lastModified, request.url};
    return fetched;
}
}  // namespace luftpost::app
