#include "engine/weather/grib_values.h"

#include <eccodes.h>
#include <fmt/format.h>
#include <grib_api.h>

#include <cmath>
#include <limits>
#include <memory>
#include <mutex>

#include "engine/core/error.h"

namespace luftpost::weather {
namespace {
constexpr double kHole = -1e34;  // no quantity comes near it; ecCodes' own 9999 is a fine visibility

/// What ecCodes says when it stops the program: an error of the file instead. It comes by way of C frames, which keep no state
/// of their own here but memory.
void refuse(char const* message) { throw core::Error("ecCodes", "", message); }

/// ecCodes writes to standard error and stops the program unless it is told not to.
void quieten() {
    static std::once_flag once;
    std::call_once(once, [] {
        codes_context_set_logging_proc(codes_context_get_default(), [](codes_context const*, int, char const*) {});
        codes_set_codes_assertion_failed_proc(refuse);
    });
}

struct DeleteHandle {
    void operator()(codes_handle* handle) const { codes_handle_delete(handle); }
};
}  // namespace

std::vector<double> gribValues(GribField const& field, std::string const& file) {
    static std::mutex mutex;
    std::lock_guard const lock{mutex};
    quieten();
    auto const fail = [&](std::string const& what) { throw core::Error(file, field.place, "expected data that ecCodes can unpack: " + what); };
    std::unique_ptr<codes_handle, DeleteHandle> const handle{codes_handle_new_from_message_copy(nullptr, field.message.data(), field.message.size())};
    if (!handle) fail("not a message");
    std::size_t const points = field.grid.points();
    std::vector<double> values(points);
    try {
        std::size_t count = 0;
        int error = codes_set_double(handle.get(), "missingValue", kHole);
        if (!error) error = codes_get_size(handle.get(), "values", &count);
        if (error) fail(codes_get_error_message(error));
        if (count != points) fail(fmt::format("{} values for {} points", count, points));
        error = codes_get_double_array(handle.get(), "values", values.data(), &count);
        if (error) fail(codes_get_error_message(error));
    } catch (core::Error const& error) {
        throw core::Error(file, field.place, error.what());
    }
    for (double& value : values)
        if (value == kHole || !std::isfinite(value)) value = std::numeric_limits<double>::quiet_NaN();
    return values;
}

std::optional<double> gribValueAt(std::vector<double> const& values, GribGrid const& grid, GribGrid::Spot spot) {
    auto const column = static_cast<std::size_t>(spot.column), row = static_cast<std::size_t>(spot.row);
    double const u = spot.column - static_cast<double>(column), v = spot.row - static_cast<double>(row);
    auto const at = [&](std::size_t r, std::size_t c) {
        std::size_t const inside = grid.around ? c % grid.columns : std::min(c, grid.columns - 1);
        return values[std::min(r, grid.rows - 1) * grid.columns + inside];
    };
    double const a = at(row, column), b = at(row, column + 1), c = at(row + 1, column), d = at(row + 1, column + 1);
    auto const blend = [](double x, double y, double share) { return share == 0.0 ? x : share == 1.0 ? y : x + (y - x) * share; };
    double value = blend(blend(a, b, u), blend(c, d, u), v);
    if (std::isnan(value)) value = at(row + (v > 0.5 ? 1 : 0), column + (u > 0.5 ? 1 : 0));
    return std::isnan(value) ? std::nullopt : std::optional{value};
}
}  // namespace luftpost::weather
