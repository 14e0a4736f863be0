// One bounded fetch over HTTP: it never takes longer, never holds more and never goes elsewhere than it may.
#pragma once
#include <atomic>
#include <cstddef>
#include <optional>
#include <string>

namespace luftpost::platform {
struct HttpRequest {
    std::string url;                         // http or https; a server's certificate is always checked
    std::string etag{}, lastModified{};      // of the answer in hand, empty: none; unchanged, the server says 304
    double connect_s = 10.0, total_s = 30.0; // time-outs
    double silent_s = 10.0;                  // given up after so long with hardly a byte
    std::size_t mostBytes = 8u << 20;        // of the body, unpacked
    long redirects = 3;                      // from https to https only
};

/// What came. Every failure is a text in one line, never an exception.
struct HttpAnswer {
    int status = 0;     // 0: no answer came, or not all of it
    std::string body;   // unpacked; empty unless the whole of it came
    std::string etag, lastModified;
    std::optional<double> retryAfter_s;  // the server's wish
    std::string error;  // why there is no whole answer; empty: there is one, of whatever status. Never holds the URL's query
    bool aborted = false;
};

/// Any thread; blocks until the answer is there, a limit is met or `abort` becomes true (seen within a hundredth of a second).
HttpAnswer httpGet(HttpRequest const& request, std::atomic<bool> const& abort);
}  // namespace luftpost::platform
