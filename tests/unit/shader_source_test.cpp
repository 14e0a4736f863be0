// The include resolver of the shaders: string code, no GL.
#include "engine/assets/shader_source.h"

#include <gtest/gtest.h>

#include <map>

#include "engine/core/error.h"

namespace {
using namespace luftpost;
using Files = std::map<std::string, std::string>;

assets::ShaderSource resolve(Files const& files, std::string const& file, std::vector<std::string> const& defines = {}) {
    return assets::resolveShader(
        file,
        [&](std::string const& name) {
            auto const found = files.find(name);
            if (found == files.end()) throw core::Error{name, "", "expected a shader here"};
            return found->second;
        },
        defines);
}

std::string errorOf(Files const& files, std::string const& file) {
    try {
        resolve(files, file);
    } catch (core::Error const& error) {
        return error.what();
    }
    return "";
}

TEST(ShaderSource, PutsTheIncludedTextInPlaceWithLineMarks) {
    auto const source = resolve({{"pass/a.frag", "#version 450 core\n#include \"lib/b.glsl\"\nvoid main() {}\n"},
                                 {"lib/b.glsl", "float b;\n"}},
                                "pass/a.frag");
    EXPECT_EQ(source.text, "#version 450 core\n#line 2 0\n#line 1 1\nfloat b;\n#line 3 0\nvoid main() {}\n");
    EXPECT_EQ(source.files, (std::vector<std::string>{"pass/a.frag", "lib/b.glsl"}));
}

TEST(ShaderSource, IncludesAFileOnceAndKnowsAllSpellings) {
    auto const source = resolve({{"pass/a", "#include \"lib/b.glsl\"\n#include \"shaders/lib/b.glsl\"\n#include \"../lib/b.glsl\"\n"},
                                 {"lib/b.glsl", "#pragma once\n#include <cmath>\nfloat b;\n"}},
                                "pass/a");
    EXPECT_EQ(source.text.find("float b;"), source.text.rfind("float b;"));
    EXPECT_EQ(source.text.find("cmath"), std::string::npos);
    EXPECT_EQ(source.text.find("once"), std::string::npos);
}

TEST(ShaderSource, NamesTheChainOfACycle) {
    std::string const error =
        errorOf({{"a", "#include \"b\"\n"}, {"b", "\n#include \"c\"\n"}, {"c", "#include \"a\"\n"}}, "a");
    EXPECT_NE(error.find("a -> b -> c -> a"), std::string::npos) << error;
    EXPECT_NE(error.find("c: line 1"), std::string::npos) << error;
}

TEST(ShaderSource, RefusesAnIncludeWithoutAFileName) {
    EXPECT_NE(errorOf({{"a", "\n#include b\n"}}, "a").find("a: line 2"), std::string::npos);
    EXPECT_NE(errorOf({{"a", "#include \"b\n"}}, "a").find("a: line 1"), std::string::npos);
    EXPECT_NE(errorOf({{"a", "#include\n"}}, "a").find("a: line 1"), std::string::npos);
    EXPECT_NE(errorOf({{"a", "#include \"gone\"\n"}}, "a").find("gone"), std::string::npos);
}

TEST(ShaderSource, PutsDefinesBehindTheVersion) {
    auto const source = resolve({{"a", "// head\n#version 450 core\nint x = N;\n"}}, "a", {"N 3"});
    EXPECT_EQ(source.text, "// head\n#version 450 core\n#define N 3\n#line 3 0\nint x = N;\n");
}

TEST(ShaderSource, TakesTextWithoutALastLineBreak) {
    auto const source = resolve({{"a", "#include \"b\""}, {"b", "x"}}, "a");
    EXPECT_EQ(source.text, "#line 1 1\nx\n#line 2 0\n");
}

TEST(ShaderSource, NamesOurFilesInMessagesOfEveryDriver) {
    std::vector<std::string> const files{"pass/a.frag", "lib/b.glsl"};
    EXPECT_EQ(assets::namedMessages("1:12(5): error: no", files), "shaders/lib/b.glsl:12(5): error: no");
    EXPECT_EQ(assets::namedMessages("0(7) : error C1: no", files), "shaders/pass/a.frag:7 : error C1: no");
    EXPECT_EQ(assets::namedMessages("ERROR: 1:3: no\nlinker: no\n", files),
              "ERROR: shaders/lib/b.glsl:3: no\nlinker: no\n");
    EXPECT_EQ(assets::namedMessages("9:12(5): error", files), "9:12(5): error");
}
}  // namespace
