#include "SolveOutputs.h"

#include "Output.h"
#include "PictureFile.h"
#include "ReportJson.h"
#include "SurfaceExport.h"
#include "WholeFile.h"

#include <QFileInfo>

#include <utility>

namespace bolster::cli {
namespace {

/// One name for one file, however it is reached. Several outputs may go to the same device.
QString resolved(const QString& path)
{
    constexpr int mostLinks = 40;
    QFileInfo info(path);
    for (int links = 0; info.isSymLink() && links < mostLinks; ++links)
        info.setFile(info.symLinkTarget()); // which may not be there yet
    const QString folder = QFileInfo(info.absolutePath()).canonicalFilePath();
    return folder.isEmpty() ? info.absoluteFilePath() : folder + "/" + info.fileName();
}

bool isDevice(const QString& path)
{
    return QFileInfo::exists(path) && !QFileInfo(path).isFile();
}

Scene scene(const SurfaceMeshPtr& surface, const Design& design)
{
    Scene scene;
    scene.surface = surface;
    scene.patches = patchLooks(design, noElement);
    return scene;
}

Message writeImage(const SurfaceMeshPtr& surface, const Design& design, const PreviewOptions& options,
                   const QString& path, std::stop_token stop)
{
    const auto view =
        RayCamera::threeQuarter(surface->boundingBox(), static_cast<double>(options.width) / options.height);
    const PreviewImage image = renderPreview(scene(surface, design), view, options, std::move(stop));
    if (image.rgba.empty())
        return {"\"%1\" was not drawn: interrupted", {path.toStdString()}};
    const EncodedPicture encoded = encodePicture(image, PictureFormat::Png);
    return encoded.problem.empty() ? replaceWholeFile(path, encoded.bytes) : encoded.problem;
}

} // namespace

SolveOutputs::SolveOutputs(const Arguments& arguments, int threads)
    : m_threads(threads)
{
    std::map<QString, std::string> taken;
    for (const char* const option : {"--obj", "--ply", "--image", "--report"}) {
        if (!arguments.has(option))
            continue;
        const QString path = arguments.path(option);
        m_paths.emplace(option, path);
        const auto [other, isNew] = taken.emplace(resolved(path), option);
        if (!isNew && !isDevice(path))
            throw UsageError(other->second + " and " + option + " are the same file");
    }
}

void SolveOutputs::protectInputs(const QString& designPath, const Design& design) const
{
    std::map<QString, std::string> inputs = {{resolved(designPath), "the design"}};
    const QString folder = QFileInfo(designPath).absolutePath();
    for (const auto& [id, element] : design.elements())
        if (const std::string* file = elementFile(*element))
            inputs.emplace(resolved(folder + "/" + QString::fromStdString(*file)),
                           "the file \"" + *file + "\" of " + elementLabel(id, *element));
    for (const auto& [option, path] : m_paths)
        if (const auto input = inputs.find(resolved(path)); input != inputs.end() && QFileInfo(path).isFile())
            throw UsageError(option + " would overwrite " + input->second);
}

bool SolveOutputs::write(const SolveResult& result, const Design& design, std::stop_token stop) const
{
    bool allWritten = true;
    const auto write = [&](const std::string& option, auto writer) {
        const auto found = m_paths.find(option);
        if (found == m_paths.end())
            return;
        const Message problem = writer(found->second);
        if (problem.empty())
            printResult("wrote " + found->second.toStdString());
        else
            printError("error: " + problem.english());
        allWritten = allWritten && problem.empty();
    };
    if (result.surface) {
        PreviewOptions options;
        options.threads = m_threads;
        write("--obj", [&](const QString& path) { return exportObj(*result.surface, design, path); });
        write("--ply", [&](const QString& path) { return exportPly(*result.surface, design, path); });
        write("--image",
              [&](const QString& path) { return writeImage(result.surface, design, options, path, stop); });
    }
    write("--report", [&](const QString& path) { return replaceWholeFile(path, reportJson(result)); });
    return allWritten;
}

} // namespace bolster::cli
