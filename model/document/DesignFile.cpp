#include "DesignFile.h"

#include "DesignCheck.h"
#include "FileFormats.h"
#include "WholeFile.h"

#include <QFileInfo>

#include <algorithm>
#include <map>
#include <set>
#include <utility>

namespace bolster {
namespace {

constexpr std::int64_t largestDesignFile = 64'000'000;

ReadDesign unreadable(Message why)
{
    ReadDesign read;
    read.problems.push_back({settingsId, {}, {}, std::move(why)});
    return read;
}

/// By its ending.
bool isMadeIntoDesign(const QString& path)
{
    using enum FileUse;
    return !isFileOf(Design, path) && (isFileOf(Frame, path) || isFileOf(Scan, path) || isFileOf(Pattern, path));
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

bool isNear(const Vec3& point)
{
    return (point.array().abs() <= largestCoordinate).all();
}

Message sizeProblem(const Element& element, const FileContent& content, const Box3& box)
{
    const Placement* placement = elementPlacement(element);
    if (!placement)
        return {};
    bool cornersNear = true; // then all within are
    for (int corner = 0; corner < 8; ++corner)
        cornersNear = cornersNear && isNear(placement->placed(box.corner(static_cast<Box3::CornerType>(corner))));
    const std::vector<Vec3>& points = content.points();
    if (cornersNear ||
        std::ranges::all_of(points, [&](const Vec3& point) { return isNear(placement->placed(point)); }))
        return {};
    return {QT_TRANSLATE_NOOP("Message", "with this scale and position the points reach beyond 10,000,000 mm")};
}

/// The files of elements. Many may have the same one, which is read once, and is in memory once.
class ElementFiles {
public:
    ElementFiles(const QString& folder, std::stop_token stop)
        : m_folder(folder)
        , m_stop(std::move(stop))
    {}

    ImportedFile read(const Element& element)
    {
        Message problem;
        const QString path = fileInFolder(*elementFile(element), m_folder, problem);
        if (!problem.empty())
            return {{}, problem};
        const auto [found, isNew] = m_read.try_emplace({fileKind(element), path});
        auto& [file, box] = found->second;
        if (isNew) {
            file = importFile(fileKind(element), path, {m_stop});
            box = file.content.boundingBox();
        }
        if (file.content)
            if (problem = sizeProblem(element, file.content, box); !problem.empty())
                return {{}, problem};
        return file;
    }

private:
    QString m_folder;
    std::stop_token m_stop;
    std::map<std::pair<FileKind, QString>, std::pair<ImportedFile, Box3>> m_read; // by path
};

void readFiles(OpenedDesign& opened, const QString& folder, const std::stop_token& stop)
{
    ElementFiles files(folder, stop);
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
        ImportedFile file = files.read(*element);
        if (stop.stop_requested())
            return;
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

ReadDesign readDesignFile(const QString& path)
{
    const WholeFile file = readWholeFile(path, largestDesignFile);
    if (!file.problem.empty())
        return unreadable(file.problem);
    ReadDesign read = readDesign(file.bytes);
    if (!read.readable && isMadeIntoDesign(path))
        return unreadable({QT_TRANSLATE_NOOP("Message", "\"%1\" is no design, but what one is made of: import it"),
                           {path.toStdString()}});
    if (!read.readable)
        for (Problem& problem : read.problems)
            problem.label = path.toStdString();
    return read;
}

OpenedDesign openDesign(const QString& path, const QString& filesFolder, const std::stop_token& stop)
{
    try {
        return openReadDesign(readDesignFile(path),
                              filesFolder.isEmpty() ? QFileInfo(path).absolutePath() : filesFolder, stop);
    } catch (const std::bad_alloc&) {
        const ReadDesign read =
            unreadable({QT_TRANSLATE_NOOP("Message", "there is not enough memory for this design"), {}});
        return {{}, {}, read.problems};
    }
}

OpenedDesign openReadDesign(ReadDesign read, const QString& filesFolder, const std::stop_token& stop)
{
    OpenedDesign opened{std::move(read.design), {}, std::move(read.problems), read.readable};
    if (!opened.readable)
        return opened;
    const Problems checked = checkDesign(opened.design);
    opened.problems.insert(opened.problems.end(), checked.begin(), checked.end());
    readFiles(opened, filesFolder, stop);
    arrange(opened.problems);
    return opened;
}

QString elementFilePath(const Element& element, const QString& folder, Message& problem)
{
    return fileInFolder(*elementFile(element), folder, problem);
}

ImportedFile readElementFile(const Element& element, const QString& folder)
{
    return ElementFiles(folder, {}).read(element);
}

Message saveDesign(const Design& design, const QString& path)
{
    return replaceWholeFile(path, writeDesign(design));
}

} // namespace bolster
