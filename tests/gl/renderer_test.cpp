// The renderer as a whole: what it draws without and with models, in every projection, and how long its passes take.
#include "engine/render/renderer.h"

#include <chrono>
#include <cmath>
#include <cstdlib>
#include <numeric>

#include "engine/assets/model.h"
#include "engine/sky/sky_state.h"
#include "tests/gl/gl_fixture.h"

namespace {
using namespace luftpost;

class Renderer : public test::GlTest {
protected:
    static constexpr glm::ivec2 kSize{256, 144};
    /// Midday, the camera 300 m up, looking north.
    static render::Snapshot midday() {
        render::Snapshot snapshot;
        snapshot.camera.positionWorld = {0.0, 300.0, 0.0};
        snapshot.sky.sunDirectionWorld = sky::directionWorld(core::radians(200.0), core::radians(50.0));
        snapshot.still = true;
        snapshot.dither = false;
        snapshot.drawTerrain = false;
        return snapshot;
    }
    /// A grey ball of 2 m, 8 m ahead.
    static void putBall(render::Renderer& renderer, render::Snapshot& snapshot) {
        assets::Material material;
        material.baseColour = {0.5f, 0.5f, 0.5f, 1.0f};
        material.metallic = 0.0f;
        render::ModelInstance ball;
        ball.model = renderer.addModel(assets::modelOf(assets::meshOf(assets::sphere(1.0f), 32, 16), material, "ball"));
        ball.positionWorld = snapshot.camera.positionWorld + glm::dvec3{0.0, 0.0, -8.0};
        snapshot.models.push_back(ball);
    }
    static glm::vec3 at(assets::FloatImage const& image, int x, int y) {
        return {image.at(x, y, 0), image.at(x, y, 1), image.at(x, y, 2)};
    }
    /// Left half or right half of what `LUFTPOST_KEEP_PICTURES` names a folder for, to look at.
    static void keep(render::Renderer& renderer, std::string const& name) {
        if (char const* folder = std::getenv("LUFTPOST_KEEP_PICTURES"))
            assets::writePng(std::string{folder} + "/" + name + ".png", renderer.readPixels());
    }
};

TEST_F(Renderer, DrawsASkyThatIsFiniteBlueAndNotBlack) {
    render::Renderer renderer{{.size = kSize}};
    renderer.draw(midday());
    keep(renderer, "sky");
    auto const image = renderer.readHdr();
    for (float value : image.values) ASSERT_TRUE(std::isfinite(value));
    glm::vec3 const sky = at(image, 128, 4);
    EXPECT_GT(sky.z, sky.x);
    EXPECT_GT(sky.x, 1e-4f);
    assets::Image const shown = renderer.readPixels();
    EXPECT_GT(shown.at(128, 4, 2), 60);
    EXPECT_EQ(shown.at(128, 4, 3), 255);
}

TEST_F(Renderer, ShadesAModelBrighterTowardTheSun) {
    render::Renderer renderer{{.size = kSize}};
    render::Snapshot snapshot = midday();
    snapshot.sky.sunDirectionWorld = sky::directionWorld(core::radians(90.0), core::radians(20.0));  // from the right
    snapshot.camera.horizontalFov = 0.5;
    putBall(renderer, snapshot);
    renderer.draw(snapshot);
    keep(renderer, "ball");
    auto const image = renderer.readHdr();
    EXPECT_GT(at(image, 148, 70).y, 2.0f * at(image, 108, 70).y);
    EXPECT_GT(at(image, 108, 70).y, 0.005f) << "the side away from the sun is lit by the sky";
}

TEST_F(Renderer, DrawsTheSameModelInAPanoramaWhereItsDirectionLies) {
    render::Renderer renderer{{.size = {256, 128}}};
    render::Snapshot snapshot = midday();
    snapshot.camera.projection = render::Projection::panorama;
    renderer.draw(snapshot);
    auto const empty = renderer.readHdr();
    putBall(renderer, snapshot);
    snapshot.models[0].positionWorld = snapshot.camera.positionWorld + glm::dvec3{8.0, 0.0, 0.0};  // east
    renderer.draw(snapshot);
    keep(renderer, "panorama");
    auto const image = renderer.readHdr();
    EXPECT_GT(glm::distance(at(image, 64, 64), at(empty, 64, 64)), 0.01f) << "east is a quarter from the left edge";
    for (int x : {0, 128, 192}) EXPECT_LT(glm::distance(at(image, x, 64), at(empty, x, 64)), 1e-3f) << x;
}

TEST_F(Renderer, LeavesBlackAroundADome) {
    render::Renderer renderer{{.size = {128, 128}}};
    render::Snapshot snapshot = midday();
    snapshot.camera.projection = render::Projection::dome;
    renderer.draw(snapshot);
    keep(renderer, "dome");
    auto const image = renderer.readHdr();
    EXPECT_EQ(at(image, 1, 1), glm::vec3{0.0f});
    EXPECT_EQ(image.at(1, 1, 3), 0.0f);
    EXPECT_GT(at(image, 64, 64).z, 0.001f);
    // South (where the sun stands) is below the centre: north is up.
    EXPECT_GT(at(image, 64, 110).y, at(image, 64, 18).y);
}

TEST_F(Renderer, DrawsTheSameFrameTwice) {
    render::Renderer renderer{{.size = kSize}};
    render::Snapshot snapshot = midday();
    putBall(renderer, snapshot);
    renderer.draw(snapshot);
    auto const first = renderer.readPixels();
    renderer.draw(snapshot);
    EXPECT_EQ(first.values, renderer.readPixels().values);
}

TEST_F(Renderer, KeepsItsSizeThroughAResizeAndASmallerPicture) {
    render::Renderer renderer{{.size = kSize}};
    render::Snapshot snapshot = midday();
    snapshot.graphics.resolution = 0.5f;
    renderer.resize({200, 100});
    renderer.draw(snapshot);
    EXPECT_EQ(renderer.readPixels().width, 200);
    EXPECT_EQ(renderer.readHdr().width, 100);
}

TEST_F(Renderer, ShowsNormalsAndWireframeOfModels) {
    render::Renderer renderer{{.size = kSize}};
    render::Snapshot snapshot = midday();
    snapshot.camera.horizontalFov = 0.5;
    putBall(renderer, snapshot);
    renderer.draw(snapshot);
    auto const plain = renderer.readPixels();
    snapshot.debug.normals = true;
    renderer.draw(snapshot);
    keep(renderer, "normals");
    auto const normals = renderer.readPixels();
    snapshot.debug = {.normals = false, .wireframe = true};
    renderer.draw(snapshot);
    keep(renderer, "wireframe");
    EXPECT_NE(plain.values, normals.values);
    EXPECT_NE(plain.values, renderer.readPixels().values);
}

TEST_F(Renderer, TimesOfPassesAddUpToTheFrame) {
    render::Renderer renderer{{.size = {640, 360}}};
    render::Snapshot snapshot = midday();
    renderer.setTiming(true);
    renderer.draw(snapshot);
    double best = 1.0;  // the machine may be busy with something else for a frame
    for (int i = 0; i < 8; ++i) {
        gl::finish();
        auto const start = std::chrono::steady_clock::now();
        renderer.draw(snapshot);
        gl::finish();
        double const wall = std::chrono::duration<double, std::milli>(std::chrono::steady_clock::now() - start).count();
        double sum = 0.0;
        for (render::PassTime const& time : renderer.passTimes()) sum += time.milliseconds;
        best = std::min(best, std::abs(sum / wall - 1.0));
    }
    EXPECT_LT(best, 0.10);
}
}  // namespace
