#include "DesignFile.h"

#include "DesignCheck.h"
#include "WholeFile.h"

#include <QFileInfo>

#include <algorithm>
#include <set>

namespace bolster {
namespace {

constexpr std::int64_t largestDesignFile = 64'000'000;

OpenedDesign unreadable(Message why)
{
    OpenedDesign opened;
    opened.problems.push_back({settingsId, {}, {}, std::move(why)});
    return opened;
}

/// The element's file with links resolved, if it is there and inside the folder.
QString fileInFolder(const std::string& name, const QString& folder, Message& problem)
{
    QString inside = QFileInfo(folder).canonicalFilePath();
    if (!inside.endsWith('/'))
        inside += '/';
    const QString file = QFileInfo(inside + QString::fromStdString(name)).canonicalFilePath();
    if (QFileInfo(QString::fromStdString(name)).isAbsolute() || (!file.isEmpty() && !file.startsWith(inside)))
        problem = {QT_TRANSLATE_NOOP("Message", "\"%1\" is no file in the design's folder; copy the file into that "
                                                "folder and name it here"),
                   {name}};
    else if (file.isEmpty())
        problem = {QT_TRANSLATE_NOOP("Message",
                                     "there is no file \"%1\" in the design's folder; copy the file there "
                                     "or choose another one"),
                   {name}};
    return problem.empty() ? file : QString();
}

Message sizeProblem(const Element& element, const FileContent& content)
{
    const Placement* placement = elementPlacement(element);
    for (const Vec3& point : content.points())
        if (placement && !(placement->placed(point).array().abs() <= largestCoordinate).all())
            return {
                QT_TRANSLATE_NOOP("Message", "with this scale and position the points reach beyond 10,000,000 mm")};
    return {};
}

void readFiles(OpenedDesign& opened, const QString& folder)
{
    std::set<std::pair<ElementId, std::string>> refused;
    for (const Problem& known : opened.problems)
        if (known.severity == Severity::Error)
            refused.emplace(known.element, known.field);
    for (const auto& [id, element] : opened.design.elements()) {
        if (!elementFile(*element) || refused.contains({id, elementFileField(*element)}))
            continue;
        if (!hasShapeFile(*element)) { // whoever looks at it reads it, and marks what is missing
            Message missing;
            fileInFolder(*elementFile(*element), folder, missing);
            if (!missing.empty())
                opened.problems.push_back({id, elementLabel(id, *element), elementFileField(*element),
                                           std::move(missing), Severity::Warning});
            continue;
        }
        ImportedFile file = readElementFile(*element, folder);
        file.content.addTo(opened.files, id);
        if (!file.content)
            opened.problems.push_back({id, elementLabel(id, *element), "file", std::move(file.problem)});
        else if (!file.warning.empty())
            opened.problems.push_back(
                {id, elementLabel(id, *element), "file", std::move(file.warning), Severity::Warning});
    }
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

OpenedDesign openDesign(const QString& path, const QString& filesFolder)
{
    const WholeFile file = readWholeFile(path, largestDesignFile);
    if (!file.problem.empty())
        return unreadable(file.problem);
    try {
        return openReadDesign(readDesign(file.bytes),
                              filesFolder.isEmpty() ? QFileInfo(path).absolutePath() : filesFolder);
    } catch (const std::bad_alloc&) {
        return unreadable({QT_TRANSLATE_NOOP("Message", "there is not enough memory for this design"), {}});
    }
}

OpenedDesign openReadDesign(ReadDesign read, const QString& filesFolder)
{
    OpenedDesign opened{std::move(read.design), {}, std::move(read.problems), read.readable};
    if (!opened.readable)
        return opened;
    const Problems checked = checkDesign(opened.design);
    opened.problems.insert(opened.problems.end(), checked.begin(), checked.end());
    readFiles(opened, filesFolder);
    arrange(opened.problems);
    return opened;
}

QString elementFilePath(const Element& element, const QString& folder, Message& problem)
{
    return fileInFolder(*elementFile(element), folder, problem);
}

ImportedFile readElementFile(const Element& element, const QString& folder)
{
    Message problem;
    const QString file = fileInFolder(*elementFile(element), folder, problem);
    if (!problem.empty())
        return {{}, problem};
    ImportedFile imported = importFile(fileKind(element), file);
    if (imported.content)
        if (problem = sizeProblem(element, imported.content); !problem.empty())
            return {{}, problem};
    return imported;
}

Message saveDesign(const Design& design, const QString& path)
{
    return replaceWholeFile(path, writeDesign(design));
}

} // namespace bolster
