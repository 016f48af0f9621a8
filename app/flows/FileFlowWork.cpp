// Unsaved work: what a crash has left, and what was kept for later.
#include "Background.h"
#include "Banner.h"
#include "FileFlow.h"
#include "Project.h"
#include "Salvage.h"
#include "Translated.h"

#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QStandardPaths>

#include <algorithm>

namespace bolster {

namespace {

/// "box (recovered).bolster", in the user's documents where the folder cannot be written to.
QString freePathBeside(const QString& path)
{
    const QFileInfo file(path);
    const QDir folder(QFileInfo(file.absolutePath()).isWritable()
                          ? file.absolutePath()
                          : QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation));
    const QString name = FileFlow::tr("%1 (recovered)").arg(file.completeBaseName());
    QString free = folder.filePath(name + QLatin1String(".bolster"));
    for (int n = 2; QFileInfo::exists(free); ++n)
        free = folder.filePath(QStringLiteral("%1 %2.bolster").arg(name).arg(n));
    return free;
}

} // namespace

QString FileFlow::nameOf(const WorkJournal::Left& left)
{
    if (!left.place.original.isEmpty())
        return QFileInfo(left.place.original).fileName();
    return left.place.title.isEmpty() ? tr("New design") : left.place.title;
}

void FileFlow::openLeft(const WorkJournal::Left& left)
{
    keepWork([this, left] { restore(left); });
}

void FileFlow::findLeft()
{
    inBackground<QList<WorkJournal::Left>>([] {
        return WorkJournal::left();
    }).then(this, [this](const QList<WorkJournal::Left>& all) { emit leftFound(all); });
}

/// The next start after a crash is where the work was.
void FileFlow::recover()
{
    inBackground<QList<WorkJournal::Left>>([] {
        const QList<WorkJournal::Left> all = WorkJournal::left();
        WorkJournal::emptyBin();
        OwnFolder::removeForgotten(WorkJournal::filesInUse());
        return all;
    }).then(this, [this, before = m_session.document().revision()](const QList<WorkJournal::Left>& all) {
        emit leftFound(all);
        const bool untouched = m_session.document().revision() == before && !m_reading;
        const auto crashed = std::ranges::find(all, false, &WorkJournal::Left::kept);
        if (crashed != all.end() && untouched)
            restore(*crashed, static_cast<int>(all.size()) - 1);
        else if (crashed != all.end())
            m_banner->announce(
                Banner::Kind::Information,
                tr("%n more designs are under File > Unsaved work.", nullptr, static_cast<int>(all.size())), {});
    });
}

