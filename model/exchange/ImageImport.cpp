#include "ImageImport.h"

#include "DiskFile.h"
#include "HelperProcess.h"
#include "ImageStream.h"

#include <QFileInfo>

namespace bolster {
namespace {

constexpr std::int64_t largestImageFile = 1'000'000'000;

constexpr HelperSentences imageSentences = {
    QT_TRANSLATE_NOOP("Message", "the program \"%1\", which reads pictures for Bolster, cannot be started; install "
                                 "Bolster again"),
    QT_TRANSLATE_NOOP("Message", "\"%1\" takes too long to read; save it as PNG in a picture editor"),
    QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be decoded: it is damaged or incomplete, or needs too much memory; "
                                 "save it again as PNG in a picture editor")};

HelperSpeech takeWords(ImageStreamReader& reader, std::string_view words)
{
    switch (reader.take(words)) {
    case ImageStreamReader::State::Unfinished:
        return HelperSpeech::Unfinished;
    case ImageStreamReader::State::Done:
        return HelperSpeech::Done;
    case ImageStreamReader::State::Broken:
        break;
    }
    return HelperSpeech::Nonsense;
}

Message problemOf(const ImageHead& head, const std::string& name)
{
    switch (head.verdict) {
    case ImageVerdict::UnknownKind:
        return {QT_TRANSLATE_NOOP("Message",
                                  "\"%1\" is not a picture that can be read; PNG, JPEG, TIFF and OpenEXR "
                                  "can"),
                {name}};
    case ImageVerdict::TooLarge:
        return {QT_TRANSLATE_NOOP("Message",
                                  "\"%1\" has %2 by %3 pixels, and at most 64 million are read; make the "
                                  "picture smaller in a picture editor"),
                {name, std::to_string(head.width), std::to_string(head.height)}};
    case ImageVerdict::NoColours:
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is a kind of picture whose colours cannot be read; save it as "
                                             "PNG in a picture editor"),
                {name}};
    case ImageVerdict::Damaged:
    case ImageVerdict::Pixels:
        break;
    }
    return {QT_TRANSLATE_NOOP("Message",
                              "\"%1\" is damaged or incomplete; copy it again from where it came from, or "
                              "save it again in a picture editor"),
            {name}};
}

/// As Exif counts: which row and column of the file each pixel of the upright picture is.
ImagePixels turned(ImagePixels image, std::uint32_t orientation)
{
    if (orientation <= 1)
        return image;
    const bool swapped = orientation >= 5;
    ImagePixels upright{swapped ? image.height : image.width, swapped ? image.width : image.height, {}};
    upright.rgba.resize(image.rgba.size());
    const bool mirrorX = orientation == 2 || orientation == 3 || orientation == 7 || orientation == 8;
    const bool mirrorY = orientation == 3 || orientation == 4 || orientation == 6 || orientation == 7;
    const auto index = [](int x, int y, int width) { return 4 * (static_cast<std::size_t>(y) * width + x); };
    for (int y = 0; y < upright.height; ++y) {
        for (int x = 0; x < upright.width; ++x) {
            int fromX = swapped ? y : x;
            int fromY = swapped ? x : y;
            fromX = mirrorX ? image.width - 1 - fromX : fromX;
            fromY = mirrorY ? image.height - 1 - fromY : fromY;
            std::copy_n(&image.rgba[index(fromX, fromY, image.width)], 4,
                        &upright.rgba[index(x, y, upright.width)]);
        }
    }
    return upright;
}

ImageOutcome outcomeOf(ImageStreamReader& reader, const std::string& name)
{
    const ImageHead& head = reader.head();
    if (head.verdict != ImageVerdict::Pixels)
        return {nullptr, problemOf(head, name)};
    ImagePixels image{static_cast<int>(head.width), static_cast<int>(head.height), reader.takePixels()};
    return {std::make_shared<const ImagePixels>(turned(std::move(image), head.orientation)), {}};
}

} // namespace

QString ImageDecoder::usualProgram()
{
    return helperProgram("bolster-image", "model/image");
}

ImageOutcome importImage(const QString& path, const std::stop_token& stop, const ImageDecoder& decoder)
{
    Message problem;
    const auto file = DiskFile::open(path, largestImageFile, problem);
    if (!file)
        return {nullptr, std::move(problem)};
    const std::string name = QFileInfo(path).fileName().toStdString();
    try {
        ImageStreamReader reader;
        const HelperEnd end =
            runHelper({decoder.program, {}, {decoder.memory, decoder.processor, false}, decoder.time}, *file, {},
                      stop, [&reader](std::string_view words) { return takeWords(reader, words); });
        if (end == HelperEnd::Done)
            return outcomeOf(reader, name);
        const std::string program = decoder.program.isEmpty() ? "bolster-image" : decoder.program.toStdString();
        return {nullptr, helperProblem(end, imageSentences, program, name)};
    } catch (const std::bad_alloc&) {
        return {nullptr, {QT_TRANSLATE_NOOP("Message", "%1: there is not enough memory for this picture"), {name}}};
    }
}

} // namespace bolster
