#include "engine/weather/fronts.h"

#include <algorithm>
#include <cmath>

#include "engine/core/math.h"

namespace luftpost::weather {
namespace {
constexpr double kShift = 0.8660254037844387;  // cosine of 30 degrees
constexpr double kFall = 3.0;                  // K
constexpr double kRise = 100.0;                // Pa
constexpr double kSpan = 1800.0;               // s
constexpr double kHourly = 3900.0;             // s, between two hourly reports
constexpr double kOneFront = 3600.0;           // s: what follows within is the same front
constexpr double kNoCalm = 2.0;                // m/s, behind the front
constexpr double kLeastSpeed = 5.0, kMostSpeed = 50.0;      // m/s
constexpr double kSeconds = 450.0;                          // of the change, 10 to 90 %
constexpr double kNarrowest = 3000.0, kWidest = 6000.0;     // m, likewise
constexpr double kMiddleShare = 0.608;                      // of a cubic's way from 0 to 1: its part from 10 to 90 %
constexpr double kSameFront = 5400.0;                       // s, from where another site's front may be expected
constexpr double kAround = 1800.0, kLeastFade = 5400.0;     // s: time is moved whole so near to a front, less and less beyond
constexpr double kLatest = 4.0 * 3600.0;                    // s: farther away the front counts as no later

bool said(FullReport const& report, char const* place) { return !report.filled.contains(place); }

bool shifts(FullReport const& a, FullReport const& b) {
    double const before = glm::length(a.wind), after = glm::length(b.wind);
    if (!said(a, "wind.from_deg") || !said(b, "wind.from_deg") || before < 0.3 || after < kNoCalm) return false;
    return glm::dot(a.wind, b.wind) <= kShift * before * after * (1.0 + 1e-9);
}

bool changesMass(FullReport const& a, FullReport const& b) {
    bool const falls = said(a, "temperature_c") && said(b, "temperature_c") && a.temperature - b.temperature >= kFall - 1e-9;
    bool const rises = said(a, "pressure_hpa") && said(b, "pressure_hpa") && b.pressureSea - a.pressureSea >= kRise - 1e-6;
    return falls || rises;
}

/// The earliest report before k, within the span, against which k is behind a front; k where there is none.
std::size_t aheadOf(std::vector<FullReport> const& reports, std::size_t k) {
    for (std::size_t j = 0; j < k; ++j) {
        double const span = reports[k].time - reports[j].time;
        bool const near = span <= kSpan || (j + 1 == k && span <= kHourly);
        if (near && shifts(reports[j], reports[k]) && changesMass(reports[j], reports[k])) return j;
    }
    return k;
}

/// How much speaks for the passage between reports m - 1 and m: gust, else rain, else the turn of the wind.
double strengthOf(std::vector<FullReport> const& reports, std::size_t m) {
    double const turn = glm::length(reports[m].wind - reports[m - 1].wind);
    double const rain = said(reports[m], "precipitation.rate_mm_h") ? reports[m].rate : 0.0;
    double const gust = said(reports[m], "wind.gust_mps") ? reports[m].gust : 0.0;
    return gust * 1e6 + rain * 1e3 + turn;
}

FrontSeen passageBetween(std::vector<FullReport> const& reports, std::size_t first, std::size_t last) {
    std::size_t best = first + 1;
    for (std::size_t m = first + 1; m <= last; ++m)
        if (strengthOf(reports, m) > strengthOf(reports, best)) best = m;
    return {best, 0.5 * (reports[best - 1].time + reports[best].time), reports[best].wind};
}

double smooth(double u) {
    u = std::clamp(u, 0.0, 1.0);
    return u * u * (3.0 - 2.0 * u);
}

/// Square to the wind behind the line, with that wind.
glm::dvec2 slownessBehind(std::vector<FrontPass> const& passes) {
    glm::dvec2 wind{0.0};
    for (FrontPass const& pass : passes) wind += pass.seen.windBehind / static_cast<double>(passes.size());
    double const speed = glm::length(wind);
    glm::dvec2 const toward = speed > 0.1 ? wind / speed : glm::dvec2{1.0, 0.0};
    return toward / std::max(speed, kLeastSpeed);
}

/// Least squares of time = origin + slowness . place; nothing where the sites stand in a row or the speed is no front's.
std::optional<glm::dvec2> fittedSlowness(std::vector<FrontPass> const& passes) {
    if (passes.size() < 3) return std::nullopt;
    double const n = static_cast<double>(passes.size());
    double east = 0.0, north = 0.0, time = 0.0;
    for (FrontPass const& p : passes) {
        east += p.east / n;
        north += p.north / n;
        time += (p.seen.time - passes.front().seen.time) / n;
    }
    double ee = 0.0, en = 0.0, nn = 0.0, et = 0.0, nt = 0.0;
    for (FrontPass const& p : passes) {
        double const e = p.east - east, q = p.north - north, t = p.seen.time - passes.front().seen.time - time;
        ee += e * e;
        en += e * q;
        nn += q * q;
        et += e * t;
        nt += q * t;
    }
    double const determinant = ee * nn - en * en;
    if (determinant < 1e-3 * (ee + nn) * (ee + nn)) return std::nullopt;
    glm::dvec2 const slowness{(et * nn - nt * en) / determinant, (nt * ee - et * en) / determinant};
    double const slow = glm::length(slowness);
    if (slow < 1.0 / kMostSpeed || slow > 1.0 / (0.3 * kLeastSpeed)) return std::nullopt;
    return slowness;
}

void fit(Front& front) {
    front.slowness = fittedSlowness(front.passes).value_or(slownessBehind(front.passes));
    front.origin = 0.0;
    double const n = static_cast<double>(front.passes.size());
    auto const along = [&](FrontPass const& p) { return front.slowness.x * p.east + front.slowness.y * p.north; };
    for (FrontPass const& pass : front.passes) front.origin += (pass.seen.time - along(pass)) / n;
    for (FrontPass& pass : front.passes) pass.late = pass.seen.time - front.origin - along(pass);
}

/// Whether another site's passage is this front's.
bool belongs(Front const& front, FrontPass const& pass) {
    for (FrontPass const& other : front.passes)
        if (other.site == pass.site) return false;
    FrontPass const& first = front.passes.front();
    glm::dvec2 const slowness = slownessBehind({first});
    double const due = slowness.x * (pass.east - first.east) + slowness.y * (pass.north - first.north);
    return std::abs(pass.seen.time - first.seen.time - due) <= kSameFront + 0.7 * std::abs(due);
}
}  // namespace

Window windowWithin(std::vector<Window> const& windows, double from, double to) {
    for (Window const& window : windows)
        if (window.from >= from && window.to <= to) return window;
    return {from, to};
}

std::vector<FrontSeen> frontsOver(std::vector<FullReport> const& reports) {
    std::vector<FrontSeen> fronts;
    std::size_t k = 1;
    while (k < reports.size()) {
        std::size_t const first = aheadOf(reports, k);
        if (first == k) {
            ++k;
            continue;
        }
        std::size_t last = k;
        for (std::size_t m = k + 1; m < reports.size() && reports[m].time - reports[k].time <= kSpan; ++m)
            if (aheadOf(reports, m) < m) last = m;
        fronts.push_back(passageBetween(reports, first, last));
        double const passed = reports[last].time;
        while (k < reports.size() && (k <= last || reports[k].time - passed <= kOneFront - kSpan)) ++k;
    }
    return fronts;
}

double Front::passageAt(double east, double north) const {
    double late = 0.0, sum = 0.0;
    for (FrontPass const& pass : passes) {
        double const e = east - pass.east, n = north - pass.north, weight = 1.0 / (e * e + n * n + 1.0);
        late += weight * pass.late;
        sum += weight;
    }
    return origin + slowness.x * east + slowness.y * north + late / sum;
}

double Front::speed() const { return 1.0 / glm::length(slowness); }
double Front::width() const { return std::clamp(kSeconds * speed(), kNarrowest, kWidest); }

Window Front::windowAt(double time) const {
    double const half = 0.5 * width() / (kMiddleShare * speed());
    return {time - half, time + half};
}

std::vector<Front> joinedFronts(std::vector<FrontPass> passes) {
    std::stable_sort(passes.begin(), passes.end(), [](FrontPass const& a, FrontPass const& b) { return a.seen.time < b.seen.time; });
    std::vector<Front> fronts;
    for (FrontPass const& pass : passes) {
        auto const front = std::find_if(fronts.begin(), fronts.end(), [&](Front const& f) { return belongs(f, pass); });
        if (front == fronts.end()) fronts.push_back({{pass}});
        else front->passes.push_back(pass);
    }
    for (Front& front : fronts) fit(front);
    return fronts;
}

double readingTime(double time, std::vector<PassedBy> const& fronts) {
    double late = 0.0, sum = 0.0, most = 0.0;
    for (PassedBy const& front : fronts) {
        double const own = std::clamp(front.late, -kLatest, kLatest), away = std::abs(time - front.time - own);
        double const near = 1.0 - smooth((away - kAround) / std::max(kLeastFade, 2.0 * std::abs(own)));
        double const weight = near / (away + 60.0);
        late += weight * own;
        sum += weight;
        most = std::max(most, near);
    }
    return sum > 0.0 ? time - most * late / sum : time;
}
}  // namespace luftpost::weather
