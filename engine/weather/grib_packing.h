// Whether the data of a GRIB 2 field add up: what ecCodes takes for granted while it unpacks them.
#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <string_view>

namespace luftpost::weather {
/// The big-endian whole number of `count` octets (at most 4); octet 1 is the section's first, as in WMO's templates. The
/// section must be long enough.
std::size_t gribNumber(std::string_view section, std::size_t octet, std::size_t count);

/// Sections 5 (packing), 6 (bitmap, with its own bits) and 7 (data) of a field of so many points: what does not fit, in words;
/// nothing when all is well. Templates 0, 2, 3 (simple, complex, spatial differencing), 40 (JPEG 2000) and 42 (CCSDS) are known.
std::optional<std::string> gribMisfit(std::string_view packing, std::string_view bitmap, std::string_view data, std::size_t points);
}  // namespace luftpost::weather
