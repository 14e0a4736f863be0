// A film written by ffmpeg, where that is installed: we hand it the pictures.
#pragma once
#include <sys/types.h>

#include <filesystem>

#include "engine/assets/image.h"

namespace luftpost::app {
/// Whether a file's name ends like a film's: .mp4, .mkv, .webm.
bool isFilm(std::filesystem::path const& file);
/// Whether ffmpeg lies on the PATH.
bool canFilm();

/// Runs ffmpeg beside us from the first picture to the last; 30 pictures a second. The film is written beside its place and
/// renamed when it is whole.
class VideoFile {
public:
    /// Throws core::Error where ffmpeg does not start.
    VideoFile(std::filesystem::path const& file, int width, int height);
    ~VideoFile();
    VideoFile(VideoFile const&) = delete;
    VideoFile& operator=(VideoFile const&) = delete;

    /// Four channels of the film's size. Throws core::Error where ffmpeg has ended.
    void add(assets::Image const& picture);
    /// Waits for ffmpeg; throws core::Error where it fails.
    void finish();

private:
    [[noreturn]] void fail(char const* expected) const;

    std::filesystem::path file_, part_;
    pid_t child_ = -1;
    int pipe_ = -1;
};
}  // namespace luftpost::app
