#include "game/app/run.h"

#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <algorithm>

#include "engine/core/error.h"
#include "game/app/commands.h"

namespace luftpost::app {
namespace {
/// The common options as the command line has them.
struct CommonTexts {
    std::string place, time, seed, size;
};

void addCommonOptions(CLI::App& app, CommonOptions& common, CommonTexts& texts) {
    app.add_option("--weather", common.weather,
                   "recorded:FILE, live or preset:NAME (default: the bundled recording)");
    app.add_option("--place", texts.place, "LAT,LON[,ALT_M] (default: the recording's first site)");
    app.add_option("--time", texts.time, "UTC, as 2021-06-28T16:00Z");
    app.add_option("--seed", texts.seed, "of the land and the jobs");
    app.add_option("--size", texts.size, "WIDTHxHEIGHT of picture or window (default 1280x720)");
    app.add_option("--settings", common.settingsFile, "TOML file of settings");
    app.add_option("--set", common.assignments, "key=value of one setting; may be repeated")
        ->allow_extra_args(false);
    app.fallthrough();
    app.require_subcommand(0, 1);
}

void readCommonOptions(CommonOptions& common, CommonTexts const& texts) {
    if (!texts.place.empty()) common.place = placeOption("--place", texts.place);
    if (!texts.time.empty()) common.time = timeOption("--time", texts.time);
    if (!texts.seed.empty())
        common.seed = static_cast<unsigned>(wholeOption("--seed", texts.seed, 0, 4294967295));
    if (!texts.size.empty()) common.size = sizeOption("--size", texts.size);
    core::SettingList list = settingList(common.settings);
    if (!common.settingsFile.empty()) core::readSettings(list, common.settingsFile);
    for (std::string const& assignment : common.assignments) core::assignSetting(list, "--set", assignment);
}

/// A library's or a driver's text of several lines, as the contract wants it.
std::string inOneLine(std::string text) {
    while (text.ends_with('\n')) text.pop_back();
    std::replace(text.begin(), text.end(), '\n', ' ');
    return text;
}

/// CLI11's complaint; the nearest option is named for an unknown one.
std::string complaint(CLI::App const& app, CLI::ParseError const& error) {
    std::string const message = error.what();
    if (error.get_exit_code() != static_cast<int>(CLI::ExitCodes::ExtrasError)) return message;
    auto const chosen = app.get_subcommands();
    std::vector<CLI::Option const*> known = app.get_options();
    if (!chosen.empty())
        for (CLI::Option const* option : static_cast<CLI::App const*>(chosen.front())->get_options())
            known.push_back(option);
    std::vector<std::string> names;
    for (CLI::Option const* option : known) names.push_back(option->get_name());
    std::vector<std::string> const unknown = app.remaining(true);
    if (unknown.empty() || !unknown.front().starts_with("-")) return message;
    return fmt::format("{}: no such option; the nearest known is {}", unknown.front(),
                       core::nearestText(names, unknown.front()));
}

/// No option of the program takes an empty text: a file, a number or a name is missing there.
void refuseEmptyValues(CLI::App const& app) {
    for (CLI::Option const* option : app.get_options())
        for (std::string const& value : option->results())
            if (value.empty()) throw core::Error{option->get_name(), "", "expected a value, found nothing"};
    for (CLI::App const* command : app.get_subcommands()) refuseEmptyValues(*command);
}

/// The arguments, with `play` put in where no command is named.
std::vector<std::string> argumentsOf(int argc, char** argv) {
    std::vector<std::string> arguments{argv + 1, argv + argc};
    bool const asksForHelp = !arguments.empty() && (arguments[0] == "--help" || arguments[0] == "-h");
    if (arguments.empty() || (arguments[0].starts_with("-") && !asksForHelp))
        arguments.insert(arguments.begin(), "play");
    return arguments;
}

void checkCommand(CLI::App const& app, std::string const& name) {
    std::vector<std::string> names;
    for (CLI::App const* command : app.get_subcommands([](CLI::App const*) { return true; }))
        names.push_back(command->get_name());
    if (name.starts_with("-") || std::find(names.begin(), names.end(), name) != names.end()) return;
    throw core::Error{name, "", fmt::format("no such command; expected one of {}", fmt::join(names, ", "))};
}

int runChosen(int argc, char** argv) {
    CLI::App app{"Luftpost: air mail over an endless land, in the weather that is really there", "luftpost"};
    CommonOptions common;
    CommonTexts texts;
    Chosen chosen;
    addCommonOptions(app, common, texts);
    addCommands(app, common, chosen);
    for (CLI::App* command : app.get_subcommands([](CLI::App*) { return true; }))
        command->footer("and --weather --place --time --seed --size --settings --set: see luftpost --help");
    std::vector<std::string> arguments = argumentsOf(argc, argv);
    checkCommand(app, arguments.front());
    std::reverse(arguments.begin(), arguments.end());  // CLI11 takes them from the back
    try {
        app.parse(arguments);
    } catch (CLI::Success const& help) {
        return app.exit(help);
    } catch (CLI::ParseError const& error) {
        throw core::Error{"luftpost", "", complaint(app, error)};
    }
    refuseEmptyValues(app);
    readCommonOptions(common, texts);
    return chosen();
}
}  // namespace

int run(int argc, char** argv) {
    try {
        return runChosen(argc, argv);
    } catch (core::Error const& error) {
        fmt::print(stderr, "{}\n", inOneLine(error.what()));
        return 2;
    }
}
}  // namespace luftpost::app
