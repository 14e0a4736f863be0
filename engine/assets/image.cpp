#include "engine/assets/image.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>
#include <fmt/format.h>

#include "engine/core/check.h"
#include "engine/core/error.h"
#include "engine/core/file.h"

namespace luftpost::assets {
namespace {
using Input = std::unique_ptr<OIIO::ImageInput>;

/// `name` only tells the format and the message; the bytes are read from memory.
Input openInput(std::string const& name, OIIO::Filesystem::IOMemReader& memory) {
    OIIO::ImageSpec wanted;
    wanted.attribute("oiio:UnassociatedAlpha", 1);  // colours as the file has them, not multiplied by alpha
    void* proxy = &memory;
    wanted.attribute("oiio:ioproxy", OIIO::TypeDesc(OIIO::TypeDesc::PTR), &proxy);
    Input input = OIIO::ImageInput::open(name, &wanted);
    if (!input) throw core::Error{name, "", "expected an image: " + OIIO::geterror()};
    OIIO::ImageSpec const& spec = input->spec();
    if (spec.width < 1 || spec.height < 1 || spec.width > kMaxImageSide || spec.height > kMaxImageSide ||
        spec.nchannels < 1 || spec.nchannels > 16 || spec.depth > 1)
        throw core::Error{name, "size", fmt::format("expected 1..{} x 1..{} pixels of 1..16 channels, found {} x {} of {}",
                                                    kMaxImageSide, kMaxImageSide, spec.width, spec.height,
                                                    spec.nchannels)};
    return input;
}

template <class T>
ImageOf<T> readAll(std::string const& bytes, std::string const& name, OIIO::TypeDesc type) {
    OIIO::Filesystem::IOMemReader memory{const_cast<char*>(bytes.data()), bytes.size()};
    Input const input = openInput(name, memory);
    OIIO::ImageSpec const& spec = input->spec();
    ImageOf<T> image{spec.width, spec.height, spec.nchannels, {}};
    image.values.resize(image.index(0, spec.height, 0));
    if (!input->read_image(0, 0, 0, spec.nchannels, type, image.values.data()))
        throw core::Error{name, "pixels", "expected a whole image: " + input->geterror()};
    return image;
}

/// Channel `wanted` of a pixel with `have` channels: grey is spread, a missing alpha is 255.
std::uint8_t channelOf(std::uint8_t const* pixel, int have, int wanted) {
    bool const grey = have < 3;
    if (wanted == 3) return have == 4 ? pixel[3] : (have == 2 ? pixel[1] : std::uint8_t{255});
    return grey ? pixel[0] : pixel[wanted];
}

Image withChannels(Image const& image, int channels) {
    if (image.channels == channels) return image;
    Image result{image.width, image.height, channels, {}};
    result.values.resize(result.index(0, image.height, 0));
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x)
            for (int c = 0; c < channels; ++c)
                result.at(x, y, c) = channelOf(&image.at(x, y, 0), image.channels, c);
    return result;
}

OIIO::ImageSpec specOf(int width, int height, int channels, OIIO::TypeDesc type) {
    OIIO::ImageSpec spec{width, height, channels, type};
    if (channels == 1) spec.channelnames = {"Y"};
    spec.attribute("oiio:UnassociatedAlpha", 1);
    return spec;
}

constexpr std::string_view kOurs = "luftpost:";  // before the names of what is ours in a header

template <class T>
void write(std::filesystem::path const& file, char const* format, ImageOf<T> const& image, OIIO::TypeDesc type, PictureFacts const& facts = {}) {
    CHECK(image.values.size() == image.index(0, image.height, 0) && image.width > 0, "an image of {} x {} with {} values",
          image.width, image.height, image.values.size());
    std::vector<unsigned char> bytes;
    OIIO::Filesystem::IOVecOutput memory{bytes};
    auto const output = OIIO::ImageOutput::create(format);
    if (!output) throw core::Error{file.string(), "", "expected OpenImageIO to write this format: " + OIIO::geterror()};
    OIIO::ImageSpec spec = specOf(image.width, image.height, image.channels, type);
    for (auto const& [name, value] : facts) spec.attribute(std::string{kOurs} + name, static_cast<float>(value));
    output->set_ioproxy(&memory);
    if (!output->open(std::string{"image."} + format, spec) || !output->write_image(type, image.values.data()) ||
        !output->close())
        throw core::Error{file.string(), "", "expected to write an image: " + output->geterror()};
    core::writeFileAtomically(file, {reinterpret_cast<char const*>(bytes.data()), bytes.size()});
}
}  // namespace

