#include "SolveOutputs.h"

#include "PictureFile.h"
#include "ReportJson.h"
#include "SurfaceExport.h"
#include "WholeFile.h"

namespace bolster::cli {
namespace {

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
    : m_files(arguments, {"--obj", "--ply", "--image", "--report"})
    , m_threads(threads)
{}

bool SolveOutputs::write(const SolveResult& result, const Design& design, std::stop_token stop) const
{
    bool allWritten = true;
    const auto write = [&](const std::string& option, const std::function<Message(const QString&)>& writer) {
        allWritten = m_files.write(option, writer) && allWritten;
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
