#include "WorkJournal.h"

#include "EditCodec.h"
#include "JournalFiles.h"
#include "LastPlaces.h"
#include "ProjectRows.h"
#include "TemporaryFile.h"

#include <QFileInfo>

namespace bolster {

using namespace journalFiles;

namespace {

constexpr std::chrono::seconds untilNextTry(2);

} // namespace

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
    const std::int64_t began = m_document.history().node(0).time.toMSecsSinceEpoch();
    Journal::Opened opened =
        m_identity ? Journal::create(path, m_root, m_identity) : Journal::create(path, m_root, nullptr, began);
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
        m_identity = std::make_shared<Journal::Identity>(
            Journal::Identity{newUid(), {}, m_document.history().node(0).time.toMSecsSinceEpoch()});
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
