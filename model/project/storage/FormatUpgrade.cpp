#include "FormatUpgrade.h"

#include "ProjectRows.h"
#include "Schema.h"
#include "TemporaryFile.h"

#include <QFileInfo>

#include <algorithm>

namespace bolster {
namespace {

void upgrade(Database& database, std::int64_t from, std::int64_t to, std::span<const UpgradeStep> steps)
{
    Transaction transaction(database);
    for (std::int64_t version = from; version < to; ++version) {
        const auto step =
            std::find_if(steps.begin(), steps.end(), [&](const UpgradeStep& each) { return each.from == version; });
        if (step == steps.end())
            throw DatabaseError(
                {QT_TRANSLATE_NOOP("Message", "\"%1\" has version %2 of the format, which this program "
                                              "does not know"),
                 {database.path().toStdString(), std::to_string(from)}});
        step->change(database);
    }
    database.run(("PRAGMA user_version = " + std::to_string(to)).c_str());
    transaction.commit();
}

} // namespace

std::span<const UpgradeStep> upgradeSteps()
{
    return {};
}

std::int64_t formatVersionOf(const QString& project)
{
    try {
        Database database(project, Database::Access::AtRest);
        return database.number("PRAGMA application_id") == applicationId ? database.number("PRAGMA user_version")
                                                                         : -1;
    } catch (const DatabaseError&) {
        return -1;
    }
}

Message upgradeProject(const QString& project, const QString& out, std::int64_t to,
                       std::span<const UpgradeStep> steps)
{
    if (QFileInfo::exists(out))
        return {QT_TRANSLATE_NOOP("Message", "there is a file \"%1\" already"), {out.toStdString()}};
    const std::int64_t from = formatVersionOf(project);
    if (from < 0)
        return {QT_TRANSLATE_NOOP("Message", "\"%1\" is no Bolster project"), {project.toStdString()}};
    TemporaryFile temporary(out);
    if (Message problem = temporary.copyFrom(project); !problem.empty())
        return problem;
    try {
        Database database(temporary.path(), Database::Access::Working);
        prepareUnshared(database);
        upgrade(database, from, to, steps);
    } catch (const DatabaseError& error) {
        return error.message;
    }
    return temporary.moveIntoPlace();
}

} // namespace bolster
