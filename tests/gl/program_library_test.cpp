// Programs from files: errors name our files and lines; hot reload keeps the last good program.
#include "engine/gl/program_library.h"

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <vector>

#include "engine/core/error.h"
#include "engine/gl/draw.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/texture.h"
#include "tests/gl/gl_fixture.h"
#include "tests/support/scratch.h"

namespace {
namespace fs = std::filesystem;
using namespace luftpost;

/// A data folder of its own with a fullscreen program whose colour comes from an included file.
class ProgramLibrary : public test::GlTest {
protected:
    void SetUp() override {
        fs::create_directories(root_ / "shaders/pass");
        fs::create_directories(root_ / "shaders/lib");
        fs::copy_file(fs::path{LUFTPOST_SOURCE_DIR} / "shaders/pass/fullscreen.vert",
                      root_ / "shaders/pass/fullscreen.vert", fs::copy_options::overwrite_existing);
        write("pass/colour.frag",
              "#version 450 core\n#include \"lib/value.glsl\"\nlayout(location = 0) out vec4 colour;\n"
              "void main() { colour = vec4(value()); }\n");
        writeValue("1.0");
        setenv("LUFTPOST_DATA", root_.c_str(), 1);
    }
    void TearDown() override {
        unsetenv("LUFTPOST_DATA");
        GlTest::TearDown();
    }
    void write(std::string const& name, std::string const& text) {
        fs::path const file = root_ / "shaders" / name;
        std::ofstream{file} << text;
        fs::last_write_time(file, fs::last_write_time(file) + std::chrono::seconds{++age_});
    }
    void writeValue(std::string const& value) { write("lib/value.glsl", "float value() {\n    return " + value + ";\n}\n"); }
    float drawn(gl::Program const& program) {
        gl::Texture2D const target{gl::Format::r32f, {1, 1}};
        gl::Framebuffer const framebuffer{{&target}, nullptr};
        framebuffer.bind();
        gl::apply({});
        program.use();
        gl::drawFullscreen();
        return target.readFloats()[0];
    }

    fs::path const root_ = tests::scratch();
    int age_ = 0;
};

TEST_F(ProgramLibrary, SwapsAProgramWhoseIncludedFileChanged) {
    gl::ProgramLibrary library;
    gl::Program const& program = library.graphics({"fullscreen", "colour", ""});
    EXPECT_EQ(&program, &library.graphics({"fullscreen", "colour", ""}));
    EXPECT_EQ(drawn(program), 1.0f);
    EXPECT_EQ(library.reloadChanged(), 0);
    writeValue("2.0");
    EXPECT_EQ(library.reloadChanged(), 1);
    EXPECT_EQ(drawn(program), 2.0f);
}

TEST_F(ProgramLibrary, KeepsTheLastGoodProgram) {
    gl::ProgramLibrary library;
    gl::Program const& program = library.graphics({"fullscreen", "colour", ""});
    writeValue("broken");
    EXPECT_EQ(library.reloadChanged(), 0);
    EXPECT_EQ(drawn(program), 1.0f);
    writeValue("3.0");
    EXPECT_EQ(library.reloadChanged(), 1);
    EXPECT_EQ(drawn(program), 3.0f);
}

TEST_F(ProgramLibrary, NamesTheFileAndLineOfACompileError) {
    writeValue("broken");
    gl::ProgramLibrary library;
    try {
        library.graphics({"fullscreen", "colour", ""});
        FAIL() << "expected a core::Error";
    } catch (core::Error const& error) {
        EXPECT_NE(std::string{error.what()}.find("shaders/lib/value.glsl:2"), std::string::npos) << error.what();
    }
}

// Programs that are compiled side by side: all are good after finish(), which counts them and names what is wrong.
TEST_F(ProgramLibrary, WaitsForAllThatWereBegun) {
    gl::ProgramLibrary library{gl::ProgramLibrary::Compiling::together};
    gl::Program const& one = library.graphics({"fullscreen", "colour", ""});
    write("pass/defined.frag", "#version 450 core\nlayout(location = 0) out float colour;\nvoid main() { colour = VALUE; }\n");
    gl::Program const& other = library.graphics({"fullscreen", "defined", ""}, {"VALUE 4.0"});
    std::vector<std::size_t> seen;
    library.finish([&](std::size_t ready, std::size_t all) {
        EXPECT_EQ(all, 2u);
        seen.push_back(ready);
    });
    EXPECT_EQ(seen, (std::vector<std::size_t>{0, 1}));
    EXPECT_EQ(drawn(one), 1.0f);
    EXPECT_EQ(drawn(other), 4.0f);
    EXPECT_EQ(drawn(library.graphics({"fullscreen", "defined", ""}, {"VALUE 5.0"})), 5.0f);
}

TEST_F(ProgramLibrary, NamesWhatWasBegunAndDoesNotCompile) {
    writeValue("broken");
    gl::ProgramLibrary library{gl::ProgramLibrary::Compiling::together};
    library.graphics({"fullscreen", "colour", ""});
    try {
        library.finish();
        FAIL() << "expected a core::Error";
    } catch (core::Error const& error) {
        EXPECT_NE(std::string{error.what()}.find("shaders/lib/value.glsl:2"), std::string::npos) << error.what();
    }
}

TEST_F(ProgramLibrary, SaysWhichShaderIsMissing) {
    gl::ProgramLibrary library;
    try {
        library.compute("nowhere");
        FAIL() << "expected a core::Error";
    } catch (core::Error const& error) {
        EXPECT_NE(std::string{error.what()}.find("shaders/pass/nowhere.comp"), std::string::npos) << error.what();
    }
}

TEST_F(ProgramLibrary, MakesADifferentProgramForOtherDefines) {
    write("pass/defined.frag",
          "#version 450 core\nlayout(location = 0) out float colour;\nvoid main() { colour = VALUE; }\n");
    gl::ProgramLibrary library;
    EXPECT_EQ(drawn(library.graphics({"fullscreen", "defined", ""}, {"VALUE 4.0"})), 4.0f);
    EXPECT_EQ(drawn(library.graphics({"fullscreen", "defined", ""}, {"VALUE 5.0"})), 5.0f);
}
}  // namespace
