#include "FileFlow.h"

#include "Banner.h"
#include "Samples.h"
#include "Translated.h"

#include <QDir>
#include <QFileDialog>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

#include <algorithm>

namespace bolster {

namespace {

const QString recentFilesKey = QStringLiteral("recent");
const QString folderKey = QStringLiteral("folder");
const QString projectEnding = QStringLiteral("bolster");
const QString designEnding = QStringLiteral("json");
constexpr qsizetype mostRecentFiles = 10;

QString openFilter()
{
    return FileFlow::tr("Projects and designs (*.bolster *.json)");
}

QString saveFilter()
{
    return FileFlow::tr("Project with its history (*.bolster);;Design as text (*.json)");
}

const QStringList saveEndings{projectEnding, designEnding};

bool is(FileKind kind, const QString& file)
{
    return fileEndings(kind).contains(QFileInfo(file).suffix().toLower());
}

} // namespace

FileFlow::FileFlow(DesignSession& session, QWidget* window, Banner* banner)
    : QObject(window)
    , m_session(session)
    , m_window(window)
    , m_banner(banner)
{}

QString FileFlow::startFolder() const
{
    if (!m_session.path().isEmpty())
        return QFileInfo(m_session.path()).absolutePath();
    const QString last = QSettings().value(folderKey).toString();
    for (const QString& folder : {last, QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)})
        if (!folder.isEmpty() && QFileInfo(folder).isDir())
            return folder;
    return QDir::homePath();
}

void FileFlow::fail(const QString& title, const Message& why)
{
    QMessageBox box(QMessageBox::Warning, tr("Bolster"), title, QMessageBox::Ok, m_window);
    box.setInformativeText(translated(why));
    box.exec();
}

