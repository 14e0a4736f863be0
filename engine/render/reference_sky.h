// Air, clouds and ground of a snapshot as one medium of sky/path_tracer.h: what the game's sky is held against. The frame is
// that of the bent picture: m from the camera, x east, y up, z south; straight rays. No GL; any thread.
#pragma once
#include <array>
#include <vector>

#include "engine/render/reference_clouds.h"
#include "engine/sky/atmosphere.h"
#include "engine/sky/path_tracer.h"

namespace luftpost::render {
/// The medium. The ground is a sphere of the land's mean colour at the place's altitude. The light is the sun, or the moon
/// once the sun gives less; what the air takes from it on its straight way comes from a table, the clouds' part is
/// tracked. Stars, airglow and what falls from the clouds are left out.
class ReferenceSky {
public:
    enum Kind { kDroplets, kIce, kMolecules, kHaze };
    static constexpr int kKinds = 4;
    static constexpr int kSureKind = kDroplets;

    ReferenceSky(Snapshot const& snapshot, weather::NoiseVolumes const& noise, int workers);

    sky::Stretch stretchAt(sky::PathRay const& ray, double from) const;
    sky::MediumPoint<kKinds> at(glm::dvec3 const& place) const;
    sky::Phase const& phase(int kind) const { return phases_[static_cast<std::size_t>(kind)]; }
    double surface(sky::PathRay const& ray) const;
    sky::MediumFace face(glm::dvec3 const& place) const;
    std::optional<glm::dvec3> toSun() const { return light_.toward; }
    sky::SunThere sun(glm::dvec3 const& place, core::Random& random) const;
    sky::Stretch shadowStretchAt(sky::PathRay const& ray, double from) const;
    float shadowExtinction(glm::dvec3 const& place) const;
    float sunGuess(glm::dvec3 const& place) const { return clouds_.sunGuess(flatOf(place, altitudeOf(place))); }
    glm::vec3 beyond(sky::PathRay const& ray, bool seen) const;
    /// The clouds and the air, each alone.
    sky::MediumPoint<kKinds> cloudAt(glm::dvec3 const& place) const;
    sky::MediumPoint<kKinds> airAt(glm::dvec3 const& place) const;
    /// An estimate of the transmittance of the air along a ray.
    glm::vec3 throughAir(sky::PathRay const& ray, double distance, core::Random& random) const;
    /// For rays near this one: draws places as often as the air there sends light to the eye, about.
    sky::AirDraw airDraw(sky::PathRay const& ray) const;

private:
    struct Light {
        glm::dvec3 toward{0.0, 1.0, 0.0};
        glm::vec3 above{0.0f};  // irradiance above the air
        double radius = 0.00465;
    };
    double altitudeOf(glm::dvec3 const& place) const;
    double flattening(glm::dvec3 const& place) const;  // m along the ground for each m across the picture's frame
    glm::dvec3 flatOf(glm::dvec3 const& place, double altitude) const;
    double crossing(sky::PathRay const& ray, double from, double altitude, bool outward) const;
    sky::Stretch cloudStretch(sky::PathRay const& ray, double from, glm::dvec3 const& place, double altitude) const;
    glm::vec3 sunThroughAir(double altitude, double cosine, double radius) const;
    std::size_t bandOf(double altitude) const;
    double endOfBand(sky::PathRay const& ray, double from, std::size_t band) const;
    void makeBands();
    void makeTable();

    double eye_;     // m above sea level
    double ground_;  // m above sea level
    glm::vec3 albedo_;
    glsl::Atmosphere air_;
    Light light_;
    ReferenceClouds clouds_;
    std::array<sky::Phase, kKinds> phases_;
    std::vector<double> bands_;        // altitudes between which one majorant holds, rising
    std::vector<float> bandMajorants_; // of the air, 1/m: [i] from bands_[i] to bands_[i + 1]
    std::vector<glm::vec3> bandLeasts_; // the same from below, by colours
    std::vector<float> bandRests_;      // and what lies between them at most
    float airAmongClouds_ = 0.0f;      // of the bands that reach into the clouds' heights, the most
    std::vector<glm::vec4> transmittance_;
};
}  // namespace luftpost::render
