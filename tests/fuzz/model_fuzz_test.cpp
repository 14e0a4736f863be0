// Broken glTF and PNG files: whatever a file holds, reading it gives a model or a core::Error with one line, never
// a crash. Every index and offset of the product's own models is broken here, thousands of ways, always the same ones.
#include <gtest/gtest.h>

#include <filesystem>
#include <random>
#include <string>
#include <vector>

#include "engine/assets/image.h"
#include "engine/assets/model.h"
#include "engine/core/error.h"
#include "engine/core/file.h"
#include "tests/support/scratch.h"

namespace {
namespace fs = std::filesystem;
using namespace luftpost;

fs::path const kModels = fs::path{LUFTPOST_SOURCE_DIR} / "assets/models";

/// True when the bytes were read, false when they were refused with a message that names the file.
bool readsModel(std::string const& bytes) {
    try {
        assets::Model const model = assets::decodeModel(bytes, "broken.glb");
        for (assets::Primitive const& primitive : model.primitives)
            for (std::uint32_t index : primitive.mesh.indices) EXPECT_LT(index, primitive.mesh.vertices.size());
        return true;
    } catch (core::Error const& error) {
        EXPECT_TRUE(std::string{error.what()}.starts_with("broken.glb")) << error.what();
        return false;
    }
}

bool readsImage(std::string const& bytes) {
    try {
        assets::Image const image = assets::decodeImage(bytes, "broken.png");
        EXPECT_EQ(image.values.size(), static_cast<std::size_t>(image.width * image.height * 4));
        return true;
    } catch (core::Error const& error) {
        EXPECT_TRUE(std::string{error.what()}.starts_with("broken.png")) << error.what();
        return false;
    }
}

std::uint32_t jsonLength(std::string const& glb) {
    std::uint32_t length = 0;
    for (int i = 3; i >= 0; --i) length = length << 8 | static_cast<unsigned char>(glb[static_cast<std::size_t>(12 + i)]);
    return length;
}

TEST(BrokenModels, OurOwnAreWhole) {
    int count = 0;
    for (auto const& entry : fs::directory_iterator{kModels})
        if (entry.path().extension() == ".glb") {
            EXPECT_TRUE(readsModel(core::readFile(entry.path()))) << entry.path();
            ++count;
        }
    EXPECT_GE(count, 4);
}

TEST(BrokenModels, CutAnywhereAreRefused) {
    std::string const whole = core::readFile(kModels / "drop_zone.glb");
    std::mt19937 random{1};
    for (int i = 0; i < 200; ++i) EXPECT_FALSE(readsModel(whole.substr(0, random() % whole.size())));
}

TEST(BrokenModels, WithBitsFlippedNeverCrash) {
    std::string const whole = core::readFile(kModels / "drop_zone.glb");
    std::uint32_t const json = jsonLength(whole);
    std::mt19937 random{2};
    int refused = 0;
    for (int i = 0; i < 1500; ++i) {
        std::string bytes = whole;
        // Mostly the JSON, where the indices and offsets stand; sometimes headers and vertices.
        std::size_t const at = i % 4 ? 20 + random() % json : random() % bytes.size();
        bytes[at] = static_cast<char>(bytes[at] ^ (1 << random() % 8));
        refused += !readsModel(bytes);
    }
    EXPECT_GT(refused, 100);
}

TEST(BrokenModels, WithDigitsReplacedNeverCrash) {
    std::string const whole = core::readFile(kModels / "drop_zone.glb");
    std::uint32_t const json = jsonLength(whole);
    int refused = 0, tried = 0;
    for (std::size_t at = 20; at < 20 + json; ++at) {
        if (whole[at] < '0' || whole[at] > '9') continue;
        std::string bytes = whole;
        bytes[at] = whole[at] == '9' ? '8' : '9';  // an index too large, an offset too far, a wrong type
        refused += !readsModel(bytes);
        ++tried;
    }
    EXPECT_GT(refused, tried / 20);
}

std::string triangle(std::string const& accessor, std::string const& more = "") {
    return R"({"asset":{"version":"2.0"},"scene":0,"scenes":[{"nodes":[0]}],"nodes":[{"mesh":0}],
        "meshes":[{"primitives":[{"attributes":{"POSITION":0}}]}],"accessors":[)" + accessor +
           R"(],"bufferViews":[{"buffer":0,"byteLength":36}],"buffers":[{"byteLength":36,"uri":"data:application/octet-stream;base64,)" +
           std::string(48, 'A') + "\"}]" + more + "}";
}

