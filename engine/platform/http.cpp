#include "engine/platform/http.h"

#include <curl/curl.h>
#include <fmt/format.h>

#include <array>
#include <memory>

#include "engine/core/check.h"

namespace luftpost::platform {
namespace {
constexpr int kLookEvery_ms = 10;     // at `abort`
constexpr long kHardlyAByte = 50;     // bytes a second

struct FreeEasy {
    void operator()(CURL* easy) const { curl_easy_cleanup(easy); }
};
struct FreeMulti {
    void operator()(CURLM* multi) const { curl_multi_cleanup(multi); }
};
struct FreeList {
    void operator()(curl_slist* list) const { curl_slist_free_all(list); }
};
using Easy = std::unique_ptr<CURL, FreeEasy>;
using Multi = std::unique_ptr<CURLM, FreeMulti>;
using List = std::unique_ptr<curl_slist, FreeList>;

/// What arrives, and how much of it may.
struct Body {
    std::string bytes;
    std::size_t most = 0;
    bool tooMuch = false;
};

std::size_t take(char const* data, std::size_t size, std::size_t count, void* user) {
    Body& body = *static_cast<Body*>(user);
    std::size_t const bytes = size * count;
    if (body.bytes.size() + bytes > body.most) {
        body.tooMuch = true;
        return 0;
    }
    body.bytes.append(data, bytes);
    return bytes;
}

void startLibrary() {
    static CURLcode const started = curl_global_init(CURL_GLOBAL_DEFAULT);
    CHECK(started == CURLE_OK, "libcurl: {}", curl_easy_strerror(started));
}

long milliseconds(double seconds) { return static_cast<long>(seconds * 1000.0); }

List headersOf(HttpRequest const& request) {
    curl_slist* list = nullptr;
    if (!request.etag.empty()) list = curl_slist_append(list, ("If-None-Match: " + request.etag).c_str());
    if (!request.lastModified.empty()) list = curl_slist_append(list, ("If-Modified-Since: " + request.lastModified).c_str());
    return List{list};
}

void setLimits(CURL* easy, HttpRequest const& request) {
    bool const secure = request.url.starts_with("https:");
    curl_easy_setopt(easy, CURLOPT_PROTOCOLS_STR, secure ? "https" : "http,https");
    curl_easy_setopt(easy, CURLOPT_REDIR_PROTOCOLS_STR, secure ? "https" : "http,https");
    curl_easy_setopt(easy, CURLOPT_FOLLOWLOCATION, request.redirects > 0 ? 1L : 0L);
    curl_easy_setopt(easy, CURLOPT_MAXREDIRS, request.redirects);
    curl_easy_setopt(easy, CURLOPT_CONNECTTIMEOUT_MS, milliseconds(request.connect_s));
    curl_easy_setopt(easy, CURLOPT_TIMEOUT_MS, milliseconds(request.total_s));
    curl_easy_setopt(easy, CURLOPT_LOW_SPEED_LIMIT, kHardlyAByte);
    curl_easy_setopt(easy, CURLOPT_LOW_SPEED_TIME, static_cast<long>(request.silent_s + 0.999));
    curl_easy_setopt(easy, CURLOPT_MAXFILESIZE_LARGE, static_cast<curl_off_t>(request.mostBytes));
    curl_easy_setopt(easy, CURLOPT_SSL_VERIFYPEER, 1L);
    curl_easy_setopt(easy, CURLOPT_SSL_VERIFYHOST, 2L);
}

void setUp(CURL* easy, HttpRequest const& request, curl_slist* headers, Body& body, char* errorText) {
    curl_easy_setopt(easy, CURLOPT_URL, request.url.c_str());
    curl_easy_setopt(easy, CURLOPT_HTTPHEADER, headers);
    curl_easy_setopt(easy, CURLOPT_USERAGENT, "Luftpost");
    curl_easy_setopt(easy, CURLOPT_ACCEPT_ENCODING, "gzip");
    curl_easy_setopt(easy, CURLOPT_NOSIGNAL, 1L);
    curl_easy_setopt(easy, CURLOPT_QUICK_EXIT, 1L);  // a name that is still being looked up is not waited for
    curl_easy_setopt(easy, CURLOPT_WRITEFUNCTION, take);
    curl_easy_setopt(easy, CURLOPT_WRITEDATA, &body);
    curl_easy_setopt(easy, CURLOPT_ERRORBUFFER, errorText);
    setLimits(easy, request);
}

/// Nothing when `abort` came first.
std::optional<CURLcode> perform(CURL* easy, std::atomic<bool> const& abort) {
    Multi const multi{curl_multi_init()};
    CHECK(multi, "libcurl has no memory");
    curl_multi_add_handle(multi.get(), easy);
    std::optional<CURLcode> result;
    for (int running = 1; running > 0 && !abort.load(std::memory_order_relaxed);) {
        if (curl_multi_perform(multi.get(), &running) != CURLM_OK) break;
        int left = 0;
        if (CURLMsg const* message = curl_multi_info_read(multi.get(), &left)) result = message->data.result;
        if (running > 0) curl_multi_poll(multi.get(), nullptr, 0, kLookEvery_ms, nullptr);
    }
    curl_multi_remove_handle(multi.get(), easy);
    if (!result && !abort) result = CURLE_FAILED_INIT;
    return result;
}

/// The last answer's header, not one of those that led to it.
std::string headerOf(CURL* easy, char const* name) {
    curl_header* header = nullptr;
    bool const found = curl_easy_header(easy, name, 0, CURLH_HEADER, -1, &header) == CURLHE_OK;
    return found ? header->value : "";
}

std::string complaint(CURLcode code, HttpRequest const& request, Body const& body, char const* text) {
    if (body.tooMuch || code == CURLE_FILESIZE_EXCEEDED) return fmt::format("expected an answer of at most {} bytes", request.mostBytes);
    if (code == CURLE_TOO_MANY_REDIRECTS) return fmt::format("expected at most {} redirections", request.redirects);
    if (code == CURLE_PARTIAL_FILE) return "the answer was cut off";
    if (code == CURLE_URL_MALFORMAT) return "expected an address of http or https";
    std::string words = *text ? text : curl_easy_strerror(code);
    if (auto const query = words.find('?'); query != words.npos) words.resize(query);  // it may hold a key
    while (words.ends_with('\n')) words.pop_back();
    return words;
}
}  // namespace

HttpAnswer httpGet(HttpRequest const& request, std::atomic<bool> const& abort) {
    startLibrary();
    Easy const easy{curl_easy_init()};
    CHECK(easy, "libcurl has no memory");
    Body body{{}, request.mostBytes, false};
    List const headers = headersOf(request);
    std::array<char, CURL_ERROR_SIZE> text{};
    setUp(easy.get(), request, headers.get(), body, text.data());
    HttpAnswer answer;
    auto const code = perform(easy.get(), abort);
    if (!code) {
        answer.aborted = true;
        answer.error = "given up";
        return answer;
    }
    if (*code != CURLE_OK) {
        answer.error = complaint(*code, request, body, text.data());
        return answer;
    }
    long status = 0;
    curl_off_t retryAfter = 0;
    curl_easy_getinfo(easy.get(), CURLINFO_RESPONSE_CODE, &status);
    curl_easy_getinfo(easy.get(), CURLINFO_RETRY_AFTER, &retryAfter);
    answer.status = static_cast<int>(status);
    answer.etag = headerOf(easy.get(), "ETag");
    answer.lastModified = headerOf(easy.get(), "Last-Modified");
    if (retryAfter > 0) answer.retryAfter_s = static_cast<double>(retryAfter);
    answer.body = std::move(body.bytes);
    return answer;
}
}  // namespace luftpost::platform