void FileFlow::keepWork(const Then& then)
{
    m_session.document().cancelGesture();
    if (!m_session.document().dirty()) {
        then();
        return;
    }
    if (m_session.savingAll()) { // nothing to ask unless that fails
        connect(
            &m_session, &DesignSession::saveEnded, this, [this, then] { keepWork(then); },
            Qt::ConnectionType(Qt::QueuedConnection | Qt::SingleShotConnection));
        return;
    }
    QMessageBox box(QMessageBox::Question, tr("Bolster"), tr("Save the changes in \"%1\"?").arg(m_session.title()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
    box.setInformativeText(tr("Work that is kept for later, with all its steps, is under File > Unsaved work."));
    const QPushButton* keep = box.addButton(tr("&Keep for later"), QMessageBox::AcceptRole);
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (box.clickedButton() == keep) {
        m_session.journal().setFate(WorkJournal::Fate::KeepForLater);
        then();
    } else if (answer == QMessageBox::Discard) {
        m_session.journal().setFate(WorkJournal::Fate::Bin);
        then();
    } else if (answer == QMessageBox::Save) {
        const Then saved = [this, then] { keepWork(then); }; // asks again when there are changes since
        if (!m_session.path().isEmpty())
            saveTo(m_session.path(), saved);
        else if (const QString path = chooseSaveTarget(); !path.isEmpty())
            saveTo(path, saved);
    }
}

QString FileFlow::chooseSaveTarget()
{
    return chooseTarget(tr("Save project"), proposed(projectEnding), saveFilter(), saveEndings);
}

void FileFlow::startNew()
{
    keepWork([this] { m_session.startNew(); });
}

void FileFlow::open(const QString& path)
{
    QString file = path;
    if (file.isEmpty())
        file = QFileDialog::getOpenFileName(m_window, tr("Open project or design"), startFolder(), openFilter());
    if (!file.isEmpty())
        keepWork([this, file] { openNow(file); });
}

void FileFlow::openNow(const QString& path)
{
    const QString original = QFileInfo(path).absoluteFilePath();
    if (const auto left = WorkJournal::leftOf(original)) { // what was not saved to it is newer
        restore(*left);
        return;
    }
    const auto opening = howToOpen(original);
    if (!opening)
        return;
    const auto replace = [this](const Then& then) { keepWork(then); };
    m_session.open(path, *opening, replace, [this, path](const Message& problem) {
        if (!problem.empty()) {
            offerSalvage(path, problem);
            return;
        }
        if (!isSample(path))
            remember(path);
        announceProblems();
    });
}

/// Nothing: not at all.
std::optional<DesignSession::Opening> FileFlow::howToOpen(const QString& original)
{
    if (original == m_session.path() || !WorkJournal::isWorkedOn(original))
        return DesignSession::Opening::ToWork;
    QMessageBox box(QMessageBox::Question, tr("Bolster"),
                    tr("\"%1\" is open in another window.").arg(QFileInfo(original).fileName()),
                    QMessageBox::Open | QMessageBox::Cancel, m_window);
    box.setInformativeText(tr("It can be opened here to look at; what is changed is saved under another name."));
    box.setDefaultButton(QMessageBox::Open);
    return box.exec() == QMessageBox::Open ? std::optional(DesignSession::Opening::ToLook) : std::nullopt;
}

void FileFlow::announceProblems()
{
    std::set<ElementId> bad;
    for (const Problem& problem : m_session.problemsOnOpening())
        if (problem.severity == Severity::Error)
            bad.insert(problem.element);
    if (bad.empty())
        return;
    m_banner->announce(
        Banner::Kind::Problem,
        tr("%n elements cannot be used as they are; everything else works.", nullptr, static_cast<int>(bad.size())),
        {{tr("Show"), [this] { emit problemsWanted(); }}});
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
    if (const QString path = chooseSaveTarget(); !path.isEmpty())
        saveTo(path, [] {});
}

void FileFlow::saveCopy(const SaveOptions& options)
{
    const QString path = chooseTarget(tr("Save a copy"), proposed(projectEnding, tr("-copy")),
                                      tr("Project (*.%1)").arg(projectEnding), {projectEnding});
    if (path.isEmpty())
        return;
    m_session.saveCopy(path, options, [this, path](const Message& problem) {
        if (problem.empty())
            emit done(tr("Saved a copy as %1").arg(QDir::toNativeSeparators(path)));
        else
            fail(tr("\"%1\" could not be saved.").arg(QFileInfo(path).fileName()), problem);
    });
}

void FileFlow::revert()
{
    if (const auto saved = m_session.document().saved())
        m_session.document().jumpTo(*saved);
}

/// The title as a file in the usual folder.
QString FileFlow::proposed(const QString& ending, const QString& addition) const
{
    QString name = m_session.title();
    for (const QString& known : saveEndings)
        if (name.endsWith(u'.' + known))
            name.chop(known.size() + 1);
    name.replace(u'/', u'-');
    return QDir(startFolder()).filePath(name + addition + u'.' + ending);
}

/// A file with one of the endings, the first one if none was typed, or "". Never one of the design's files.
QString FileFlow::chooseTarget(const QString& title, const QString& proposal, const QString& filter,
                               const QStringList& endings)
{
    QString chosenFilter;
    QString path = QFileDialog::getSaveFileName(m_window, title, proposal, filter, &chosenFilter);
    if (path.isEmpty())
        return {};
    if (!endings.contains(QFileInfo(path).suffix().toLower())) {
        const auto asFiltered = std::ranges::find_if(
            endings, [&](const QString& ending) { return chosenFilter.contains(QStringLiteral("*.") + ending); });
        path += u'.' + (asFiltered == endings.end() ? endings.front() : *asFiltered);
        const QString question = tr("\"%1\" exists already. Replace it?").arg(QFileInfo(path).fileName());
        if (QFileInfo::exists(path) && QMessageBox::question(m_window, tr("Bolster"), question) != QMessageBox::Yes)
            return {};
    }
    if (m_session.isElementFile(path)) {
        fail(tr("\"%1\" is not replaced.").arg(QFileInfo(path).fileName()),
             {QT_TRANSLATE_NOOP("Message", "it is a file that this design refers to; choose another name")});
        return {};
    }
    return path;
}

void FileFlow::saveTo(const QString& path, const Then& then)
{
    m_session.save(path, [this, path, then](const Message& problem) {
        if (m_session.changedByOthers()) {
            saveBesideOthers(path, then);
            return;
        }
        if (!problem.empty()) {
            fail(tr("\"%1\" could not be saved.").arg(QFileInfo(path).fileName()), problem);
            return;
        }
        remember(path);
        emit done(tr("Saved as %1").arg(QDir::toNativeSeparators(path)));
        then();
    });
}

void FileFlow::remember(const QString& path)
{
    QSettings settings;
    QStringList recent = settings.value(recentFilesKey).toStringList();
    const QString file = QFileInfo(path).absoluteFilePath();
    recent.removeAll(file);
    recent.prepend(file);
    settings.setValue(recentFilesKey, QStringList(recent.mid(0, mostRecentFiles)));
    settings.setValue(folderKey, QFileInfo(file).absolutePath());
}

void FileFlow::fillRecent(QMenu& menu)
{
    menu.clear();
    const QStringList recent = QSettings().value(recentFilesKey).toStringList();
    for (const QString& file : recent) {
        if (!QFileInfo::exists(file))
            continue;
        QAction* action = menu.addAction(QFileInfo(file).fileName(), this, [this, file] { open(file); });
        action->setToolTip(QDir::toNativeSeparators(file));
    }
    menu.setToolTipsVisible(true);
    if (menu.isEmpty())
        menu.addAction(tr("Nothing yet"))->setEnabled(false);
}

void FileFlow::fillSamples(QMenu& menu)
{
    menu.clear();
    menu.setToolTipsVisible(true);
    for (const Sample& sample : samples()) {
        QAction* action = menu.addAction(sample.title, this, [this, path = sample.path] { open(path); });
        action->setToolTip(sample.description);
    }
    if (menu.isEmpty())
        menu.addAction(tr("The samples are not installed"))->setEnabled(false);
}

bool FileFlow::takes(const QString& file)
{
    return saveEndings.contains(QFileInfo(file).suffix().toLower()) || is(FileKind::Mesh, file) ||
           is(FileKind::Cloud, file);
}

void FileFlow::drop(const QString& file)
{
    if (is(FileKind::Mesh, file))
        importFrame(file); // a PLY too: a mesh is dropped more often than a scan
    else if (is(FileKind::Cloud, file))
        importScan(file);
    else
        open(file);
}

} // namespace bolster
