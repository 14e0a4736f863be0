// Every shader file of the product: strict GLSL 4.50 core by glslangValidator; every shared block laid out by the
// driver as C++ lays it out.
#include <fmt/format.h>

#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <map>
#include <regex>
#include <string>
#include <vector>

#include "engine/assets/shader_source.h"
#include "engine/core/file.h"
#include "engine/gl/program.h"
#include "shaders/shared/cloud.glsl.h"
#include "shaders/shared/falling.glsl.h"
#include "shaders/shared/frame.glsl.h"
#include "shaders/shared/sky_block.glsl.h"
#include "shaders/shared/terrain.glsl.h"
#include "tests/gl/gl_fixture.h"
#include "tests/support/scratch.h"

namespace {
namespace fs = std::filesystem;
using namespace luftpost;

fs::path const kShaders = fs::path{LUFTPOST_SOURCE_DIR} / "shaders";

assets::ShaderSource resolved(std::string const& file, std::vector<std::string> const& defines = {}) {
    return assets::resolveShader(file, [](std::string const& name) { return core::readFile(kShaders / name); }, defines);
}

/// Runs a command; its exit status and all it printed.
std::pair<int, std::string> run(std::string const& command) {
    std::string output;
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    if (!pipe) return {-1, "popen"};
    char chunk[512];
    while (std::size_t const got = std::fread(chunk, 1, sizeof chunk, pipe)) output.append(chunk, got);
    return {pclose(pipe), output};
}

/// Two samplers of one program on one unit read the same texture, whatever each was meant to: no driver has to say so.
TEST(ShaderFiles, GiveEachSamplerOfAProgramAUnitOfItsOwn) {
    std::regex const sampler{R"(layout\(binding = (\d+)\) uniform [iu]?sampler\w+ (\w+))"};
    int count = 0;
    for (auto const& entry : fs::directory_iterator{kShaders / "pass"}) {
        std::string const name = entry.path().filename().string(), text = resolved("pass/" + name).text;
        std::map<int, std::string> owners;
        for (std::sregex_iterator at{text.begin(), text.end(), sampler}, end; at != end; ++at, ++count) {
            auto const [owner, isNew] = owners.emplace(std::stoi((*at)[1]), (*at)[2]);
            EXPECT_TRUE(isNew) << name << ": " << owner->second << " and " << (*at)[2] << " on unit " << (*at)[1];
        }
    }
    EXPECT_GT(count, 50);
}

TEST(ShaderFiles, AreStrictCoreGlsl) {
    ASSERT_EQ(run("glslangValidator --version").first, 0) << "expected glslangValidator (Debian: glslang-tools)";
    fs::path const& folder = tests::scratch();
    int count = 0;
    auto const check = [&](std::string const& name, assets::ShaderSource const& source) {
        EXPECT_TRUE(source.text.starts_with("#version 450 core\n")) << name;
        fs::path const file = folder / name;
        std::ofstream{file} << source.text;
        auto const [status, output] = run(fmt::format("glslangValidator {}", file.string()));
        EXPECT_EQ(status, 0) << name << "\n" << assets::namedMessages(output, source.files);
        ++count;
    };
    for (auto const& entry : fs::directory_iterator{kShaders / "pass"}) {
        std::string const name = entry.path().filename().string();
        assets::ShaderSource const source = resolved("pass/" + name);
        check(name, source);
        if (source.text.find("CLOUD_TOWERS") != std::string::npos) check(name, resolved("pass/" + name, {"CLOUD_TOWERS false"}));
    }
    EXPECT_GT(count, 20);
}

struct Member {
    std::string type, name, count;  // count: "" for no array, else a number or a constant's name
};

std::vector<Member> members(std::string const& body) {
    std::vector<Member> found;
    std::regex const member{R"((\w+)\s+(\w+)\s*(?:\[(\w+)\])?\s*;)"};
    std::string const plain = std::regex_replace(body, std::regex{R"(//[^\n]*)"}, "");
    for (std::sregex_iterator it{plain.begin(), plain.end(), member}, end; it != end; ++it)
        found.push_back({(*it)[1], (*it)[2], (*it)[3]});
    return found;
}

/// A header's blocks with their bodies, and the structs that they are made of.
struct Header {
    std::map<std::string, std::string> blocks, instances, structs, constants;

