// A process of its own that decodes one picture of unknown origin: the file on its standard input, an ImageHead and
// the pixels on its standard output. It may crash, hang or run out of memory; importImage() limits it and cleans up
// after it. Before it looks at the first byte it gives up all rights but these two.
#include "GivenFiles.h"
#include "ImageStream.h"
#include "Sandbox.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imageio.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <unistd.h>
#include <utility>
#include <vector>

using namespace bolster;

namespace {

constexpr const char* input = "picture"; // decoders want a name; there is no such file
constexpr const char* decoderNames[] = {"png", "jpeg", "tiff", "openexr"};
constexpr std::uint64_t pixelsAtOnce = 4 << 20;

struct Refused {
    ImageHead head;
};

[[noreturn]] void refuse(ImageVerdict verdict)
{
    throw Refused{{verdict}};
}

const Answer& answer()
{
    static const Answer only;
    return only;
}

void write(const void* bytes, std::size_t size)
{
    answer().write({static_cast<const char*>(bytes), size});
}

ImageKind kindOf(std::string_view bytes)
{
    const auto kind = imageKindOf(bytes);
    if (!kind)
        refuse(ImageVerdict::UnknownKind);
    if (kind == ImageKind::Jpeg && !jpegIsWhole(bytes))
        refuse(ImageVerdict::Damaged);
    return *kind;
}

/// The library sets itself up while files can still be opened: it has not seen any byte of the picture.
void prepareLibrary()
{
    OIIO::attribute("threads", 1);
    OIIO::attribute("exr_threads", -1); // -1: none beside this one
    for (const char* name : decoderNames)
        OIIO::ImageInput::create(name, false);
}

/// By name: what the file is has been seen, and no other decoder of the library is tried.
std::unique_ptr<OIIO::ImageInput> opened(ImageKind kind, OIIO::Filesystem::IOProxy* bytes, OIIO::ImageSpec& spec)
{
    OIIO::ImageSpec wish;
    wish["oiio:UnassociatedAlpha"] = 1;
    wish.attribute("oiio:ioproxy", OIIO::TypeDesc::PTR, &bytes);
    auto decoder = OIIO::ImageInput::create(decoderNames[static_cast<std::size_t>(kind)], false, &wish);
    if (!decoder || !decoder->open(input, spec, wish))
        refuse(ImageVerdict::Damaged);
    return decoder;
}

/// Which channels are red, green, blue and opacity; -1 for no opacity.
std::array<int, 4> coloursOf(const OIIO::ImageSpec& spec)
{
    const auto named = [&](const char* name) { return spec.channelindex(name); };
    if (named("R") >= 0 && named("G") >= 0 && named("B") >= 0)
        return {named("R"), named("G"), named("B"), spec.alpha_channel};
    if (named("Y") >= 0)
        return {named("Y"), named("Y"), named("Y"), spec.alpha_channel};
    if (spec.nchannels == 1 || spec.nchannels == 2)
        return {0, 0, 0, spec.alpha_channel};
    refuse(ImageVerdict::NoColours);
}

/// How to make 8 bits per channel, not premultiplied, in sRGB of what the file holds.
struct Conversion {
    std::array<int, 4> channels;
    int channelCount;
    bool linear;        ///< light, not sRGB
    bool premultiplied; ///< colours times opacity
};

std::uint8_t eightBits(float value)
{
    return static_cast<std::uint8_t>(std::clamp(value, 0.0F, 1.0F) * 255 + 0.5F);
}

float sRgbOf(float light)
{
    return light <= 0.0031308F ? 12.92F * light : 1.055F * std::pow(light, 1 / 2.4F) - 0.055F;
}

void convert(const Conversion& how, const float* from, std::size_t pixels, std::uint8_t* to)
{
    for (std::size_t i = 0; i < pixels; ++i, from += how.channelCount, to += 4) {
        const float alpha = how.channels[3] < 0 ? 1 : from[how.channels[3]];
        for (std::size_t k = 0; k < 3; ++k) {
            float value = from[how.channels[k]];
            if (how.premultiplied && alpha > 0)
                value /= alpha;
            if (how.linear)
                value = sRgbOf(value);
            to[k] = std::isnan(value) ? 0 : eightBits(value);
        }
        to[3] = std::isnan(alpha) ? 0 : eightBits(alpha);
    }
}

/// Sends rows of pixels with as many columns and rows taken together as shrinkingOf() says.
class ShrunkRows {
public:
    ShrunkRows(std::uint32_t width, std::uint32_t height)
        : m_width(width)
        , m_height(height)
        , m_factor(shrinkingOf(width, height))
        , m_sums(width / m_factor + (width % m_factor > 0 ? 1 : 0))
        , m_row(4 * m_sums.size())
    {}

    void send(const std::uint8_t* rows, std::uint32_t count)
    {
        if (m_factor == 1) {
            write(rows, std::size_t{4} * m_width * count);
            return;
        }
        for (std::uint32_t y = 0; y < count; ++y, rows += std::size_t{4} * m_width) {
            add(rows);
            if (++m_seen % m_factor == 0 || m_seen == m_height)
                sendSums();
        }
    }

private:
    struct Sum {
        std::array<std::uint64_t, 3> colour{}; ///< times opacity: what is not seen has no colour
        std::uint64_t opacity = 0, count = 0;
    };

