// Images in and out (OpenImageIO) as plain data. Rows from the top, channels interleaved, tightly packed.
#pragma once
#include <cstdint>
#include <filesystem>
#include <map>
#include <memory>
#include <string>
#include <vector>

namespace luftpost::assets {
template <class T>
struct ImageOf {
    int width = 0;
    int height = 0;
    int channels = 4;
    std::vector<T> values;  // width * height * channels

    T& at(int x, int y, int channel) { return values[index(x, y, channel)]; }
    T const& at(int x, int y, int channel) const { return values[index(x, y, channel)]; }
    std::size_t index(int x, int y, int channel) const {
        return (static_cast<std::size_t>(y) * static_cast<std::size_t>(width) + static_cast<std::size_t>(x)) *
                   static_cast<std::size_t>(channels) +
               static_cast<std::size_t>(channel);
    }
};
using Image = ImageOf<std::uint8_t>;   // display-encoded
using FloatImage = ImageOf<float>;     // linear

inline constexpr int kMaxImageSide = 16384;

/// Reads PNG, JPEG, EXR and what else OpenImageIO knows as `channels` 8-bit channels (a missing alpha is 255; grey is
/// spread). Throws core::Error naming the file and what was expected.
Image readImage(std::filesystem::path const& file, int channels = 4);
/// The same from the bytes of a file; `name` is for the message.
Image decodeImage(std::string const& bytes, std::string const& name, int channels = 4);
/// The same as 32-bit floats without any conversion of colour; all channels the file has.
FloatImage readFloatImage(std::filesystem::path const& file);

/// Numbers that a picture keeps beside its pixels, by name: "luftpost:..." attributes in its header.
using PictureFacts = std::map<std::string, double>;
/// Throws core::Error naming the file.
PictureFacts readFacts(std::filesystem::path const& file);

/// Write a new file and rename it. Throw core::Error when the disk refuses.
void writePng(std::filesystem::path const& file, Image const& image);
/// 32-bit float; channels named Y for one, R,G,B for three and R,G,B,A for four.
void writeExr(std::filesystem::path const& file, FloatImage const& image, PictureFacts const& facts = {});

/// A picture of 4 channels that is never whole in memory: written band by band from the top, then renamed. The ending tells the kind, .png of bytes or
/// .exr of floats. One thread at a time.
class ImageWriter {
public:
    /// Throws core::Error when the file cannot be made.
    ImageWriter(std::filesystem::path const& file, int width, int height);
    /// What was not finished goes.
    ~ImageWriter();

    /// The next rows, as wide as the picture. Throw core::Error when the disk refuses.
    void add(Image const& band);
    void add(FloatImage const& band);
    /// After the last row. Throws core::Error.
    void finish();

private:
    struct Parts;
    std::unique_ptr<Parts> parts_;
};
}  // namespace luftpost::assets
