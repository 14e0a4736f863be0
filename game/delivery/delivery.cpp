#include "game/delivery/delivery.h"

#include <algorithm>
#include <cmath>

#include "engine/core/frames.h"

namespace luftpost::delivery {
namespace {
constexpr std::size_t kLandedKept = 8;

/// The stretch of a segment from `above` (over the ground) to `below` where it meets the ground, by halving.
glm::dvec3 touchdownPoint(glm::dvec3 above, glm::dvec3 below, core::GroundFunction const& ground) {
    for (int i = 0; i < 12; ++i) {
        glm::dvec3 const middle = (above + below) * 0.5;
        (middle.y > ground(middle.x, -middle.z).height ? above : below) = middle;
    }
    return {above.x, ground(above.x, -above.z).height, above.z};
}
}  // namespace

Delivery::Delivery(unsigned seed, glm::dvec2 start, glm::dvec2 heading, core::GroundFunction const& ground)
    : random_{0x4c756674706f7374u ^ seed}, target_{firstDropZone(random_, start, heading, ground)} {}

DeliveryEvent Delivery::release(glm::dvec3 const& position, glm::dvec3 const& velocity, double t) {
    if (!parcelAboard()) return DeliveryEvent::none;
    parcel_ = Parcel{position, velocity, 0.0, 0.0};
    before_ = *parcel_;
    Drop drop;
    drop.t = t;
    drop.releaseWorld = position;
    drops_.push_back(drop);
    return DeliveryEvent::released;
}

DeliveryEvent Delivery::step(core::AirFunction const& air, core::GroundFunction const& ground, double t,
                             core::UtcSeconds time) {
    if (!parcel_) return DeliveryEvent::none;
    before_ = *parcel_;
    stepParcel(*parcel_, data_, air(parcel_->positionWorld, time), core::kTickSeconds);
    glm::dvec3 const& now = parcel_->positionWorld;
    if (now.y <= ground(now.x, -now.z).height)
        return touchDown(touchdownPoint(before_.positionWorld, now, ground), ground, t + core::kTickSeconds);
    bool const opens = before_.chute <= 0.0 && parcel_->chute > 0.0;
    return opens ? DeliveryEvent::chuteOpened : DeliveryEvent::none;
}

DeliveryEvent Delivery::touchDown(glm::dvec3 const& place, core::GroundFunction const& ground, double t) {
    Drop& drop = drops_.back();
    drop.landingTime = t;
    drop.landingWorld = place;
    drop.distance = distanceFrom(target_, place.x, -place.z);
    drop.score = pointsFor(drop.distance);
    drop.delivered = drop.distance < kDropZoneRadius;
    parcel_.reset();
    landed_.push_back(place);
    if (landed_.size() > kLandedKept) landed_.pop_front();
    if (!drop.delivered) return DeliveryEvent::lost;
    score_ += drop.score;
    ++deliveries_;
    target_ = nextDropZone(random_, target_, ground);
    return DeliveryEvent::delivered;
}
}  // namespace luftpost::delivery
