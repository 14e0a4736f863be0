#include "engine/gl/program_library.h"

#include <spdlog/spdlog.h>

#include <fstream>
#include <iterator>

#include "engine/core/error.h"
#include "engine/platform/paths.h"

namespace luftpost::gl {
namespace {
namespace fs = std::filesystem;

std::string readText(fs::path const& file) {
    std::ifstream in{file, std::ios::binary};
    if (!in) throw core::Error{file.string(), "", "expected a shader that can be read"};
    return {std::istreambuf_iterator<char>{in}, {}};
}
}  // namespace

std::vector<ShaderText> ProgramLibrary::read(Entry& entry) {
    Times times;
    auto const readOne = [&](std::string const& relative) {
        fs::path const file = platform::dataFile("shaders/" + relative);
        std::error_code error;
        times[file] = fs::last_write_time(file, error);
        return readText(file);
    };
    std::vector<ShaderText> texts;
    try {
        for (StageFile const& stage : entry.stages)
            texts.push_back({stage.stage, assets::resolveShader(stage.file, readOne, entry.defines)});
    } catch (core::Error const&) {
        entry.times.insert(times.begin(), times.end());
        throw;
    }
    entry.times = times;
    return texts;
}

void ProgramLibrary::finish(Progress const& progress) {
    compiling_ = Compiling::oneByOne;
    std::size_t ready = 0;
    for (Entry& entry : entries_) {
        if (progress) progress(ready++, entries_.size());
        entry.program.finish();
    }
}

bool ProgramLibrary::changed(Entry const& entry) {
    for (auto const& [file, time] : entry.times) {
        std::error_code error;
        fs::file_time_type const now = fs::last_write_time(file, error);
        if (!error && now != time) return true;
    }
    return false;
}

Program const& ProgramLibrary::find(std::vector<StageFile> stages, Defines const& defines) {
    Entry entry;
    for (StageFile const& stage : stages) entry.name += (entry.name.empty() ? "" : " + ") + stage.file;
    for (std::string const& define : defines) entry.name += " " + define;
    for (Entry const& known : entries_)
        if (known.name == entry.name) return known.program;
    entry.stages = std::move(stages);
    entry.defines = defines;
    entry.program = compiling_ == Compiling::together ? Program::begun(read(entry), entry.name) : build(entry);
    return entries_.emplace_back(std::move(entry)).program;
}

Program const& ProgramLibrary::graphics(std::string const& name, Defines const& defines) {
    std::error_code error;
    fs::path const vertex = platform::dataFile("shaders/pass/" + name + ".vert");
    bool const geometry = fs::exists(fs::path{vertex}.replace_extension(".geom"), error);
    return graphics(GraphicsStages{name, name, geometry ? name : ""}, defines);
}

Program const& ProgramLibrary::graphics(GraphicsStages const& stages, Defines const& defines) {
    std::vector<StageFile> files{{Stage::vertex, "pass/" + stages.vertex + ".vert"}};
    if (!stages.geometry.empty()) files.push_back({Stage::geometry, "pass/" + stages.geometry + ".geom"});
    if (!stages.fragment.empty()) files.push_back({Stage::fragment, "pass/" + stages.fragment + ".frag"});
    return find(std::move(files), defines);
}

Program const& ProgramLibrary::compute(std::string const& name, Defines const& defines) {
    return find({{Stage::compute, "pass/" + name + ".comp"}}, defines);
}

int ProgramLibrary::reloadChanged() {
    int swapped = 0;
    for (Entry& entry : entries_) {
        if (!changed(entry)) continue;
        try {
            entry.program = build(entry);
            spdlog::info("reloaded {}", entry.name);
            ++swapped;
        } catch (std::exception const& error) {
            for (auto& [file, time] : entry.times) {  // asked again only when a file changes again
                std::error_code ignored;
                time = fs::last_write_time(file, ignored);
            }
            spdlog::error("kept the last good {}: {}", entry.name, error.what());
        }
    }
    return swapped;
}
}  // namespace luftpost::gl
