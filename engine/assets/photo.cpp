#include "engine/assets/photo.h"

#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/time.h"

namespace luftpost::assets {
namespace {
namespace fs = std::filesystem;
constexpr std::array<std::string_view, 8> kEndings{".jpg", ".jpeg", ".png", ".tif", ".tiff", ".exr", ".webp", ".heic"};

bool isDigit(char c) { return c >= '0' && c <= '9'; }

/// "2023-06-22T17:20:05Z" out of its digits, if such a moment exists.
std::optional<core::UtcSeconds> timeOfDigits(std::string_view d) {
    return core::parseUtc(fmt::format("{}-{}-{}T{}:{}:{}Z", d.substr(0, 4), d.substr(4, 2), d.substr(6, 2), d.substr(8, 2), d.substr(10, 2), d.substr(12, 2)));
}

/// Seconds east of Greenwich; nothing for another shape.
std::optional<double> offsetSeconds(std::string_view text) {
    if (text == "Z") return 0.0;
    if (text.size() != 6 || (text[0] != '+' && text[0] != '-') || text[3] != ':') return std::nullopt;
    for (std::size_t i : {1u, 2u, 4u, 5u})
        if (!isDigit(text[i])) return std::nullopt;
    auto const two = [&](std::size_t i) { return 10.0 * (text[i] - '0') + (text[i + 1] - '0'); };
    double const seconds = 3600.0 * two(1) + 60.0 * two(4);
    return text[0] == '-' ? -seconds : seconds;
}

PhotoFile photoOf(fs::path const& file) {
    auto const input = OIIO::ImageInput::open(file.string());
    if (!input) throw core::Error{file.string(), "", "expected an image: " + OIIO::geterror()};
    OIIO::ImageSpec const& spec = input->spec();
    std::string const original = spec.get_string_attribute("Exif:DateTimeOriginal"), offset = spec.get_string_attribute("Exif:OffsetTimeOriginal");
    if (auto const taken = exifTime(original, offset)) return {file, taken, offsetSeconds(offset) ? "EXIF" : "EXIF, its clock as UTC"};
    if (auto const taken = timeInName(file.stem().string())) return {file, taken, "its name"};
    return {file, std::nullopt, ""};
}

bool looksLikeImage(fs::path const& file) {
    std::string ending = file.extension().string();
    std::transform(ending.begin(), ending.end(), ending.begin(), [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c + 32) : c; });
    return std::find(kEndings.begin(), kEndings.end(), ending) != kEndings.end();
}
}  // namespace

std::optional<core::UtcSeconds> exifTime(std::string_view dateTime, std::string_view offset) {
    std::string digits;
    for (std::size_t i = 0; i < dateTime.size(); ++i) {
        bool const sign = i == 4 || i == 7 || i == 13 || i == 16;
        if (sign ? dateTime[i] != ':' : i == 10 ? dateTime[i] != ' ' : !isDigit(dateTime[i])) return std::nullopt;
        if (isDigit(dateTime[i])) digits += dateTime[i];
    }
    if (digits.size() != 14) return std::nullopt;
    auto const clock = timeOfDigits(digits);
    if (!clock) return std::nullopt;
    return *clock - offsetSeconds(offset).value_or(0.0);
}

std::optional<core::UtcSeconds> timeInName(std::string_view name) {
    for (std::size_t start = 0; start < name.size(); ++start) {
        if (!isDigit(name[start]) || (start > 0 && isDigit(name[start - 1]))) continue;
        std::string digits;
        for (std::size_t i = start; i < name.size() && digits.size() < 14; ++i) {
            if (isDigit(name[i])) digits += name[i];
            else if (i > start && !isDigit(name[i - 1])) break;  // one sign between two groups
            else if (std::string_view{"-_T.: h"}.find(name[i]) == std::string_view::npos) break;
        }
        if (digits.size() < 12) continue;
        digits.resize(digits.size() >= 14 ? 14 : 12);
        if (digits.size() == 12) digits += "00";
        if (auto const time = timeOfDigits(digits)) return time;
    }
    return std::nullopt;
}

std::vector<PhotoFile> findPhotos(fs::path const& given) {
    std::error_code error;
    if (!fs::is_directory(given, error)) return {photoOf(given)};
    std::vector<fs::path> files;
    for (auto const& entry : fs::directory_iterator{given, error})
        if (looksLikeImage(entry.path())) files.push_back(entry.path());
    if (error) throw core::Error{given.string(), "", "expected a folder that can be read: " + error.message()};
    if (files.empty()) throw core::Error{given.string(), "", "expected photographs in the folder, found none"};
    std::sort(files.begin(), files.end());
    std::vector<PhotoFile> photos;
    for (fs::path const& file : files) photos.push_back(photoOf(file));
    return photos;
}

std::size_t nearestPhoto(std::span<PhotoFile const> photos, core::UtcSeconds time) {
    CHECK(!photos.empty(), "no photograph to choose from");
    auto const distance = [time](PhotoFile const& photo) { return photo.taken ? std::abs(*photo.taken - time) : 1e300; };
    auto const nearest = std::min_element(photos.begin(), photos.end(), [&](auto const& a, auto const& b) { return distance(a) < distance(b); });
    return static_cast<std::size_t>(nearest - photos.begin());
}
}  // namespace luftpost::assets