std::string complaint(std::string const& text) {
    try {
        assets::decodeModel(text, "t.gltf");
    } catch (core::Error const& error) {
        return error.what();
    }
    return "";
}

TEST(BrokenModels, AreToldWhereAndWhatWasExpected) {
    std::string const good = R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})";
    EXPECT_EQ(complaint(triangle(good)), "");
    auto const says = [&](std::string const& accessor, std::string const& part) {
        std::string const found = complaint(triangle(accessor));
        EXPECT_NE(found.find(part), std::string::npos) << found;
        EXPECT_NE(found.find("meshes[0].primitives[0].POSITION"), std::string::npos) << found;
    };
    says(R"({"bufferView":0,"componentType":5126,"count":4,"type":"VEC3"})", "expected 4 elements of 12 bytes");
    says(R"({"bufferView":7,"componentType":5126,"count":3,"type":"VEC3"})", "expected a number 0..0, found 7");
    says(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC2"})", "expected 3 numbers an element");
    says(R"({"bufferView":0,"byteOffset":8,"componentType":5126,"count":3,"type":"VEC3"})", "within the view");
    says(R"({"componentType":5126,"count":3,"type":"VEC3"})", "expected a number 0..0, found -1");
    EXPECT_NE(complaint(triangle(good, R"(,"extensionsRequired":["KHR_draco_mesh_compression"])")).find("KHR_draco"),
              std::string::npos);
    EXPECT_NE(complaint("{").find("t.gltf: expected a glTF 2.0 file"), std::string::npos);
    EXPECT_NE(complaint("").find("t.gltf"), std::string::npos);
}

TEST(BrokenModels, ThatLoopAreRefused) {
    std::string text = triangle(R"({"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"})");
    text.replace(text.find(R"({"mesh":0})"), 10, R"({"mesh":0,"children":[0]})");
    EXPECT_NE(complaint(text).find("expected a tree"), std::string::npos) << complaint(text);
}

/// A picture of our own as PNG bytes.
std::string png() {
    fs::path const file = tests::scratch() / "picture.png";
    assets::Image image{16, 12, 4, std::vector<std::uint8_t>(16 * 12 * 4)};
    for (std::size_t i = 0; i < image.values.size(); ++i) image.values[i] = static_cast<std::uint8_t>(i * 37);
    assets::writePng(file, image);
    std::string const bytes = core::readFile(file);
    EXPECT_EQ(assets::readImage(file).values, image.values);
    return bytes;
}

TEST(BrokenImages, CutOrFlippedNeverCrash) {
    std::string const whole = png();
    EXPECT_TRUE(readsImage(whole));
    EXPECT_FALSE(readsImage(""));
    EXPECT_FALSE(readsImage("not a picture at all"));
    std::mt19937 random{3};
    int refused = 0;
    for (int i = 0; i < 400; ++i) {
        std::string bytes = whole;
        if (i % 2)
            bytes.resize(random() % bytes.size());
        else
            bytes[random() % bytes.size()] = static_cast<char>(random());
        refused += !readsImage(bytes);
    }
    EXPECT_GT(refused, 100);
}

TEST(BrokenImages, ClaimingToBeHugeAreRefusedBeforeMemoryIsTaken) {
    std::string bytes = png();
    bytes[16] = '\x7f';  // width in IHDR: 2 billion; its checksum is wrong too
    EXPECT_FALSE(readsImage(bytes));
}
}  // namespace
