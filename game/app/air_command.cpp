// luftpost air --probe IN.csv -o OUT.csv: the air at points, for scripts.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <charconv>
#include <cmath>
#include <memory>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/terrain/land.h"
#include "engine/weather/air.h"
#include "engine/weather/noise_volume.h"
#include "game/app/commands.h"
#include "game/app/weather_source.h"

namespace luftpost::app {
namespace {
constexpr std::string_view kColumns = "t_s,east_m,north_m,altitude_m";
constexpr std::string_view kAdded = "wind_east_mps,wind_north_mps,wind_up_mps,turbulence_mps,density_kg_m3,temperature_c,visibility_m,icing";
constexpr double kZeroCelsius = 273.15;

struct AirTexts {
    std::filesystem::path probe, out;
};

struct Probe {
    double t, east, north, altitude;
};

/// One line of the file, without its end (also of Windows).
std::string_view takeLine(std::string_view& text) {
    std::size_t const end = text.find('\n');
    std::string_view line = text.substr(0, end);
    text.remove_prefix(end == text.npos ? text.size() : end + 1);
    if (line.ends_with('\r')) line.remove_suffix(1);
    return line;
}

Probe readProbe(std::string const& file, std::size_t lineNumber, std::string_view line) {
    double values[4];
    std::string const place = fmt::format("line {}", lineNumber);
    for (int i = 0; i < 4; ++i) {
        std::size_t const comma = line.find(',');
        if ((comma == line.npos) != (i == 3)) throw core::Error(file, place, fmt::format("expected four numbers {}", kColumns));
        std::string_view const cell = line.substr(0, comma);
        auto const [end, error] = std::from_chars(cell.data(), cell.data() + cell.size(), values[i]);
        if (error != std::errc{} || end != cell.data() + cell.size() || !std::isfinite(values[i]) || std::abs(values[i]) > 1e9)
            throw core::Error(file, place, fmt::format("expected a number in column {} of {}, found \"{}\"", i + 1, kColumns, cell.substr(0, 30)));
        line.remove_prefix(i == 3 ? line.size() : comma + 1);
    }
    return {values[0], values[1], values[2], values[3]};
}

std::vector<Probe> readProbes(std::string const& file) {
    std::string const bytes = core::readFile(file);
    std::string_view rest = bytes;
    if (takeLine(rest) != kColumns) throw core::Error(file, "line 1", fmt::format("expected the header {}", kColumns));
    std::vector<Probe> probes;
    for (std::size_t number = 2; !rest.empty(); ++number) {
        std::string_view const line = takeLine(rest);
        if (!line.empty()) probes.push_back(readProbe(file, number, line));
    }
    return probes;
}

int runAir(AirTexts const& texts, CommonOptions const& common) {
    core::checkOutputFolder("-o", texts.out);
    std::vector<Probe> const probes = readProbes(texts.probe.string());
    weather::Field const field = weatherField(common);
    core::UtcSeconds const start = startTime(common, field);
    unsigned const seed = common.seed.value_or(1);
    weather::NoiseVolumes const noise = noiseVolumes();
    terrain::Land const land{seed, field.place().altitude_m};
    weather::Air const air{field, [&land](double east, double north) { return land.ground(east, north); }, seed, &noise};
    std::string text = fmt::format("{},{}\n", kColumns, kAdded);
    for (Probe const& probe : probes) {
        core::AirSample const s = air.instant(start + probe.t, common.settings.flight.clouds).at(core::worldFromEastNorth(probe.east, probe.north, probe.altitude));
        text += fmt::format("{},{},{},{},{:.5f},{:.5f},{:.5f},{:.5f},{:.7f},{:.4f},{:.1f},{:.8f}\n", probe.t, probe.east, probe.north, probe.altitude,
                            s.windWorld.x + 0.0, 0.0 - s.windWorld.z, s.windWorld.y + 0.0, s.turbulence, s.density, s.temperature - kZeroCelsius, s.visibility,
                            s.icing);
    }
    core::writeFileAtomically(texts.out, text);
    return 0;
}
}  // namespace

void addAirCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    auto const texts = std::make_shared<AirTexts>();
    CLI::App* const command = app.add_subcommand("air", "the air at points");
    command->add_option("--probe", texts->probe, fmt::format("IN.csv with the columns {}; t_s counts from --time", kColumns))->required();
    command->add_option("-o", texts->out, fmt::format("OUT.csv: the same and {}", kAdded))->required();
    command->callback([texts, &common, &chosen] { chosen = [texts, &common] { return runAir(*texts, common); }; });
}
}  // namespace luftpost::app