    void add(const std::uint8_t* row)
    {
        for (std::uint32_t x = 0; x < m_width; ++x) {
            Sum& sum = m_sums[x / m_factor];
            const std::uint8_t* const pixel = row + std::size_t{4} * x;
            for (std::size_t c = 0; c < 3; ++c)
                sum.colour[c] += std::uint64_t{pixel[c]} * pixel[3];
            sum.opacity += pixel[3];
            ++sum.count;
        }
    }

    void sendSums()
    {
        for (std::size_t x = 0; x < m_sums.size(); ++x) {
            const Sum sum = std::exchange(m_sums[x], {});
            for (std::size_t c = 0; c < 3; ++c)
                m_row[4 * x + c] = rounded(sum.colour[c], sum.opacity);
            m_row[4 * x + 3] = rounded(sum.opacity, sum.count);
        }
        write(m_row.data(), m_row.size());
    }

    static std::uint8_t rounded(std::uint64_t sum, std::uint64_t count)
    {
        return count == 0 ? 0 : static_cast<std::uint8_t>((sum + count / 2) / count);
    }

    std::uint32_t m_width, m_height, m_factor, m_seen = 0;
    std::vector<Sum> m_sums;
    std::vector<std::uint8_t> m_row;
};

/// Strip by strip, so that only one is in memory.
void sendPixels(OIIO::ImageInput& decoder, const OIIO::ImageSpec& spec, const Conversion& how)
{
    const bool tiled = spec.tile_width > 0;
    const auto width = static_cast<std::uint64_t>(spec.width);
    int rows = static_cast<int>(std::max<std::uint64_t>(1, pixelsAtOnce / 16 / width));
    if (tiled)
        rows = spec.tile_height;
    // Tiles need not be smaller than the picture, and all channels are asked for.
    if (rows <= 0 || static_cast<std::uint64_t>(rows) * (width + static_cast<std::uint64_t>(spec.tile_width)) *
                             static_cast<std::uint64_t>(spec.nchannels) >
                         4 * mostImagePixels)
        refuse(ImageVerdict::Damaged);
    std::vector<float> strip(static_cast<std::size_t>(rows) * width * static_cast<std::size_t>(spec.nchannels));
    std::vector<std::uint8_t> row(static_cast<std::size_t>(rows) * width * 4);
    ShrunkRows shrunk(static_cast<std::uint32_t>(spec.width), static_cast<std::uint32_t>(spec.height));
    for (int y = 0; y < spec.height; y += rows) {
        const int end = std::min(y + rows, spec.height);
        const bool read = tiled ? decoder.read_tiles(0, 0, spec.x, spec.x + spec.width, spec.y + y, spec.y + end, 0,
                                                     1, 0, spec.nchannels, OIIO::TypeDesc::FLOAT, strip.data())
                                : decoder.read_scanlines(0, 0, spec.y + y, spec.y + end, 0, 0, spec.nchannels,
                                                         OIIO::TypeDesc::FLOAT, strip.data());
        if (!read || decoder.has_error())
            ::_exit(2); // the head has been sent: that there are no more pixels says it
        const std::size_t pixels = static_cast<std::size_t>(end - y) * width;
        convert(how, strip.data(), pixels, row.data());
        shrunk.send(row.data(), static_cast<std::uint32_t>(end - y));
    }
}

void decode()
{
    const MappedFile bytes(STDIN_FILENO);
    OIIO::Filesystem::IOMemReader reader(bytes.view().data(), bytes.view().size());
    OIIO::ImageSpec spec;
    const auto decoder = opened(kindOf(bytes.view()), &reader, spec);
    const auto width = static_cast<std::uint32_t>(std::max(spec.width, 0));
    const auto height = static_cast<std::uint32_t>(std::max(spec.height, 0));
    if (width == 0 || height == 0 || spec.depth > 1 || spec.deep || spec.nchannels < 1 || spec.nchannels > 64)
        refuse(ImageVerdict::NoColours);
    if (!imageFits(width, height))
        throw Refused{{ImageVerdict::TooLarge, width, height}};

    const auto channels = coloursOf(spec);
    const std::string space = spec.get_string_attribute("oiio:ColorSpace");
    const Conversion how{channels, spec.nchannels, spec.format.is_floating_point() || space == "Linear",
                         channels[3] >= 0 && spec.get_int_attribute("oiio:UnassociatedAlpha") == 0};
    const int orientation = spec.get_int_attribute("Orientation", 1);
    const std::uint32_t factor = shrinkingOf(width, height);
    const ImageHead head{ImageVerdict::Pixels, (width - 1) / factor + 1, (height - 1) / factor + 1,
                         orientation < 1 || orientation > 8 ? 1U : static_cast<std::uint32_t>(orientation)};
    write(bytesOf(head).data(), imageHeadBytes);
    sendPixels(*decoder, spec, how);
}

} // namespace

int main()
{
    leaveEverything();
    try {
        const int kept[] = {answer().descriptor()};
        prepareLibrary();
        if (!enterSandbox(kept))
            ::_exit(4);
        decode();
    } catch (const Refused& refused) {
        write(bytesOf(refused.head).data(), imageHeadBytes);
    } catch (const std::exception&) {
        ::_exit(3);
    }
    ::_exit(0); // no library tidies up
}
