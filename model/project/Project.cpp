#include "Project.h"

#include "BlobStore.h"
#include "DesignJson.h"
#include "DiskFile.h"
#include "ProjectContents.h"
#include "Schema.h"
#include "Unfinished.h"

#include <QDir>
#include <QFileInfo>

#include <algorithm>
#include <limits>

namespace bolster {
namespace {

constexpr std::string_view magic("SQLite format 3", 16); // with its zero
constexpr std::size_t readSize = 105;                    // that of SQLite, and the beginning of its list of tables

std::int64_t bigEndian(std::string_view bytes, std::size_t at, std::size_t length)
{
    std::int64_t number = 0;
    for (std::size_t i = 0; i < length; ++i)
        number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return number;
}

/// The first bytes, fewer where there are not so many.
std::string headOf(const DiskFile& file, std::size_t count)
{
    std::string head(count, '\0');
    head.resize(static_cast<std::size_t>(std::max<std::int64_t>(file.read(0, head.data(), count), 0)));
    return head;
}

/// What the first bytes tell, before SQLite has a look.
Message headProblem(const QString& path, bool& damaged)
{
    const std::string name = path.toStdString();
    Message problem;
    const auto file = DiskFile::open(path, std::numeric_limits<std::int64_t>::max(), problem);
    if (!file)
        return problem;
    const std::string head = headOf(*file, readSize);
    const auto size = static_cast<std::int64_t>(file->size());
    if (head.size() < readSize || !head.starts_with(magic) || bigEndian(head, 68, 4) != applicationId)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is no Bolster project"), {name}};
    if (bigEndian(head, 60, 4) > schemaVersion)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" was made by a newer Bolster (version %2 of the format, this "
                                             "program knows %3); update the program"),
                {name, std::to_string(bigEndian(head, 60, 4)), std::to_string(schemaVersion)}};
    if (bigEndian(head, 60, 4) != schemaVersion)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" says that it has version %2 of the format, which never was"),
                {name, std::to_string(bigEndian(head, 60, 4))}};
    if (head[18] != 1 || head[19] != 1)
        return {QT_TRANSLATE_NOOP("Message",
                                  "\"%1\" is the journal of a running program, or of one that crashed, not "
                                  "a project file"),
                {name}};
    damaged = true;
    if (bigEndian(head, 16, 2) != pageSize || bigEndian(head, 28, 4) * pageSize != size)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged: it is %2 bytes long and should have %3"),
                {name, std::to_string(size), std::to_string(bigEndian(head, 28, 4) * pageSize)}};
    if (!tablesFitOnePage(std::string_view(head).substr(100)))
        return foreignTables(path);
    return {};
}

OpenedProject refused(Message why, bool damaged = false)
{
    OpenedProject project;
    project.damaged = damaged;
    project.problem = std::move(why);
    return project;
}

OpenedDesign unreadable(Message why)
{
    OpenedDesign result;
    result.problems.push_back({settingsId, {}, {}, std::move(why)});
    return result;
}

QString pathOfAsset(const std::string& name, const QString& folder)
{
    return QDir(folder).filePath(QString::fromStdString(assetPlace(name)));
}

void extractAsset(const OpenedProject& project, const std::string& name, const QString& folder, FileThere there)
{
    extractBlob(*project.database, project.assets.at(name), pathOfAsset(name, folder), there);
}

} // namespace

bool looksLikeProject(const QString& path)
{
    Message problem;
    const auto file = DiskFile::open(path, std::numeric_limits<std::int64_t>::max(), problem);
    return file && headOf(*file, magic.size()) == magic;
}

std::string projectUuid(const QString& path)
{
    if (!looksLikeProject(path))
        return {};
    try {
        Database database(path, Database::Access::AtRest);
        Query project(database, "SELECT uuid FROM project");
        return project.next() ? std::string(project.blob(0)) : std::string();
    } catch (const std::exception&) {
        return {};
    }
}

ProjectPicture projectPicture(const QString& path)
{
    ProjectPicture picture;
    picture.problem = headProblem(path, picture.damaged);
    if (!picture.problem.empty())
        return picture;
    try {
        Database database(path, Database::Access::AtRest);
        checkTables(database); // a column of other tables may take for ever
        Query query(database, "SELECT png FROM thumbnail WHERE node <= (SELECT node FROM state LIMIT 1) "
                              "ORDER BY node DESC LIMIT 1");
        if (query.next())
            picture.png = query.blob(0);
        picture.damaged = false;
    } catch (const DatabaseError& error) {
        picture.problem = error.message;
    } catch (const std::bad_alloc&) {
        picture = {{}, {QT_TRANSLATE_NOOP("Message", "there is not enough memory for this project"), {}}, false};
    }
    return picture;
}

