// The land on the GPU: no hole under the horizon, and where the height function says it is.
#include <random>

#include "shaders/lib/curvature.glsl"
#include "tests/gl/gl_fixture.h"
#include "tests/gl/land_picture.h"

namespace luftpost::render {
namespace {
class LandTest : public test::GlTest {};

/// Does the straight ray from the camera meet the ball of radius R + `altitude`?
bool meetsBall(glm::dvec3 direction, double cameraAltitude, double altitude) {
    double const r = core::kEarthRadius + altitude, b = direction.y * (core::kEarthRadius + cameraAltitude);
    double const c = (cameraAltitude - altitude) * (2.0 * core::kEarthRadius + cameraAltitude + altitude);
    return r > 0.0 && b < 0.0 && b * b >= c;
}

glm::dvec3 rayOf(glsl::FrameBlock const& frame, int x, int y) {
    glm::vec3 const inCamera{(2.0f * (static_cast<float>(x) + 0.5f) * frame.viewport.z - 1.0f) * frame.projection.x,
                             (2.0f * (static_cast<float>(y) + 0.5f) * frame.viewport.w - 1.0f) * frame.projection.y, -1.0f};
    return glm::normalize(glm::dvec3{glm::mat3{frame.worldFromCamera} * inCamera});
}

int holes(LandPicture& picture, double cameraAltitude) {
    std::vector<float> const colour = picture.targets().colour.readFloats();
    glm::ivec2 const size = picture.targets().size;
    double const lowest = picture.scene().land().waterLevel() - 250.0;  // no lake is deeper
    int count = 0;
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) {
            bool const magenta = colour[static_cast<std::size_t>(y * size.x + x) * 4 + 3] == 0.0f;
            count += magenta && meetsBall(rayOf(picture.frame(), x, y), cameraAltitude, lowest);
        }
    return count;
}

TEST_F(LandTest, HasNoHoleUnderTheHorizonRightAfterATurn) {
    LandPicture picture{{96, 54}};
    std::mt19937 random{7};
    std::uniform_real_distribution<double> any{0.0, 1.0};
    int views = 0, covered = 0;
    for (int place = 0; place < 10; ++place) {
        double const east = (any(random) - 0.5) * 4.0e5, north = (any(random) - 0.5) * 4.0e5;
        double const ground = terrain::Land{1, 316.0}.ground(east, north).height;
        double const altitude = ground + 3.0 * std::pow(3500.0, any(random));
        glm::dvec3 const position = core::worldFromEastNorth(east, north, altitude);
        for (int turn = 0; turn < 20; ++turn, ++views) {
            double const azimuth = any(random) * 6.283, elevation = (any(random) - 0.7) * 1.4, fov = 0.6 + any(random);
            picture.aim(position, azimuth, elevation, fov, false);
            picture.aim(position, azimuth + core::kPi, elevation, fov, false);
            picture.draw();
            EXPECT_EQ(holes(picture, altitude), 0) << "from " << east << " " << north << " at " << altitude << " toward " << azimuth;
            covered += !picture.scene().chunks().empty();
        }
    }
    EXPECT_EQ(views, 200);
    EXPECT_GT(covered, 150);
}

TEST_F(LandTest, IsDrawnWhereTheWheelsWouldStand) {
    LandPicture picture{{160, 90}};
    std::size_t off = 0, seen = 0;
    for (glm::dvec2 place : {glm::dvec2{0.0, 0.0}, glm::dvec2{21000.0, -5000.0}, glm::dvec2{-9.0e5, 3.0e5}}) {
        terrain::Land const land{1, 316.0};
        double const altitude = land.ground(place.x, place.y).height + 40.0;
        picture.look(core::worldFromEastNorth(place.x, place.y, altitude), 0.7, -0.5, 1.2, true);
        std::vector<float> const depth = picture.targets().depth.readFloats();
        for (int y = 0; y < 90; ++y)
            for (int x = 0; x < 160; ++x) {
                double const along = 0.2 / static_cast<double>(depth[static_cast<std::size_t>(y * 160 + x)]);
                glm::dvec3 const ray = rayOf(picture.frame(), x, y);
                glm::dvec3 const axis = glm::dvec3{glm::mat3{picture.frame().worldFromCamera} * glm::vec3{0.0f, 0.0f, -1.0f}};
                glm::dvec3 const bent = ray * (along / glm::dot(ray, axis));
                glm::vec3 const flat = glsl::flatFromCurved(glm::vec3{bent}, static_cast<float>(altitude));
                if (glm::length(bent) > 300.0) continue;
                double const east = place.x + static_cast<double>(flat.x), north = place.y - static_cast<double>(flat.z);
                if (land.ground(east, north).normalWorld.y < std::cos(core::radians(10.0))) continue;
                ++seen;
                off += std::abs(altitude + static_cast<double>(flat.y) - land.height(east, north)) > 0.1;
            }
    }
    EXPECT_GT(seen, 10000u);
    EXPECT_LT(off, seen / 100);
}

TEST_F(LandTest, KeepsWithinItsTrianglesAndItsMemory) {
    LandPicture picture{{64, 36}};
    for (int triangles : {300'000, 500'000}) {
        picture.snapshot().graphics.triangles = triangles;
        picture.look(core::worldFromEastNorth(0.0, 0.0, 700.0), 1.0, -0.1, 1.2, true);
        EXPECT_LE(picture.scene().trianglesDrawn(), triangles);
        EXPECT_GT(picture.scene().trianglesDrawn(), triangles / 4);
        EXPECT_LE(picture.scene().stats().peakBytes, 160'000'000u);
    }
}

TEST_F(LandTest, TakesNoFurtherMemoryOnceItsCacheIsFull) {
    LandPicture picture{{64, 36}};
    std::size_t full = 0;
    int later = 0;
    for (int place = 0; place < 12 && later < 2; ++place) {
        picture.aim(core::worldFromEastNorth(place * 40'000.0, 0.0, 1200.0), 1.0, -0.1, 1.2, true);
        if (picture.scene().stats().evicted == 0) continue;
        if (full == 0) full = gl::allocatedBytes();
        else ++later;
        EXPECT_EQ(gl::allocatedBytes(), full) << place;
    }
    EXPECT_EQ(later, 2) << "it was never full";
    EXPECT_LT(picture.scene().stats().peakBytes, 60'000'000u) << "of a small picture's chunks";
}
}  // namespace
}  // namespace luftpost::render
