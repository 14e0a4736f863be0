#include "game/delivery/career.h"

#include <nlohmann/json.hpp>

#include "engine/core/error.h"

namespace luftpost::delivery {
namespace {
constexpr char const* kFormat = "luftpost-save-1";

template <class T>
void read(nlohmann::json const& json, char const* key, T& value, double min, std::string const& file) {
    if (!json.contains(key)) return;
    bool const good = json[key].is_number() && json[key].get<double>() >= min && json[key].get<double>() <= 4294967295.0;
    if (!good) throw core::Error{file, key, fmt::format("expected a number of at least {}", min)};
    value = json[key].get<T>();
}
}  // namespace

std::string careerText(Career const& career) {
    nlohmann::ordered_json const json{{"format", kFormat},
                                      {"seed", career.seed},
                                      {"deliveries", career.deliveries},
                                      {"parcels_lost", career.parcelsLost},
                                      {"score", career.score},
                                      {"best_distance_m", career.bestDistance_m}};
    return json.dump(2) + "\n";
}

Career parseCareer(std::string_view text, std::string const& file) {
    nlohmann::json const json = nlohmann::json::parse(text, nullptr, false);
    if (!json.is_object() || json.value("format", nlohmann::json{}) != kFormat)
        throw core::Error{file, "format", fmt::format("expected a {} file", kFormat)};
    Career career;
    read(json, "seed", career.seed, 0.0, file);
    read(json, "deliveries", career.deliveries, 0.0, file);
    read(json, "parcels_lost", career.parcelsLost, 0.0, file);
    read(json, "score", career.score, 0.0, file);
    read(json, "best_distance_m", career.bestDistance_m, -1.0, file);
    return career;
}
}  // namespace luftpost::delivery
