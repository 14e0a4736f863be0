// The programs made from shaders/pass, with hot reload.
#pragma once
#include <deque>
#include <filesystem>
#include <functional>
#include <map>
#include <string>
#include <vector>

#include "engine/gl/program.h"

namespace luftpost::gl {
/// Names of files in shaders/pass without their endings; an empty geometry stage is left out.
struct GraphicsStages {
    std::string vertex, fragment, geometry;
};

/// Loads programs from the data's shaders folder. References stay good as long as the library lives; a reload swaps
/// the program behind them.
class ProgramLibrary {
public:
    using Defines = std::vector<std::string>;  // "NAME VALUE"
    enum class Compiling {
        oneByOne,  // what is asked for is ready, or throws
        together   // until finish() all programs are begun and none is waited for
    };

    explicit ProgramLibrary(Compiling compiling = Compiling::oneByOne) : compiling_{compiling} {}
    using Progress = std::function<void(std::size_t ready, std::size_t all)>;
    /// Waits for all programs that were begun and says how far it is; from here on they are made one by one. Throws core::Error.
    void finish(Progress const& progress = {});

    /// shaders/pass/NAME.vert, NAME.frag and, if there is one, NAME.geom. Throws core::Error.
    Program const& graphics(std::string const& name, Defines const& defines = {});
    /// Any mixture; "fullscreen" is the vertex stage that covers the screen with one triangle. Throws core::Error.
    Program const& graphics(GraphicsStages const& stages, Defines const& defines = {});
    /// shaders/pass/NAME.comp. Throws core::Error.
    Program const& compute(std::string const& name, Defines const& defines = {});

    /// Looks at the times of all files that went into the programs; programs whose files changed are made again. A
    /// program that then does not compile stays as it was, and the log says why. Never throws; cheap enough for once
    /// a second. Returns how many programs were swapped.
    int reloadChanged();

    std::size_t size() const { return entries_.size(); }

private:
    using Times = std::map<std::filesystem::path, std::filesystem::file_time_type>;
    struct StageFile {
        Stage stage;
        std::string file;
    };
    struct Entry {
        std::string name;
        std::vector<StageFile> stages;
        Defines defines;
        Program program;
        Times times;
    };

    Program const& find(std::vector<StageFile> stages, Defines const& defines);
    static std::vector<ShaderText> read(Entry& entry);
    static Program build(Entry& entry) { return Program{read(entry), entry.name}; }
    static bool changed(Entry const& entry);

    Compiling compiling_;
    std::deque<Entry> entries_;
};
}  // namespace luftpost::gl
