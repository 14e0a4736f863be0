// `luftpost reference --case`: the path tracer on a textbook's cloud, where others have published what comes out.
#include <CLI/CLI.hpp>
#include <chrono>
#include <filesystem>
#include <nlohmann/json.hpp>
#include <string>

#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/core/frames.h"
#include "engine/sky/step_cloud.h"
#include "game/app/commands.h"
#include "game/app/options.h"

namespace luftpost::app {
namespace {
namespace fs = std::filesystem;
using nlohmann::json;
constexpr std::size_t kMostColumns = 65536;
constexpr std::size_t kMostBytes = 16u << 20u;
constexpr double kMostPhotons = 1.0e12;

struct Case {
    sky::StepCloud cloud;
    std::int64_t photons = 0;
};

/// Reads the numbers of a case, each by its name; throws core::Error that says which and what was expected.
class CaseReader {
public:
    explicit CaseReader(fs::path const& file) : file_{file.string()} {
        try {
            values_ = json::parse(core::readFile(file, kMostBytes));
        } catch (json::parse_error const& error) {
            throw core::Error{file_, fmt::format("byte {}", error.byte), "expected JSON"};
        }
        if (!values_.is_object()) throw core::Error{file_, "", "expected an object"};
    }

    /// A number low..high; the ends themselves only where `ends`.
    double number(char const* name, double low, double high, bool ends) const {
        json const& value = member(name);
        double const number = value.is_number() ? value.get<double>() : low - 1.0;
        bool const inside = ends ? number >= low && number <= high : number > low && number < high;
        if (!inside) fail(name, fmt::format("expected a number {}{}..{}, found {}", ends ? "" : "between ", low, high, value.dump()));
        return number;
    }
    std::vector<double> depths() const {
        json const& value = member("columns");
        if (!value.is_array() || value.empty() || value.size() > kMostColumns)
            fail("columns", fmt::format("expected 1..{} optical depths", kMostColumns));
        std::vector<double> depths;
        for (json const& one : value) {
            if (!one.is_number() || !(one.get<double>() >= 0.0) || one.get<double>() > 1.0e5)
                fail(fmt::format("columns[{}]", depths.size()), fmt::format("expected an optical depth 0..100000, found {}", one.dump()));
            depths.push_back(one.get<double>());
        }
        return depths;
    }
    std::int64_t count(char const* name) const {
        double const value = number(name, 1.0, kMostPhotons, true);
        if (value != std::floor(value)) fail(name, fmt::format("expected a whole number, found {}", member(name).dump()));
        return static_cast<std::int64_t>(value);
    }

private:
    json const& member(char const* name) const {
        auto const found = values_.find(name);
        if (found == values_.end()) fail(name, "expected, but not there");
        return *found;
    }
    [[noreturn]] void fail(std::string const& place, std::string const& expected) const { throw core::Error{file_, place, expected}; }

    std::string file_;
    json values_;
};

Case readCase(fs::path const& file) {
    CaseReader const reader{file};
    Case result;
    result.cloud.depths = reader.depths();
    result.cloud.width = 1000.0 * reader.number("width_km", 0.0, 1.0e6, false);
    result.cloud.thickness = 1000.0 * reader.number("thickness_km", 0.0, 1.0e6, false);
    result.cloud.g = reader.number("g", -1.0, 1.0, false);
    result.cloud.albedo = reader.number("albedo", 0.0, 1.0, true);
    double const zenith = reader.number("sun_zenith_deg", -90.0, 90.0, false);
    result.cloud.sunZenith = core::radians(zenith);
    result.photons = reader.count("photons");
    return result;
}

int runReference(fs::path const& file, fs::path const& output, CommonOptions const& common) {
    Case const asked = readCase(file);
    core::checkOutputFolder("--json", output);
    auto const start = std::chrono::steady_clock::now();
    auto const fluxes = sky::photonFluxes(asked.cloud, asked.photons, common.seed.value_or(1u), toolWorkers());
    std::chrono::duration<double> const seconds = std::chrono::steady_clock::now() - start;
    json const result{{"reflectance", fluxes.reflectance}, {"transmittance", fluxes.transmittance},
                      {"absorptance", fluxes.absorptance}, {"seconds", seconds.count()}};
    core::writeFileAtomically(output, result.dump(1) + "\n");
    return 0;
}
}  // namespace

void addReferenceCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    struct Texts {
        fs::path file, output;
    };
    auto const texts = std::make_shared<Texts>();
    CLI::App* reference = app.add_subcommand("reference", "the path tracer on a textbook cloud of columns");
    reference->add_option("--case", texts->file, "FILE.json: columns, width_km, thickness_km, g, albedo, sun_zenith_deg, photons")->required();
    reference->add_option("--json", texts->output, "FILE: reflectance, transmittance and absorptance of each column")->required();
    reference->callback([texts, &common, &chosen] { chosen = [texts, &common] { return runReference(texts->file, texts->output, common); }; });
}
}  // namespace luftpost::app
