#include "engine/weather/cloud_column.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"
#include "engine/core/math.h"
#include "engine/weather/cloud_cover_table.h"
#include "engine/weather/genera.h"
#include "shaders/lib/cloud.glsl"

namespace luftpost::weather {
namespace {
constexpr float kEmpty = -1.0f;   // no rank, however frayed, is below it
constexpr float kClosed = 2.0f;   // every rank is, by far

/// How a genus is formed; the columns are LayerShape's form, look and body.
struct Form {
    float domeWidth, lens, carve, detail;
    float softness, fray, variety, reach, anvil;
    double grain;           // size of the noise against a cumulus'
    bool sheet;
    double along, across;   // m, period of the fibres' grain
};
constexpr std::array<Form, kGenera> kForms{{
    //         dome  lens   carve   detail  soft   fray   variety reach anvil grain
    /* Ci */ {0.60f, 1.0f, 0.0f, 0.0f, 1.0f, 0.22f, 0.00f, 1.0f, 0.0f, 1.0, true, 44000.0, 2900.0},
    /* Cc */ {0.30f, 0.9f, 0.0f, 0.0f, 1.0f, 0.20f, 0.00f, 1.0f, 0.0f, 1.0, true, 3800.0, 2900.0},
    /* Cs */ {0.45f, 0.3f, 0.0f, 0.0f, 1.0f, 0.10f, 0.00f, 1.0f, 0.0f, 1.0, true, 36000.0, 5200.0},
    /* Ac */ {0.45f, 0.40f, 80.0f, 35.0f, 70.0f, 0.06f, 0.00f, 420.0f, 0.0f, 0.5, false, 0.0, 0.0},
    /* As */ {0.12f, 0.40f, 150.0f, 60.0f, 400.0f, 0.05f, 0.00f, 2500.0f, 0.0f, 1.0, false, 0.0, 0.0},
    /* Ns */ {0.10f, 0.10f, 200.0f, 80.0f, 300.0f, 0.04f, 0.00f, 2500.0f, 0.0f, 1.0, false, 0.0, 0.0},
    /* Sc */ {0.50f, 0.10f, 160.0f, 60.0f, 60.0f, 0.05f, 0.35f, 1300.0f, 0.0f, 0.75, false, 0.0, 0.0},
    /* St */ {0.12f, 0.15f, 80.0f, 60.0f, 120.0f, 0.06f, 0.00f, 1800.0f, 0.0f, 1.0, false, 0.0, 0.0},
    /* Cu */ {0.50f, 0.0f, 300.0f, 140.0f, 20.0f, 0.05f, 0.45f, 1100.0f, 0.0f, 1.0, false, 0.0, 0.0},
    /* Cb */ {0.50f, 0.0f, 850.0f, 110.0f, 50.0f, 0.0f, 0.18f, 4000.0f, 0.06f, 1.5, false, 0.0, 0.0},
    /* fog */ {0.12f, 0.0f, 30.0f, 30.0f, 60.0f, 0.06f, 0.00f, 1800.0f, 0.0f, 1.0, false, 0.0, 0.0},
}};
Form const& formOf(Genus genus) { return kForms[static_cast<std::size_t>(genus)]; }

constexpr double kAnchorPeriod = 3.0 * glsl::kShapePeriod;  // m: the periods of shape, curl, detail and variety divide it
constexpr double kSheetPeriod = 65536.0;              // m: the fibres' periods divide it along both axes
constexpr float kBald = 2000.0f;                      // m: the top of a storm that is no thicker is no ice that spreads
constexpr double kAnvilLead = 0.66, kAnvilLength = 1.5;  // by how much of the tower's inset beyond its foot, and of the rim's own, it is carried
constexpr float kAnvilWeaker = 0.4f;      // of the cover: what it loses in rank on that way
constexpr double kAnvilWesterly = 0.3;     // m/s, added to the wind that carries it: a calm has no direction
constexpr double kDetailPace = 1.08;                  // the detail drifts faster than the clouds it eats at
constexpr double kDetailRise = 900.0;                 // m/h, the boiling of the edges

double wrapped(double v, double period) { return v - period * std::floor(v / period); }

bool precipitates(Genus genus) { return genus == Genus::Ns || genus == Genus::Cb || genus == Genus::Cu || genus == Genus::Sc || genus == Genus::St; }

constexpr double kSeenDepth = 3.0;  // optical, of the core of a layer that somebody reported, however thin it is

/// m2/kg: extinction of one kg/m3.
float extinctionOfWater(Genus genus) {
    GenusRow const& row = genusRow(genus);
    return static_cast<float>(row.extinction / row.water);
}

/// kg/m3 in the core: what the layer has, thickened by its rain, and no less than it takes to be seen.
float coreWater(Layer const& layer, Weather const& weather) {
    double const rate = weather.precipitation == Precipitation::None ? 0.0 : weather.precipitationRate;
    double const thickening = precipitates(layer.genus) ? 1.0 + 0.15 * std::min(rate, 8.0) : 1.0;
    double const thickness = static_cast<double>(std::max(layer.top - layer.base, 20.0f));
    double const opacity = static_cast<double>(extinctionOfWater(layer.genus));
    double const seen = formOf(layer.genus).sheet ? 0.0 : kSeenDepth / (opacity * thickness);
    return static_cast<float>(std::max(static_cast<double>(layer.water) * thickening, seen));
}

/// Share of a small cover on which no tower stands, 0 for a layer without an anvil; `thickness`: the layer's, m.
float anvilShareOf(Genus genus, float thickness) { return thickness > kBald ? formOf(genus).anvil : 0.0f; }

/// Where between lib/cloud's eight lattice ways, 0..8, a wind (m/s, east and north) blows, or the way back.
float latticeWayOf(glm::dvec2 const& wind) {
    double turn = core::atan2(-wind.y, wind.x) * 2.0 / core::kPi;  // quarters, east by south
    turn -= 2.0 * std::floor(turn * 0.5);                         // a streak has no direction
    constexpr std::array<double, 4> kTurns{0.0, 0.29516723530086653, 0.5, 0.7048327646991335};  // of (1, 0), (2, 1), (1, 1), (1, 2)
    double const quarter = std::floor(turn), within = turn - quarter;
    std::size_t k = 3;
    while (within < kTurns[k]) --k;
    double const next = k < 3 ? kTurns[k + 1] : 1.0;
    return static_cast<float>(4.0 * quarter + static_cast<double>(k) + (within - kTurns[k]) / (next - kTurns[k]));
}

glsl::LayerColumn emptyLayer() { return {1.0f, kEmpty, -1.0e5f, -1.0e5f + 1.0f, 0.0f, 1.0f}; }

/// Anchor of a noise of `period` m, after a drift in m east and north.
glm::vec3 anchorOf(glm::dvec2 const& origin, glm::dvec2 const& drift, double rise, double period) {
    return {static_cast<float>(wrapped(origin.x - drift.x, period)), static_cast<float>(wrapped(-rise, period)),
            static_cast<float>(wrapped(drift.y - origin.y, period))};
}

/// Fibres along the pattern's axis, their grain a whole number of times in the period of the anchor.
void layFibres(glsl::LayerShape& shape, Form const& form, LayerPattern const& pattern, double scale) {
    glm::vec2 const axis = pattern.axis();
    double const longest = std::max(std::abs(axis.x), std::abs(axis.y));
    double const shortest = std::min(std::abs(axis.x), std::abs(axis.y));
    // The axis is (a, b) / |ab| of small whole numbers: |ab| / period steps it by whole periods.
    double const wholes = shortest < 1e-6 ? 1.0 : 1.0 / (shortest > 0.9 * longest ? longest : shortest);
    auto const perMetre = [&](double metres) {
        return static_cast<float>(std::max(1.0, std::round(kSheetPeriod / (metres * wholes))) * wholes / (kSheetPeriod * scale));
    };
    shape.fibre = {axis.x, -axis.y, perMetre(form.along), perMetre(form.across)};
    shape.anchor.w = static_cast<float>(std::round(kSheetPeriod / 8000.0) / (kSheetPeriod * scale));
}
}  // namespace

float calibratedCover(Genus genus, float cover, float thickness) {
    using namespace table;
    if (!(cover > 0.0f)) return kEmpty;
    if (cover >= 1.0f) return kClosed;
    auto const& rows = kThresholds[static_cast<std::size_t>(genus)];
    // Between two thicknesses of the table, and within each between two covers.
    std::size_t row = 0;
    while (row + 2 < kThicknesses.size() && thickness > kThicknesses[row + 1]) ++row;
    // Nothing lies between a bald storm and one with an anvil: below the lowest of these goes on what lies above.
    bool const iced = anvilShareOf(genus, thickness) > 0.0f;
    while (iced && !(kThicknesses[row] > kBald)) ++row;
    float const down = std::clamp((thickness - kThicknesses[row]) / (kThicknesses[row + 1] - kThicknesses[row]), iced ? -0.6f : 0.0f, 1.0f);
    auto const threshold = [&](std::size_t column) {
        return rows[row][column] + down * (rows[row + 1][column] - rows[row][column]);
    };
    if (cover <= kCovers.front()) return threshold(0) * cover / kCovers.front();
    if (cover >= kCovers.back()) {
        float const share = (cover - kCovers.back()) / (1.0f - kCovers.back());
        return threshold(kCovers.size() - 1) + share * (kClosed - threshold(kCovers.size() - 1));
    }
    std::size_t column = 0;
    while (cover > kCovers[column + 1]) ++column;
    float const share = (cover - kCovers[column]) / (kCovers[column + 1] - kCovers[column]);
    return threshold(column) + share * (threshold(column + 1) - threshold(column));
}

glm::vec4 anvilWay(Layer const& layer, CloudSettings const& settings) {
    float const anvil = anvilShareOf(layer.genus, layer.top - layer.base), cover = std::clamp(layer.cover, 0.0f, 1.0f);
    if (!(anvil > 0.0f && cover > 0.0f)) return glm::vec4{0.0f};
    glm::dvec2 const wind = layer.wind + glm::dvec2{kAnvilWesterly, 0.0};
    double const speed = glm::length(wind);
    if (!(speed > 0.0)) return {0.0f, 0.0f, 1.0f, kAnvilWeaker * cover};
    // All of it lies so far downwind that it ends little upwind of the tower's foot, and its far half that far again.
    glsl::LayerShape shape{};
    shape.body = {formOf(layer.genus).reach, 0.0f, anvil, 0.0f};
    float const towers = glsl::towerCover(cover, shape);
    double const rim = static_cast<double>(glsl::stormWay(cover, shape)), foot = static_cast<double>(glsl::stormWay(towers, shape));
    double const all = rim - foot + kAnvilLead * static_cast<double>(glsl::mostInset(towers, shape)), far = all + kAnvilLength * rim;
    glm::dvec2 const way = wind * (far * static_cast<double>(settings.weatherScale) / speed);
    return {static_cast<float>(way.x), static_cast<float>(-way.y), static_cast<float>(all / far), kAnvilWeaker * cover};
}

CloudColumns::CloudColumns(Weather const& weather, unsigned seed, CloudSettings const& settings)
    : scale_{static_cast<double>(settings.weatherScale)} {
    for (int i = 0; i < glsl::kCloudLayers; ++i) bare_.layers[i] = emptyLayer();
    bare_.rain = weather.precipitation == Precipitation::None ? 0.0f : static_cast<float>(weather.precipitationRate);
    for (int i = 0; i < std::min(weather.layerCount, glsl::kCloudLayers); ++i) {
        Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        float const cover = calibratedCover(layer.genus, layer.cover, layer.top - layer.base);
        bare_.layers[i] = {1.0f, cover - settings.densityThreshold, layer.base + settings.height,
                           std::max(layer.top, layer.base + 20.0f) + settings.height, coreWater(layer, weather) * settings.sigma, 1.0f};
        patterns_.emplace_back(layer, seed);
        carried_.push_back(anvilWay(layer, settings));
    }
}

glsl::CloudColumn CloudColumns::at(double east, double north) const {
    glsl::CloudColumn column = bare_;
    for (int i = 0; i < layerCount(); ++i) {
        LayerPattern const& pattern = patterns_[static_cast<std::size_t>(i)];
        auto const rankAt = [&](double x, double y) { return pattern.drifting((x - pattern.drift().x) / scale_, (y - pattern.drift().y) / scale_); };
        column.layers[i].rank = rankAt(east, north);
        glm::dvec4 const way{carried_[static_cast<std::size_t>(i)]};
        if (way.w > 0.0)
            column.layers[i].anvil = glsl::anvilRank(rankAt(east - way.z * way.x, north + way.z * way.y), rankAt(east - way.x, north + way.y), static_cast<float>(way.w));
    }
    return column;
}

glsl::CloudColumn cloudColumn(Field const& field, double east, double north, core::UtcSeconds time, unsigned seed) {
    return CloudColumns{field.at(east, north, time), seed}.at(east, north);
}

glsl::CloudShape cloudShape(Weather const& weather, unsigned seed, glm::dvec2 const& originEastNorth,
                            CloudSettings const& settings) {
    glsl::CloudShape result;
    for (int i = 0; i < glsl::kCloudLayers; ++i) {
        glsl::LayerShape& shape = result.layers[i];
        shape = {};
        shape.look.x = 1.0f;
        shape.form.x = 1.0f;
        shape.body.x = 1.0f;
        if (i >= weather.layerCount) continue;
        Layer const& layer = weather.layers[static_cast<std::size_t>(i)];
        Form const& form = formOf(layer.genus);
        shape.form = {form.domeWidth, form.lens, form.carve, form.detail};
        shape.look = {form.softness, form.fray, form.sheet ? 1.0f : 0.0f, extinctionOfWater(layer.genus)};
        float const threshold = std::clamp(calibratedCover(layer.genus, layer.cover, layer.top - layer.base), 0.0f, kClosed);
        float const anvil = anvilShareOf(layer.genus, layer.top - layer.base);
        shape.body = {form.reach, threshold - layer.cover, anvil, anvil > 0.0f ? latticeWayOf(layer.wind) : 0.0f};
        double const scale = static_cast<double>(form.sheet ? settings.higherScale : settings.scale) * form.grain;
        double const rise = layer.phase * kDetailRise;
        shape.anchor = glm::vec4{anchorOf(originEastNorth, layer.drift, 0.0, (form.sheet ? kSheetPeriod : kAnchorPeriod) * scale),
                                 static_cast<float>(1.0 / (glsl::kShapePeriod * scale))};
        shape.detail = glm::vec4{anchorOf(originEastNorth, layer.drift * kDetailPace, rise, glsl::kDetailPeriod * scale),
                                 static_cast<float>(1.0 / (glsl::kDetailPeriod * scale))};
        shape.fibre = anvilWay(layer, settings);
        if (form.sheet) layFibres(shape, form, LayerPattern{layer, seed}, scale);
        shape.wind = {static_cast<float>(layer.wind.x), static_cast<float>(-layer.wind.y),
                      static_cast<float>(0.02 * layer.wind.x), static_cast<float>(-0.02 * layer.wind.y)};
        shape.extent = {layer.base + settings.height, std::max(layer.top, layer.base + 20.0f) + settings.height, 1.0f, form.variety};
    }
    return result;
}
}  // namespace luftpost::weather
