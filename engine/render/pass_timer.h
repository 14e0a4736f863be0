// How long each pass takes, by a pair of timestamps around it.
#pragma once
#include <string>
#include <vector>

#include "engine/gl/context.h"
#include "engine/gl/query.h"
#include "engine/render/renderer.h"

namespace luftpost::render {
class PassTimer {
public:
    void setOn(bool on) { on_ = on; }

    /// Runs one pass of the frame. Software GL works after the call returns: there all earlier work is finished first,
    /// so that it is not counted as this pass's.
    template <class Draw>
    void pass(char const* name, Draw&& draw) {
        if (!on_) return draw();
        Entry& entry = next(name);
        if (software_) gl::finish();
        entry.start.record();
        draw();
        if (software_) gl::finish();
        entry.end.record();
    }

    /// Waits for the frame's timestamps; passes of one name are added up.
    std::vector<PassTime> const& collect();

private:
    struct Entry {
        std::string name;
        gl::Query start, end;
    };
    Entry& next(char const* name);

    bool on_ = false;
    bool software_ = false;
    std::size_t used_ = 0;
    std::vector<Entry> entries_;
    std::vector<PassTime> times_;
};
}  // namespace luftpost::render
