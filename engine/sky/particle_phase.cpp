#include "engine/sky/particle_phase.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <numeric>

#include "engine/core/frames.h"
#include "engine/sky/spectrum.h"

namespace luftpost::sky {
namespace {
constexpr double kStep = core::kPi / (kPhaseAngles - 1);  // rad
constexpr double kSunRadius = core::radians(0.267);

std::size_t indexOf(double angle) { return static_cast<std::size_t>(std::clamp(angle / kStep + 0.5, 0.0, kPhaseAngles - 1.0)); }

/// Solid angle that a bin of the table stands for, sr.
double solidAngle(std::size_t bin) {
    double const low = std::max((static_cast<double>(bin) - 0.5) * kStep, 0.0), high = std::min((static_cast<double>(bin) + 0.5) * kStep, core::kPi);
    return 2.0 * core::kPi * (std::cos(low) - std::cos(high));
}

/// Energy by bin -> 1/sr, the whole being 1.
std::vector<double> phaseOf(std::vector<double> bins) {
    double const total = std::accumulate(bins.begin(), bins.end(), 0.0);
    for (std::size_t i = 0; i < bins.size(); ++i) bins[i] /= solidAngle(i) * total;
    return bins;
}

/// Share of unpolarised light that a face mirrors. Cosines of the ways on its two sides, `ratio` the index behind it over that before.
double mirrored(double cosIn, double cosOut, double ratio) {
    double const s = (cosIn - ratio * cosOut) / (cosIn + ratio * cosOut), p = (ratio * cosIn - cosOut) / (ratio * cosIn + cosOut);
    return 0.5 * (s * s + p * p);
}

/// Scattering angle 0..pi of a ray that was turned by so much.
double folded(double turned) {
    double const around = std::fmod(turned, 2.0 * core::kPi);
    return around > core::kPi ? 2.0 * core::kPi - around : around;
}

/// Blurs along the angle by the sun's disc and a bell of `sigma`.
std::vector<double> blurred(std::vector<double> const& sharp, double sigma) {
    int const reach = static_cast<int>((kSunRadius + 3.0 * sigma) / kStep) + 1;
    std::vector<double> kernel;
    double sum = 0.0;
    for (int i = -reach; i <= reach; ++i) {
        double weight = 0.0;  // the disc's chord, seen through the bell
        for (int k = -8; k <= 8; ++k) {
            double const x = k / 8.5, off = (i * kStep - x * kSunRadius) / std::max(sigma, 0.3 * kStep);
            weight += std::sqrt(1.0 - x * x) * std::exp(-0.5 * off * off);
        }
        kernel.push_back(weight);
        sum += weight;
    }
    std::vector<double> soft(sharp.size(), 0.0);
    int const last = static_cast<int>(sharp.size()) - 1;
    for (int i = 0; i <= last; ++i)
        for (int k = -reach; k <= reach; ++k) {
            int const from = std::abs(i + k) > last ? 2 * last - (i + k) : std::abs(i + k);
            soft[static_cast<std::size_t>(i)] += kernel[static_cast<std::size_t>(k + reach)] / sum * sharp[static_cast<std::size_t>(from)];
        }
    return soft;
}

void addSpectrum(PhaseTable& table, std::vector<double> const& phase, int i) {
    glm::vec3 const colour{spectralColour(i)};
    for (std::size_t k = 0; k < table.size(); ++k) table[k] += glm::vec4{colour * static_cast<float>(phase[k]), 0.0f};
}

/// Energy of a drop by bin of scattering angle: a ray that meets it `b` radii off its middle is turned by pi - 2 i, 2 (i - r) and with
/// every reflection inside by pi - 2 r more (Descartes).
std::vector<double> dropEnergy(double index) {
    constexpr int kRays = 20000;
    std::vector<double> bins(kPhaseAngles, 0.0);
    for (int k = 0; k < kRays; ++k) {
        double const b = (k + 0.5) / kRays, energy = 2.0 * b / kRays;
        double const in = std::asin(b), out = std::asin(b / index), r = mirrored(std::cos(in), std::cos(out), index);
        bins[indexOf(core::kPi - 2.0 * in)] += energy * r;
        double left = energy * (1.0 - r) * (1.0 - r), turned = 2.0 * (in - out);
        for (int reflections = 0; reflections < 3; ++reflections) {
            bins[indexOf(folded(turned))] += left;
            left *= r;
            turned += core::kPi - 2.0 * out;
        }
    }
    return bins;
}

// ------------------------------------------------------------------------------------------------------------- Mie

/// Amplitudes of a sphere of size parameter x and real index m at the cosines asked for (Bohren and Huffman 1983, appendix A);
/// |S|^2 summed, and the scattering efficiency times x^2.
struct Mie {
    std::vector<double> intensity;  // (|S1|^2 + |S2|^2) / 2
    double scattering = 0.0;        // Q x^2
};

struct MieTerm { std::complex<double> a, b; };

std::vector<MieTerm> mieTerms(double x, double m) {
    int const terms = static_cast<int>(x + 4.0 * std::cbrt(x) + 2.0), start = static_cast<int>(std::max<double>(terms, m * x)) + 15;
    std::vector<double> slope(static_cast<std::size_t>(start) + 1, 0.0);  // logarithmic derivative, downward
    for (int n = start; n > 1; --n) {
        double const share = n / (m * x);
        slope[static_cast<std::size_t>(n) - 1] = share - 1.0 / (slope[static_cast<std::size_t>(n)] + share);
    }
    std::vector<MieTerm> all;
    double psi0 = std::cos(x), psi1 = std::sin(x), chi0 = -std::sin(x), chi1 = std::cos(x);
    for (int n = 1; n <= terms; ++n) {
        double const psi = (2.0 * n - 1.0) * psi1 / x - psi0, chi = (2.0 * n - 1.0) * chi1 / x - chi0;
        std::complex<double> const xi{psi, -chi}, xi1{psi1, -chi1};
        double const d = slope[static_cast<std::size_t>(n)], e = d / m + n / x, f = m * d + n / x;
        all.push_back({(e * psi - psi1) / (e * xi - xi1), (f * psi - psi1) / (f * xi - xi1)});
        psi0 = psi1, psi1 = psi, chi0 = chi1, chi1 = chi;
    }
    return all;
}

Mie mieOf(double x, double m, std::vector<double> const& cosines) {
    std::vector<MieTerm> const terms = mieTerms(x, m);
    Mie mie;
    for (std::size_t n = 1; n <= terms.size(); ++n)
        mie.scattering += 2.0 * (2.0 * static_cast<double>(n) + 1.0) * (std::norm(terms[n - 1].a) + std::norm(terms[n - 1].b));
    for (double const cosine : cosines) {
        std::complex<double> s1, s2;
        double pi0 = 0.0, pi1 = 1.0;
        for (std::size_t k = 1; k <= terms.size(); ++k) {
            double const n = static_cast<double>(k), tau = n * cosine * pi1 - (n + 1.0) * pi0, weight = (2.0 * n + 1.0) / (n * (n + 1.0));
            s1 += weight * (terms[k - 1].a * pi1 + terms[k - 1].b * tau);
            s2 += weight * (terms[k - 1].a * tau + terms[k - 1].b * pi1);
            double const next = ((2.0 * n + 1.0) * cosine * pi1 - (n + 1.0) * pi0) / n;
            pi0 = pi1, pi1 = next;
        }
        mie.intensity.push_back(0.5 * (std::norm(s1) + std::norm(s2)));
    }
    return mie;
}

/// Share of droplets of r radii against the effective one: a gamma distribution of effective variance 0.02 (Hansen 1971 gives 0.02 to 0.2), narrow as in
/// fresh cloud, by which the rings are seen.
double dropletCount(double r) {
    constexpr double kVariance = 0.02;
    return std::pow(r, 1.0 / kVariance - 3.0) * std::exp(-r / kVariance);
}

// ------------------------------------------------------------------------------------------------------------- ice

struct Face { glm::dvec3 normal; double distance; };

/// A hexagonal column, 1 across the edges' circle and twice as long.
std::array<Face, 8> column() {
    std::array<Face, 8> faces;
    for (int i = 0; i < 6; ++i) {
        double const turn = core::kPi / 3.0 * i;
        faces[static_cast<std::size_t>(i)] = {{std::cos(turn), std::sin(turn), 0.0}, std::sqrt(0.75)};
    }
    faces[6] = {{0, 0, 1}, 2.0};
    faces[7] = {{0, 0, -1}, 2.0};
    return faces;
}

/// A low-discrepancy sequence in four dimensions (Roberts 2018: powers of the root of x^5 = x + 1).
double strewn(int i, int dimension) {
    constexpr double kRoot = 1.1673039782614187;
    double const v = 0.5 + (i + 1) * std::pow(kRoot, -(dimension + 1));
    return v - std::floor(v);
}

glm::dvec3 onSphere(double u, double v) {
    double const z = 2.0 * u - 1.0, r = std::sqrt(std::max(1.0 - z * z, 0.0)), turn = 2.0 * core::kPi * v;
    return {r * std::cos(turn), r * std::sin(turn), z};
}

/// Where a ray inside the crystal leaves it.
std::size_t faceAhead(std::array<Face, 8> const& faces, glm::dvec3 const& from, glm::dvec3 const& way, double& distance) {
    std::size_t found = 0;
    distance = 1e9;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        double const toward = glm::dot(faces[i].normal, way);
        if (toward <= 1e-12) continue;
        double const t = (faces[i].distance - glm::dot(faces[i].normal, from)) / toward;
        if (t < distance) distance = t, found = i;
    }
    return found;
}

/// Where a ray from outside meets the crystal; false where it misses.
bool faceMet(std::array<Face, 8> const& faces, glm::dvec3 const& from, glm::dvec3 const& way, std::size_t& face, double& distance) {
    double enters = -1e9, leaves = 1e9;
    for (std::size_t i = 0; i < faces.size(); ++i) {
        double const toward = glm::dot(faces[i].normal, way), t = (faces[i].distance - glm::dot(faces[i].normal, from)) / toward;
        if (toward < 0.0 && t > enters) enters = t, face = i;
        if (toward > 0.0) leaves = std::min(leaves, t);
    }
    distance = enters;
    return enters < leaves;
}

/// One ray through the crystal: what it leaves in the bins. `way`: unit, in the crystal's frame.
void traceIce(std::array<Face, 8> const& faces, glm::dvec3 point, glm::dvec3 const& way, double index, std::vector<double>& bins) {
    std::size_t face = 0;
    double distance = 0.0;
    if (!faceMet(faces, point, way, face, distance)) return;
    point += distance * way;
    auto const scatter = [&](glm::dvec3 const& out, double energy) { bins[indexOf(std::acos(std::clamp(glm::dot(out, way), -1.0, 1.0)))] += energy; };
    glm::dvec3 inside = glm::refract(way, faces[face].normal, 1.0 / index);
    double const first = mirrored(-glm::dot(way, faces[face].normal), -glm::dot(inside, faces[face].normal), index);
    scatter(glm::reflect(way, faces[face].normal), first);
    double energy = 1.0 - first;
    for (int bounce = 0; bounce < 8 && energy > 1e-3; ++bounce) {
        face = faceAhead(faces, point, inside, distance);
        point += distance * inside;
        glm::dvec3 const normal = -faces[face].normal, out = glm::refract(inside, normal, index);
        double r = 1.0;
        if (glm::dot(out, out) > 0.5) {
            r = mirrored(-glm::dot(inside, normal), -glm::dot(out, normal), 1.0 / index);
            scatter(out, energy * (1.0 - r));
        }
        inside = glm::reflect(inside, normal);
        energy *= r;
    }
}

std::vector<double> iceEnergy(double index) {
    constexpr int kRays = 60000;
    constexpr double kBall = 2.25;  // around the crystal
    std::array<Face, 8> const faces = column();
    std::vector<double> bins(kPhaseAngles, 0.0);
    for (int i = 0; i < kRays; ++i) {
        glm::dvec3 const way = onSphere(strewn(i, 0), strewn(i, 1));
        glm::dvec3 const side = glm::normalize(glm::cross(way, std::abs(way.z) < 0.9 ? glm::dvec3{0, 0, 1} : glm::dvec3{1, 0, 0}));
        double const r = kBall * std::sqrt(strewn(i, 2)), turn = 2.0 * core::kPi * strewn(i, 3);
        glm::dvec3 const aside = r * (std::cos(turn) * side + std::sin(turn) * glm::cross(way, side));
        traceIce(faces, aside - 4.0 * way, way, index, bins);
    }
    return bins;
}
}  // namespace

