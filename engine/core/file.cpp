#include "engine/core/file.h"

#include <fcntl.h>
#include <unistd.h>

#include <cerrno>
#include <cstring>
#include <fstream>
#include <iterator>

#include "engine/core/error.h"

namespace luftpost::core {
namespace {
namespace fs = std::filesystem;

Error systemError(fs::path const& file, char const* action) {
    return Error{file.string(), action, std::strerror(errno)};
}

/// Writes all bytes to an open descriptor, then to the disk; closes it in any case.
void writeAndClose(int descriptor, fs::path const& file, std::string_view bytes, bool flush) {
    while (!bytes.empty()) {
        ssize_t const written = ::write(descriptor, bytes.data(), bytes.size());
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) {
            Error const error = systemError(file, "cannot write");
            ::close(descriptor);
            throw error;
        }
        bytes.remove_prefix(static_cast<std::size_t>(written));
    }
    bool const flushed = !flush || ::fsync(descriptor) == 0;
    Error const error = systemError(file, "cannot write");
    if (::close(descriptor) != 0 || !flushed) throw error;
}
}  // namespace

std::string readFile(fs::path const& file, std::size_t most) {
    std::error_code ignored;
    if (fs::is_directory(file, ignored)) throw Error{file.string(), "", "expected a file, found a folder"};
    std::ifstream in{file, std::ios::binary};
    if (!in) throw systemError(file, "cannot read");
    std::string bytes;
    char block[65536];
    while (in.read(block, sizeof block) || in.gcount() > 0) {
        bytes.append(block, static_cast<std::size_t>(in.gcount()));
        if (bytes.size() > most) throw Error{file.string(), "", fmt::format("expected at most {} bytes", most)};
    }
    if (in.bad()) throw systemError(file, "cannot read");
    return bytes;
}

void writeFileAtomically(fs::path const& file, std::string_view bytes) {
    std::error_code ignored;
    if (fs::exists(file, ignored) && !fs::is_regular_file(file, ignored)) {
        int const descriptor = ::open(file.c_str(), O_WRONLY | O_CLOEXEC);
        if (descriptor < 0) throw systemError(file, "cannot write");
        return writeAndClose(descriptor, file, bytes, false);
    }
    fs::path const fresh{file.string() + ".new"};
    int const descriptor = ::open(fresh.c_str(), O_WRONLY | O_CREAT | O_TRUNC | O_CLOEXEC, 0644);
    if (descriptor < 0) throw systemError(file, "cannot write");
    try {
        writeAndClose(descriptor, file, bytes, true);
    } catch (Error const&) {
        fs::remove(fresh, ignored);
        throw;
    }
    if (std::rename(fresh.c_str(), file.c_str()) != 0) throw systemError(file, "cannot write");
}

void moveIntoPlace(fs::path const& fresh, fs::path const& file) {
    int const descriptor = ::open(fresh.c_str(), O_WRONLY | O_CLOEXEC);
    if (descriptor < 0) throw systemError(file, "cannot write");
    writeAndClose(descriptor, file, {}, true);
    if (std::rename(fresh.c_str(), file.c_str()) != 0) throw systemError(file, "cannot write");
}

void checkOutputFolder(std::string_view option, fs::path const& file) {
    std::error_code ignored;
    fs::path const folder = file.has_parent_path() ? file.parent_path() : fs::path{"."};
    if (file.empty()) throw Error{std::string{option}, "", "expected a file name"};
    if (!fs::is_directory(folder, ignored))
        throw Error{file.string(), std::string{option}, "expected a folder that exists: " + folder.string()};
    if (fs::is_directory(file, ignored))
        throw Error{file.string(), std::string{option}, "expected a file name, found a folder"};
    if (::access(fs::exists(file, ignored) ? file.c_str() : folder.c_str(), W_OK) != 0)
        throw Error{file.string(), std::string{option}, "expected a place that may be written"};
}
}  // namespace luftpost::core
