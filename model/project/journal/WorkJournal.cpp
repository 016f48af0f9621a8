#include "WorkJournal.h"

#include "EditCodec.h"
#include "LastPlaces.h"
#include "ProjectRows.h"
#include "TemporaryFile.h"
#include "WholeFile.h"

#include <QDir>
#include <QFileInfo>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <chrono>
#include <cstdio>
#include <map>
#include <mutex>

namespace bolster {
namespace {

const QString journalEnding = QStringLiteral(".bolster");
const QString damagedEnding = QStringLiteral(".damaged");
const QString logEnding = QStringLiteral("-wal"); // after the other one
const QString aboutEnding = QStringLiteral(".about");
constexpr std::int64_t longestAbout = 100'000;
constexpr int daysInBin = 30;
constexpr std::chrono::seconds untilNextTry(2);
constexpr std::chrono::seconds untilOthersHaveLooked(2);

QString stateFolder(const char* name)
{
    return QStandardPaths::writableLocation(QStandardPaths::AppLocalDataLocation) + '/' + name;
}

QString journals()
{
    return stateFolder("journals");
}

QString bin()
{
    return stateFolder("bin");
}

/// Only the lock of a program that has ended can be had: no age makes a lock invalid.
std::shared_ptr<QLockFile> lockOf(const QString& base, std::chrono::milliseconds patience = {})
{
    auto lock = std::make_shared<QLockFile>(base + ".lock");
    lock->setStaleLockTime(0);
    return lock->tryLock(static_cast<int>(patience.count())) ? std::move(lock) : nullptr;
}

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

QString newBase()
{
    QDir().mkpath(journals());
    return journals() + '/' + QUuid::createUuid().toString(QUuid::WithoutBraces);
}

QString baseOf(const WorkJournal::Left& left)
{
    return left.journal.chopped(left.damaged ? damagedEnding.size() : journalEnding.size());
}

/// What stands in UUID.about, a line each.
struct About {
    WorkJournal::Place place;
    bool kept = false;
    std::optional<HeldHistory> held;
};

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

/// Where nobody could say it before the program was killed: as little as may be.
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

/// Of a project without unsaved work: nobody has made it, but whoever comes back wants to be there.
void keepPlace(const Journal& journal, const HeldHistory& held, NodeId current)
{
    if (held.designAlone)
        return;
    if (const auto seal = journal.base(); seal && current != held.mark.current)
        lastPlaces::keep(journal.uuid(), *seal, current);
    else
        lastPlaces::forget(journal.uuid());
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
    QList<Left> found = leftWhere([&](const About& about, const QString& journal) {
        const QString& known = about.place.original;
        return known == original || (known.isEmpty() && isOfProject(journal, original));
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
    const QFileInfoList files = QDir(journals()).entryInfoList({"*.bolster"}, QDir::Files);
    return std::ranges::any_of(files, [&](const QFileInfo& file) {
        const QString base = file.absoluteFilePath().chopped(journalEnding.size());
        return readAbout(base).place.original == original && !lockOf(base);
    });
}

WorkJournal::Taken WorkJournal::takeProject(const QString& project)
{
    const QString base = newBase();
    auto lock = lockOf(base);
    if (!lock)
        return notTaken({QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written"), {journals().toStdString()}});
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

void WorkJournal::emptyBin()
{
    const QDateTime before = QDateTime::currentDateTime().addDays(-daysInBin);
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

WorkJournal::WorkJournal(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
{
    connect(&document, &Document::historyChanged, this, &WorkJournal::follow);
    connect(&document, &Document::named, this, [this](NodeId node) { m_renamed.insert(node); });
    m_again.setInterval(untilNextTry);
    connect(&m_again, &QTimer::timeout, this, [this] { (void)catchUp(); });
}

QString WorkJournal::folder()
{
    return journals();
}

WorkJournal::~WorkJournal()
{
    end();
}

void WorkJournal::start(const Place& place, const Taken& taken)
{
    m_place = place;
    m_root = m_document.committed();
    m_base = taken.base;
    m_lock = taken.lock;
    m_journal = taken.journal;
    m_gone.clear();
    m_renamed.clear();
    m_identity.reset();
    m_savedSeal.reset();
    m_fate = Fate::Leave;
    m_aboutBehind = false;
    m_following = true;
    setFailing({});
    if (m_journal)
        move(place);
}

void WorkJournal::move(const Place& place)
{
    m_place = place;
    if (!m_journal)
        return;
    const Message problem = writeAbout();
    m_aboutBehind = !problem.empty();
    if (m_aboutBehind)
        setFailing(problem);
}

Message WorkJournal::writeAbout() const
{
    return writeAboutFile(m_base, {m_place, false, m_document.held()});
}

void WorkJournal::end()
{
    if (m_failing && m_following)
        (void)catchUp(); // the last time
    m_again.stop();
    if (!std::exchange(m_following, false) || !m_journal)
        return;
    const bool unsaved = m_document.hasUnsavedWork();
    if (!unsaved)
        keepPlace(*m_journal, m_document.held(), m_document.history().current());
    m_journal.reset();
    m_gone.clear();
    if (!unsaved)
        removeJournal(m_base);
    else if (m_fate == Fate::Bin)
        moveToBin(m_base);
    else if (m_fate == Fate::KeepForLater)
        writeAboutFile(m_base, {m_place, true, m_document.held()});
    m_lock.reset();
}

std::optional<NodeId> WorkJournal::lastPlace() const
{
    const auto seal = m_journal ? m_journal->base() : std::nullopt;
    return seal ? lastPlaces::find(m_journal->uuid(), *seal) : std::nullopt;
}

namespace {

Message cannotBeProtected()
{
    return {QT_TRANSLATE_NOOP("Message", "unsaved work cannot be protected: \"%1\" cannot be written"),
            {journals().toStdString()}};
}

} // namespace

Message WorkJournal::prepare()
{
    if (m_journal)
        return {};
    m_base = newBase();
    m_lock = lockOf(m_base);
    if (!m_lock)
        return cannotBeProtected();
    if (Message problem = writeAbout(); !problem.empty())
        return problem;
    const QString path = m_base + journalEnding;
    Journal::Opened opened = m_identity ? Journal::create(path, m_root, m_identity) : Journal::create(path, m_root);
    m_journal = std::move(opened.journal);
    if (!m_journal)
        removeJournal(m_base); // half of one would be taken for work
    else if (m_savedSeal)
        m_journal->setBase(*m_savedSeal);
    return opened.project.problem;
}

void WorkJournal::follow()
{
    if (!m_following || (!m_journal && m_document.history().count() == 1 && m_renamed.empty()))
        return;           // nothing was done
    m_fate = Fate::Leave; // was said of the work as it was then
    (void)catchUp();
}

/// An edit that cannot be stored is done nevertheless: whoever is warned can save it, which is more than nothing.
void WorkJournal::setFailing(const Message& problem)
{
    const bool before = std::exchange(m_failing, !problem.empty());
    if (m_failing == before)
        return;
    if (m_failing) {
        m_again.start();
        emit failed(problem);
    } else {
        m_again.stop();
        emit worksAgain();
    }
}

Message WorkJournal::catchUp()
{
    const Message problem = store();
    setFailing(problem);
    return problem;
}

/// What is written to a file that nobody can open any more is not protected: somebody tidied up, or a disk went.
Message WorkJournal::bringBack()
{
    if (!m_journal || QFileInfo::exists(m_base + journalEnding))
        return {};
    const QString base = newBase();
    auto lock = lockOf(base);
    if (!lock)
        return cannotBeProtected();
    Journal::Opened opened = m_journal->successor(base + journalEnding);
    if (!opened.journal) {
        removeJournal(base);
        return opened.project.problem;
    }
    m_base = base;
    m_lock = std::move(lock);
    m_gone.push_back(std::exchange(m_journal, std::move(opened.journal)));
    m_aboutBehind = true;
    return {};
}

Message WorkJournal::store()
{
    if (Message problem = prepare(); !problem.empty())
        return problem;
    if (Message problem = bringBack(); !problem.empty())
        return problem;
    if (m_aboutBehind)
        if (Message problem = writeAbout(); !problem.empty())
            return problem;
    m_aboutBehind = false;
    Message problem = catchUp(*m_journal);
    if (problem.empty())
        m_renamed.clear();
    return problem;
}

Message WorkJournal::catchUp(Journal& journal) const
{
    const History& history = m_document.history();
    if (Message problem = journal.record(history, m_document.committed()); !problem.empty())
        return problem;
    for (const NodeId id : m_renamed) {
        const History::Node& node = history.node(id);
        if (Message problem = journal.setNames(id, node.name, node.branch); !problem.empty())
            return problem;
    }
    return {};
}

WorkJournal::StandIn::StandIn() = default;
WorkJournal::StandIn::~StandIn() = default;

std::function<std::shared_ptr<WorkJournal::StandIn>(const QString& target)> WorkJournal::standIns()
{
    if (!m_journal && !m_identity)
        m_identity = std::make_shared<Journal::Identity>(Journal::Identity{newUid(), {}});
    return [journal = m_journal, root = m_root, identity = m_identity, base = m_savedSeal](const QString& target) {
        auto made = std::make_shared<StandIn>();
        made->file = std::make_unique<TemporaryFile>(target);
        made->problem = made->file->problem();
        if (!made->problem.empty())
            return made;
        const QString path = made->file->path();
        Journal::Opened opened = journal ? journal->standIn(path) : Journal::createStandIn(path, root, identity);
        made->journal = std::move(opened.journal);
        made->problem = std::move(opened.project.problem);
        for (std::string& arg : made->problem.args)
            if (arg == path.toStdString())
                arg = target.toStdString(); // the file that the user knows
        if (made->journal && !journal && base)
            made->journal->setBase(*base);
        return made;
    };
}

void WorkJournal::savedBy(const Journal& standIn)
{
    m_savedSeal = standIn.base();
    if (m_journal && m_savedSeal)
        m_journal->setBase(*m_savedSeal);
}

Message WorkJournal::takeIn(const OpenedProject& theirs, const std::string& name, NodeId& tip)
{
    if (Message problem = catchUp(); !problem.empty())
        return problem;
    Journal::TakenIn taken;
    if (Message problem = m_journal->takeIn(theirs, name, m_document.history(), taken); !problem.empty())
        return problem;
    tip = taken.tip;
    m_document.takeIn(std::move(taken.nodes), std::move(taken.edits));
    for (const auto& [node, text] : taken.names)
        m_document.nameVersion(node, text);
    for (const auto& [node, text] : taken.branches)
        m_document.nameBranch(node, text);
    return {};
}

} // namespace bolster
