#include "ImageImport.h"

#include "DiskFile.h"
#include "HelperProcess.h"
#include "ImageStream.h"

#include <QFileInfo>
#include <QProcess>

namespace bolster {
namespace {

constexpr std::int64_t largestImageFile = 1'000'000'000;
constexpr int pollMilliseconds = 20;

enum class Ended { Done, NotStarted, Stopped, TooLong, Died };

/// Feeds the reader with what the decoder says, until it ends or has to be ended.
Ended runDecoder(const QString& path, const std::stop_token& stop, const ImageDecoder& decoder,
                 ImageStreamReader& reader)
{
    QProcess process;
    process.setProgram(decoder.program);
    process.setStandardInputFile(path);
    process.setStandardErrorFile(QProcess::nullDevice());
    confine(process, {decoder.memory, decoder.processor, false});
    process.start(QIODevice::ReadOnly);
    const auto end = std::chrono::steady_clock::now() + decoder.time;
    const auto endedBy = [&](Ended how) {
        process.kill();
        process.waitForFinished();
        return how;
    };
    if (!process.waitForStarted())
        return Ended::NotStarted;
    for (;;) {
        process.waitForReadyRead(pollMilliseconds);
        const QByteArray bytes = process.readAllStandardOutput();
        using State = ImageStreamReader::State;
        const State state = reader.take({bytes.data(), static_cast<std::size_t>(bytes.size())});
        if (state == State::Done)
            return endedBy(Ended::Done);
        if (stop.stop_requested())
            return endedBy(Ended::Stopped);
        if (state == State::Broken || (bytes.isEmpty() && process.state() == QProcess::NotRunning))
            return endedBy(Ended::Died);
        if (std::chrono::steady_clock::now() > end)
            return endedBy(Ended::TooLong);
    }
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

ImageOutcome outcomeOf(Ended ended, ImageStreamReader& reader, const std::string& name, const ImageDecoder& decoder)
{
    switch (ended) {
    case Ended::Stopped:
        return {};
    case Ended::NotStarted:
        return {nullptr,
                {QT_TRANSLATE_NOOP("Message", "the program \"%1\", which reads pictures for Bolster, cannot be "
                                              "started; install Bolster again"),
                 {decoder.program.isEmpty() ? "bolster-image" : decoder.program.toStdString()}}};
    case Ended::TooLong:
        return {nullptr,
                {QT_TRANSLATE_NOOP("Message", "\"%1\" takes too long to read; save it as PNG in a picture editor"),
                 {name}}};
    case Ended::Died:
        return {nullptr,
                {QT_TRANSLATE_NOOP("Message",
                                   "\"%1\" cannot be decoded: it is damaged or incomplete, or needs too much "
                                   "memory; save it again as PNG in a picture editor"),
                 {name}}};
    case Ended::Done:
        break;
    }
    const ImageHead& head = reader.head();
    if (head.verdict != ImageVerdict::Pixels)
        return {nullptr, problemOf(head, name)};
    ImagePixels image{static_cast<int>(head.width), static_cast<int>(head.height), reader.takePixels()};
    return {std::make_shared<const ImagePixels>(turned(std::move(image), head.orientation)), {}};
}

} // namespace

QString ImageDecoder::usualProgram()
{
    return helperProgram(QStringLiteral("bolster-image"), QStringLiteral(BOLSTER_IMAGE_DECODER));
}

ImageOutcome importImage(const QString& path, const std::stop_token& stop, const ImageDecoder& decoder)
{
    Message problem;
    if (!DiskFile::open(path, largestImageFile, problem))
        return {nullptr, std::move(problem)};
    const std::string name = QFileInfo(path).fileName().toStdString();
    try {
        ImageStreamReader reader;
        const Ended ended = runDecoder(path, stop, decoder, reader);
        return outcomeOf(ended, reader, name, decoder);
    } catch (const std::bad_alloc&) {
        return {nullptr, {QT_TRANSLATE_NOOP("Message", "%1: there is not enough memory for this picture"), {name}}};
    }
}

QStringList imageFileEndings()
{
    return {QStringLiteral("png"), QStringLiteral("jpg"),  QStringLiteral("jpeg"),
            QStringLiteral("tif"), QStringLiteral("tiff"), QStringLiteral("exr")};
}

} // namespace bolster
