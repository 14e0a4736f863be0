// The groups of an aerodrome report (METAR, SPECI), each read by itself: WMO-No. 306, FM 15 and FM 16; the American forms
// by FMH-1 (2019). A text that is not such a group gives nothing. Pure; any thread.
#pragma once
#include <optional>
#include <string_view>
#include <vector>

#include "engine/weather/weather.h"

namespace luftpost::weather {
/// dddff(f)Gff(f)KT, MPS or KMH.
struct MetarWind {
    std::optional<double> speed_mps, gust_mps, from_deg;  // from_deg: none when calm or variable
    bool unitMissing = false;                             // knots were taken
};
std::optional<MetarWind> metarWind(std::string_view group);

/// 4000, 9999NDV, 0400W, 10KM, 6SM, 1/2SM, M1/4SM, P6SM; nothing in it for ////. What stands between "1" and "1/2SM" is the caller's.
struct MetarVisibility {
    std::optional<double> visibility_m;
    bool isMinimum = false;  // 9999, 10SM and P..: that far or farther
    bool directional = false;
};
std::optional<MetarVisibility> metarVisibility(std::string_view group);

/// Present or recent weather.
struct MetarWeather {
    int intensity = 0;  // -1 light, 0 moderate, +1 heavy
    bool vicinity = false, recent = false, missing = false;
    bool thunder = false;                     // TS: at the aerodrome, or VCTS: near enough to be heard
    std::optional<Precipitation> kind;        // what falls at the aerodrome; none where nothing does
    bool obscures = false;                    // FG, BR, FU, VA, DU, SA, HZ, PY
};
std::optional<MetarWeather> metarWeather(std::string_view group);

/// FEW018CB, OVC006///, ///TCU, //////; heights above the aerodrome.
struct MetarCloud {
    std::optional<double> amount;    // 0..1: FEW 1.5, SCT 3.5, BKN 6, OVC 8 eighths
    std::optional<double> height_m;
    std::optional<Genus> genus;      // Cb, or Cu for TCU
    bool typeHidden = false;         // ///: the automatic station cannot tell convective cloud
    bool empty() const { return !amount && !height_m && !genus; }
};
std::optional<MetarCloud> metarCloud(std::string_view group);

/// VV003: metres; VV///: nothing in it.
struct MetarVertical {
    std::optional<double> height_m;
};
std::optional<MetarVertical> metarVertical(std::string_view group);

/// M05/M11, 13/, /////.
struct MetarTemperature {
    std::optional<double> temperature_c, dew_point_c;
};
std::optional<MetarTemperature> metarTemperature(std::string_view group);

/// Q1013, A2992, QNH1013HPA, QNH2992INS; nothing in it for Q////.
struct MetarPressure {
    std::optional<double> pressure_hpa;
    bool inches = false;  // A
};
std::optional<MetarPressure> metarPressure(std::string_view group);

/// Groups that say nothing of the air's state: variable sector, runway visual range, runway state, sea state, colour state.
bool isMetarSector(std::string_view group);
bool isMetarRunway(std::string_view group);
bool isMetarSea(std::string_view group);
bool isMetarColour(std::string_view group);

/// A cloud as remarks of some countries have it: SC3 (Canada), 6CU045 (Japan, Turkey).
struct MetarGenus {
    Genus genus = Genus::Cu;
    int eighths = 0;
    std::optional<double> height_m;
};
/// "SC3AC5" -> two; empty where the text is anything else.
std::vector<MetarGenus> metarGenera(std::string_view group);

/// T01830094, T0128: tenths of a degree.
std::optional<MetarTemperature> metarTenths(std::string_view group);
}  // namespace luftpost::weather
