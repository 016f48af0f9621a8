#include "SaveFlow.h"

#include "Banner.h"
#include "Translated.h"

#include <QAbstractButton>
#include <QDir>
#include <QFileInfo>
#include <QLocale>
#include <QPushButton>
#include <QTime>

namespace bolster {

namespace {

const QString projectEnding = QStringLiteral("bolster");
const QString designEnding = QStringLiteral("json");
const QStringList saveEndings{projectEnding, designEnding};

QString saveFilter()
{
    return SaveFlow::tr("Project with its history (*.bolster);;Design as text (*.json)");
}

/// A sentence.
QString whatNoFileHolds(const UnsavedWork& unsaved)
{
    QStringList what;
    if (const int here = unsaved.edits - unsaved.elsewhere; here > 0)
        what << SaveFlow::tr("%n edits", nullptr, here);
    if (unsaved.elsewhere > 0)
        what << SaveFlow::tr("%n edits that were undone or are on other branches", nullptr, unsaved.elsewhere);
    if (unsaved.names)
        what << SaveFlow::tr("names of versions or branches");
    return what.isEmpty() ? SaveFlow::tr("The file holds another version of the design than the one you see.")
                          : SaveFlow::tr("Not saved yet: %1.").arg(what.join(QStringLiteral(", ")));
}

} // namespace

SaveFlow::SaveFlow(DesignSession& session, FileTalk& talk, Banner& banner)
    : m_session(session)
    , m_talk(talk)
    , m_banner(banner)
{
    connect(&session, &DesignSession::saveEnded, this, [this] {
        if (!m_session.document().hasUnsavedWork() && !m_unprotected.empty())
            warnOfCrashes(m_unprotected); // counts from now on
    });
    connect(&session, &DesignSession::recoveryFailed, this, &SaveFlow::warnOfCrashes);
    connect(&session, &DesignSession::recoveryWorksAgain, this, [this] {
        m_unprotected = {};
        m_banner.endWarning();
    });
}

void SaveFlow::save()
{
    if (m_session.path().isEmpty())
        saveAs();
    else
        saveTo(m_session.path(), [] {});
}

void SaveFlow::saveAs()
{
    chooseSaveTarget([this](const QString& path) { saveTo(path, [] {}); });
}

void SaveFlow::saveCopy(const SaveOptions& options)
{
    m_talk.chooseTarget(tr("Save a copy"), m_talk.proposed(projectEnding, tr("-copy")),
                        tr("Project (*.%1)").arg(projectEnding), {projectEnding},
                        [this, options](const QString& path) { saveCopyTo(path, options); });
}

void SaveFlow::revert()
{
    m_session.document().jumpTo(m_session.document().saved());
}

bool SaveFlow::hasSaved() const
{
    return !m_session.path().isEmpty() || m_session.readOnly();
}

void SaveFlow::keepWork(const Then& then)
{
    m_session.document().cancelGesture();
    if (m_session.saving()) { // who knows what there is to ask then
        connect(
            &m_session, &DesignSession::saveEnded, this, [this, then] { keepWork(then); },
            Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
        return;
    }
    if (!m_session.document().hasUnsavedWork()) {
        then();
        return;
    }
    if (m_question)
        m_question->raise(); // one answer at a time
    else
        askAboutWork(then);
}

void SaveFlow::askAboutWork(const Then& then)
{
    const UnsavedWork unsaved = m_session.document().unsavedWork();
    const bool asProject = !m_session.path().isEmpty() && !DesignSession::isProject(m_session.path()) &&
                           (unsaved.elsewhere > 0 || unsaved.names); // a text would not hold it
    QMessageBox* box =
        m_talk.newBox(QMessageBox::Question, tr("Save the changes in \"%1\"?").arg(m_session.title()),
                      QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel);
    QStringList text{whatNoFileHolds(unsaved)};
    if (asProject)
        text << tr("A design as text cannot hold that, a project can.");
    text << tr("Work that is kept for later, with all its steps, is under File > Unsaved work.");
    box->setInformativeText(text.join(QStringLiteral("\n\n")));
    if (asProject)
        box->button(QMessageBox::Save)->setText(tr("Save as &project \u2026"));
    const QAbstractButton* keep = box->addButton(tr("&Keep for later"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Save);
    box->setObjectName(QStringLiteral("question.save"));
    m_question = box;
    openQuestion(box, [this, box, keep, asProject, then](const QAbstractButton* pressed) {
        m_question.clear();
        if (pressed == keep) {
            keepForLater(then);
        } else if (pressed == box->button(QMessageBox::Discard)) {
            m_session.journal().setFate(WorkJournal::Fate::Bin);
            then();
        } else if (pressed == box->button(QMessageBox::Save)) {
            saveForGood(asProject, then);
        }
    });
}

void SaveFlow::keepForLater(const Then& then)
{
    if (const Message problem = m_session.journal().catchUp(); !problem.empty()) {
        m_talk.fail(tr("The work cannot be kept."), problem);
        return;
    }
    m_session.journal().setFate(WorkJournal::Fate::KeepForLater);
    then();
}

void SaveFlow::saveForGood(bool asProject, const Then& then)
{
    const Then saved = [this, then] { keepWork(then); }; // asks again when there are changes since
    if (!m_session.path().isEmpty() && !asProject)
        saveTo(m_session.path(), saved);
    else
        chooseSaveTarget([this, saved](const QString& path) { saveTo(path, saved); });
}

void SaveFlow::chooseSaveTarget(const Answer& chosen)
{
    m_talk.chooseTarget(tr("Save project"), m_talk.proposed(projectEnding), saveFilter(), saveEndings, chosen);
}

void SaveFlow::saveCopyTo(const QString& path, const SaveOptions& options)
{
    m_session.saveCopy(path, options, [this, path, options](const Message& problem) {
        if (problem.empty())
            m_talk.say(tr("Saved a copy as %1").arg(QDir::toNativeSeparators(path)));
        else
            offerAnotherTry(
                path, problem, [this, path, options] { saveCopyTo(path, options); },
                [this, options] { saveCopy(options); });
    });
}

void SaveFlow::saveTo(const QString& path, const Then& then)
{
    m_session.save(path, [this, path, then](const Message& problem) {
        if (m_session.changedByOthers()) {
            saveBesideOthers(path, then);
            return;
        }
        if (m_session.placeTaken()) {
            saveBesideStranger(path, problem, then);
            return;
        }
        if (!problem.empty()) {
            offerAnotherTry(
                path, problem, [this, path, then] { saveTo(path, then); }, [this, then] { saveElsewhere(then); });
            return;
        }
        m_talk.remember(path);
        const QString saved = tr("Saved as %1").arg(QDir::toNativeSeparators(path));
        m_talk.say(DesignSession::isProject(path) ? saved
                                                  : tr("%1: the design alone, without its history").arg(saved));
        then();
    });
}

void SaveFlow::saveElsewhere(const Then& then)
{
    chooseSaveTarget([this, then](const QString& other) { saveTo(other, then); });
}

/// Whatever it is, somebody may want it: it is never replaced, but given another name.
void SaveFlow::saveBesideStranger(const QString& path, const Message& stranger, const Then& then)
{
    QMessageBox* box = m_talk.newBox(
        QMessageBox::Warning,
        tr("\"%1\" is not the file any more that was opened or saved here.").arg(QFileInfo(path).fileName()),
        QMessageBox::Cancel);
    QStringList text{translated(stranger)};
    text << tr("Save your design under another name, or let what is there now have another name beside it. If that "
               "is a damaged project, File > Open recovers what can be read of it.");
    box->setInformativeText(text.join(QStringLiteral("\n\n")));
    askOrSaveElsewhere(
        box, tr("&Keep the other file beside it, and save"), [this, path, then] { keepAside(path, then); },
        [this, then] { saveElsewhere(then); });
}

void SaveFlow::keepAside(const QString& path, const Then& then)
{
    QString name;
    if (const Message problem = DesignSession::moveAside(path, &name); !problem.empty()) {
        m_talk.fail(tr("\"%1\" could not be saved.").arg(QFileInfo(path).fileName()), problem);
        return;
    }
    m_banner.announce(Banner::Kind::Information,
                      tr("What was in the place of \"%1\" is in \"%2\" now.").arg(QFileInfo(path).fileName(), name),
                      {});
    saveTo(path, then);
}

void SaveFlow::saveBesideOthers(const QString& path, const Then& then)
{
    QMessageBox* box = m_talk.newBox(
        QMessageBox::Question,
        tr("Somebody else has changed \"%1\" since it was opened here.").arg(QFileInfo(path).fileName()),
        QMessageBox::Cancel);
    box->setInformativeText(
        tr("Their changes can become a branch of the history here, then both are saved. Your design "
           "stays as it is, and you can go to theirs."));
    askOrSaveElsewhere(
        box, tr("&Take their changes in as a branch"), [this, path, then] { takeTheirs(path, then); },
        [this, then] { saveElsewhere(then); });
}

void SaveFlow::takeTheirs(const QString& path, const Then& then)
{
    const QString now = QLocale().toString(QTime::currentTime(), QLocale::ShortFormat);
    m_session.takeTheirs(tr("From the file, %1").arg(now), [this, path, then](const Message& problem, NodeId tip) {
        if (!problem.empty()) {
            m_talk.fail(tr("Their changes could not be taken in."), problem);
            return;
        }
        m_banner.announce(Banner::Kind::Information,
                          tr("The changes of somebody else are a branch of the history now."),
                          {{tr("Sh&ow"), [this] { emit historyWanted(); }},
                           {tr("Go &there"), [this, tip] { m_session.document().jumpTo(tip); }}});
        saveTo(path, then);
    });
}

/// Whoever can make room or choose another place must not begin again.
void SaveFlow::offerAnotherTry(const QString& path, const Message& problem, const Then& again,
                               const Then& elsewhere)
{
    QMessageBox* box =
        m_talk.newBox(QMessageBox::Warning, tr("\"%1\" could not be saved.").arg(QFileInfo(path).fileName()),
                      QMessageBox::Cancel);
    box->setInformativeText(translated(problem));
    askOrSaveElsewhere(box, tr("&Try again"), again, elsewhere);
}

/// The box, which can be cancelled, gets a button of its own and "Save as".
void SaveFlow::askOrSaveElsewhere(QMessageBox* box, const QString& text, const Then& act, const Then& elsewhere)
{
    const QAbstractButton* own = box->addButton(text, QMessageBox::AcceptRole);
    const QAbstractButton* other = box->addButton(tr("Save &as \u2026"), QMessageBox::AcceptRole);
    box->setDefaultButton(QMessageBox::Cancel);
    box->setObjectName(QStringLiteral("question.changed-elsewhere"));
    openQuestion(box, [own, other, act, elsewhere](const QAbstractButton* pressed) {
        if (pressed == own)
            act();
        else if (pressed == other)
            elsewhere();
    });
}

/// As long as it is so: whoever goes on working has to know.
void SaveFlow::warnOfCrashes(const Message& why)
{
    m_unprotected = why;
    m_banner.warn(tr("Nothing protects what you do since %1 against a crash: Bolster cannot write to the folder "
                     "\"%2\". Make room there, or save the design.")
                      .arg(QLocale().toString(QTime::currentTime(), QLocale::ShortFormat),
                           QDir::toNativeSeparators(WorkJournal::folder())),
                  translated(why),
                  {{tr("&Save"), [this] { save(); }},
                   {tr("Save &as \u2026"), [this] { saveAs(); }},
                   {tr("&Try again"), [this] {
                        if (const Message still = m_session.journal().catchUp(); !still.empty())
                            m_talk.say(translated(still));
                    }}});
}

} // namespace bolster
