#include "engine/assets/sound.h"

#include <sndfile.h>

#include <memory>

#include "engine/core/error.h"

namespace luftpost::assets {
Sound readSound(std::filesystem::path const& file) {
    SF_INFO info{};
    std::unique_ptr<SNDFILE, int (*)(SNDFILE*)> const in{sf_open(file.c_str(), SFM_READ, &info), &sf_close};
    if (!in) throw core::Error{file.string(), "", std::string{"expected a sound file: "} + sf_strerror(nullptr)};
    if (info.frames <= 0 || info.channels <= 0 || info.channels > 8 || info.samplerate <= 0 ||
        info.frames > sf_count_t{600} * info.samplerate)
        throw core::Error{file.string(), "", "expected 1 to 8 channels and up to ten minutes of sound"};
    auto const channels = static_cast<std::size_t>(info.channels);
    std::vector<std::int16_t> raw(static_cast<std::size_t>(info.frames) * channels);
    sf_count_t const got = sf_readf_short(in.get(), raw.data(), info.frames);
    if (got <= 0) throw core::Error{file.string(), "", "expected samples; the file ends in its header"};
    Sound sound{{}, info.samplerate};
    sound.samples.resize(static_cast<std::size_t>(got));
    for (std::size_t i = 0; i < sound.samples.size(); ++i) {
        int sum = 0;
        for (std::size_t c = 0; c < channels; ++c) sum += raw[i * channels + c];
        sound.samples[i] = static_cast<std::int16_t>(sum / info.channels);
    }
    return sound;
}
}  // namespace luftpost::assets
