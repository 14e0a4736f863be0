// The courier's work: one job at a time, one parcel at a time. Advanced in ticks; pure rules, no GL, no clock
// of its own.
#pragma once
#include <deque>
#include <optional>
#include <vector>

#include "game/delivery/drop_zone.h"
#include "game/delivery/parcel.h"

namespace luftpost::delivery {
/// One parcel that was released. Times in seconds of flight.
struct Drop {
    double t = 0.0;
    glm::dvec3 releaseWorld{0.0};
    std::optional<double> landingTime;  // none: still in the air
    glm::dvec3 landingWorld{0.0};
    double distance = 0.0;  // m from the centre of the zone that was due
    double score = 0.0;
    bool delivered = false;
};

/// What a tick brought about, for messages and sounds.
enum class DeliveryEvent { none, released, chuteOpened, delivered, lost };

class Delivery {
public:
    /// The first zone lies ahead of the start. `seed` of land and jobs.
    Delivery(unsigned seed, glm::dvec2 startEastNorth, glm::dvec2 headingEastNorth,
             core::GroundFunction const& ground);

    /// Releases the parcel if one is aboard: it keeps the aircraft's velocity. `t` in seconds of flight.
    DeliveryEvent release(glm::dvec3 const& positionWorld, glm::dvec3 const& velocityWorld, double t);
    /// One tick, beginning at `t` seconds of flight and `time`: moves the parcel, judges it at touchdown. A
    /// served zone is followed by the next; outside it the parcel is lost and the job stays. A new parcel is
    /// aboard at once.
    DeliveryEvent step(core::AirFunction const& air, core::GroundFunction const& ground, double t,
                       core::UtcSeconds time);

    DropZone const& target() const { return target_; }
    bool parcelAboard() const { return !parcel_; }
    /// In the air: the parcel of this tick and of the tick before (for the picture between them).
    std::optional<Parcel> const& parcel() const { return parcel_; }
    Parcel const& parcelBefore() const { return before_; }
    ParcelData const& parcelData() const { return data_; }
    /// Parcels that lie on the ground, the newest last (the last eight).
    std::deque<glm::dvec3> const& landed() const { return landed_; }

    std::vector<Drop> const& drops() const { return drops_; }
    double score() const { return score_; }
    int deliveries() const { return deliveries_; }
    std::uint64_t randomState() const { return random_.state(); }

private:
    DeliveryEvent touchDown(glm::dvec3 const& place, core::GroundFunction const& ground, double t);

    core::Random random_;
    DropZone target_;
    ParcelData data_;
    std::optional<Parcel> parcel_;
    Parcel before_;
    std::deque<glm::dvec3> landed_;
    std::vector<Drop> drops_;
    double score_ = 0.0;
    int deliveries_ = 0;
};

/// Calls `take(double)` for every number of the work that the flight's future depends on, in a fixed order.
template <class Take>
void forEachNumber(Delivery const& delivery, Take&& take) {
    auto const vector = [&](glm::dvec3 const& v) { take(v.x), take(v.y), take(v.z); };
    take(delivery.target().east), take(delivery.target().north), take(delivery.target().height);
    take(delivery.parcelAboard() ? 1.0 : 0.0);
    if (auto const& parcel = delivery.parcel())
        vector(parcel->positionWorld), vector(parcel->velocityWorld), take(parcel->age), take(parcel->chute);
    take(delivery.score()), take(static_cast<double>(delivery.deliveries()));
    take(static_cast<double>(delivery.drops().size()));
}
}  // namespace luftpost::delivery
