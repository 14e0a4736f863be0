#include "game/app/photo_box.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "engine/core/error.h"
#include "engine/core/time.h"

namespace luftpost::app {
namespace {
constexpr int kMostPixels = 2560;  // across or down: more is not seen on a screen

/// No larger than the screen needs, its shape kept.
assets::Image forTheScreen(assets::Image image) {
    int const longer = std::max(image.width, image.height);
    if (longer <= kMostPixels) return image;
    auto const side = [&](int length) { return std::max(1, length * kMostPixels / longer); };
    assets::Image const small = resampled(image, side(image.width), side(image.height));
    assets::Image whole{small.width, small.height, 4, {}};
    whole.values.assign(whole.index(0, whole.height, 0), 255);
    for (int y = 0; y < small.height; ++y)
        for (int x = 0; x < small.width; ++x) std::copy_n(&small.at(x, y, 0), 3, &whole.at(x, y, 0));
    return whole;
}
}  // namespace

std::vector<assets::PhotoFile> photosOption(std::filesystem::path const& fileOrFolder, core::UtcSeconds time) {
    std::vector<assets::PhotoFile> photos = assets::findPhotos(fileOrFolder);
    assets::readImage(photos[assets::nearestPhoto(photos, time)].file);  // a broken one is refused before anything is made
    return photos;
}

std::string takenText(assets::PhotoFile const& photo) {
    if (!photo.taken) return "taken at no known time";
    std::string const time = core::formatUtc(*photo.taken);
    return fmt::format("taken {} {} UTC, by {}", time.substr(0, 10), time.substr(11, 5), photo.saidBy);
}

std::optional<std::string> PhotoBox::follow(core::UtcSeconds utc) {
    wanted_ = assets::nearestPhoto(photos_, utc);
    if (reading_.valid()) {
        if (reading_.wait_for(std::chrono::seconds{0}) != std::future_status::ready) return std::nullopt;
        return take(reading_.get());
    }
    if (wanted_ == shown_) return std::nullopt;
    reading_ = std::async(std::launch::async, [which = *wanted_, file = photos_[*wanted_].file]() -> Read {
        try {
            return {which, forTheScreen(assets::readImage(file)), {}};
        } catch (core::Error const& error) {
            return {which, std::nullopt, error.what()};
        }
    });
    return std::nullopt;
}

void PhotoBox::finish() {
    if (reading_.valid()) take(reading_.get());
}

std::optional<std::string> PhotoBox::take(Read read) {
    shown_ = read.which;  // a broken one is not tried again until another was nearer
    comparison_.reset();
    if (!read.image) return read.error;
    image_ = std::move(read.image);
    ++version_;
    return std::nullopt;
}

void PhotoBox::compare(assets::Image const& picture) {
    if (image_) comparison_ = compareColours(picture, *image_);
}

ui::PhotoState PhotoBox::state() const {
    if (!image_ || !shown_) return {};
    assets::PhotoFile const& photo = photos_[*shown_];
    return {photo.file.filename().string(), takenText(photo), comparison_ ? comparisonText(*comparison_) : "", view_, {image_->width, image_->height}};
}
}  // namespace luftpost::app