void FileFlow::restore(const WorkJournal::Left& left, int others)
{
    const std::stop_source stop;
    const auto reading = showReading(tr("Restoring the work on \"%1\" \u2026").arg(nameOf(left)), stop);
    connect(reading, &QProgressDialog::canceled, this,
            [this] { emit done(tr("The work stays under File > Unsaved work")); });
    const auto replace = [this, reading](const Then& then) {
        closeProgress(reading);
        keepWork(then);
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
void FileFlow::setAside(const WorkJournal::Left& left, const Message& problem)
{
    using Aside = std::optional<WorkJournal::Left>;
    inBackground<Aside>([left] {
        return WorkJournal::setAside(left);
    }).then(this, [this, left, problem](const Aside& damaged) {
        if (damaged)
            goOnWithout(*damaged, problem);
        else
            fail(tr("The unsaved work on \"%1\" could not be restored.").arg(nameOf(left)), problem);
    });
}

/// The project is opened as it was saved.
void FileFlow::goOnWithout(const WorkJournal::Left& damaged, const Message& problem)
{
    if (QFileInfo(damaged.place.original).isFile())
        openNow(damaged.place.original);
    salvageWork(damaged, translated(problem));
}

void FileFlow::salvageWork(const WorkJournal::Left& damaged, const QString& why)
{
    const QString& original = damaged.place.original;
    const QString to = freePathBeside(
        original.isEmpty()
            ? QDir(QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)).filePath(nameOf(damaged))
            : original);
    const std::stop_source stop;
    const auto progress = showProgress(tr("Recovering \"%1\" \u2026").arg(nameOf(damaged)), stop);
    inBackground<Salvaged>([journal = damaged.journal, to, token = stop.get_token()] {
        return salvageJournal(journal, to, token);
    }).then(this, [this, work = nameOf(damaged), why, to, stop, progress](const Salvaged& salvaged) {
        closeProgress(progress);
        if (stop.stop_requested() && !salvaged.problem.empty())
            emit done(tr("The damaged work is kept under File > Unsaved work"));
        else
            sayWhatBecameOf(work, why, to, salvaged);
    });
}

void FileFlow::sayWhatBecameOf(const QString& work, const QString& why, const QString& recovered,
                               const Salvaged& salvaged)
{
    QMessageBox* box =
        newBox(QMessageBox::Warning, tr("The unsaved work on \"%1\" is damaged.").arg(work), QMessageBox::Ok);
    const bool some = salvaged.problem.empty();
    QStringList text;
    if (some)
        text << tr("What could be read of it is in \"%1\" now.").arg(QDir::toNativeSeparators(recovered));
    else if (salvaged.readable)
        text << asSentence(translated(salvaged.problem));
    else
        text << tr("Nothing of it could be read.");
    text << tr("Nothing that was saved is concerned. The damaged work is kept under File > Unsaved work.");
    box->setInformativeText(text.join(QStringLiteral("\n\n")));
    QStringList details{why, translated(salvaged.problem)};
    for (const Message& note : salvaged.notes)
        details << translated(note);
    details.removeAll(QString());
    box->setDetailedText(details.join(u'\n'));
    const QAbstractButton* look =
        some ? box->addButton(tr("Open what was &recovered"), QMessageBox::AcceptRole) : nullptr;
    box->setObjectName(QStringLiteral("question.damaged"));
    openQuestion(box, [this, look, recovered](const QAbstractButton* pressed) {
        if (look && pressed == look)
            open(recovered);
    });
}

void FileFlow::offerWorkSalvage(const WorkJournal::Left& damaged)
{
    QMessageBox* box =
        newBox(QMessageBox::Question, tr("The unsaved work on \"%1\" is damaged.").arg(nameOf(damaged)),
               QMessageBox::Cancel);
    box->setInformativeText(tr("What can be read goes into a new project. What you do not want any more is deleted "
                               "%n days after it was put into the bin.",
                               nullptr, WorkJournal::daysInBin()));
    const QAbstractButton* rescue = box->addButton(tr("&Recover what can be read"), QMessageBox::AcceptRole);
    const QAbstractButton* bin = box->addButton(tr("Put it into the &bin"), QMessageBox::DestructiveRole);
    box->setObjectName(QStringLiteral("question.damaged"));
    openQuestion(box, [this, rescue, bin, damaged](const QAbstractButton* pressed) {
        if (pressed == rescue)
            salvageWork(damaged, {});
        else if (pressed == bin)
            WorkJournal::putIntoBin(damaged);
    });
}

void FileFlow::announceRestored(int others)
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
    if (hasSaved())
        buttons.push_back({tr("Go &back to saved"), [this] { revert(); }});
    m_restored = m_banner->announce(Banner::Kind::Information, text.join(QLatin1Char(' ')), buttons);
}

/// As long as it is so: whoever goes on working has to know.
void FileFlow::warnOfCrashes(const Message& why)
{
    m_unprotected = why;
    m_banner->warn(tr("Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder "
                      "\"%2\". Make room there, or save the design.")
                       .arg(QLocale().toString(QTime::currentTime(), QLocale::ShortFormat),
                            QDir::toNativeSeparators(WorkJournal::folder())),
                   translated(why),
                   {{tr("&Save"), [this] { save(); }},
                    {tr("Save &as \u2026"), [this] { saveAs(); }},
                    {tr("&Try again"), [this] {
                         if (const Message still = m_session.journal().catchUp(); !still.empty())
                             emit done(translated(still));
                     }}});
}

/// Designs as text say where they are wrong; there is nothing to salvage. Nor is there in a sound project, which
/// cannot be opened where the disk of the journals is full.
void FileFlow::failToOpen(const QString& path, const Message& problem)
{
    if (!DesignSession::isProject(path) || !QFileInfo(path).isFile()) {
        offerSalvage(path, problem, false);
        return;
    }
    inBackground<bool>([path] {
        return !openProject(path).problem.empty();
    }).then(this, [this, path, problem](bool damaged) { offerSalvage(path, problem, damaged); });
}

