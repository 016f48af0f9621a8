#include "Project.h"

#include "BlobStore.h"
#include "DesignJson.h"
#include "ProjectContents.h"
#include "Schema.h"

#include <QDir>
#include <QFile>
#include <QFileInfo>
#include <QTemporaryDir>

namespace bolster {
namespace {

constexpr std::string_view magic("SQLite format 3", 16); // with its zero
constexpr qsizetype headSize = 100;

std::int64_t bigEndian(const QByteArray& bytes, qsizetype at, int length)
{
    std::int64_t number = 0;
    for (int i = 0; i < length; ++i)
        number = number << 8 | static_cast<std::uint8_t>(bytes[at + i]);
    return number;
}

/// What the first bytes tell, before SQLite has a look.
Message headProblem(const QString& path)
{
    const std::string name = path.toStdString();
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return QFileInfo::exists(path) ? Message{QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be read (%2)"),
                                                 {name, file.errorString().toStdString()}}
                                       : Message{QT_TRANSLATE_NOOP("Message", "there is no file \"%1\""), {name}};
    const QByteArray head = file.read(headSize);
    if (head.size() < headSize || !head.startsWith(QByteArrayView(magic.data(), magic.size())) ||
        bigEndian(head, 68, 4) != applicationId)
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
    if (bigEndian(head, 16, 2) != pageSize || bigEndian(head, 28, 4) * pageSize != file.size())
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is damaged: it is %2 bytes long and should have %3"),
                {name, std::to_string(file.size()), std::to_string(bigEndian(head, 28, 4) * pageSize)}};
    return {};
}

OpenedProject refused(Message why)
{
    OpenedProject project;
    project.problem = std::move(why);
    return project;
}

OpenedDesign unreadable(Message why)
{
    OpenedDesign result;
    result.problems.push_back({settingsId, {}, {}, std::move(why)});
    return result;
}

void extractAsset(const OpenedProject& project, const std::string& name, const QString& folder)
{
    const QString path = QDir(folder).filePath(QDir::cleanPath(QString::fromStdString(name)));
    extractBlob(*project.database, project.assets.at(name), path);
}

} // namespace

bool looksLikeProject(const QString& path)
{
    QFile file(path);
    return file.open(QIODevice::ReadOnly) &&
           file.read(static_cast<qint64>(magic.size())) == QByteArrayView(magic.data(), magic.size());
}

OpenedProject openProject(const QString& path, ProjectCheck check)
{
    if (Message problem = headProblem(path); !problem.empty())
        return refused(std::move(problem));
    try {
        auto database = std::make_shared<Database>(path, Database::Access::AtRest);
        ProjectContents contents = readContents(*database);
        Design design = designOf(*database, contents, contents.current);
        if (check == ProjectCheck::Everything)
            checkEverything(*database, contents);
        return opened(std::move(contents), std::move(design), std::move(database));
    } catch (const DatabaseError& error) {
        return refused(error.message);
    } catch (const std::bad_alloc&) {
        return refused({QT_TRANSLATE_NOOP("Message", "there is not enough memory for this project"), {}});
    }
}

std::optional<FieldChanges> storedChanges(const OpenedProject& project, NodeId node)
{
    try {
        return changesOf(*project.database, node);
    } catch (const DatabaseError&) {
        return std::nullopt;
    }
}

Message extractAllAssets(const OpenedProject& project, const QString& folder)
{
    try {
        for (const auto& [name, blob] : project.assets)
            extractAsset(project, name, folder);
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
                extractAsset(project, *name, folder);
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
        return unreadable(project.problem);
    const QTemporaryDir folder;
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
