#include "ImageImport.h"
#include "Output.h"
#include "Project.h"
#include "Subcommands.h"
#include "Unfinished.h"
#include "WholeFile.h"

#include <QBuffer>
#include <QFileInfo>
#include <QImage>

#include <algorithm>
#include <array>

namespace bolster::cli {

const char* const thumbnailHelp = R"(Usage: bolster thumbnail PROJECT OUT.png [options]

Copies the small picture of the cover that is kept in a project, for the lists of
file managers. Nothing is drawn or solved, and PROJECT is not changed. The window
makes the picture when the cover has come to rest; a project that never was in a
window has none.

Options:
  --size N           at most so many pixels wide and high (default 256); a smaller
                     picture stays as it is

Exit code:
  0  done
  1  there is no picture, or OUT.png cannot be written
  2  PROJECT is damaged, or no project
)";

namespace {

using namespace std::chrono_literals;

constexpr std::array thumbnailRules = {OptionRule{"--size", true}};
constexpr int usualSize = 256;
constexpr int largestSize = 2048;
constexpr std::size_t largestPicture = 4 << 20; // bytes; ours have some 20 kB

/// By the process for pictures of unknown origin: file managers ask for whatever was downloaded.
ImageOutcome decoded(const std::string& png)
{
    const WorkFolder folder;
    if (!folder.isValid())
        return {nullptr, {"a temporary folder cannot be made (%1)", {folder.errorString().toStdString()}}};
    const QString file = folder.filePath(QStringLiteral("picture.png"));
    if (Message problem = replaceWholeFile(file, png); !problem.empty())
        return {nullptr, std::move(problem)};
    ImageDecoder decoder;
    decoder.processor = 5s;
    decoder.time = 10s;
    return importImage(file, {}, decoder);
}

QByteArray pngOf(const ImagePixels& pixels, int most)
{
    QImage image(pixels.rgba.data(), pixels.width, pixels.height, 4 * pixels.width, QImage::Format_RGBA8888);
    if (std::max(pixels.width, pixels.height) > most)
        image = image.scaled(most, most, Qt::KeepAspectRatio, Qt::SmoothTransformation);
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return image.save(&buffer, "PNG") ? bytes : QByteArray();
}

int failed(const Message& problem, int code)
{
    printError("error: " + problem.english());
    return code;
}

/// A file manager may write to a place of its own only; the project itself never is one.
bool sameFile(const QString& a, const QString& b)
{
    const QString first = QFileInfo(a).canonicalFilePath();
    return !first.isEmpty() && first == QFileInfo(b).canonicalFilePath();
}

} // namespace

int thumbnail(std::span<const std::string> words)
{
    const Arguments arguments(words, thumbnailRules);
    const std::vector<QString> files = arguments.files({"PROJECT", "OUT.png"});
    const int size = arguments.integer("--size", usualSize, 1, largestSize);
    if (sameFile(files[0], files[1]))
        throw UsageError("OUT.png would overwrite the project");
    const ProjectPicture kept = projectPicture(files[0]);
    if (!kept.problem.empty())
        return failed(kept.problem, badInput);
    const std::string project = files[0].toStdString();
    if (kept.png.empty())
        return failed(
            {"\"%1\" has no picture: open it in the window, and save it when the cover is at rest", {project}},
            otherFailure);
    const ImageOutcome picture = kept.png.size() <= largestPicture ? decoded(kept.png) : ImageOutcome{};
    if (!picture.pixels || !picture.pixels->complete())
        return failed({"the picture in \"%1\" cannot be read", {project}}, otherFailure);
    const Message problem = replaceWholeFile(files[1], pngOf(*picture.pixels, size).toStdString());
    return problem.empty() ? int(done) : failed(problem, otherFailure);
}

} // namespace bolster::cli
