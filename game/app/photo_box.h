// The photographs of --photo: the one nearest to the weather's clock is read beside the frame and shown. Main thread.
#pragma once
#include <filesystem>
#include <future>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "engine/assets/image.h"
#include "engine/assets/photo.h"
#include "game/app/colour_comparison.h"
#include "game/ui/photo_view.h"

namespace luftpost::app {
/// The photographs of --photo. Throws core::Error where there is none, or where the one nearest to `time` cannot be read.
std::vector<assets::PhotoFile> photosOption(std::filesystem::path const& fileOrFolder, core::UtcSeconds time);
/// "taken 2023-06-22 17:21 UTC, by EXIF", "taken at no known time".
std::string takenText(assets::PhotoFile const& photo);

class PhotoBox {
public:
    explicit PhotoBox(std::vector<assets::PhotoFile> photos) : photos_{std::move(photos)} {}

    /// Once a frame: another photograph when the clock is nearer to it. A line where one cannot be read.
    std::optional<std::string> follow(core::UtcSeconds utc);
    /// Waits for the one that is being read: a picture that is written shall show it.
    void finish();

    /// None until the first is read.
    assets::Image const* image() const { return image_ ? &*image_ : nullptr; }
    int version() const { return version_; }
    ui::PhotoState state() const;
    ui::PhotoView& view() { return view_; }
    /// `picture` without instruments, as the player sees it.
    void compare(assets::Image const& picture);

private:
    struct Read {
        std::size_t which = 0;
        std::optional<assets::Image> image;
        std::string error;
    };
    std::optional<std::string> take(Read read);

    std::vector<assets::PhotoFile> photos_;
    std::optional<std::size_t> wanted_, shown_;
    std::optional<assets::Image> image_;
    int version_ = 0;
    ui::PhotoView view_;
    std::optional<ColourComparison> comparison_;
    std::future<Read> reading_;
};
}  // namespace luftpost::app
