// The models and sounds of the repo are what the game asks of them.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <fstream>

#include "engine/assets/model.h"
#include "engine/assets/sound.h"
#include "engine/audio/mixer.h"
#include "engine/core/error.h"
#include "engine/flight/airframe.h"
#include "game/ui/camera.h"
#include "tests/support/scratch.h"

namespace {
using namespace luftpost;
std::filesystem::path const kAssets = std::filesystem::path{LUFTPOST_SOURCE_DIR} / "assets";

assets::Model model(std::string const& name) { return assets::readModel(kAssets / "models" / (name + ".glb")); }

int nodeIndex(assets::Model const& m, std::string const& name) {
    for (std::size_t i = 0; i < m.nodes.size(); ++i)
        if (m.nodes[i].name == name) return static_cast<int>(i);
    return -1;
}

glm::vec3 inModel(assets::Model const& m, int node, glm::vec3 point) {
    for (int i = node; i >= 0; i = m.nodes[static_cast<std::size_t>(i)].parent) {
        assets::Node const& n = m.nodes[static_cast<std::size_t>(i)];
        point = n.translation + n.rotation * (n.scale * point);
    }
    return point;
}

struct Bounds {
    glm::vec3 low{1e9f}, high{-1e9f};
};

Bounds bounds(assets::Model const& m, std::string const& only = "") {
    Bounds b;
    for (std::size_t i = 0; i < m.nodes.size(); ++i) {
        if (!only.empty() && m.nodes[i].name != only) continue;
        for (int p : m.nodes[i].primitives)
            for (auto const& vertex : m.primitives[static_cast<std::size_t>(p)].mesh.vertices) {
                glm::vec3 const at = inModel(m, static_cast<int>(i), vertex.position);
                b.low = glm::min(b.low, at), b.high = glm::max(b.high, at);
            }
    }
    return b;
}

TEST(PlaneModel, HasTheSizeOfABushPlaneAndItsDatumAtTheOrigin) {
    Bounds const b = bounds(model("plane"));
    EXPECT_NEAR(b.high.z - b.low.z, 10.9f, 0.1f);   // span
    EXPECT_NEAR(b.high.x - b.low.x, 8.3f, 0.15f);   // length
    EXPECT_NEAR(b.high.z, -b.low.z, 0.01f);         // symmetric
    EXPECT_GT(b.high.x, 1.9f);                      // the nose is forward, +x
    EXPECT_LT(b.low.x, -5.0f);
}

std::pair<char const*, char const*> const kPlanes[]{{"mail_plane.json", "plane"}, {"freight_plane.json", "freight_plane"}};

void expectMovingNodes(assets::Model const& plane) {
    for (char const* name : {"propeller", "propeller_disc", "spinner", "cowling", "aileron_left", "aileron_right", "elevator", "rudder", "flap_left", "flap_right",
                             "wheel_left", "wheel_right", "wheel_nose", "yoke_left", "yoke_right", "pilot", "glass"}) {
        int const node = nodeIndex(plane, name);
        ASSERT_GE(node, 0) << name;
        EXPECT_FALSE(plane.nodes[static_cast<std::size_t>(node)].primitives.empty()) << name;
        EXPECT_EQ(plane.nodes[static_cast<std::size_t>(node)].rotation, (glm::quat{1.0f, 0.0f, 0.0f, 0.0f})) << name << " rests turned";
    }
    // A surface hangs behind its hinge.
    for (char const* name : {"aileron_left", "aileron_right", "elevator", "flap_left", "flap_right"}) {
        float const hinge = inModel(plane, nodeIndex(plane, name), glm::vec3{0.0f}).x;
        Bounds const b = bounds(plane, name);
        EXPECT_LT(b.low.x, hinge - 0.25f) << name;
        EXPECT_LT(b.high.x, hinge + 0.08f) << name;
    }
    EXPECT_LT(bounds(plane, "aileron_left").high.z, 0.0f);
    EXPECT_GT(bounds(plane, "aileron_right").low.z, 0.0f);
}

TEST(PlaneModel, HasTheMovingNodesWithTheirPivots) {
    for (auto const& [file, name] : kPlanes) expectMovingNodes(model(name));
}

TEST(PlaneModel, IsAsBigAsItsAirframe) {
    for (auto const& [file, name] : kPlanes) {
        flight::Airframe const airframe = flight::loadAirframe(kAssets / "airframes" / file);
        assets::Model const plane = model(name);
        EXPECT_NEAR(bounds(plane).high.z, 0.5 * airframe.wingSpan, 0.05) << name;
        EXPECT_NEAR(0.5f * (bounds(plane, "propeller_disc").high.y - bounds(plane, "propeller_disc").low.y), 0.5 * airframe.propeller.diameter, 0.02) << name;
        for (auto const& strike : airframe.strikes) {
            float const beyond = glm::max(glm::max(static_cast<float>(std::abs(strike.position.z)) - bounds(plane).high.z, static_cast<float>(strike.position.y) - bounds(plane).high.y), bounds(plane).low.x - static_cast<float>(strike.position.x));
            EXPECT_LT(beyond, 0.05f) << name << ": " << strike.name << " strikes where nothing is seen";
        }
    }
    EXPECT_GT(bounds(model("freight_plane"), "elevator").high.z, bounds(model("plane"), "elevator").high.z + 0.2f);
}

void expectOnTheWheelsOf(flight::Airframe const& airframe, assets::Model const& plane) {
    std::pair<char const*, char const*> const wheels[] = {{"nose wheel", "wheel_nose"}, {"left wheel", "wheel_left"}, {"right wheel", "wheel_right"}};
    for (auto const& [ofAirframe, ofModel] : wheels) {
        auto const wheel = std::find_if(airframe.wheels.begin(), airframe.wheels.end(), [&, name = ofAirframe](auto const& w) { return w.name == name; });
        ASSERT_NE(wheel, airframe.wheels.end()) << ofAirframe;
        Bounds const b = bounds(plane, ofModel);
        EXPECT_NEAR(b.low.y, wheel->position.y, 0.03) << ofModel;
        EXPECT_NEAR(0.5f * (b.low.x + b.high.x), wheel->position.x, 0.05) << ofModel;
        EXPECT_NEAR(0.5f * (b.low.z + b.high.z), wheel->position.z, 0.05) << ofModel;
    }
}

TEST(PlaneModel, StandsOnTheWheelsOfEveryAirframe) {
    for (auto const& [file, name] : kPlanes)
        expectOnTheWheelsOf(flight::loadAirframe(kAssets / "airframes" / file), model(name));
}

void expectAFreeView(assets::Model const& plane) {
    glm::vec3 const eye{ui::kPilotEyeBody};
    for (char const* name : {"interior_cabin", "exterior_fuselage", "cowling"}) {
        int const node = nodeIndex(plane, name);
        ASSERT_GE(node, 0) << name;
        for (int p : plane.nodes[static_cast<std::size_t>(node)].primitives)
            for (auto const& vertex : plane.primitives[static_cast<std::size_t>(p)].mesh.vertices) {
                glm::vec3 const way = inModel(plane, node, vertex.position) - eye;
                if (way.x < 0.3f) continue;
                float const across = std::abs(std::atan2(way.z, way.x)), up = std::atan2(way.y, way.x);
                EXPECT_FALSE(across < 0.25f && up > -0.10f && up < 0.20f) << name << " at " << way.x << ", " << way.y << ", " << way.z;
            }
    }
}

TEST(PlaneModel, LeavesThePilotAFreeViewAhead) {
    for (auto const& [file, name] : kPlanes) expectAFreeView(model(name));
}

TEST(Models, HaveUnitNormalsThatAgreeWithTheirTriangles) {
    for (char const* name : {"plane", "freight_plane", "parcel", "parachute", "windsock", "hangar", "drop_zone"}) {
        assets::Model const m = model(name);
        std::size_t agree = 0, all = 0;
        for (auto const& primitive : m.primitives) {
            auto const& mesh = primitive.mesh;
            for (std::size_t k = 0; k + 2 < mesh.indices.size(); k += 3) {
                auto const &a = mesh.vertices[mesh.indices[k]], &b = mesh.vertices[mesh.indices[k + 1]], &c = mesh.vertices[mesh.indices[k + 2]];
                glm::vec3 const face = glm::cross(b.position - a.position, c.position - a.position);
                for (auto const* v : {&a, &b, &c}) ASSERT_NEAR(glm::length(v->normal), 1.0f, 1e-3f) << name;
                agree += glm::dot(face, a.normal + b.normal + c.normal) > 0.0f;
                ++all;
            }
        }
        EXPECT_GT(all, 100u) << name;
        EXPECT_GT(static_cast<double>(agree), 0.995 * static_cast<double>(all)) << name;  // razor edges may differ
    }
}

TEST(Models, TellTheGameWhereTheyHang) {
    assets::Model const sock = model("windsock");
    EXPECT_GE(nodeIndex(sock, "sock"), 0);
    EXPECT_GE(nodeIndex(sock, "sock_droop"), 0);
    Bounds const canopy = bounds(model("parachute"), "canopy");
    EXPECT_GT(canopy.low.y, 3.0f);  // over the parcel
    Bounds const parcel = bounds(model("parcel"));
    EXPECT_LT(glm::length(parcel.high - parcel.low), 2.0f);
}

struct Level {
    double mean = 0.0, power = 0.0;
    int peak = 0, step = 0;
};

Level level(std::vector<std::int16_t> const& samples) {
    Level l;
    for (std::size_t i = 0; i < samples.size(); ++i) {
        l.mean += samples[i], l.power += static_cast<double>(samples[i]) * samples[i];
        l.peak = std::max(l.peak, std::abs(static_cast<int>(samples[i])));
        if (i > 0) l.step = std::max(l.step, std::abs(samples[i] - samples[i - 1]));
    }
    l.mean /= static_cast<double>(samples.size());
    l.power = std::sqrt(l.power / static_cast<double>(samples.size()));
    return l;
}

TEST(Sounds, LoopWithoutASeam) {
    for (int i = 0; i < static_cast<int>(audio::Loop::count); ++i) {
        std::string const name = audio::fileName(static_cast<audio::Loop>(i));
        auto const sound = assets::readSound(kAssets / "sounds" / (name + ".wav"));
        Level const l = level(sound.samples);
        EXPECT_LE(std::abs(sound.samples.front() - sound.samples.back()), l.step) << name << ": a click at the seam";
        EXPECT_GE(sound.samples.size(), static_cast<std::size_t>(sound.rate)) << name;
        // As loud at the seam as elsewhere.
        std::size_t const part = static_cast<std::size_t>(sound.rate) / 8;
        std::vector<std::int16_t> seam(sound.samples.end() - static_cast<std::ptrdiff_t>(part / 2), sound.samples.end());
        seam.insert(seam.end(), sound.samples.begin(), sound.samples.begin() + static_cast<std::ptrdiff_t>(part / 2));
        EXPECT_GT(level(seam).power, 0.45 * l.power) << name;
        EXPECT_LT(level(seam).power, 2.0 * l.power) << name;
    }
}

TEST(Sounds, NeitherClipNorCarryADirectVoltage) {
    std::uintmax_t bytes = 0;
    std::vector<std::string> names;
    for (int i = 0; i < static_cast<int>(audio::Loop::count); ++i) names.emplace_back(audio::fileName(static_cast<audio::Loop>(i)));
    for (int i = 0; i < static_cast<int>(audio::Event::count); ++i) names.emplace_back(audio::fileName(static_cast<audio::Event>(i)));
    for (std::string const& name : names) {
        auto const file = kAssets / "sounds" / (name + ".wav");
        bytes += std::filesystem::file_size(file);
        Level const l = level(assets::readSound(file).samples);
        EXPECT_LT(l.peak, 32000) << name;
        EXPECT_GT(l.peak, 8000) << name;
        EXPECT_LT(std::abs(l.mean), 4.0) << name;
    }
    EXPECT_LT(bytes, 3'000'000u);
}

TEST(Sounds, ThatAreBrokenAreNamed) {
    auto const file = tests::scratch() / "broken.wav";
    std::ofstream{file} << "RIFFnothing";
    try {
        assets::readSound(file);
        FAIL() << "read a broken file";
    } catch (core::Error const& error) {
        EXPECT_NE(std::string{error.what()}.find("broken.wav"), std::string::npos);
    }
}
}  // namespace
