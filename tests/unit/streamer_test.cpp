// Chunks, the choice of levels, and the streamer: no GL.
#include "engine/terrain/streamer.h"

#include <gtest/gtest.h>

#include <cmath>
#include <set>
#include <tuple>

#include "engine/core/frames.h"

namespace luftpost::terrain {
namespace {
Land const kLand{1, 316.0};

CameraView viewFrom(double east, double north, double altitude, double azimuth, double elevation = -0.1) {
    CameraView view;
    view.positionWorld = core::worldFromEastNorth(east, north, altitude);
    view.forward = {std::sin(azimuth) * std::cos(elevation), std::sin(elevation), -std::cos(azimuth) * std::cos(elevation)};
    glm::dvec3 const right{std::cos(azimuth), 0.0, std::sin(azimuth)};
    view.up = glm::cross(right, view.forward);
    return view;
}

TEST(Chunk, HoldsTheLandsHeightsToHalfACentimetre) {
    for (ChunkKey key : {ChunkKey{0, 12, -7}, ChunkKey{3, -2, 1}, ChunkKey{9, 1, 0}, ChunkKey{2, 5000, -1}}) {
        Chunk const chunk = makeChunk(kLand, key);
        ASSERT_EQ(chunk.samples.size(), 241u * 241u);
        double const spacing = key.size() / 240.0;
        for (int i = 0; i <= 240; i += 16) {
            glm::dvec2 const at = key.corner() + glm::dvec2{i, 240 - i} * spacing;
            EXPECT_NEAR(chunk.samples[static_cast<std::size_t>((240 - i) * 241 + i)].x, kLand.height(at.x, at.y), 0.005);
        }
    }
}

TEST(Chunk, MeetsItsNeighboursWithoutASeamInHeightOrLight) {
    Chunk const west = makeChunk(kLand, {1, 3, 4}), east = makeChunk(kLand, {1, 4, 4}), north = makeChunk(kLand, {1, 3, 5});
    for (std::size_t i = 0; i <= 240; ++i) {
        EXPECT_EQ(west.samples[i * 241 + 240], east.samples[i * 241]);
        EXPECT_EQ(west.samples[240 * 241 + i], north.samples[i]);
    }
}

TEST(Chunk, SharesItsEvenVerticesWithItsParent) {
    Chunk const child = makeChunk(kLand, {2, 7, -3}), parent = makeChunk(kLand, ChunkKey{2, 7, -3}.parent());
    // Child (7, -3) is the eastern, northern quarter: -3 = 2 * -2 + 1.
    EXPECT_EQ((ChunkKey{2, 7, -3}).quarter(), 3);
    for (std::size_t i = 0; i <= 120; ++i)
        EXPECT_EQ(child.samples[2 * i * 241 + 2 * i].x, parent.samples[(120 + i) * 241 + 120 + i].x);
}

TEST(Chunk, ThinnedOutHoldsTheSameHeights) {
    Chunk const full = makeChunk(kLand, {0, 40, 40}), thin = makeChunk(kLand, {0, 40, 40}, 3);
    ASSERT_EQ(thin.samples.size(), 81u * 81u);
    for (std::size_t i = 0; i <= 80; ++i) EXPECT_EQ(thin.samples[i * 81 + 7].x, full.samples[3 * i * 241 + 21].x);
}

// Every point of the visible land is covered once, and neighbours differ by one level at most.
int levelAt(std::vector<DrawnChunk> const& drawn, glm::dvec2 at, int& count) {
    int level = -1;
    count = 0;
    for (DrawnChunk const& chunk : drawn) {
        glm::dvec2 const inside = (at - chunk.key.corner()) / chunk.key.size();
        if (inside.x < 0.0 || inside.y < 0.0 || inside.x >= 1.0 || inside.y >= 1.0) continue;
        int const quarter = (inside.x >= 0.5 ? 1 : 0) | (inside.y >= 0.5 ? 2 : 0);
        if (!(chunk.quarters >> quarter & 1u)) continue;
        ++count;
        level = chunk.key.level;
    }
    return level;
}

void expectWholeCover(std::vector<DrawnChunk> const& drawn, glm::dvec2 camera, double farthest) {
    for (int i = 0; i < 3000; ++i) {
        double const angle = i * 2.39996323, radius = farthest * std::pow(10.0, -3.5 * (1.0 - i / 3000.0));
        glm::dvec2 const at = camera + radius * glm::dvec2{std::cos(angle), std::sin(angle)};
        int count = 0;
        int const level = levelAt(drawn, at, count);
        ASSERT_EQ(count, 1) << "at " << at.x << " " << at.y;
        double const beside = 0.12 * chunkSize(level);
        for (glm::dvec2 offset : {glm::dvec2{beside, 0.0}, glm::dvec2{0.0, beside}}) {
            int other = 0;
            int const neighbour = levelAt(drawn, at + offset, other);
            if (other == 1) { ASSERT_LE(std::abs(neighbour - level), 1) << at.x << " " << at.y; }
        }
    }
}

TEST(LevelChoice, CoversTheLandOnceWithNeighboursOneLevelApart) {
    for (double altitude : {330.0, 1500.0, 12000.0}) {
        CameraView view = viewFrom(1234.0, -777.0, altitude, 0.0);
        view.allRound = true;
        auto const wanted = wantedChunks(view, altitude - 300.0, 280.0, [](ChunkKey) { return HeightBounds{200.0, 3000.0}; });
        auto const drawn = drawnChunks(wanted, [](ChunkKey) { return true; });
        expectWholeCover(drawn, {1234.0, -777.0}, farthestLand(altitude - 280.0));
    }
}

TEST(LevelChoice, CoversTheLandAlsoWhereChunksAreMissing) {
    CameraView view = viewFrom(0.0, 0.0, 400.0, 0.0);
    view.allRound = true;
    auto const wanted = wantedChunks(view, 60.0, 280.0, [](ChunkKey) { return HeightBounds{200.0, 3000.0}; });
    for (unsigned salt = 0; salt < 8; ++salt) {
        auto const ready = [&](ChunkKey key) { return key.level >= kResidentLevel || (ChunkHash{}(key) + salt * 7u) % 5u != 0u; };
        expectWholeCover(drawnChunks(wanted, ready), {0.0, 0.0}, farthestLand(120.0));
    }
}

TEST(LevelChoice, MarksTheSidesWhereTheNeighbourIsCoarser) {
    CameraView view = viewFrom(0.0, 0.0, 400.0, 0.0);
    view.allRound = true;
    auto const wanted = wantedChunks(view, 60.0, 280.0, [](ChunkKey) { return HeightBounds{200.0, 3000.0}; });
    auto const drawn = drawnChunks(wanted, [](ChunkKey key) { return !(key == ChunkKey{0, 1, 0}); });
    bool seen = false;
    for (DrawnChunk const& chunk : drawn)
        if (chunk.key == ChunkKey{0, 0, 0}) {
            seen = true;
            EXPECT_EQ(chunk.coarserSides & 2u, 2u);
        }
    EXPECT_TRUE(seen);
}

TEST(LevelChoice, AsksForResidentChunksFirstAndFineOnesBehindLast) {
    CameraView const view = viewFrom(0.0, 0.0, 400.0, 0.0);
    auto const wanted = wantedChunks(view, 60.0, 280.0, [](ChunkKey) { return HeightBounds{200.0, 3000.0}; });
    std::size_t firstFine = wanted.size(), firstBehind = wanted.size(), lastSeen = 0, lastResident = 0;
    for (std::size_t i = 0; i < wanted.size(); ++i) {
        bool const resident = wanted[i].kept;
        if (resident) lastResident = i;
        else if (firstFine == wanted.size()) firstFine = i;
        if (!resident && !wanted[i].inView && firstBehind == wanted.size()) firstBehind = i;
        if (!resident && wanted[i].inView) lastSeen = i;
    }
    EXPECT_LT(lastResident, firstFine);
    EXPECT_LT(lastSeen, firstBehind);
    EXPECT_LT(firstBehind, wanted.size());
}

TEST(Streamer, HasEverythingInViewOnceFinished) {
    StreamerOptions options;
    options.workers = 2;
    options.step = 6;
    Streamer streamer{kLand, options};
    CameraView const view = viewFrom(0.0, 0.0, 900.0, 1.0);
    DrawList const list = streamer.finish(view);
    EXPECT_GT(list.chunks.size(), 20u);
    std::set<std::tuple<int, int, int>> fresh;
    for (auto const& chunk : list.fresh) fresh.insert({chunk->key.level, chunk->key.x, chunk->key.y});
    for (DrawnChunk const& chunk : list.chunks) EXPECT_TRUE(fresh.contains({chunk.key.level, chunk.key.x, chunk.key.y}));
    int finest = 9;
    for (DrawnChunk const& chunk : list.chunks) finest = std::min(finest, chunk.key.level);
    EXPECT_LE(finest, 1);
    EXPECT_TRUE(list.dropped.empty());
}

TEST(Streamer, NeverHoldsMoreThanItsCap) {
    StreamerOptions options;
    options.workers = 1;
    options.step = 6;
    options.capBytes = 18'000'000;
    Streamer streamer{kLand, options};
    std::set<std::tuple<int, int, int>> held;
    for (int i = 0; i < 60; ++i) {
        CameraView const view = viewFrom(i * 1500.0, 0.0, 900.0, i * 0.9);
        DrawList const list = i % 7 == 0 ? streamer.finish(view) : streamer.update(view);
        for (ChunkKey const& key : list.dropped) held.erase({key.level, key.x, key.y});
        for (auto const& chunk : list.fresh) held.insert({chunk->key.level, chunk->key.x, chunk->key.y});
        for (DrawnChunk const& chunk : list.chunks) EXPECT_TRUE(held.contains({chunk.key.level, chunk.key.x, chunk.key.y}));
        EXPECT_EQ(held.size(), streamer.stats().cached);
        EXPECT_LE(streamer.stats().peakBytes, options.capBytes);
    }
    EXPECT_GT(streamer.stats().evicted, 0u);
    EXPECT_GT(streamer.stats().made, streamer.stats().cached);
}

TEST(Streamer, DrawsParentsRightAfterATurn) {
    StreamerOptions options;
    options.workers = 1;
    options.step = 6;
    Streamer streamer{kLand, options};
    streamer.finishKept(viewFrom(0.0, 0.0, 900.0, 0.0));
    DrawList const turned = streamer.update(viewFrom(0.0, 0.0, 900.0, 3.14159));
    EXPECT_TRUE(turned.whole);
    EXPECT_FALSE(turned.chunks.empty());
    for (DrawnChunk const& chunk : turned.chunks) EXPECT_NE(chunk.quarters, 0u);
    EXPECT_GE(turned.chunks.back().key.level, kResidentLevel);
}
}  // namespace
}  // namespace luftpost::terrain