Image decodeImage(std::string const& bytes, std::string const& name, int channels) {
    CHECK(channels >= 1 && channels <= 4, "{} channels", channels);
    return withChannels(readAll<std::uint8_t>(bytes, name, OIIO::TypeDesc::UINT8), channels);
}

Image readImage(std::filesystem::path const& file, int channels) {
    return decodeImage(core::readFile(file), file.string(), channels);
}

FloatImage readFloatImage(std::filesystem::path const& file) {
    return readAll<float>(core::readFile(file), file.string(), OIIO::TypeDesc::FLOAT);
}

PictureFacts readFacts(std::filesystem::path const& file) {
    std::string const bytes = core::readFile(file);
    OIIO::Filesystem::IOMemReader memory{const_cast<char*>(bytes.data()), bytes.size()};
    Input const input = openInput(file.string(), memory);
    PictureFacts facts;
    for (OIIO::ParamValue const& value : input->spec().extra_attribs)
        if (value.name().string().starts_with(kOurs)) facts[value.name().string().substr(kOurs.size())] = static_cast<double>(value.get_float());
    return facts;
}

void writePng(std::filesystem::path const& file, Image const& image) {
    write(file, "png", image, OIIO::TypeDesc::UINT8);
}
void writeExr(std::filesystem::path const& file, FloatImage const& image, PictureFacts const& facts) {
    write(file, "exr", image, OIIO::TypeDesc::FLOAT, facts);
}

struct ImageWriter::Parts {
    std::filesystem::path file, fresh;
    std::unique_ptr<OIIO::ImageOutput> output;
    int width, height;
    int rows = 0;  // written so far

    template <class T>
    void add(ImageOf<T> const& band, OIIO::TypeDesc type) {
        CHECK(output && band.width == width && band.channels == 4 && rows + band.height <= height, "a band of {} x {} after {} rows of {} x {}",
              band.width, band.height, rows, width, height);
        if (!output->write_scanlines(rows, rows + band.height, 0, type, band.values.data())) refuse();
        rows += band.height;
    }
    [[noreturn]] void refuse() const { throw core::Error{file.string(), "", "expected to write an image: " + output->geterror()}; }
};

ImageWriter::ImageWriter(std::filesystem::path const& file, int width, int height)
    : parts_{std::make_unique<Parts>(Parts{file, file.string() + ".new", nullptr, width, height})} {
    bool const linear = file.extension() == ".exr";
    parts_->output = OIIO::ImageOutput::create(linear ? "exr" : "png");
    if (!parts_->output) throw core::Error{file.string(), "", "expected OpenImageIO to write this format: " + OIIO::geterror()};
    if (!parts_->output->open(parts_->fresh.string(), specOf(width, height, 4, linear ? OIIO::TypeDesc::FLOAT : OIIO::TypeDesc::UINT8))) parts_->refuse();
}

ImageWriter::~ImageWriter() {
    if (!parts_->output) return;
    parts_->output->close();
    std::error_code ignored;
    std::filesystem::remove(parts_->fresh, ignored);
}

void ImageWriter::add(Image const& band) { parts_->add(band, OIIO::TypeDesc::UINT8); }
void ImageWriter::add(FloatImage const& band) { parts_->add(band, OIIO::TypeDesc::FLOAT); }

void ImageWriter::finish() {
    CHECK(parts_->rows == parts_->height, "{} rows of {}", parts_->rows, parts_->height);
    if (!parts_->output->close()) parts_->refuse();
    parts_->output.reset();
    core::moveIntoPlace(parts_->fresh, parts_->file);
}
}  // namespace luftpost::assets
