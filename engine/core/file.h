// Whole files, read and written. All throw Error naming the file and what the system said.
#pragma once
#include <cstddef>
#include <filesystem>
#include <limits>
#include <string>
#include <string_view>

namespace luftpost::core {
/// The bytes of the file; throws when there are more than `most`.
std::string readFile(std::filesystem::path const& file, std::size_t most = std::numeric_limits<std::size_t>::max());

/// Writes a new file beside it, flushes it to the disk and renames it: after a crash the file is the old one
/// or the new one, never a part. Makes no folder. A target that is no plain file (/dev/stdout) is written in
/// place.
void writeFileAtomically(std::filesystem::path const& file, std::string_view bytes);

/// Takes a file that was written beside its place: flushes it to the disk and renames it.
void moveIntoPlace(std::filesystem::path const& fresh, std::filesystem::path const& file);

/// Throws when the folder that `file` would lie in does not exist or is no folder, or `file` itself is a
/// folder. `option` is named in the message ("--log").
void checkOutputFolder(std::string_view option, std::filesystem::path const& file);
}  // namespace luftpost::core
