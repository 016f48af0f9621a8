// Work that programs have left behind: finding it, taking it, throwing it away.
#include "JournalFiles.h"

#include "ProjectRows.h"
#include "TemporaryFile.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>
#include <QStorageInfo>

#include <algorithm>
#include <cstdio>
#include <map>
#include <mutex>

namespace bolster {

using namespace journalFiles;

namespace {

constexpr qint64 leastRoom = 100'000; // bytes
constexpr int leastDaysInBin = 30;
int wantedDaysInBin = leastDaysInBin; // of the GUI thread
constexpr std::chrono::seconds untilOthersHaveLooked(2);

/// Who looks into journals has their locks, one after another, and would seem to be a program that works on them.
/// So the threads of this program take turns.
std::unique_lock<std::mutex> aloneWithJournals()
{
    static std::mutex only;
    return std::unique_lock(only);
}

/// The lock of a journal that was found; another program that only looks into it is waited for.
std::shared_ptr<QLockFile> lockOfFound(const QString& base)
{
    const auto alone = aloneWithJournals();
    return lockOf(base, untilOthersHaveLooked);
}

QString baseOf(const WorkJournal::Left& left)
{
    return left.journal.chopped(left.damaged ? damagedEnding.size() : journalEnding.size());
}

WorkJournal::Taken notTaken(Message why)
{
    WorkJournal::Taken taken;
    taken.project.problem = std::move(why);
    return taken;
}

WorkJournal::Taken taken(const QString& base, std::shared_ptr<QLockFile> lock, Journal::Opened opened)
{
    if (!opened.journal)
        return notTaken(std::move(opened.project.problem));
    HeldHistory held = heldOf(readAbout(base), opened.project);
    return {std::move(lock), std::move(opened.journal), base, std::move(opened.project), std::move(held)};
}

/// A full disk may have kept the journal from knowing what the file holds.
bool isSavedByNow(Journal& journal, const About& about)
{
    return looksLikeProject(about.place.original) && journal.isIn(openProject(about.place.original));
}

/// Whether there is unsaved work in the journal of a program that has ended.
bool hasUnsavedWork(const QString& base)
{
    const auto opened = Journal::open(base + journalEnding);
    if (!opened.journal)
        return true; // whatever it is, it is not for us to throw it away
    const HeldHistory held = heldOf(readAbout(base), opened.project);
    const HistoryMark now = opened.project.history.mark();
    if (!holdsAllWork(held, opened.project.history, now) && !isSavedByNow(*opened.journal, readAbout(base)))
        return true;
    keepPlace(*opened.journal, held, now.current);
    return false;
}

/// Changes when the journal or what it belongs to does.
QString stampOfWork(const QString& base, const About& about)
{
    QStringList stamps;
    for (const QString& path :
         {base + journalEnding, base + journalEnding + logEnding, base + aboutEnding, about.place.original}) {
        const QFileInfo file(path);
        stamps << QStringLiteral("%1 %2").arg(file.size()).arg(file.lastModified().toMSecsSinceEpoch());
    }
    return stamps.join(u',');
}

/// Looks into journals, alone in this program.
class JournalScan {
public:
    /// Reads the history of a journal only when it has changed since: a long one takes a while.
    bool hasUnsavedWork(const QString& base, const About& about) const
    {
        static std::map<QString, QString> known; // stamps of those that have some
        if (const auto found = known.find(base); found != known.end() && found->second == stampOfWork(base, about))
            return true;
        known.erase(base);
        if (!bolster::hasUnsavedWork(base))
            return false;
        known.emplace(base, stampOfWork(base, about));
        return true;
    }

private:
    const std::unique_lock<std::mutex> m_alone = aloneWithJournals();
};

bool isOfProject(const QString& journal, const QString& project)
{
    const std::string uuid = projectUuid(journal);
    return !uuid.empty() && uuid == projectUuid(project);
}

/// Those with unsaved work among the journals that are `wanted`, by what stands about them.
template <class Wanted>
QList<WorkJournal::Left> leftWhere(Wanted wanted)
{
    const JournalScan scan;
    QList<WorkJournal::Left> found;
    for (const QFileInfo& file : QDir(journals()).entryInfoList({"*.bolster"}, QDir::Files, QDir::Time)) {
        WorkJournal::Left left{{}, file.lastModified(), file.absoluteFilePath()};
        const QString base = baseOf(left);
        const About about = readAbout(base);
        const auto lock = wanted(about, left.journal) ? lockOf(base) : nullptr;
        if (!lock)
            continue;
        if (!scan.hasUnsavedWork(base, about)) {
            removeJournal(base);
            continue;
        }
        left.place = about.place;
        left.kept = about.kept;
        if (const QFileInfo wal(left.journal + "-wal"); wal.exists() && wal.lastModified() > left.when)
            left.when = wal.lastModified();
        found.append(left);
    }
    return found;
}

} // namespace

QList<WorkJournal::Left> WorkJournal::left()
{
    removeLeftTemporaryFiles(journals());
    return leftWhere([](const About&, const QString&) { return true; });
}

std::optional<WorkJournal::Left> WorkJournal::leftOf(const QString& original)
{
    QList<Left> found = leftWhere([&, key = fileKey(original)](const About& about, const QString& journal) {
        const QString& known = about.place.original;
        return known.isEmpty() ? isOfProject(journal, original) : fileKey(known) == key;
    });
    if (found.isEmpty())
        return std::nullopt;
    found.front().place.original = original;
    return found.front();
}

std::optional<WorkJournal::Left> WorkJournal::setAside(const Left& left)
{
    const QString base = baseOf(left);
    const auto lock = lockOfFound(base);
    if (!lock || left.damaged || Journal::open(left.journal).journal)
        return std::nullopt;
    Left aside = left;
    aside.damaged = true;
    aside.journal = base + damagedEnding;
    const auto rename = [](const QString& from, const QString& to) { // QFile has its doubts about folders
        return std::rename(QFile::encodeName(from).constData(), QFile::encodeName(to).constData()) == 0;
    };
    rename(left.journal + logEnding, aside.journal + logEnding);
    return rename(left.journal, aside.journal) ? std::optional(aside) : std::nullopt;
}

QList<WorkJournal::Left> WorkJournal::damaged()
{
    QList<Left> found;
    const auto filter = QDir::Files | QDir::Dirs | QDir::NoDotAndDotDot;
    for (const QFileInfo& file : QDir(journals()).entryInfoList({'*' + damagedEnding}, filter, QDir::Time)) {
        Left left{{}, file.lastModified(), file.absoluteFilePath(), false, true};
        const About about = readAbout(baseOf(left));
        left.place = about.place;
        left.kept = about.kept;
        found.append(left);
    }
    return found;
}

bool WorkJournal::isWorkedOn(const QString& original)
{
    const JournalScan scan;
    const QString key = fileKey(original);
    const QFileInfoList files = QDir(journals()).entryInfoList({"*.bolster"}, QDir::Files);
    return std::ranges::any_of(files, [&](const QFileInfo& file) {
        const QString base = file.absoluteFilePath().chopped(journalEnding.size());
        const QString known = readAbout(base).place.original;
        return !known.isEmpty() && fileKey(known) == key && !lockOf(base);
    });
}

WorkJournal::Taken WorkJournal::takeProject(const QString& project)
{
    const QString base = newBase();
    auto lock = lockOf(base);
    if (!lock)
        return notTaken(
            QStorageInfo(journals()).bytesAvailable() < leastRoom
                ? Message{QT_TRANSLATE_NOOP("Message", "the disk of \"%1\" is full, where work is "
                                                       "protected from crashes; make room, and open it "
                                                       "again"),
                          {journals().toStdString()}}
                : Message{QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written"), {journals().toStdString()}});
    if (Message problem = writeAboutFile(base, {{project, {}}, false, {}}); !problem.empty())
        return notTaken(std::move(problem));
    Taken result = taken(base, std::move(lock), Journal::begin(project, base + journalEnding));
    if (!result.journal) {
        removeJournal(base);
        return result;
    }
    result.held = {result.project.history.mark(), false};
    (void)writeAboutFile(base, {{project, {}}, false, result.held});
    return result;
}

WorkJournal::Taken WorkJournal::takeLeft(const Left& left)
{
    const QString base = baseOf(left);
    auto lock = lockOfFound(base);
    if (!lock || !QFileInfo::exists(left.journal))
        return notTaken({QT_TRANSLATE_NOOP("Message", "another window has it"), {}});
    return taken(base, std::move(lock), Journal::open(left.journal));
}

void WorkJournal::putIntoBin(const Left& left)
{
    if (const auto lock = lockOfFound(baseOf(left)))
        moveToBin(baseOf(left));
}

/// What somebody relies on is never shortened below what it has always been.
void WorkJournal::setDaysInBin(int days)
{
    wantedDaysInBin = std::max(days, leastDaysInBin);
}

int WorkJournal::daysInBin()
{
    return wantedDaysInBin;
}

void WorkJournal::emptyBin()
{
    const QDateTime before = QDateTime::currentDateTime().addDays(-wantedDaysInBin);
    for (const QFileInfo& file : QDir(bin()).entryInfoList(QDir::Files))
        if (std::max(file.lastModified(), file.metadataChangeTime()) < before)
            QFile::remove(file.absoluteFilePath());
}

QStringList WorkJournal::filesInUse()
{
    QStringList folders;
    for (const QString& folder : {journals(), bin()})
        for (const QFileInfo& file : QDir(folder).entryInfoList({'*' + aboutEnding}, QDir::Files))
            folders << readAbout(file.absoluteFilePath().chopped(aboutEnding.size())).place.files;
    return folders;
}

} // namespace bolster
