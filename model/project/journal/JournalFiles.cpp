#include "JournalFiles.h"

#include "LastPlaces.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

namespace bolster::journalFiles {

namespace {

constexpr std::int64_t longestAbout = 100'000;

QString stateFolder(const char* name)
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + '/' + name;
}

/// "text 5" or "project 5 12 HASH": the present version, and of a project how many there are, and their names.
QString textOf(const HeldHistory& held)
{
    const QString current = QString::number(held.mark.current);
    if (held.designAlone)
        return QStringLiteral("text ") + current;
    return QStringLiteral("project %1 %2 ").arg(current).arg(held.mark.count) + held.mark.names.toHex();
}

std::optional<HeldHistory> heldFrom(const QString& text)
{
    const QStringList words = text.split(' ');
    HeldHistory held;
    held.designAlone = words[0] == QLatin1String("text");
    if (!held.designAlone && words[0] != QLatin1String("project"))
        return std::nullopt;
    held.mark.current = words.value(1).toInt();
    held.mark.count = words.value(2).toInt();
    held.mark.names = QByteArray::fromHex(words.value(3).toLatin1());
    return held;
}

} // namespace

QString journals()
{
    return stateFolder("journals");
}

QString bin()
{
    return stateFolder("bin");
}

QString newBase()
{
    QDir().mkpath(journals());
    return journals() + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces);
}

std::shared_ptr<QLockFile> lockOf(const QString& base, std::chrono::milliseconds patience)
{
    auto lock = std::make_shared<QLockFile>(base + ".lock");
    lock->setStaleLockTime(0);
    return lock->tryLock(static_cast<int>(patience.count())) ? std::move(lock) : nullptr;
}

About readAbout(const QString& base)
{
    const QStringList lines =
        QString::fromStdString(readWholeFile(base + aboutEnding, longestAbout).bytes).split('\n');
    About about;
    about.place = {lines.value(0), lines.value(1), stampFrom(lines.value(4)), lines.value(5)};
    about.kept = lines.value(2) == QLatin1String("kept");
    about.held = heldFrom(lines.value(3));
    return about;
}

Message writeAboutFile(const QString& base, const About& about)
{
    const QStringList lines{about.place.original,
                            about.place.files,
                            about.kept ? QStringLiteral("kept") : QString(),
                            about.held ? textOf(*about.held) : QString(),
                            textOf(about.place.stamp),
                            about.place.title.simplified()};
    return replaceWholeFile(base + aboutEnding, lines.join('\n').toStdString());
}

HeldHistory heldOf(const About& about, const OpenedProject& project)
{
    const NodeId count = project.history.count();
    HeldHistory held = about.held.value_or(HeldHistory{});
    if (!about.held && (project.base || project.saved))
        held = {{project.saved.value_or(0), project.saved.value_or(0) + 1, {}}, false};
    if (held.mark.current < 0 || held.mark.current >= count)
        held.mark.current = 0;
    return held;
}

void removeJournal(const QString& base)
{
    for (const char* ending : {".bolster", ".bolster-wal", ".bolster-journal", ".about"})
        QFile::remove(base + ending);
}

void moveToBin(const QString& base)
{
    QDir().mkpath(bin());
    const QString target = bin() + '/' + QFileInfo(base).fileName();
    for (const QString& ending : {journalEnding, damagedEnding, damagedEnding + logEnding, aboutEnding})
        if (!QFile::rename(base + ending, target + ending))
            QFile::remove(base + ending);
    removeJournal(base);
}

void keepPlace(const Journal& journal, const HeldHistory& held, NodeId current)
{
    if (held.designAlone)
        return;
    if (const auto seal = journal.base(); seal && current != held.mark.current)
        lastPlaces::keep(journal.uuid(), *seal, current);
    else
        lastPlaces::forget(journal.uuid());
}

} // namespace bolster::journalFiles
