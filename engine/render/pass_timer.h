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

    /// Runs one pass of the frame. Software GL works after the call returns, and takes a timestamp only when it gets to
    /// it: there earlier work, the timestamp and the pass are each finished before the next.
    template <class Draw>
    void pass(char const* name, Draw&& draw) {
        if (!on_) return draw();
        Entry& entry = next(name);
        if (software_) gl::finish();
        entry.start.record();
        if (software_) gl::finish();
        draw();
        if (software_) gl::finish();
        entry.end.record();
        if (software_) gl::finish();
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
