#include "game/app/player_files.h"

#include <utility>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "engine/platform/paths.h"
#include "game/app/play_options.h"

namespace luftpost::app {
namespace {
namespace fs = std::filesystem;

/// The player's settings first, then what the command line says, as before.
void readSettingsBelowCommandLine(CommonOptions& common, fs::path const& file) {
    Settings settings;
    core::SettingList list = settingList(settings);
    for (std::string const& line : core::readPlayerSettings(list, file).lines) fmt::print("{}\n", line);
    if (!common.settingsFile.empty()) core::readSettings(list, common.settingsFile);
    for (std::string const& assignment : common.assignments) core::assignSetting(list, "--set", assignment);
    common.settings = settings;
}

/// The player's folders are made with the first file in them.
void makeFolderOf(fs::path const& file) {
    std::error_code ignored;
    fs::create_directories(file.parent_path(), ignored);
}
}  // namespace

void usePlayerFiles(CommonOptions& common, RunOptions& run) {
    run.settingsFile = platform::configFolder() / "settings.toml";
    if (run.save.empty()) run.save = platform::dataFolder() / "save.json";
    readSettingsBelowCommandLine(common, run.settingsFile);
    if (!common.seed) common.seed = loadCareer(run.save).seed;
}

StoredSettings::StoredSettings(fs::path file) : file_{std::move(file)}, list_{settingList(settings_)} {
    if (!file_.empty()) notes_ = core::readPlayerSettings(list_, file_);
}

void StoredSettings::change(std::string_view key, core::SettingValue const& value) {
    core::Setting* const setting = core::findSetting(list_, key);
    CHECK(setting, "no setting {}", key);
    setting->set(value);
    changed_ = true;
}

void StoredSettings::write() {
    if (!std::exchange(changed_, false) || file_.empty()) return;
    makeFolderOf(file_);
    core::writeSettings(list_, notes_, file_);
}

bool countParcel(delivery::Career& career, Simulation const& simulation, FlightEventAt const& event) {
    if (event.event != FlightEvent::delivered && event.event != FlightEvent::lost) return false;
    delivery::Drop const& drop = simulation.delivery().drops().back();
    career.seed = simulation.world().land().seed();
    if (!drop.delivered) {
        ++career.parcelsLost;
        return true;
    }
    ++career.deliveries;
    career.score += drop.score;
    if (career.bestDistance_m < 0.0 || drop.distance < career.bestDistance_m)
        career.bestDistance_m = drop.distance;
    return true;
}

delivery::Career namedCareer(fs::path const& file) {
    std::error_code ignored;
    if (!fs::is_regular_file(file, ignored) || fs::is_empty(file, ignored)) return {};
    return delivery::parseCareer(core::readFile(file), file.string());
}

delivery::Career loadCareer(fs::path const& file) {
    try {
        return namedCareer(file);
    } catch (core::Error const& error) {
        std::error_code ignored;
        fs::rename(file, file.string() + ".bad", ignored);
        fmt::print("{}; set aside as {}.bad\n", error.what(), file.string());
        return {};
    }
}

void saveCareer(fs::path const& file, delivery::Career const& career) {
    makeFolderOf(file);
    core::writeFileAtomically(file, delivery::careerText(career));
}
}  // namespace luftpost::app
