#include "SampleScene.h"

#include "DesignFile.h"
#include "PreparedSheet.h"

#include <QDir>
#include <QFileInfo>

#include <stdexcept>

namespace bolster::bench {

SolveInput sampleScene(const std::string& name, double edge)
{
    const QString file = QString::fromStdString(name) + QStringLiteral(".json");
    const QDir program = QFileInfo(QStringLiteral("/proc/self/exe")).symLinkTarget().section('/', 0, -2);
    // Installed it lies in lib/bolster or the like.
    QString path = QStringLiteral(BOLSTER_SAMPLES_SOURCE "/") + file;
    for (const char* const folder : {"../share/bolster/samples/", "../../share/bolster/samples/"})
        if (QFileInfo::exists(program.filePath(folder + file)))
            path = program.filePath(folder + file);
    const OpenedDesign opened = openDesign(path);
    if (hasErrors(opened.problems) || opened.design.elements().empty())
        throw std::runtime_error("a benchmark failed: the sample " + name + " cannot be read");
    const SolveInput input{opened.design, opened.files};
    return edge > 0 ? withEdgeLength(input, edge) : input;
}

} // namespace bolster::bench
