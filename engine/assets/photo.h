// Photographs and when they were taken: from the file's EXIF data, else from its name.
#pragma once
#include <filesystem>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "engine/core/environment.h"

namespace luftpost::assets {
struct PhotoFile {
    std::filesystem::path file;
    std::optional<core::UtcSeconds> taken;  // none: nothing says when
    std::string saidBy;                     // "EXIF", "EXIF, its clock as UTC", "its name"; empty: nobody
};

/// The time of EXIF's DateTimeOriginal ("2023:06:22 19:20:05") with its OffsetTimeOriginal ("+02:00"); without an offset the clock is
/// taken for UTC. Nothing for a text of another shape.
std::optional<core::UtcSeconds> exifTime(std::string_view dateTime, std::string_view offset);

/// The time in a file's name, in UTC: year, month, day, hour, minute and perhaps second as 12 or 14 digits, with or without signs
/// between them ("2023-06-22T17-20Z", "IMG_20230622_172005"). Nothing where there is none.
std::optional<core::UtcSeconds> timeInName(std::string_view name);

/// One image with its time, or all images of a folder (by name; files that are no images are passed over). Throws core::Error where
/// there is none or one cannot be read.
std::vector<PhotoFile> findPhotos(std::filesystem::path const& fileOrFolder);

/// The photograph taken nearest to `time`: its place in `photos` (not empty). Those without a time count last.
std::size_t nearestPhoto(std::span<PhotoFile const> photos, core::UtcSeconds time);
}  // namespace luftpost::assets
