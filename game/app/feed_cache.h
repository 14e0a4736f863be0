// The last answer of a provider, kept on disk for the next start.
#pragma once
#include <filesystem>
#include <optional>

#include "game/app/weather_provider.h"

namespace luftpost::app {
struct KeptNews {
    WeatherNews news;
    core::UtcSeconds asked = 0.0;  // when
};

/// What the file keeps. A missing file keeps nothing; one that is broken (its form, its checksum, its recording) is removed and said so
/// in the log. Never throws.
std::optional<KeptNews> readKept(std::filesystem::path const& file);
/// Writes it atomically; a disk that refuses is said so in the log. Never throws.
void writeKept(std::filesystem::path const& file, KeptNews const& kept);
}  // namespace luftpost::app
