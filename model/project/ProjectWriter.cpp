#include "ProjectWriter.h"

#include "BlobStore.h"
#include "ProjectRows.h"
#include "TemporaryFile.h"

#include <QFileInfo>
#include <QTemporaryFile>

namespace bolster {
namespace {

void throwUnless(const Message& problem)
{
    if (!problem.empty())
        throw DatabaseError(problem);
}

/// The user knows the file that is wanted, not the one that it is at first.
Message naming(Message problem, const QString& temporary, const QString& path)
{
    for (std::string& arg : problem.args)
        if (arg == temporary.toStdString())
            arg = path.toStdString();
    return problem;
}

} // namespace

Hash replaceProject(const QString& path, const std::function<void(const QString& file)>& write, ProjectCheck check)
{
    removeLeftTemporaryFiles(QFileInfo(path).absolutePath());
    TemporaryFile temporary(path);
    throwUnless(temporary.problem());
    try {
        write(temporary.path());
    } catch (const DatabaseError& error) {
        throw DatabaseError(naming(error.message, temporary.path(), path));
    }
    OpenedProject written = openProject(temporary.path(), check);
    throwUnless(naming(written.problem, temporary.path(), path));
    written.database->setName(path);
    for (const auto& [name, blob] : written.assets)
        readBlob(*written.database, blob, nullptr);
    throwUnless(temporary.moveIntoPlace());
    return written.seal;
}

void copyAsset(Database& from, std::int64_t blob, const std::string& name, Database& to, SealedRows& rows)
{
    QTemporaryFile content; // may be larger than memory
    if (!content.open())
        throw DatabaseError({QT_TRANSLATE_NOOP("Message", "a temporary file cannot be made (%1)"),
                             {content.errorString().toStdString()}});
    QFile::remove(content.fileName()); // it needs no name: so nothing is left, whatever ends the program
    readBlob(from, blob, &content);
    content.seek(0);
    putAsset(to, rows, name, NewBlob(to, content).finish(rows));
}

} // namespace bolster
