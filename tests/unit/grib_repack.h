// A GRIB message in another packing, by ecCodes itself.
#pragma once
#include <eccodes.h>

#include <string>
#include <vector>

namespace luftpost::tests {
/// `type` is ecCodes' name: grid_simple, grid_jpeg, grid_ccsds. Empty where this ecCodes cannot.
inline std::string repacked(std::string const& message, std::string const& type) {
    codes_handle* handle = codes_handle_new_from_message_copy(nullptr, message.data(), message.size());
    std::size_t count = 0;
    codes_get_size(handle, "values", &count);
    std::vector<double> values(count);
    codes_get_double_array(handle, "values", values.data(), &count);
    std::size_t length = std::string{"grid_simple"}.size();
    codes_set_string(handle, "packingType", "grid_simple", &length);
    codes_set_long(handle, "bitsPerValue", 14);
    codes_set_double_array(handle, "values", values.data(), count);
    length = type.size();
    int const error = codes_set_string(handle, "packingType", type.c_str(), &length);
    void const* bytes = nullptr;
    codes_get_message(handle, &bytes, &count);
    std::string text{static_cast<char const*>(bytes), count};
    codes_handle_delete(handle);
    return error == 0 ? text : std::string{};
}
}  // namespace luftpost::tests