    explicit Header(std::string const& text) {
        std::regex const block{R"(UNIFORM_BLOCK\((\w+),\s*\d+\)\s*\{([^}]*)\}\s*BLOCK_NAME\((\w+)\))"};
        for (std::sregex_iterator it{text.begin(), text.end(), block}, end; it != end; ++it) {
            blocks[(*it)[1]] = (*it)[2];
            instances[(*it)[1]] = (*it)[3];
        }
        std::regex const structure{R"(struct\s+(\w+)\s*\{([^}]*)\})"};
        for (std::sregex_iterator it{text.begin(), text.end(), structure}, end; it != end; ++it)
            structs[(*it)[1]] = (*it)[2];
        std::regex const constant{R"(GLSL_CONST int (\w+) = (\d+);)"};
        for (std::sregex_iterator it{text.begin(), text.end(), constant}, end; it != end; ++it)
            constants[(*it)[1]] = (*it)[2];
    }

    /// How often a member stands there; 1 for no array.
    int count(Member const& member) const {
        if (member.count.empty()) return 1;
        auto const constant = constants.find(member.count);
        return std::stoi(constant == constants.end() ? member.count : constant->second);
    }

    /// Names as the driver knows them, each with its offset by C++'s rules: members of 16 or 64 bytes one after another.
    void leaves(std::string const& body, std::string const& prefix, int& offset,
                std::vector<std::pair<std::string, int>>& found) const {
        static std::map<std::string, int> const kBytes{{"vec4", 16}, {"ivec4", 16}, {"uvec4", 16}, {"mat4", 64}};
        for (Member const& member : members(body)) {
            if (auto const structure = structs.find(member.type); structure != structs.end()) {
                for (int i = 0; i < count(member); ++i)
                    leaves(structure->second, prefix + member.name + (member.count.empty() ? "." : fmt::format("[{}].", i)),
                           offset, found);
                continue;
            }
            ASSERT_TRUE(kBytes.contains(member.type)) << member.type << " " << member.name << ": only vec4, ivec4, mat4";
            found.emplace_back(prefix + member.name + (member.count.empty() ? "" : "[0]"), offset);
            offset += kBytes.at(member.type) * count(member);
        }
    }
};

class SharedBlocks : public test::GlTest {};

/// What C++ says of the blocks it has.
std::map<std::string, std::size_t> const kSizes{{"FrameBlock", sizeof(glsl::FrameBlock)},
                                                {"SkyBlock", sizeof(glsl::SkyBlock)},
                                                {"CloudBlock", sizeof(glsl::CloudBlock)},
                                                {"LandBlock", sizeof(glsl::LandBlock)},
                                                {"FallBlock", sizeof(glsl::FallBlock)}};

TEST_F(SharedBlocks, LieInTheDriverAsInCpp) {
    std::map<std::string, bool> seen;
    for (auto const& entry : fs::directory_iterator{kShaders / "shared"}) {
        std::string const file = "shared/" + entry.path().filename().string();
        Header const header{resolved(file).text};
        for (auto const& [block, body] : header.blocks) {
            seen[block] = true;
            int bytes = 0;
            std::vector<std::pair<std::string, int>> leaves;
            header.leaves(body, block + ".", bytes, leaves);
            std::string const text = fmt::format(
                "#version 450 core\n#include \"{}\"\nlayout(local_size_x = 1) in;\n"
                "layout(std430, binding = 0) buffer Result {{ vec4 value; }} result;\nvoid main() {{ result.value = vec4({}.{}[0]); }}\n",
                file, header.instances.at(block), leaves.front().first.substr(block.size() + 1));
            gl::ShaderText const shader{gl::Stage::compute, assets::resolveShader("probe", [&](std::string const& name) {
                                            return name == "probe" ? text : core::readFile(kShaders / name);
                                        })};
            gl::Program const program{std::span{&shader, 1}, block};
            for (auto const& [name, offset] : leaves) EXPECT_EQ(program.uniformOffset(name), offset) << name;
            EXPECT_EQ(program.uniformBlockBytes(block), bytes) << block;
            ASSERT_TRUE(kSizes.contains(block)) << block << ": name its C++ size in kSizes";
            EXPECT_EQ(kSizes.at(block), static_cast<std::size_t>(bytes)) << block;
        }
    }
    for (auto const& [block, size] : kSizes) EXPECT_TRUE(seen[block]) << block;
}
}  // namespace
