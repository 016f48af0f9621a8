#include "FabricBaking.h"

#include "BakeFabric.h"
#include "DesignFile.h"
#include "ImageImport.h"
#include "Output.h"
#include "Project.h"

#include <QFileInfo>

#include <optional>
#include <utility>

namespace bolster::cli {

namespace {

/// The folder with the files of the design: those of a project are written to `extracted`.
QString folderWithFiles(const QString& path, const Design& design, const WorkFolder& extracted)
{
    if (!looksLikeProject(path))
        return QFileInfo(path).absolutePath();
    if (const OpenedProject project = openProject(path); project.problem.empty())
        (void)extractAssets(project, design, extracted.path()); // what is missing shows when it is looked for
    return extracted.path();
}

} // namespace

Problems pictureProblems(const QString& path, const Design& design, const std::stop_token& stop)
{
    std::optional<WorkFolder> extracted;
    QString folder;
    std::map<QString, Message> known; // by file: many fabrics may have the same
    Problems problems;
    design.each<Fabric>([&](ElementId id, const Fabric& fabric) {
        if (fabric.look.kind != FabricLook::Kind::Image || fabric.look.file.empty() || stop.stop_requested())
            return;
        if (!extracted)
            folder = folderWithFiles(path, design, extracted.emplace());
        const Element& element = *design.element(id);
        Message missing;
        const QString file = elementFilePath(element, folder, missing);
        if (!missing.empty()) // which is known already
            return;
        const auto [found, isNew] = known.try_emplace(file);
        if (isNew)
            found->second = importImage(file, stop).problem;
        if (!found->second.empty())
            problems.push_back({id, elementLabel(id, element), "look.file", found->second, Severity::Warning});
    });
    return problems;
}

FabricBaking::FabricBaking(const QString& path, const Design& design, int threads, std::stop_token stop)
    : m_design(design)
    , m_folder(folderWithFiles(path, design, m_extracted))
    , m_threads(threads)
    , m_stop(std::move(stop))
{}

FabricMapsPtr FabricBaking::operator()(ElementId id, const Fabric& fabric)
{
    if (const auto found = m_baked.find(id); found != m_baked.end())
        return found->second;
    ImagePixelsPtr pixels;
    if (fabric.look.kind == FabricLook::Kind::Image) {
        ImageOutcome image;
        const ElementPtr element = m_design.element(id);
        const QString file = elementFilePath(*element, m_folder, image.problem);
        if (image.problem.empty())
            image = importImage(file, m_stop);
        if (!image.problem.empty())
            printProblems({{id, elementLabel(id, *element), "look.file", image.problem, Severity::Warning}});
        pixels = image.pixels;
    }
    BakeOptions options;
    options.threads = m_threads;
    return m_baked.emplace(id, bakeFabric(fabric, pixels.get(), options)).first->second;
}

} // namespace bolster::cli
