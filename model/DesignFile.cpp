#include "DesignFile.h"

#include "DesignCheck.h"
#include "DesignJson.h"
#include "MeshImport.h"
#include "WholeFile.h"

#include <QFileInfo>

#include <algorithm>

namespace bolster {
namespace {

constexpr std::int64_t largestDesignFile = 64'000'000;
constexpr double largestCoordinate = 1e7; // mm

OpenedDesign unreadable(Message why)
{
    OpenedDesign opened;
    opened.problems.push_back({settingsId, {}, {}, std::move(why)});
    return opened;
}

/// The frame's file with links resolved, if it is there and inside the folder.
QString fileInFolder(const Frame& frame, const QString& folder, Message& problem)
{
    QString inside = QFileInfo(folder).canonicalFilePath();
    if (!inside.endsWith('/'))
        inside += '/';
    const QString file = QFileInfo(inside + QString::fromStdString(frame.file)).canonicalFilePath();
    if (QFileInfo(QString::fromStdString(frame.file)).isAbsolute() || (!file.isEmpty() && !file.startsWith(inside)))
        problem = {QT_TRANSLATE_NOOP("Message", "\"%1\" is no file in the design's folder; copy the mesh into that "
                                                "folder and name it here"),
                   {frame.file}};
    else if (file.isEmpty())
        problem = {QT_TRANSLATE_NOOP("Message",
                                     "there is no file \"%1\" in the design's folder; copy the mesh there "
                                     "or choose another one"),
                   {frame.file}};
    return problem.empty() ? file : QString();
}

Message sizeProblem(const Frame& frame, const TriangleMesh& mesh)
{
    for (const Vec3& point : mesh.points)
        if (!(frame.placed(point).array().abs() <= largestCoordinate).all())
            return {QT_TRANSLATE_NOOP("Message",
                                      "with this scale and position the frame reaches beyond 10,000,000 mm")};
    return {};
}

void readFrames(OpenedDesign& opened, const QString& folder)
{
    opened.design.each<Frame>([&](ElementId id, const Frame& frame) {
        const bool refused = std::any_of(opened.problems.begin(), opened.problems.end(), [&](const Problem& known) {
            return known.element == id && known.field == "file" && known.severity == Severity::Error;
        });
        if (refused)
            return;
        Message problem;
        if (auto mesh = readFrame(frame, folder, &problem))
            opened.frames.emplace(id, std::move(mesh));
        else
            opened.problems.push_back(
                {id, elementLabel(id, *opened.design.element(id)), "file", std::move(problem)});
    });
}

/// Ordered as checkDesign does, each only once.
void arrange(Problems& problems)
{
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
        return std::tie(a.element, a.field) < std::tie(b.element, b.field);
    });
    problems.erase(std::unique(problems.begin(), problems.end()), problems.end());
}

} // namespace

OpenedDesign openDesign(const QString& path, const QString& frameFolder)
{
    const WholeFile file = readWholeFile(path, largestDesignFile);
    if (!file.problem.empty())
        return unreadable(file.problem);
    try {
        ReadDesign read = readDesign(file.bytes);
        OpenedDesign opened{std::move(read.design), {}, std::move(read.problems), read.readable};
        if (!opened.readable)
            return opened;
        const Problems checked = checkDesign(opened.design);
        opened.problems.insert(opened.problems.end(), checked.begin(), checked.end());
        readFrames(opened, frameFolder.isEmpty() ? QFileInfo(path).absolutePath() : frameFolder);
        arrange(opened.problems);
        return opened;
    } catch (const std::bad_alloc&) {
        return unreadable({QT_TRANSLATE_NOOP("Message", "there is not enough memory for this design"), {}});
    }
}

std::shared_ptr<const TriangleMesh> readFrame(const Frame& frame, const QString& folder, Message* problem)
{
    Message why;
    const QString file = fileInFolder(frame, folder, why);
    ImportedMesh imported;
    if (why.empty()) {
        imported = importMesh(file);
        why = imported.problem;
    }
    if (why.empty())
        why = sizeProblem(frame, *imported.mesh);
    if (problem)
        *problem = why;
    return why.empty() ? imported.mesh : nullptr;
}

Message saveDesign(const Design& design, const QString& path)
{
    return replaceWholeFile(path, writeDesign(design));
}

} // namespace bolster
