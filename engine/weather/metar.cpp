#include "engine/weather/metar.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "engine/weather/metar_scan.h"

namespace luftpost::weather {
namespace {
constexpr double kCavokHeight = 1524.0;      // m: 5,000 ft
constexpr double kClearHeight = 3657.6;      // m: 12,000 ft, as far as American automatic stations look
constexpr std::size_t kMostClouds = 16;      // as many layers as a recording takes
constexpr std::size_t kMostWeather = 16;
constexpr int kMostFallen = 900;             // hundredths of an inch in an hour

struct Token {
    std::string_view text;
    std::size_t offset;
};

bool isBlank(char c) { return c == ' ' || c == '\t' || c == '\r' || c == '\n'; }

/// The words of the report up to its "=", without the "$" that asks for maintenance.
std::vector<Token> tokensOf(std::string_view text) {
    text = text.substr(0, text.find('='));
    std::vector<Token> tokens;
    std::size_t i = 0;
    while (i < text.size()) {
        while (i < text.size() && isBlank(text[i])) ++i;
        std::size_t const from = i;
        while (i < text.size() && !isBlank(text[i])) ++i;
        if (i > from && text.substr(from, i - from) != "$") tokens.push_back({text.substr(from, i - from), from});
    }
    return tokens;
}

bool isTypeWord(std::string_view word) { return word == "METAR" || word == "SPECI" || word == "COR"; }

bool isStation(std::string_view word) {
    return word.size() == 4 && word[0] >= 'A' && word[0] <= 'Z' && std::all_of(word.begin(), word.end(), [](char c) {
               return (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9');
           });
}

/// "010050Z", or what was meant to be one: four to seven digits and a Z, or six digits.
bool isTimeLike(std::string_view word) {
    bool const zulu = word.ends_with('Z');
    if (zulu) word.remove_suffix(1);
    return word.size() >= (zulu ? 4u : 6u) && word.size() <= (zulu ? 7u : 6u) && word.find_first_not_of("0123456789/") == word.npos;
}

std::optional<MetarTime> timeOf(std::string_view word) {
    MetarScan scan{word};
    auto const day = scan.exactly(2), hour = scan.exactly(2), minute = scan.exactly(2);
    if (!day || !hour || !minute || (!scan.done() && scan.rest() != "Z")) return std::nullopt;
    if (*day < 1 || *day > 31 || *hour > 23 || *minute > 59) return std::nullopt;
    return MetarTime{*day, *hour, *minute};
}

/// The walk through a report's words.
struct Walk {
    std::vector<Token> tokens;
    std::size_t i = 0;
    Metar metar;
    bool windSeen = false, visibilitySeen = false, temperatureSeen = false, inchesTaken = false;

    std::string_view word(std::size_t ahead = 0) const { return i + ahead < tokens.size() ? tokens[i + ahead].text : std::string_view{}; }
    void note(std::size_t count, std::string what) {
        Token const &first = tokens[i], &last = tokens[i + count - 1];
        metar.notes.push_back({first.offset, last.offset + last.text.size() - first.offset, std::move(what)});
    }
};

// Each reads the group that begins at the walk's word and says how many words it took; 0: it is another group.

std::size_t takeMarker(Walk& walk) {
    std::string_view const word = walk.word();
    if (word == "AUTO") walk.metar.automatic = true;
    else if (word == "COR" || (word.size() == 3 && word.starts_with("CC") && word[2] >= 'A' && word[2] <= 'Z')) walk.metar.corrected = true;
    else if (word != "NIL" && word != "RTD" && word != "NOSIG") return 0;
    return 1;
}

std::size_t takeWind(Walk& walk) {
    auto const wind = metarWind(walk.word());
    if (!wind || (wind->unitMissing && walk.windSeen)) return 0;
    if (walk.windSeen) {
        walk.note(1, "is a second wind");
        return 1;
    }
    // Where the unit is usually metres a second (the former Soviet Union, China, Mongolia) knots would be a guess.
    bool const metric = walk.metar.station.starts_with('U') || walk.metar.station.starts_with('Z');
    walk.windSeen = true;
    if (wind->unitMissing) walk.note(1, metric ? "is a wind without a unit" : "is a wind without a unit, taken as knots");
    if (!wind->unitMissing || !metric) walk.metar.wind = *wind;
    return 1;
}

std::size_t takeSector(Walk& walk) { return isMetarSector(walk.word()) ? 1 : 0; }

std::size_t takeCavok(Walk& walk) {
    if (walk.word() != "CAVOK") return 0;
    walk.visibilitySeen = true;
    walk.metar.visibility = {10000.0, true, false};
    if (!walk.metar.clouds) {
        walk.metar.clouds.emplace();
        walk.metar.cloudsTo_m = kCavokHeight;
    }
    return 1;
}

/// "1 1/2SM" in two words: nothing where it is not that.
std::optional<MetarVisibility> visibilityOfTwo(std::string_view whole, std::string_view fraction) {
    if (whole.size() != 1 || whole[0] < '1' || whole[0] > '9' || fraction.find('/') == fraction.npos || !fraction.ends_with("SM")) return std::nullopt;
    auto read = metarVisibility(fraction);
    auto const miles = metarVisibility(fmt::format("{}SM", whole));
    if (!read || !read->visibility_m) return std::nullopt;
    *read->visibility_m += *miles->visibility_m;
    return read;
}

std::size_t takeVisibility(Walk& walk) {
    std::size_t taken = 2;
    auto read = visibilityOfTwo(walk.word(), walk.word(1));
    if (!read) {
        read = metarVisibility(walk.word());
        taken = 1;
    }
    if (!read) return 0;
    bool const first = !walk.visibilitySeen;
    // After the prevailing one stands the least, with its direction or (France) without; most of the horizon is better.
    bool const least = read->directional || read->visibility_m < walk.metar.visibility.visibility_m;
    if (!first && !least) walk.note(taken, "is a second visibility");
    if (first) walk.metar.visibility = *read;
    walk.visibilitySeen = true;
    return taken;
}

std::size_t takeRunway(Walk& walk) { return isMetarRunway(walk.word()) ? 1 : 0; }

std::size_t takeWeather(Walk& walk) {
    if (walk.word() == "NSW") return 1;
    auto const weather = metarWeather(walk.word());
    if (!weather) return 0;
    walk.metar.weatherMissing = walk.metar.weatherMissing || weather->missing;
    if (weather->missing || weather->recent) return 1;
    if (walk.metar.weather.size() < kMostWeather) walk.metar.weather.push_back(*weather);
    else walk.note(1, "is one weather group too many");
    return 1;
}

std::size_t takeClear(Walk& walk) {
    static constexpr std::pair<std::string_view, std::optional<double>> kWords[] = {
        {"SKC", std::nullopt}, {"CLR", kClearHeight}, {"NSC", kCavokHeight}, {"NCD", kCavokHeight}};
    for (auto const& [word, height] : kWords) {
        if (walk.word() != word) continue;
        if (walk.metar.clouds) walk.note(1, "contradicts the clouds before it");
        else {
            walk.metar.clouds.emplace();
            walk.metar.cloudsTo_m = height;
        }
        return 1;
    }
    return 0;
}

std::size_t addCloud(Walk& walk, MetarCloud const& cloud, std::size_t taken) {
    if (cloud.empty()) return taken;  // //////: nothing said
    if (!walk.metar.clouds) walk.metar.clouds.emplace();
    if (walk.metar.clouds->size() < kMostClouds) walk.metar.clouds->push_back(cloud);
    else walk.note(taken, "is one layer too many");
    return taken;
}

std::size_t takeCloud(Walk& walk) {
    std::string_view const word = walk.word(), next = walk.word(1);
    auto const cloud = metarCloud(word);
    if (!cloud) return 0;
    // "FEW 018CB": the height after a blank.
    if (word.size() == 3 && next.size() >= 3 && next.find_first_not_of("0123456789") >= 3) {
        if (auto const joined = metarCloud(fmt::format("{}{}", word, next))) {
            walk.note(2, "has a blank in it");
            return addCloud(walk, *joined, 2);
        }
    }
    return addCloud(walk, *cloud, 1);
}

std::size_t takeVertical(Walk& walk) {
    auto const vertical = metarVertical(walk.word());
    if (!vertical) return 0;
    walk.metar.obscured = true;
    walk.metar.verticalVisibility_m = vertical->height_m;
    return 1;
}

std::size_t takeTemperature(Walk& walk) {
    auto const read = metarTemperature(walk.word());
    if (!read) return 0;
    if (walk.temperatureSeen) walk.note(1, "is a second temperature");
    else walk.metar.temperature = *read;
    walk.temperatureSeen = true;
    return 1;
}

/// Q rather than A where both stand there; they are the same pressure.
std::size_t takePressure(Walk& walk) {
    auto const read = metarPressure(walk.word());
    if (!read) return 0;
    if (!walk.metar.pressure_hpa || (walk.inchesTaken && !read->inches)) walk.metar.pressure_hpa = read->pressure_hpa;
    walk.inchesTaken = read->inches;
    return 1;
}

/// WS R18, WS RWY18L, WS ALL RWY, WS TKOF RWY18.
std::size_t takeShear(Walk& walk) {
    if (walk.word() != "WS") return 0;
    std::size_t taken = 1;
    if (walk.word(1) == "ALL" || walk.word(1) == "TKOF" || walk.word(1) == "LDG") ++taken;
    if (!walk.word(taken).starts_with('R')) return 0;
    return taken + 1;
}

std::size_t takeStateless(Walk& walk) {
    std::string_view const word = walk.word();
    bool const solidi = word.find_first_not_of('/') == word.npos;  // a group of which nothing is known
    return solidi || isMetarSea(word) || isMetarColour(word) ? 1 : 0;
}

/// QFE742, QFE742/0989, QFE 773/5: the pressure at the aerodrome, which no field of ours holds.
std::size_t takeStationPressure(Walk& walk) {
    std::string_view word = walk.word();
    if (!word.starts_with("QFE")) return 0;
    std::size_t const taken = word.size() == 3 ? 2 : 1;
    word = taken == 2 ? walk.word(1) : word.substr(3);
    return !word.empty() && word.find_first_not_of("0123456789/") == word.npos ? taken : 0;
}

/// 2AC070: a layer in the national form.
std::size_t takeGenera(Walk& walk) {
    auto const genera = metarGenera(walk.word());
    if (genera.size() != 1 || !genera[0].height_m) return 0;
    walk.metar.genera.push_back(genera[0]);
    return 1;
}

using Take = std::size_t (*)(Walk&);
constexpr std::array<Take, 16> kBody{takeMarker, takeWind, takeSector, takeCavok, takeRunway, takeWeather, takeVisibility, takeClear, takeCloud,
                                     takeVertical, takeTemperature, takePressure, takeShear, takeStateless, takeGenera, takeStationPressure};

/// What a word that is no group was probably meant to be.
std::string meantFor(std::string_view word) {
    if (word.ends_with("KT") || word.ends_with("MPS")) return "is no wind";
    if (word.ends_with("SM")) return "is no visibility";
    for (std::string_view const amount : {"FEW", "SCT", "BKN", "OVC", "VV"})
        if (word.starts_with(amount)) return "is no cloud";
    if (word.starts_with('Q')) return "is no pressure";
    if (word.size() >= 4 && word.size() <= 7 && word.find('/') != word.npos) return "is no temperature and dew point";
    return "is no group of a METAR";
}

/// Words that belong together are one note; before cloud and temperature they may have been the weather.
void noteUnknown(Walk& walk) {
    Metar& metar = walk.metar;
    std::string what = meantFor(walk.word());
    if (!metar.clouds && !metar.obscured && !walk.temperatureSeen && walk.windSeen && what.ends_with("METAR")) metar.weatherMissing = true;
    Token const& token = walk.tokens[walk.i];
    if (!metar.notes.empty() && walk.i > 0 && metar.notes.back().what == what && what.ends_with("METAR")) {
        MetarNote& before = metar.notes.back();
        Token const& last = walk.tokens[walk.i - 1];
        if (before.offset + before.length == last.offset + last.text.size()) {
            before.length = token.offset + token.text.size() - before.offset;
            return;
        }
    }
    walk.note(1, std::move(what));
}

bool beginsTrend(std::string_view word) {
    return word == "BECMG" || word == "TEMPO" || word == "INTER" || word == "GRADU" || word == "RAPID" || word.starts_with("PROB");
}

void readBody(Walk& walk) {
    bool trend = false;  // what is expected is no part of the observation
    while (walk.i < walk.tokens.size() && walk.word() != "RMK") {
        trend = trend || beginsTrend(walk.word());
        std::size_t taken = trend ? 1 : 0;
        for (std::size_t k = 0; k < kBody.size() && taken == 0; ++k) taken = kBody[k](walk);
        if (taken == 0) noteUnknown(walk);
        walk.i += std::max<std::size_t>(taken, 1);
    }
}

/// SLP134, P0003: the digits behind the word.
std::optional<int> codedNumber(std::string_view word, std::string_view head, std::size_t count) {
    MetarScan scan{word};
    if (!scan.take(head)) return std::nullopt;
    auto const value = scan.exactly(count);
    return value && scan.done() ? value : std::nullopt;
}

void readRemark(Walk& walk) {
    Metar& metar = walk.metar;
    std::string_view const word = walk.word();
    bool const american = metar.station.starts_with('K') || metar.station.starts_with('P') || metar.station.starts_with('T');
    if (word.size() <= 4 && (word.starts_with("AO") || word.starts_with("A0")) && word.size() >= 3 && (word[2] == '1' || word[2] == '2'))
        metar.automaticType = word[2] - '0';
    if (word == "TSNO") metar.thunderBlind = true;
    if (word == "PWINO") metar.weatherBlind = true;
    if (auto const tenths = metarTenths(word)) metar.tenths = *tenths;
    if (auto const tenths = codedNumber(word, "SLP", 3)) metar.seaLevel = tenths;
    if (auto const hundredths = american ? codedNumber(word, "P", 4) : std::nullopt) {
        if (*hundredths <= kMostFallen) metar.fallen_mm = *hundredths * 0.254;
        else walk.note(1, "is no amount of an hour");
    }
    // Where the body has no Q, the pressure may stand here (Japan writes both).
    if (auto const pressure = metarPressure(word); pressure && !metar.pressure_hpa) metar.pressure_hpa = pressure->pressure_hpa;
    for (MetarGenus const& genus : metarGenera(word)) metar.genera.push_back(genus);
}

/// Type words, station and time; false where the text does not begin as a report does.
bool readHead(Walk& walk) {
    for (; isTypeWord(walk.word()); ++walk.i) walk.metar.corrected = walk.metar.corrected || walk.word() == "COR";
    if (!isStation(walk.word()) || walk.i + 1 >= walk.tokens.size()) return false;
    walk.metar.station = walk.word();
    ++walk.i;
    if (walk.word() == "NIL" || walk.word() == "AUTO") return true;
    if (!isTimeLike(walk.word())) {  // a report without its time
        auto const wind = metarWind(walk.word());
        return wind && !wind->unitMissing;
    }
    walk.metar.time = timeOf(walk.word());
    if (!walk.metar.time) walk.note(1, "is no day and time");
    else if (!walk.word().ends_with('Z')) walk.note(1, "is a time without its Z");
    ++walk.i;
    return true;
}
}  // namespace

bool looksLikeMetar(std::string_view line) {
    Walk walk;
    walk.tokens = tokensOf(line.substr(0, 80));
    while (isTypeWord(walk.word())) ++walk.i;
    return isStation(walk.word()) && (isTimeLike(walk.word(1)) || walk.word(1) == "NIL");
}

std::optional<Metar> decodeMetar(std::string_view text) {
    Walk walk;
    walk.tokens = tokensOf(text);
    if (!readHead(walk)) return std::nullopt;
    readBody(walk);
    for (; walk.i < walk.tokens.size(); ++walk.i) readRemark(walk);
    return std::move(walk.metar);
}
}  // namespace luftpost::weather
