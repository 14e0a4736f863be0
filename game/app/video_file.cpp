#include "game/app/video_file.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <signal.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cerrno>
#include <cstdlib>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "engine/core/check.h"
#include "engine/core/error.h"

extern char** environ;

namespace luftpost::app {
namespace {
namespace fs = std::filesystem;
constexpr char const* kFilmer = "ffmpeg";
constexpr int kRate = 30;  // pictures a second

/// Starts ffmpeg with `input` as its standard input; -1 where that fails.
pid_t started(std::vector<std::string> arguments, int input) {
    std::vector<char*> pointers;
    for (std::string& argument : arguments) pointers.push_back(argument.data());
    pointers.push_back(nullptr);
    posix_spawn_file_actions_t actions;
    posix_spawn_file_actions_init(&actions);
    posix_spawn_file_actions_adddup2(&actions, input, STDIN_FILENO);
    posix_spawn_file_actions_addopen(&actions, STDOUT_FILENO, "/dev/null", O_WRONLY, 0);
    posix_spawn_file_actions_addopen(&actions, STDERR_FILENO, "/dev/null", O_WRONLY, 0);  // what it says would not be our one line
    pid_t child = -1;
    bool const failed = posix_spawnp(&child, kFilmer, &actions, nullptr, pointers.data(), environ) != 0;
    posix_spawn_file_actions_destroy(&actions);
    return failed ? -1 : child;
}
}  // namespace

bool isFilm(fs::path const& file) {
    std::string const ending = file.extension().string();
    return ending == ".mp4" || ending == ".mkv" || ending == ".webm";
}

bool canFilm() {
    char const* const path = std::getenv("PATH");
    std::string_view rest = path != nullptr ? path : "";
    while (!rest.empty()) {
        auto const end = std::min(rest.find(':'), rest.size());
        fs::path const program = fs::path{rest.substr(0, end)} / kFilmer;
        if (access(program.c_str(), X_OK) == 0) return true;
        rest.remove_prefix(std::min(end + 1, rest.size()));
    }
    return false;
}

VideoFile::VideoFile(fs::path const& file, int width, int height) : file_{file}, part_{file} {
    part_.replace_filename(fmt::format(".{}.part{}", file.stem().string(), file.extension().string()));
    std::array<int, 2> ends{};
    if (pipe2(ends.data(), O_CLOEXEC) != 0) fail("a pipe to ffmpeg could not be made");
    pipe_ = ends[1];
    signal(SIGPIPE, SIG_IGN);  // where it has ended, writing says so
    // Even sides: what the usual encodings ask for.
    child_ = started({kFilmer, "-nostdin", "-y", "-f", "rawvideo", "-pixel_format", "rgba", "-video_size", fmt::format("{}x{}", width, height), "-framerate",
                      std::to_string(kRate), "-i", "pipe:0", "-vf", "pad=ceil(iw/2)*2:ceil(ih/2)*2", "-pix_fmt", "yuv420p", part_.string()}, ends[0]);
    close(ends[0]);
    if (child_ < 0) fail("ffmpeg could not be started");
}

VideoFile::~VideoFile() {
    if (pipe_ >= 0) close(pipe_);
    if (child_ >= 0) waitpid(child_, nullptr, 0);
    std::error_code ignored;
    fs::remove(part_, ignored);
}

void VideoFile::add(assets::Image const& picture) {
    CHECK(picture.channels == 4, "a film's pictures have four channels");
    std::uint8_t const* from = picture.values.data();
    std::size_t left = picture.values.size();
    while (left > 0) {
        ssize_t const written = write(pipe_, from, left);
        if (written < 0 && errno == EINTR) continue;
        if (written < 0) fail("ffmpeg ended before the film did");
        from += written;
        left -= static_cast<std::size_t>(written);
    }
}

void VideoFile::finish() {
    close(std::exchange(pipe_, -1));
    int status = 0;
    waitpid(std::exchange(child_, -1), &status, 0);
    if (!WIFEXITED(status) || WEXITSTATUS(status) != 0) fail("ffmpeg could not write it");
    std::error_code refused;
    fs::rename(part_, file_, refused);
    if (refused) fail("the film could not be put in its place");
}

void VideoFile::fail(char const* expected) const { throw core::Error{file_.string(), "", expected}; }
}  // namespace luftpost::app
