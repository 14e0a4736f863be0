// The owners of GL objects: move-only, empty after a move, no GL error, bytes counted.
#include <type_traits>

#include "engine/gl/buffer.h"
#include "engine/gl/draw.h"
#include "engine/gl/framebuffer.h"
#include "engine/gl/program_library.h"
#include "engine/gl/query.h"
#include "engine/gl/sampler.h"
#include "engine/gl/texture.h"
#include "engine/gl/vertex_array.h"
#include "tests/gl/gl_fixture.h"

namespace {
using namespace luftpost;

class Owners : public test::GlTest {};

template <class Owner>
void expectOwner(Owner made) {
    static_assert(!std::is_copy_constructible_v<Owner> && !std::is_copy_assignable_v<Owner>);
    static_assert(std::is_nothrow_move_constructible_v<Owner> && std::is_nothrow_move_assignable_v<Owner>);
    static_assert(std::is_default_constructible_v<Owner>);
    EXPECT_EQ(Owner{}.id(), 0u);
    unsigned const id = made.id();
    EXPECT_NE(id, 0u);
    Owner moved{std::move(made)};
    EXPECT_EQ(made.id(), 0u);
    EXPECT_EQ(moved.id(), id);
    Owner assigned;
    assigned = std::move(moved);
    EXPECT_EQ(moved.id(), 0u);
    EXPECT_EQ(assigned.id(), id);
}

TEST_F(Owners, AreMoveOnlyAndEmptyAfterAMove) {
    gl::Texture2D const target{gl::Format::rgba8, {4, 4}};
    gl::Buffer const vertices{std::size_t{64}};
    gl::ProgramLibrary library;
    library.graphics(gl::GraphicsStages{"fullscreen", "", ""});
    expectOwner(gl::Buffer{std::size_t{64}, "buffer"});
    expectOwner(gl::Texture2D{gl::Format::rgba16f, {8, 8}, 2, "2D"});
    expectOwner(gl::Texture2DArray{gl::Format::r32f, {8, 8}, 3, 1, "array"});
    expectOwner(gl::Texture3D{gl::Format::r8, {8, 8, 8}, 1, "3D"});
    expectOwner(gl::Framebuffer{{&target}, nullptr, "framebuffer"});
    expectOwner(gl::VertexArray::withoutAttributes());
    expectOwner(gl::Sampler{gl::SamplerSettings{}, "sampler"});
    expectOwner(gl::Query::timestamp());
    static_assert(!std::is_copy_constructible_v<gl::Program> && std::is_nothrow_move_constructible_v<gl::Program>);
    static_assert(!std::is_copy_constructible_v<gl::Fence> && std::is_nothrow_move_constructible_v<gl::Fence>);
    EXPECT_EQ(gl::Program{}.id(), 0u);
}

TEST_F(Owners, AFenceIsEmptyAfterAMoveAndPassesOnceTheWorkIsDone) {
    gl::Fence fence = gl::Fence::insert();
    gl::Fence moved{std::move(fence)};
    EXPECT_TRUE(fence.empty());
    EXPECT_TRUE(moved.wait(1'000'000'000));
    EXPECT_TRUE(moved.passed());
}

TEST_F(Owners, CountTheirBytesAndGiveThemBack) {
    std::size_t const before = gl::allocatedBytes();
    {
        gl::Buffer const buffer{std::size_t{1000}};
        gl::Texture2D const texture{gl::Format::rgba16f, {16, 8}, 2};
        gl::Texture3D const volume{gl::Format::r8, {4, 4, 4}, 2};
        EXPECT_EQ(gl::allocatedBytes() - before, 1000u + 8 * (16 * 8 + 8 * 4) + 64 + 8);
        gl::Buffer moved{std::size_t{10}};
        moved = gl::Buffer{std::size_t{20}};
        EXPECT_EQ(gl::allocatedBytes() - before, 1000u + 8 * (16 * 8 + 8 * 4) + 64 + 8 + 20);
    }
    EXPECT_EQ(gl::allocatedBytes(), before);
}

TEST_F(Owners, ATextureGivesBackWhatItWasGiven) {
    std::vector<float> const texels{0.0f, 0.25f, 1.0f, 1000.0f};
    gl::Texture2D texture{gl::Format::r32f, {2, 2}};
    texture.upload<float>(texels);
    EXPECT_EQ(texture.readFloats(), texels);
    texture.uploadRegion<float>({1, 1}, {1, 1}, std::vector<float>{7.0f});
    EXPECT_EQ(texture.readFloats()[3], 7.0f);
    texture.clear(glm::vec4{3.0f});
    EXPECT_EQ(texture.readFloats()[0], 3.0f);
}

TEST_F(Owners, ABufferGivesBackWhatItWasGiven) {
    std::vector<int> values{1, 2, 3};
    gl::Buffer buffer{values.size() * sizeof(int)};
    buffer.update(gl::bytesOfRange(values));
    buffer.update(gl::bytesOf(9), sizeof(int));
    buffer.read(std::as_writable_bytes(std::span{values}));
    EXPECT_EQ(values, (std::vector<int>{1, 9, 3}));
    buffer.clear();
    buffer.read(std::as_writable_bytes(std::span{values}));
    EXPECT_EQ(values, (std::vector<int>{0, 0, 0}));
}

TEST_F(Owners, TimestampsGrow) {
    gl::Query first = gl::Query::timestamp(), second = gl::Query::timestamp();
    first.record();
    gl::finish();
    second.record();
    EXPECT_GE(second.wait(), first.wait());
    EXPECT_TRUE(second.poll().has_value());
}

TEST_F(Owners, AGlErrorIsCounted) {
    gl::Texture2D texture{gl::Format::r8, {4, 4}};
    gl::Buffer fixed{gl::bytesOf(1)};
    int const before = gl::errorCount();
    fixed.update(gl::bytesOf(2));  // immutable without dynamic storage: GL_INVALID_OPERATION
    EXPECT_EQ(gl::errorCount(), before + 1);
    expectErrors(1);
}
}  // namespace
