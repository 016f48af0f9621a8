#include "LeftWork.h"

#include "Background.h"
#include "Banner.h"
#include "Rescue.h"
#include "SaveFlow.h"
#include "Translated.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>

#include <algorithm>

namespace bolster {

LeftWork::LeftWork(DesignSession& session, const Parts& parts)
    : m_session(session)
    , m_talk(parts.talk)
    , m_saving(parts.saving)
    , m_rescue(parts.rescue)
    , m_banner(parts.banner)
{
    connect(&session, &DesignSession::saveEnded, this, [this] {
        if (!m_session.document().hasUnsavedWork())
            m_banner.withdraw(m_restored);
    });
}

QString LeftWork::nameOf(const WorkJournal::Left& left)
{
    if (!left.place.original.isEmpty())
        return QFileInfo(left.place.original).fileName();
    return left.place.title.isEmpty() ? tr("New design") : left.place.title;
}

void LeftWork::openLeft(const WorkJournal::Left& left)
{
    m_saving.keepWork([this, left] { restore(left); });
}

void LeftWork::findLeft()
{
    inBackground<QList<WorkJournal::Left>>([] {
        return WorkJournal::left();
    }).then(this, [this](const QList<WorkJournal::Left>& all) { emit leftFound(all); });
}

/// The next start after a crash is where the work was.
void LeftWork::recover()
{
    inBackground<QList<WorkJournal::Left>>([] {
        const QList<WorkJournal::Left> all = WorkJournal::left();
        WorkJournal::emptyBin();
        OwnFolder::removeForgotten(WorkJournal::filesInUse());
        return all;
    }).then(this, [this, before = m_session.document().revision()](const QList<WorkJournal::Left>& all) {
        emit leftFound(all);
        const bool untouched = m_session.document().revision() == before && !m_talk.reading();
        const auto crashed = std::ranges::find(all, false, &WorkJournal::Left::kept);
        if (crashed != all.end() && untouched)
            restore(*crashed, static_cast<int>(all.size()) - 1);
        else if (crashed != all.end())
            m_banner.announce(
                Banner::Kind::Information,
                tr("%n more designs are under File > Unsaved work.", nullptr, static_cast<int>(all.size())), {});
    });
}

void LeftWork::restore(const WorkJournal::Left& left, int others)
{
    const std::stop_source stop;
    const auto reading = m_talk.showReading(tr("Restoring the work on \"%1\" \u2026").arg(nameOf(left)), stop);
    connect(reading, &QProgressDialog::canceled, this,
            [this] { m_talk.say(tr("The work stays under File > Unsaved work")); });
    const auto replace = [this, reading](const SaveFlow::Then& then) {
        closeProgress(reading);
        m_saving.keepWork(then);
    };
    const auto restored = [this, left, others, reading](const Message& problem) {
        closeProgress(reading);
        if (!problem.empty())
            setAside(left, problem);
        else
            announceRestored(others);
    };
    m_session.restore(left, replace, restored, stop.get_token());
}

/// Damaged work must not stand before its sound project.
void LeftWork::setAside(const WorkJournal::Left& left, const Message& problem)
{
    using Aside = std::optional<WorkJournal::Left>;
    inBackground<Aside>([left] {
        return WorkJournal::setAside(left);
    }).then(this, [this, left, problem](const Aside& damaged) {
        if (damaged)
            goOnWithout(*damaged, problem);
        else
            m_talk.fail(tr("The unsaved work on \"%1\" could not be restored.").arg(nameOf(left)), problem);
    });
}

/// The project is opened as it was saved.
void LeftWork::goOnWithout(const WorkJournal::Left& damaged, const Message& problem)
{
    if (QFileInfo(damaged.place.original).isFile())
        emit openWanted(damaged.place.original);
    m_rescue.salvageWork(damaged, translated(problem));
}

void LeftWork::announceRestored(int others)
{
    const UnsavedWork unsaved = m_session.document().unsavedWork();
    QStringList text;
    if (const int here = unsaved.edits - unsaved.elsewhere; here > 0 || !unsaved.any())
        text << tr("%n unsaved edits restored.", nullptr, here);
    if (unsaved.elsewhere > 0)
        text << tr("%n unsaved edits are in the history, undone or on other branches.", nullptr, unsaved.elsewhere);
    if (unsaved.names)
        text << tr("Unsaved names of versions or branches restored.");
    if (others > 0)
        text << tr("%n more designs are under File > Unsaved work.", nullptr, others);
    QList<Banner::Button> buttons{{tr("Sh&ow"), [this] { emit historyWanted(); }}};
    if (m_saving.hasSaved())
        buttons.push_back({tr("Go &back to saved"), [this] { m_saving.revert(); }});
    m_restored = m_banner.announce(Banner::Kind::Information, text.join(QLatin1Char(' ')), buttons);
}

void LeftWork::fillUnsaved(QMenu& menu)
{
    menu.clear();
    menu.setToolTipsVisible(true);
    for (const WorkJournal::Left& left : WorkJournal::left()) {
        QAction* action =
            menu.addAction(tr("%1, %2").arg(nameOf(left), QLocale().toString(left.when, QLocale::ShortFormat)),
                           this, [this, left] { openLeft(left); });
        action->setToolTip(QDir::toNativeSeparators(left.place.original));
    }
    for (const WorkJournal::Left& left : WorkJournal::damaged()) {
        QAction* action = menu.addAction(
            tr("%1, %2, damaged").arg(nameOf(left), QLocale().toString(left.when, QLocale::ShortFormat)), this,
            [this, left] { m_rescue.offerWorkSalvage(left); });
        action->setToolTip(QDir::toNativeSeparators(left.place.original));
    }
    if (menu.isEmpty())
        menu.addAction(tr("Nothing"))->setEnabled(false);
}

} // namespace bolster
