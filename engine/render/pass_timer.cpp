#include "engine/render/pass_timer.h"

#include <algorithm>

namespace luftpost::render {
PassTimer::Entry& PassTimer::next(char const* name) {
    if (used_ == entries_.size()) entries_.push_back({{}, gl::Query::timestamp(), gl::Query::timestamp()});
    if (used_ == 0) software_ = gl::isSoftware();
    Entry& entry = entries_[used_++];
    entry.name = name;
    return entry;
}

std::vector<PassTime> const& PassTimer::collect() {
    times_.clear();
    for (std::size_t i = 0; i < used_; ++i) {
        Entry const& entry = entries_[i];
        double const milliseconds = static_cast<double>(entry.end.wait() - entry.start.wait()) * 1e-6;
        auto const same = [&](PassTime const& time) { return time.name == entry.name; };
        auto const known = std::find_if(times_.begin(), times_.end(), same);
        if (known != times_.end())
            known->milliseconds += milliseconds;
        else
            times_.push_back({entry.name, milliseconds});
    }
    used_ = 0;
    return times_;
}
}  // namespace luftpost::render