PhaseTable rainPhase() {
    constexpr int kAxis = 15;  // bins: 1.5 degrees
    PhaseTable table(kPhaseAngles, glm::vec4{0.0f});
    for (int i = 0; i < kWavelengths; ++i) {
        std::vector<double> const bins = dropEnergy(waterIndex(wavelength_nm(i)));
        std::vector<double> phase = phaseOf(blurred(bins, core::radians(0.3)));
        // Rays through a drop's middle meet in a point straight back, which waves do not.
        std::fill(phase.end() - kAxis, phase.end(), *(phase.end() - kAxis - 1));
        addSpectrum(table, phase, i);
    }
    return table;
}

PhaseTable dropletPhase(double effectiveRadius) {
    constexpr int kFirst = 1100, kSizes = 24;
    std::vector<double> cosines;
    for (int i = kFirst; i < kPhaseAngles; i += 2) cosines.push_back(std::cos(i * kStep));
    PhaseTable table(kPhaseAngles, glm::vec4{0.0f});
    for (int i = 0; i < kWavelengths; i += 2) {
        double const wave = 2.0 * core::kPi / (wavelength_nm(i) * 1e-9);  // 1/m
        std::vector<double> sum(cosines.size(), 0.0);
        double scattering = 0.0;
        for (int size = 0; size < kSizes; ++size) {
            double const r = 0.55 + 0.95 * size / (kSizes - 1.0), count = dropletCount(r);
            Mie const mie = mieOf(wave * effectiveRadius * r, waterIndex(wavelength_nm(i)), cosines);
            scattering += count * mie.scattering;
            for (std::size_t k = 0; k < sum.size(); ++k) sum[k] += count * mie.intensity[k];
        }
        std::vector<double> phase(kPhaseAngles, 0.0);  // |S|^2 / (pi Q x^2)
        for (std::size_t k = 0; k < sum.size(); ++k)
            for (std::size_t near = 0; near < 2 && kFirst + 2 * k + near < phase.size(); ++near)
                phase[kFirst + 2 * k + near] = (near == 0 || k + 1 == sum.size() ? sum[k] : 0.5 * (sum[k] + sum[k + 1])) / (core::kPi * scattering);
        std::vector<double> const soft = blurred(phase, core::radians(0.1));
        // Every second wavelength stands for itself and half of its neighbours.
        for (int near = std::max(i - 1, 0); near <= std::min(i + 1, kWavelengths - 1); ++near) {
            std::vector<double> part = soft;
            double const share = near == i ? 1.0 : 0.5;
            for (double& value : part) value *= share;
            addSpectrum(table, part, near);
        }
    }
    return table;
}

PhaseTable icePhase() {
    PhaseTable table(kPhaseAngles, glm::vec4{0.0f});
    constexpr int kEach = 5;  // every fifth wavelength stands for those around it
    for (int middle = kEach / 2; middle < kWavelengths; middle += kEach) {
        std::vector<double> const bins = iceEnergy(iceIndex(wavelength_nm(middle)));
        std::vector<double> const soft = phaseOf(blurred(bins, core::radians(0.15)));
        for (int i = middle - kEach / 2; i <= std::min(middle + kEach / 2, kWavelengths - 1); ++i) addSpectrum(table, soft, i);
        if (middle + kEach >= kWavelengths && middle + kEach / 2 < kWavelengths - 1)
            for (int i = middle + kEach / 2 + 1; i < kWavelengths; ++i) addSpectrum(table, soft, i);
    }
    return table;
}
}  // namespace luftpost::sky
