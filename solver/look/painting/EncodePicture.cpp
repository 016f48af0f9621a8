#include "EncodePicture.h"

#include <OpenImageIO/filesystem.h>
#include <OpenImageIO/imagebufalgo.h>
#include <OpenImageIO/imageio.h>

#include <memory>

namespace bolster {

namespace {

OIIO::TypeDesc typeOf(EncodeOrder::Depth depth)
{
    switch (depth) {
    case EncodeOrder::Depth::Bytes:
        break;
    case EncodeOrder::Depth::Shorts:
        return OIIO::TypeDesc::UINT16;
    case EncodeOrder::Depth::Halves:
        return OIIO::TypeDesc::HALF;
    }
    return OIIO::TypeDesc::UINT8;
}

} // namespace

std::string encodedPicture(const EncodeOrder& order, std::string& problem)
{
    OIIO::Filesystem::IOVecOutput bytes;
    const std::unique_ptr<OIIO::ImageOutput> output = OIIO::ImageOutput::create(order.format);
    if (!output) {
        problem = OIIO::geterror();
        return {};
    }
    OIIO::ImageSpec spec(order.width, order.height, order.channels, typeOf(order.depth));
    for (const auto& [name, value] : order.words)
        spec.attribute(name, value);
    for (const auto& [name, value] : order.numbers)
        spec.attribute(name, value);
    const bool good = output->set_ioproxy(&bytes) && output->open("picture", spec) &&
                      (order.bytes ? output->write_image(OIIO::TypeDesc::UINT8, order.bytes)
                                   : output->write_image(OIIO::TypeDesc::FLOAT, order.floats)) &&
                      output->close();
    if (!good || bytes.buffer().empty()) {
        problem = output->geterror();
        return {};
    }
    return {bytes.buffer().begin(), bytes.buffer().end()};
}

bool drawnText(const TextOrder& order, const char* font, float* share)
{
    using OIIO::ImageBufAlgo::TextAlignX;
    using Align = TextOrder::Align;
    const TextAlignX across = order.align == Align::Left     ? TextAlignX::Left
                              : order.align == Align::Center ? TextAlignX::Center
                                                             : TextAlignX::Right;
    const int at = order.align == Align::Left     ? 0
                   : order.align == Align::Center ? order.width / 2
                                                  : order.width - 1;
    OIIO::ImageBuf strip(OIIO::ImageSpec(order.width, order.height, 1, OIIO::TypeDesc::FLOAT));
    OIIO::ImageBufAlgo::zero(strip);
    if (!OIIO::ImageBufAlgo::render_text(strip, at, order.height / 2, order.text, order.size, font, {1.f}, across,
                                         OIIO::ImageBufAlgo::TextAlignY::Center)) {
        (void)strip.geterror();
        return false;
    }
    strip.get_pixels(OIIO::ROI::All(), OIIO::TypeDesc::FLOAT, share);
    return true;
}

} // namespace bolster
