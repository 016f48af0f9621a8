#include "FabricBaking.h"

#include "BakeFabric.h"
#include "DesignFile.h"
#include "ImageImport.h"
#include "Output.h"
#include "Project.h"

#include <QFileInfo>

#include <utility>

namespace bolster::cli {

FabricBaking::FabricBaking(const QString& path, const Design& design, int threads, std::stop_token stop)
    : m_design(design)
    , m_folder(QFileInfo(path).absolutePath())
    , m_threads(threads)
    , m_stop(std::move(stop))
{
    if (!looksLikeProject(path))
        return;
    m_folder = m_extracted.path();
    if (const OpenedProject project = openProject(path); project.problem.empty())
        (void)extractAssets(project, design, m_folder); // what is missing shows when it is looked for
}

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
