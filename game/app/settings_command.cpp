// `luftpost settings`: every setting, with the value that file and command line give it, or the page of the
// docs.
#include <fmt/format.h>

#include <CLI/CLI.hpp>
#include <memory>

#include "game/app/commands.h"

namespace luftpost::app {
namespace {
void printValues(Settings settings) {
    for (core::Setting const& setting : settingList(settings))
        fmt::print("{:<26} {:<8} {:<34} {}\n", setting.key, isSecret(setting.key) && setting.get() != setting.initial ? "(hidden)" : core::settingText(setting.get()),
                   core::expectedValue(setting), setting.help);
}
}  // namespace

void addSettingsCommand(CLI::App& app, CommonOptions const& common, Chosen& chosen) {
    auto const markdown = std::make_shared<bool>(false);
    CLI::App* const command = app.add_subcommand("settings", "every setting: its value, its range, its help");
    command->add_flag("--markdown", *markdown, "the page docs/settings.md, with the defaults");
    command->callback([markdown, &common, &chosen] {
        chosen = [markdown, &common] {
            if (*markdown)
                fmt::print("{}", settingsPage());
            else
                printValues(common.settings);
            return 0;
        };
    });
}
}  // namespace luftpost::app
