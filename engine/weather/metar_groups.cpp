#include "engine/weather/metar_groups.h"

#include <algorithm>
#include <array>

#include "engine/weather/metar_scan.h"

namespace luftpost::weather {
namespace {
constexpr double kKnot = 1852.0 / 3600.0;         // m/s
constexpr double kMile = 1609.344;                // m, statute
constexpr double kHundredFeet = 30.48;            // m
constexpr double kInchOfMercury = 33.86389;       // hPa (ISO 80000-4: conventional inch of mercury)
constexpr int kHighestCloud = 500;                // hundreds of feet; more is an error of writing
constexpr int kHottestTenths = 650;               // tenths of a degree
constexpr double kStrongestWind = 150.0;          // m/s; more is an error of writing
constexpr double kLeastPressure = 850.0, kMostPressure = 1090.0;  // hPa at sea level; the records are 870 and 1085

/// "12", "//", "P99": a speed in the group's unit.
struct Speed {
    bool read = false;
    std::optional<double> value;
};

Speed takeSpeed(MetarScan& scan) {
    if (scan.take("//")) return {true, std::nullopt};
    scan.take("P");  // more than can be written: the most that can
    auto const value = scan.digits(2, 3);
    return {value.has_value(), value ? std::optional{static_cast<double>(*value)} : std::nullopt};
}

bool takeDirection(MetarScan& scan, MetarWind& wind) {
    if (scan.take("VRB") || scan.take("///")) return true;
    auto const degrees = scan.exactly(3);
    if (!degrees || *degrees > 360) return false;
    wind.from_deg = *degrees;
    return true;
}

/// "M05", "//", "": a temperature in whole degrees.
bool takeDegrees(MetarScan& scan, std::optional<double>& degrees) {
    if (scan.take("//")) return true;
    bool const minus = scan.take("M");
    auto const value = scan.exactly(2);
    if (value) degrees = minus && *value > 0 ? -*value : *value;
    return value.has_value() || (!minus && (scan.done() || scan.rest().starts_with('/')));
}

std::optional<double> milesOf(MetarScan& scan) {
    auto const whole = scan.digits(1, 3);
    if (!whole) return std::nullopt;
    if (!scan.take("/")) return *whole * kMile;
    auto const parts = scan.digits(1, 2);
    if (!parts || *parts == 0) return std::nullopt;
    if (*whole < *parts) return *whole * kMile / *parts;
    // "11/2": one and a half whose blank was lost.
    int const units = *whole / 10, over = *whole % 10;
    if (units == 0 || over == 0 || over >= *parts) return std::nullopt;
    return (units + static_cast<double>(over) / *parts) * kMile;
}

std::optional<MetarVisibility> milesVisibility(std::string_view group) {
    group.remove_suffix(2);
    if (!group.empty() && group.find_first_not_of('/') == group.npos) return MetarVisibility{};
    MetarScan scan{group};
    bool const more = scan.take("P");
    if (!more) scan.take("M");
    auto const metres = milesOf(scan);
    if (!metres || !scan.done() || *metres > 300000.0) return std::nullopt;
    return MetarVisibility{metres, more || group == "10", false};
}

/// What the code table 4678 knows, in its order: first the descriptors, then what falls, then what dims.
enum class Phenomenon { None, Drizzle, Rain, Snow, Pellets, Hail, Unknown, Dims, Other };
struct PhenomenonWord {
    std::string_view word;
    Phenomenon phenomenon;
};
constexpr std::array<PhenomenonWord, 22> kPhenomena{{
    {"DZ", Phenomenon::Drizzle}, {"RA", Phenomenon::Rain}, {"SN", Phenomenon::Snow}, {"SG", Phenomenon::Snow}, {"IC", Phenomenon::Snow},
    {"PL", Phenomenon::Pellets}, {"PE", Phenomenon::Pellets}, {"GR", Phenomenon::Hail}, {"GS", Phenomenon::Hail}, {"UP", Phenomenon::Unknown},
    {"BR", Phenomenon::Dims}, {"FG", Phenomenon::Dims}, {"FU", Phenomenon::Dims}, {"VA", Phenomenon::Dims}, {"DU", Phenomenon::Dims},
    {"SA", Phenomenon::Dims}, {"HZ", Phenomenon::Dims}, {"PY", Phenomenon::Dims}, {"PO", Phenomenon::Other}, {"SQ", Phenomenon::Other},
    {"FC", Phenomenon::Other}, {"SS", Phenomenon::Other}}};

Phenomenon takePhenomenon(MetarScan& scan) {
    for (auto const& [word, phenomenon] : kPhenomena)
        if (scan.take(word)) return phenomenon;
    return scan.take("DS") ? Phenomenon::Other : Phenomenon::None;
}

/// What the word for a mixture is: hail before freezing before mixed before what stands first.
std::optional<Precipitation> kindOf(std::vector<Phenomenon> const& seen, bool freezing) {
    auto const has = [&](Phenomenon p) { return std::find(seen.begin(), seen.end(), p) != seen.end(); };
    bool const liquid = has(Phenomenon::Rain) || has(Phenomenon::Drizzle);
    if (has(Phenomenon::Hail)) return Precipitation::Hail;
    if (freezing && liquid) return Precipitation::FreezingRain;
    if (has(Phenomenon::Pellets) || (liquid && has(Phenomenon::Snow))) return Precipitation::Sleet;
    for (Phenomenon const p : seen) {
        if (p == Phenomenon::Drizzle) return Precipitation::Drizzle;
        if (p == Phenomenon::Rain) return Precipitation::Rain;
        if (p == Phenomenon::Snow) return Precipitation::Snow;
        if (p == Phenomenon::Unknown) return Precipitation::Unknown;
    }
    return std::nullopt;
}

std::optional<double> takeAmount(MetarScan& scan) {
    static constexpr double kEighths[] = {1.5, 3.5, 6.0, 8.0};
    auto const word = scan.takeOneOf({"FEW", "SCT", "BKN", "OVC"});
    return word ? std::optional{kEighths[*word] / 8.0} : std::nullopt;
}

bool takeRange(MetarScan& scan) {
    if (scan.take("////")) return true;
    if (!scan.take("P")) scan.take("M");
    return scan.exactly(4).has_value();
}

/// Behind "R09/": 0650, P2000FT, 0250V0300U, 3000VP6000FT/D, ////.
bool isVisualRange(MetarScan scan) {
    if (!takeRange(scan)) return false;
    if (scan.take("V") && !takeRange(scan)) return false;
    scan.take("FT");
    scan.take("/");
    scan.takeOneOf({"U", "D", "N"});
    return scan.done();
}

/// Behind "R09/": 450255, 39//31, CLRD70, CLRD//, SNOCLO, D.
bool isRunwayState(MetarScan scan) {
    if (scan.take("SNOCLO") || scan.rest() == "D") return scan.rest().size() <= 1;
    if (scan.take("CLRD")) return scan.rest().empty() || scan.rest() == "//" || (scan.rest().size() == 2 && scan.digits(2, 2));
    std::string_view const rest = scan.rest();
    return rest.size() == 6 && rest.find_first_not_of("0123456789/") == rest.npos;
}

std::optional<Genus> takeGenusWord(MetarScan& scan) {
    static constexpr Genus kGenus[] = {Genus::Ac, Genus::Cu, Genus::Cb, Genus::Cu, Genus::St, Genus::Sc, Genus::St,
                                       Genus::Ns, Genus::As, Genus::Ac, Genus::Cc, Genus::Cs, Genus::Ci, Genus::Cu};
    // ACC castellanus, CF and SF the ragged ones, TCU towering.
    auto const word = scan.takeOneOf({"ACC", "TCU", "CB", "CF", "SF", "SC", "ST", "NS", "AS", "AC", "CC", "CS", "CI", "CU"});
    return word ? std::optional{kGenus[*word]} : std::nullopt;
}
}  // namespace

std::optional<MetarWind> metarWind(std::string_view group) {
    MetarScan scan{group};
    MetarWind wind;
    if (!takeDirection(scan, wind)) return std::nullopt;
    Speed const speed = takeSpeed(scan);
    if (!speed.read) return std::nullopt;
    Speed gust;
    if (scan.take("G") && !(gust = takeSpeed(scan)).read) return std::nullopt;
    static constexpr double kUnits[] = {kKnot, 1.0, 1.0 / 3.6};
    auto const unit = scan.takeOneOf({"KT", "MPS", "KMH"});
    if (!scan.done() || (!unit && !speed.value)) return std::nullopt;
    wind.unitMissing = !unit;
    double const factor = kUnits[unit.value_or(0)];
    if (speed.value) wind.speed_mps = *speed.value * factor;
    if (gust.value) wind.gust_mps = *gust.value * factor;
    if (wind.speed_mps.value_or(0.0) > kStrongestWind || wind.gust_mps.value_or(0.0) > kStrongestWind) return std::nullopt;
    if (wind.speed_mps == 0.0) wind.from_deg.reset();
    return wind;
}

std::optional<MetarVisibility> metarVisibility(std::string_view group) {
    if (group == "////") return MetarVisibility{};
    if (group.ends_with("SM")) return milesVisibility(group);
    MetarScan scan{group};
    if (group.ends_with("KM")) {
        bool const more = scan.take("P");
        auto const km = scan.digits(1, 3);
        if (!km || scan.rest() != "KM" || *km > 300) return std::nullopt;
        return MetarVisibility{*km * 1000.0, more, false};
    }
    auto const metres = scan.digits(4, 4);
    if (!metres) return std::nullopt;
    bool const far = *metres == 9999;
    bool const directional = !scan.take("NDV") && scan.takeOneOf({"NE", "NW", "SE", "SW", "N", "E", "S", "W"});
    if (!scan.done()) return std::nullopt;
    return MetarVisibility{far ? 10000.0 : static_cast<double>(*metres), far, directional};
}

std::optional<MetarWeather> metarWeather(std::string_view group) {
    MetarScan scan{group};
    MetarWeather weather;
    weather.recent = scan.take("RE");
    if (scan.take("//")) {
        weather.missing = !weather.recent;
        return scan.done() ? std::optional{weather} : std::nullopt;
    }
    if (auto const sign = scan.takeOneOf({"-", "+"})) weather.intensity = *sign == 0 ? -1 : 1;
    weather.vicinity = scan.take("VC");
    auto const descriptor = scan.takeOneOf({"TS", "SH", "FZ", "MI", "PR", "BC", "DR", "BL"});
    std::vector<Phenomenon> seen;
    for (Phenomenon p = takePhenomenon(scan); p != Phenomenon::None; p = takePhenomenon(scan)) seen.push_back(p);
    bool const alone = descriptor && *descriptor <= 1;  // TS and SH stand alone
    if (!scan.done() || (seen.empty() && !alone) || seen.size() > 4) return std::nullopt;
    bool const lifted = descriptor && *descriptor >= 6;  // DR, BL: from the ground, it does not fall
    weather.thunder = descriptor == 0 && !weather.recent;
    weather.obscures = std::find(seen.begin(), seen.end(), Phenomenon::Dims) != seen.end();
    if (!weather.vicinity && !weather.recent && !lifted) weather.kind = kindOf(seen, descriptor == 2);
    return weather;
}

std::optional<MetarCloud> metarCloud(std::string_view group) {
    MetarScan scan{group};
    MetarCloud cloud;
    cloud.amount = takeAmount(scan);
    if (!cloud.amount && !scan.take("///")) return std::nullopt;
    auto const height = scan.take("///") ? std::nullopt : scan.exactly(3);
    if (height) cloud.height_m = *height * kHundredFeet;
    if (scan.take("CB")) cloud.genus = Genus::Cb;
    else if (scan.take("TCU")) cloud.genus = Genus::Cu;
    else cloud.typeHidden = scan.take("///");
    if (!scan.done() || group == "///" || height.value_or(0) > kHighestCloud) return std::nullopt;
    return cloud;
}

std::optional<MetarVertical> metarVertical(std::string_view group) {
    MetarScan scan{group};
    if (!scan.take("VV")) return std::nullopt;
    if (scan.rest() == "///") return MetarVertical{};
    auto const height = scan.digits(3, 3);
    if (!height || !scan.done() || *height > kHighestCloud) return std::nullopt;
    return MetarVertical{*height * kHundredFeet};
}

std::optional<MetarTemperature> metarTemperature(std::string_view group) {
    if (group.find_first_not_of('/') == group.npos && group != "/////") return std::nullopt;
    MetarScan scan{group};
    MetarTemperature read;
    if (!takeDegrees(scan, read.temperature_c) || !scan.take("/")) return std::nullopt;
    if (!takeDegrees(scan, read.dew_point_c) || !scan.done() || group.size() < 3) return std::nullopt;
    if (read.temperature_c.value_or(0.0) * 10.0 > kHottestTenths || read.dew_point_c.value_or(0.0) * 10.0 > kHottestTenths) return std::nullopt;
    return read;
}

std::optional<MetarPressure> metarPressure(std::string_view group) {
    if (group == "Q////" || group == "A////") return MetarPressure{};
    MetarScan scan{group};
    auto const word = scan.takeOneOf({"QNH", "Q", "A"});
    auto const value = word ? scan.exactly(4) : std::nullopt;
    if (!value) return std::nullopt;
    bool inches = *word == 2;
    if (*word == 0 && !(inches = scan.take("INS"))) scan.take("HPA");
    double const hpa = inches ? *value * kInchOfMercury / 100.0 : *value;
    if (!scan.done() || hpa < kLeastPressure || hpa > kMostPressure) return std::nullopt;
    return MetarPressure{hpa, inches};
}

bool isMetarSector(std::string_view group) {
    MetarScan scan{group};
    auto const from = scan.exactly(3);
    if (!from || !scan.take("V")) return false;
    auto const to = scan.digits(3, 3);
    return to && scan.done() && *from <= 360 && *to <= 360;
}

bool isMetarRunway(std::string_view group) {
    if (group == "SNOCLO" || group == "R/SNOCLO") return true;
    if (group.size() == 8 && group.find_first_not_of("0123456789/") == group.npos && group.find_first_not_of('/') != group.npos) return true;
    MetarScan scan{group};
    if (!scan.take("R") || !scan.exactly(2)) return false;
    scan.takeOneOf({"L", "C", "R"});
    return scan.take("/") && (isVisualRange(scan) || isRunwayState(scan));
}

bool isMetarSea(std::string_view group) {
    MetarScan scan{group};
    if (!scan.take("W")) return false;
    if (!scan.take("//")) {
        scan.take("M");
        if (!scan.exactly(2)) return false;
    }
    if (!scan.take("/")) return false;
    if (scan.take("S")) return scan.rest() == "/" || (scan.digits(1, 1) && scan.done());
    return scan.take("H") && (scan.rest() == "///" || (scan.digits(1, 3) && scan.done()));
}

bool isMetarColour(std::string_view group) {
    MetarScan scan{group};
    bool const black = scan.take("BLACK");
    bool any = false;
    while (scan.takeOneOf({"BLU", "WHT", "GRN", "YLO1", "YLO2", "YLO", "AMB", "RED"})) any = true;
    scan.take("+");
    return scan.done() && (black || any);
}

std::vector<MetarGenus> metarGenera(std::string_view group) {
    std::vector<MetarGenus> genera;
    MetarScan scan{group};
    if (auto const eighths = scan.exactly(1)) {
        auto const genus = takeGenusWord(scan);
        auto const height = genus ? scan.digits(3, 3) : std::nullopt;
        if (height && scan.done() && *eighths >= 1 && *eighths <= 8) genera.push_back({*genus, *eighths, *height * kHundredFeet});
        return genera;
    }
    while (!scan.done()) {
        auto const genus = takeGenusWord(scan);
        auto const eighths = genus ? scan.exactly(1) : std::nullopt;
        if (!eighths || *eighths > 8) return {};
        genera.push_back({*genus, *eighths, std::nullopt});
    }
    return genera;
}

std::optional<MetarTemperature> metarTenths(std::string_view group) {
    MetarScan scan{group};
    if (!scan.take("T")) return std::nullopt;
    auto const tenths = [&scan]() -> std::optional<double> {
        auto const sign = scan.takeOneOf({"0", "1"});
        auto const value = sign ? scan.exactly(3) : std::nullopt;
        if (!value || (*sign == 0 && *value > kHottestTenths)) return std::nullopt;
        return (*sign == 1 && *value > 0 ? -*value : *value) / 10.0;
    };
    MetarTemperature read;
    read.temperature_c = tenths();
    if (!read.temperature_c) return std::nullopt;
    if (!scan.done() && !(read.dew_point_c = tenths())) return std::nullopt;
    return scan.done() ? std::optional{read} : std::nullopt;
}
}  // namespace luftpost::weather
