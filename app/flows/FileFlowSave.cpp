// Saving, and what becomes of unsaved work.
#include "Banner.h"
#include "FileFlow.h"
#include "Translated.h"

#include <QDir>
#include <QFileInfo>
#include <QPushButton>

namespace bolster {

namespace {

const QString projectEnding = QStringLiteral("bolster");
const QString designEnding = QStringLiteral("json");
const QStringList saveEndings{projectEnding, designEnding};

QString saveFilter()
{
    return FileFlow::tr("Project with its history (*.bolster);;Design as text (*.json)");
}

/// A sentence.
QString whatNoFileHolds(const UnsavedWork& unsaved)
{
    QStringList what;
    if (const int here = unsaved.edits - unsaved.elsewhere; here > 0)
        what << FileFlow::tr("%n edits", nullptr, here);
    if (unsaved.elsewhere > 0)
        what << FileFlow::tr("%n edits that were undone or are on other branches", nullptr, unsaved.elsewhere);
    if (unsaved.names)
        what << FileFlow::tr("names of versions or branches");
    return what.isEmpty() ? FileFlow::tr("The file holds another version of the design than the one you see.")
                          : FileFlow::tr("Not saved yet: %1.").arg(what.join(QStringLiteral(", ")));
}

} // namespace

QMessageBox* FileFlow::newBox(QMessageBox::Icon icon, const QString& text, QMessageBox::StandardButtons buttons)
{
    return new QMessageBox(icon, tr("Bolster"), text, buttons, m_window);
}

void FileFlow::fail(const QString& title, const Message& why)
{
    tell(m_window, QMessageBox::Warning, title, translated(why))->setObjectName(QString::fromStdString(why.key));
}

void FileFlow::keepWork(const Then& then)
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

void FileFlow::askAboutWork(const Then& then)
{
    const UnsavedWork unsaved = m_session.document().unsavedWork();
    const bool asProject = !m_session.path().isEmpty() && !DesignSession::isProject(m_session.path()) &&
                           (unsaved.elsewhere > 0 || unsaved.names); // a text would not hold it
    QMessageBox* box = newBox(QMessageBox::Question, tr("Save the changes in \"%1\"?").arg(m_session.title()),
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

void FileFlow::keepForLater(const Then& then)
{
    if (const Message problem = m_session.journal().catchUp(); !problem.empty()) {
        fail(tr("The work cannot be kept."), problem);
        return;
    }
    m_session.journal().setFate(WorkJournal::Fate::KeepForLater);
    then();
}

void FileFlow::saveForGood(bool asProject, const Then& then)
{
    const Then saved = [this, then] { keepWork(then); }; // asks again when there are changes since
    if (!m_session.path().isEmpty() && !asProject)
        saveTo(m_session.path(), saved);
    else
        chooseSaveTarget([this, saved](const QString& path) { saveTo(path, saved); });
}

void FileFlow::chooseSaveTarget(const Answer& chosen)
{
    chooseTarget(tr("Save project"), proposed(projectEnding), saveFilter(), saveEndings, chosen);
}

void FileFlow::save()
{
    if (m_session.path().isEmpty())
        saveAs();
    else
        saveTo(m_session.path(), [] {});
}

void FileFlow::saveAs()
{
    chooseSaveTarget([this](const QString& path) { saveTo(path, [] {}); });
}

void FileFlow::saveCopy(const SaveOptions& options)
{
    chooseTarget(tr("Save a copy"), proposed(projectEnding, tr("-copy")), tr("Project (*.%1)").arg(projectEnding),
                 {projectEnding}, [this, options](const QString& path) { saveCopyTo(path, options); });
}

void FileFlow::saveCopyTo(const QString& path, const SaveOptions& options)
{
    m_session.saveCopy(path, options, [this, path, options](const Message& problem) {
        if (problem.empty())
            emit done(tr("Saved a copy as %1").arg(QDir::toNativeSeparators(path)));
        else
            offerAnotherTry(
                path, problem, [this, path, options] { saveCopyTo(path, options); },
                [this, options] { saveCopy(options); });
    });
}

/// The title without the ending of its file.
QString FileFlow::name() const
{
    QString name = m_session.title();
    for (const QString& known : saveEndings)
        if (name.endsWith(u'.' + known))
            name.chop(known.size() + 1);
    return name;
}

/// Where something else than a project goes: where the last one of this design went.
QString FileFlow::exportFolder() const
{
    return m_exported.of == m_session.path() && QFileInfo(m_exported.folder).isDir() ? m_exported.folder
                                                                                     : startFolder();
}

/// The title as a file in the usual folder.
QString FileFlow::proposed(const QString& ending, const QString& addition) const
{
    QString name = this->name();
    name.replace(u'/', u'-');
    return QDir(saveEndings.contains(ending) ? startFolder() : exportFolder())
        .filePath(name + addition + u'.' + ending);
}

/// A file with one of the endings, the first one if none was typed. Never one of the design's files.
void FileFlow::chooseTarget(const QString& title, const QString& proposal, const QString& filter,
                            const QStringList& endings, const Answer& chosen)
{
    askWhereToWrite(m_window, title, proposal, filter, endings, [this, chosen](const QString& path) {
        if (!m_session.isElementFile(path)) {
            if (!saveEndings.contains(QFileInfo(path).suffix()))
                m_exported = {m_session.path(), QFileInfo(path).absolutePath()};
            chosen(path);
            return;
        }
        fail(tr("\"%1\" is not replaced.").arg(QFileInfo(path).fileName()),
             {QT_TRANSLATE_NOOP("Message", "it is a file that this design refers to; choose another name")});
    });
}

void FileFlow::saveTo(const QString& path, const Then& then)
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
        remember(path);
        const QString saved = tr("Saved as %1").arg(QDir::toNativeSeparators(path));
        emit done(DesignSession::isProject(path) ? saved
                                                 : tr("%1: the design alone, without its history").arg(saved));
        then();
    });
}

/// Whatever it is, somebody may want it: it is never replaced, but given another name.
void FileFlow::saveBesideStranger(const QString& path, const Message& stranger, const Then& then)
{
    QMessageBox* box =
        newBox(QMessageBox::Warning,
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

void FileFlow::saveElsewhere(const Then& then)
{
    chooseSaveTarget([this, then](const QString& other) { saveTo(other, then); });
}

/// The box, which can be cancelled, gets a button of its own and "Save as".
void FileFlow::askOrSaveElsewhere(QMessageBox* box, const QString& text, const Then& act, const Then& elsewhere)
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

void FileFlow::keepAside(const QString& path, const Then& then)
{
    QString name;
    if (const Message problem = DesignSession::moveAside(path, &name); !problem.empty()) {
        fail(tr("\"%1\" could not be saved.").arg(QFileInfo(path).fileName()), problem);
        return;
    }
    m_banner->announce(
        Banner::Kind::Information,
        tr("What was in the place of \"%1\" is in \"%2\" now.").arg(QFileInfo(path).fileName(), name), {});
    saveTo(path, then);
}

/// Whoever can make room or choose another place must not begin again.
void FileFlow::offerAnotherTry(const QString& path, const Message& problem, const Then& again,
                               const Then& elsewhere)
{
    QMessageBox* box =
        newBox(QMessageBox::Warning, tr("\"%1\" could not be saved.").arg(QFileInfo(path).fileName()),
               QMessageBox::Cancel);
    box->setInformativeText(translated(problem));
    askOrSaveElsewhere(box, tr("&Try again"), again, elsewhere);
}

} // namespace bolster