void FileFlow::offerSalvage(const QString& path, const Message& problem, bool damaged)
{
    QMessageBox* box =
        newBox(QMessageBox::Warning, tr("\"%1\" could not be opened.").arg(QFileInfo(path).fileName()),
               damaged ? QMessageBox::Close : QMessageBox::Ok);
    box->setInformativeText(translated(problem));
    QPushButton* rescue = nullptr;
    if (damaged) {
        box->setInformativeText(
            translated(problem) + QStringLiteral("\n\n") +
            tr("What can be read goes into a new project beside it. This file stays as it is."));
        rescue = box->addButton(tr("&Recover what can be read"), QMessageBox::AcceptRole);
        box->setDefaultButton(rescue);
    }
    box->setObjectName(QStringLiteral("question.damaged"));
    openQuestion(box, [this, rescue, path](const QAbstractButton* pressed) {
        if (rescue && pressed == rescue)
            salvage(path);
    });
}

/// Into a new project beside it; the damaged file stays as it is.
void FileFlow::salvage(const QString& path)
{
    const QString to = freePathBeside(path);
    const std::stop_source stop;
    const auto progress = showProgress(tr("Recovering \"%1\" \u2026").arg(QFileInfo(path).fileName()), stop);
    inBackground<Salvaged>([path, to, token = stop.get_token()] {
        return salvageProject(path, to, token);
    }).then(this, [this, to, stop, progress](const Salvaged& salvaged) {
        closeProgress(progress);
        if (stop.stop_requested() && !salvaged.problem.empty())
            return;
        if (!salvaged.problem.empty())
            fail(tr("Nothing could be recovered."), salvaged.problem);
        else
            keepWork([this, to, salvaged] {
                openNow(to);
                sayWhatIsLeft(to, salvaged.notes);
            });
    });
}

void FileFlow::sayWhatIsLeft(const QString& path, const std::vector<Message>& notes)
{
    constexpr qsizetype shown = 12;
    QStringList lines;
    for (const Message& note : notes)
        lines << translated(note);
    QMessageBox* box =
        newBox(QMessageBox::Information, tr("What could be read is in \"%1\" now.").arg(QFileInfo(path).fileName()),
               QMessageBox::Ok);
    box->setInformativeText(lines.mid(0, shown).join(QLatin1Char('\n')));
    if (lines.size() > shown)
        box->setDetailedText(lines.join(QLatin1Char('\n')));
    openDialog(box);
}

void FileFlow::saveBesideOthers(const QString& path, const Then& then)
{
    QMessageBox* box =
        newBox(QMessageBox::Question,
               tr("Somebody else has changed \"%1\" since it was opened here.").arg(QFileInfo(path).fileName()),
               QMessageBox::Cancel);
    box->setInformativeText(
        tr("Their changes can become a branch of the history here, then both are saved. Your design "
           "stays as it is, and you can go to theirs."));
    askOrSaveElsewhere(
        box, tr("&Take their changes in as a branch"), [this, path, then] { takeTheirs(path, then); },
        [this, then] { saveElsewhere(then); });
}

void FileFlow::takeTheirs(const QString& path, const Then& then)
{
    const QString now = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
    m_session.takeTheirs(tr("From the file, %1").arg(now), [this, path, then](const Message& problem, NodeId tip) {
        if (!problem.empty()) {
            fail(tr("Their changes could not be taken in."), problem);
            return;
        }
        m_banner->announce(Banner::Kind::Information,
                           tr("The changes of somebody else are a branch of the history now."),
                           {{tr("Sh&ow"), [this] { emit historyWanted(); }},
                            {tr("Go &there"), [this, tip] { m_session.document().jumpTo(tip); }}});
        saveTo(path, then);
    });
}

void FileFlow::fillUnsaved(QMenu& menu)
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
            [this, left] { offerWorkSalvage(left); });
        action->setToolTip(QDir::toNativeSeparators(left.place.original));
    }
    if (menu.isEmpty())
        menu.addAction(tr("Nothing"))->setEnabled(false);
}

} // namespace bolster
