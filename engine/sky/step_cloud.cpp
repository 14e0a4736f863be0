#include "engine/sky/step_cloud.h"

#include <algorithm>
#include <atomic>
#include <thread>

#include "engine/core/check.h"

namespace luftpost::sky {
namespace {
constexpr std::int64_t kBlock = 1 << 14;  // photons that share one sequence of random numbers

/// What shines on the cloud.
enum class Lamp { Sun, Furnace };

/// The medium of path_tracer.h: x along the columns, y up from the cloud's bottom.
class StepMedium {
public:
    static constexpr int kKinds = 1;
    static constexpr int kSureKind = 0;
    StepMedium(StepCloud const& cloud, Lamp lamp)
        : cloud_{cloud}, lamp_{lamp}, phase_{Phase::henyeyGreenstein(static_cast<float>(cloud.g))},
          columnWidth_{cloud.width / static_cast<double>(cloud.depths.size())} {
        for (double depth : cloud.depths) extinctions_.push_back(static_cast<float>(depth / cloud.thickness));
    }

    int columnOf(double x) const {
        double const turns = x / cloud_.width;
        double const unit = turns - std::floor(turns);
        auto const count = static_cast<double>(extinctions_.size());
        return std::min(static_cast<int>(unit * count), static_cast<int>(extinctions_.size()) - 1);
    }
    Stretch stretchAt(PathRay const& ray, double from) const {
        double const rise = ray.direction.y;
        double const leaves = rise > 0.0 ? (cloud_.thickness - ray.origin.y) / rise
                              : rise < 0.0 ? -ray.origin.y / rise : kNever;
        if (from >= leaves) return {};
        constexpr double kNudge = 1e-7;  // m: over the face between two columns
        double const x = ray.origin.x + ray.direction.x * (from + kNudge);
        double end = leaves;
        if (ray.direction.x != 0.0) {
            double const column = std::floor(x / columnWidth_);
            double const face = (ray.direction.x > 0.0 ? column + 1.0 : column) * columnWidth_;
            end = std::min(end, std::max((face - ray.origin.x) / ray.direction.x, from) + kNudge);
        }
        float const extinction = extinctions_[static_cast<std::size_t>(columnOf(x))];
        return {end, extinction, cloud_.albedo < 1.0 ? 0.0f : kSure * extinction};
    }
    MediumPoint<1> at(glm::dvec3 const& place) const {
        float const extinction = shadowExtinction(place);
        return {glm::vec3{extinction}, {glm::vec3{extinction * static_cast<float>(cloud_.albedo)}}};
    }
    Phase const& phase(int) const { return phase_; }
    double surface(PathRay const&) const { return kNever; }
    MediumFace face(glm::dvec3 const&) const { return {}; }
    /// The sun, or a direction of the furnace drawn evenly: its irradiance over the density of the draw is 4 pi.
    SunThere sun(glm::dvec3 const&, core::Random& random) const {
        if (lamp_ == Lamp::Furnace) return {isotropic(random), glm::vec3{static_cast<float>(4.0 * core::kPi)}};
        return {sunward(), glm::vec3{1.0f}};
    }
    glm::dvec3 sunward() const { return {-std::sin(cloud_.sunZenith), std::cos(cloud_.sunZenith), 0.0}; }
    std::optional<glm::dvec3> toSun() const { return lamp_ == Lamp::Sun ? std::optional{sunward()} : std::nullopt; }
    Stretch shadowStretchAt(PathRay const& ray, double from) const { return stretchAt(ray, from); }
    /// As if the cloud were twice as thin: guesses may be wrong.
    float sunGuess(glm::dvec3 const& place) const {
        return std::exp(-0.5f * shadowExtinction(place) * static_cast<float>((cloud_.thickness - place.y) / std::cos(cloud_.sunZenith)));
    }
    float shadowExtinction(glm::dvec3 const& place) const { return extinctions_[static_cast<std::size_t>(columnOf(place.x))]; }
    /// What the connections have not counted: a furnace behind a cloud that was crossed without a turn.
    glm::vec3 beyond(PathRay const&, bool seen) const { return glm::vec3{lamp_ == Lamp::Furnace && seen ? 1.0f : 0.0f}; }

private:
    static constexpr float kSure = 0.7f;  // of the extinction, where nothing absorbs: less than all of it, so that both parts are tried
    StepCloud const& cloud_;
    Lamp lamp_;
    Phase phase_;
    double columnWidth_;
    std::vector<float> extinctions_;
};

/// Runs work(block, result) for blocks 0..count-1 and adds the results in the blocks' order.
template <class Work>
StepCloudFluxes inBlocks(std::int64_t count, std::size_t columns, int workers, Work const& work) {
    StepCloudFluxes const empty{std::vector<double>(columns), std::vector<double>(columns), std::vector<double>(columns)};
    std::vector<StepCloudFluxes> results(static_cast<std::size_t>(count), empty);
    std::atomic<std::int64_t> next{0};
    auto const run = [&] {
        for (std::int64_t block = next++; block < count; block = next++) work(block, results[static_cast<std::size_t>(block)]);
    };
    {
        std::vector<std::jthread> threads;
        for (int i = 1; i < workers; ++i) threads.emplace_back(run);
        run();
    }
    StepCloudFluxes sum = empty;
    for (StepCloudFluxes const& one : results)
        for (std::size_t i = 0; i < columns; ++i) {
            sum.reflectance[i] += one.reflectance[i];
            sum.transmittance[i] += one.transmittance[i];
            sum.absorptance[i] += one.absorptance[i];
        }
    return sum;
}

core::Random sequence(std::uint64_t seed, std::uint64_t block) {
    core::Random mixer{seed * 0x9e3779b97f4a7c15u ^ block};
    return core::Random{mixer.next()};
}

void followPhoton(StepMedium const& medium, StepCloud const& cloud, core::Random& random, StepCloudFluxes& tally) {
    auto const stretches = [&](PathRay const& ray, double from) { return medium.stretchAt(ray, from); };
    PathRay ray{{random.uniform(0.0, cloud.width), cloud.thickness, 0.0}, -medium.sunward()};
    glm::vec3 weight{1.0f};
    auto const flown = [&] {
        Stretch here = kUnknown;
        return freeFlight(stretches, ray, 0.0, kNever, here, random);
    };
    for (Flight flight = flown(); flight.collided; flight = flown()) {
        glm::dvec3 const place = ray.at(flight.distance);
        auto const column = static_cast<std::size_t>(medium.columnOf(place.x));
        tally.absorptance[column] += static_cast<double>(weight.x) * (1.0 - cloud.albedo);
        weight *= static_cast<float>(cloud.albedo);
        if (!survives(weight.x, 0.01f, weight, random)) return;
        ray = {place, turned(ray.direction, medium.phase(0).draw(random), random)};
    }
    double const face = ray.direction.y > 0.0 ? cloud.thickness : 0.0;
    auto const column = static_cast<std::size_t>(medium.columnOf(ray.at((face - ray.origin.y) / ray.direction.y).x));
    (ray.direction.y > 0.0 ? tally.reflectance : tally.transmittance)[column] += static_cast<double>(weight.x);
}

void scale(StepCloudFluxes& fluxes, double factor) {
    for (auto* values : {&fluxes.reflectance, &fluxes.transmittance, &fluxes.absorptance})
        for (double& value : *values) value *= factor;
}
}  // namespace

StepCloudFluxes photonFluxes(StepCloud const& cloud, std::int64_t photons, std::uint64_t seed, int workers) {
    CHECK(!cloud.depths.empty() && photons > 0, "a cloud without columns or photons");
    StepMedium const medium{cloud, Lamp::Sun};
    std::int64_t const blocks = (photons + kBlock - 1) / kBlock;
    StepCloudFluxes sum = inBlocks(blocks, cloud.depths.size(), workers, [&](std::int64_t block, StepCloudFluxes& tally) {
        core::Random random = sequence(seed, static_cast<std::uint64_t>(block));
        for (std::int64_t i = block * kBlock; i < std::min((block + 1) * kBlock, photons); ++i)
            followPhoton(medium, cloud, random, tally);
    });
    scale(sum, static_cast<double>(cloud.depths.size()) / static_cast<double>(photons));
    return sum;
}

StepCloudFluxes pathFluxes(StepCloud const& cloud, std::int64_t paths, std::uint64_t seed, int workers) {
    CHECK(!cloud.depths.empty() && paths > 0, "a cloud without columns or paths");
    StepMedium const medium{cloud, Lamp::Sun};
    auto const columns = static_cast<std::int64_t>(cloud.depths.size());
    double const columnWidth = cloud.width / static_cast<double>(columns);
    double const falling = std::cos(cloud.sunZenith);
    std::int64_t const blocks = (paths + kBlock - 1) / kBlock;
    // The mean radiance over Lambert's directions is the exitance over pi.
    StepCloudFluxes sum = inBlocks(columns * blocks, cloud.depths.size(), workers, [&](std::int64_t job, StepCloudFluxes& tally) {
        core::Random random = sequence(seed, static_cast<std::uint64_t>(job));
        std::int64_t const column = job / blocks, block = job % blocks;
        for (std::int64_t i = block * kBlock; i < std::min((block + 1) * kBlock, paths); ++i) {
            double const x = (static_cast<double>(column) + random.uniform(0.0, 1.0)) * columnWidth;
            auto const out = static_cast<std::size_t>(column);
            PathRay const down{{x, cloud.thickness, 0.0}, lambertian({0.0, -1.0, 0.0}, random)};
            tally.reflectance[out] += core::kPi / falling * static_cast<double>(pathRadiance(medium, down, random).x);
            PathRay const up{{x, 0.0, 0.0}, lambertian({0.0, 1.0, 0.0}, random)};
            tally.transmittance[out] += core::kPi / falling * static_cast<double>(pathRadiance(medium, up, random).x) +
                                        static_cast<double>(shadow(medium, PathRay{up.origin, medium.sunward()}, kNever, kMostLeast, random));
        }
    });
    scale(sum, 1.0 / static_cast<double>(paths));
    return sum;
}

double furnaceRadiance(StepCloud const& cloud, std::int64_t paths, std::uint64_t seed) {
    StepMedium const medium{cloud, Lamp::Furnace};
    core::Random random = sequence(seed, 0);
    double sum = 0.0;
    for (std::int64_t i = 0; i < paths; ++i) {
        PathRay const down{{0.5 * cloud.width, cloud.thickness, 0.0}, lambertian({0.0, -1.0, 0.0}, random)};
        sum += static_cast<double>(pathRadiance(medium, down, random).x);
    }
    return sum / static_cast<double>(paths);
}
}  // namespace luftpost::sky