OpenedProject openProject(const QString& path, ProjectCheck check)
{
    bool damaged = false;
    if (Message problem = headProblem(path, damaged); !problem.empty())
        return refused(std::move(problem), damaged);
    try {
        auto database = std::make_shared<Database>(path, Database::Access::AtRest);
        ProjectContents contents = readContents(*database);
        Design design = designOf(*database, contents, contents.current);
        const std::int64_t checked =
            check == ProjectCheck::ToWork ? 0 : checkThoroughly(*database, contents, check);
        OpenedProject project = opened(std::move(contents), std::move(design), std::move(database));
        project.designsChecked = checked;
        return project;
    } catch (const DatabaseError& error) {
        return refused(error.message, true);
    } catch (const std::bad_alloc&) {
        return refused({QT_TRANSLATE_NOOP("Message", "there is not enough memory for this project"), {}});
    }
}

Message damageAdvice(const OpenedProject& project, const QString& path)
{
    if (!project.damaged)
        return project.problem;
    const std::string file = "\"" + path.toStdString() + "\"";
    const std::string why = project.problem.english();
    return {"%1; \"bolster salvage\" may get out what is left: bolster salvage %2 OUT",
            {why.find(file) == std::string::npos ? file + ": " + why : why, file}};
}

std::optional<FieldChanges> storedChanges(const OpenedProject& project, NodeId node)
{
    try {
        return changesOf(*project.database, node);
    } catch (const DatabaseError&) {
        return std::nullopt;
    }
}

ElementId largestIdEver(const OpenedProject& project)
{
    ElementId largest = noElement;
    for (NodeId node = 0; node < project.history.count(); ++node)
        if (const auto changes = storedChanges(project, node); changes && !changes->empty())
            largest = std::max(largest, changes->back().element); // they are sorted by it
    return largest;
}

Message extractAllAssets(const OpenedProject& project, const QString& folder)
{
    for (const auto& [name, blob] : project.assets)
        if (const QFileInfo there(pathOfAsset(name, folder)); there.exists() || there.isSymLink())
            return {QT_TRANSLATE_NOOP("Message", "there is a file \"%1\" already"),
                    {there.filePath().toStdString()}};
    try {
        for (const auto& [name, blob] : project.assets)
            extractAsset(project, name, folder, FileThere::Refuse);
        return {};
    } catch (const DatabaseError& error) {
        return error.message;
    }
}

Problems extractAssets(const OpenedProject& project, const Design& design, const QString& folder)
{
    Problems problems;
    std::map<std::string, Message> done; // what went wrong, by name
    for (const auto& [id, element] : design.elements()) {
        const std::string* name = elementFile(*element);
        if (!name || !project.assets.contains(*name))
            continue; // whoever reads the files reports those that are not there
        const auto [found, isNew] = done.try_emplace(*name);
        try {
            if (isNew)
                extractAsset(project, *name, folder, FileThere::Replace);
        } catch (const DatabaseError& error) {
            found->second = error.message;
        }
        if (!found->second.empty())
            problems.push_back({id, elementLabel(id, *element), elementFileField(*element), found->second,
                                hasShapeFile(*element) ? Severity::Error : Severity::Warning});
    }
    return problems;
}

OpenedDesign openDesignOrProject(const QString& path)
{
    if (!looksLikeProject(path))
        return openDesign(path);
    const OpenedProject project = openProject(path);
    if (!project.problem.empty())
        return unreadable(damageAdvice(project, path));
    const WorkFolder folder;
    if (!folder.isValid())
        return unreadable({QT_TRANSLATE_NOOP("Message", "a temporary folder cannot be made (%1)"),
                           {folder.errorString().toStdString()}});
    Problems problems = extractAssets(project, project.design, folder.path());
    project.design.each<Quarantined>([&](ElementId, const Quarantined& bad) {
        problems.insert(problems.end(), bad.problems.begin(), bad.problems.end());
    });
    return openReadDesign({project.design, std::move(problems), true}, folder.path());
}

} // namespace bolster
