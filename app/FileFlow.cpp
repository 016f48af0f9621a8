#include "FileFlow.h"

#include "Background.h"
#include "Banner.h"
#include "FrameImportDialog.h"
#include "MeshImport.h"
#include "Samples.h"
#include "SurfaceExport.h"
#include "Translated.h"

#include <QDir>
#include <QFileDialog>
#include <QLocale>
#include <QMenu>
#include <QMessageBox>
#include <QProgressDialog>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>

namespace bolster {

namespace {

const QString recentKey = QStringLiteral("recent");
const QString folderKey = QStringLiteral("folder");
constexpr qsizetype mostRecent = 10;

QString designFilter()
{
    return FileFlow::tr("Designs (*.json)");
}

QString meshFilter()
{
    QStringList patterns;
    for (const QString& ending : meshFileEndings())
        patterns << QStringLiteral("*.") + ending;
    return FileFlow::tr("Meshes (%1)").arg(patterns.join(u' '));
}

bool isMesh(const QString& file)
{
    return meshFileEndings().contains(QFileInfo(file).suffix().toLower());
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
    QMessageBox box(QMessageBox::Question, tr("Bolster"), tr("Save the changes in \"%1\"?").arg(m_session.title()),
                    QMessageBox::Save | QMessageBox::Discard | QMessageBox::Cancel, m_window);
    box.setInformativeText(tr("Otherwise they are lost."));
    box.setDefaultButton(QMessageBox::Save);
    const int answer = box.exec();
    if (answer == QMessageBox::Discard) { // its copy goes when another design has taken its place
        then();
    } else if (answer == QMessageBox::Save) {
        const Then saved = [this, then] { keepWork(then); }; // asks again when there are changes since
        if (!m_session.path().isEmpty())
            saveTo(m_session.path(), saved);
        else if (const QString path = QFileDialog::getSaveFileName(
                     m_window, tr("Save design"),
                     QDir(startFolder()).filePath(tr("Design") + QStringLiteral(".json")), designFilter());
                 !path.isEmpty())
            saveTo(path, saved);
    }
}

void FileFlow::startNew()
{
    keepWork([this] { m_session.startNew(); });
}

void FileFlow::open(const QString& path)
{
    QString file = path;
    if (file.isEmpty())
        file = QFileDialog::getOpenFileName(m_window, tr("Open design"), startFolder(), designFilter());
    if (!file.isEmpty())
        keepWork([this, file] { openNow(file); });
}

void FileFlow::openNow(const QString& path)
{
    m_session.open(path, [this, path](const Message& problem) {
        if (!problem.empty()) {
            fail(tr("\"%1\" could not be opened.").arg(QFileInfo(path).fileName()), problem);
            return;
        }
        if (!isSample(path))
            remember(path);
        announceProblems();
    });
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
    const QString name = m_session.path().isEmpty() ? tr("Design") + QStringLiteral(".json")
                                                    : QFileInfo(m_session.path()).fileName();
    const QString path = QFileDialog::getSaveFileName(m_window, tr("Save design"),
                                                      QDir(startFolder()).filePath(name), designFilter());
    if (!path.isEmpty())
        saveTo(path, [] {});
}

void FileFlow::saveTo(const QString& chosen, const Then& then)
{
    const QString path = QFileInfo(chosen).suffix().isEmpty() ? chosen + QStringLiteral(".json") : chosen;
    m_session.save(path, [this, path, then](const Message& problem) {
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
    QStringList recent = settings.value(recentKey).toStringList();
    const QString file = QFileInfo(path).absoluteFilePath();
    recent.removeAll(file);
    recent.prepend(file);
    settings.setValue(recentKey, QStringList(recent.mid(0, mostRecent)));
    settings.setValue(folderKey, QFileInfo(file).absolutePath());
}

void FileFlow::fillRecent(QMenu& menu)
{
    menu.clear();
    const QStringList recent = QSettings().value(recentKey).toStringList();
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
    return QFileInfo(file).suffix().compare(QLatin1String("json"), Qt::CaseInsensitive) == 0 || isMesh(file);
}

void FileFlow::drop(const QString& file)
{
    if (isMesh(file))
        importFrame(file);
    else
        open(file);
}

void FileFlow::importFrame(const QString& path, std::optional<ElementId> replaced)
{
    QString file = path;
    if (file.isEmpty())
        file = QFileDialog::getOpenFileName(m_window, tr("Import frame"), startFolder(), meshFilter());
    if (!file.isEmpty())
        importMeshNow(file, replaced);
}

void FileFlow::importMeshNow(const QString& path, std::optional<ElementId> replaced)
{
    auto* progress =
        new QProgressDialog(tr("Reading %1 \u2026").arg(QFileInfo(path).fileName()), tr("Cancel"), 0, 0, m_window);
    progress->setWindowModality(Qt::WindowModal);
    progress->setMinimumDuration(400);
    progress->setAttribute(Qt::WA_DeleteOnClose);
    progress->setAutoClose(false);
    // The reader cannot be stopped, but nobody waits for it: a cancelled result is dropped.
    inBackground<ImportedMesh>([path] {
        return importMesh(path);
    }).then(this, [this, path, replaced, progress = QPointer(progress)](const ImportedMesh& imported) {
        const bool cancelled = !progress || progress->wasCanceled();
        if (progress)
            progress->deleteLater();
        if (cancelled)
            return;
        if (!imported.mesh) {
            fail(tr("\"%1\" could not be imported.").arg(QFileInfo(path).fileName()), imported.problem);
            return;
        }
        std::optional<Frame> before;
        if (const Frame* frame = replaced ? m_session.document().design().find<Frame>(*replaced) : nullptr)
            before = *frame;
        FrameImportDialog dialog(path, imported.mesh, before, m_window);
        if (dialog.exec() != QDialog::Accepted)
            return;
        if (const Message problem = m_session.addFrame(path, imported.mesh, dialog.frame(), replaced);
            !problem.empty())
            fail(tr("\"%1\" could not be imported.").arg(QFileInfo(path).fileName()), problem);
    });
}

void FileFlow::exportSurface(const SurfaceMeshPtr& surface)
{
    if (!surface)
        return;
    const QString name = QFileInfo(m_session.title()).completeBaseName() + QStringLiteral(".obj");
    QString filter;
    QString path = QFileDialog::getSaveFileName(m_window, tr("Export surface"), QDir(startFolder()).filePath(name),
                                                tr("OBJ (*.obj);;PLY (*.ply)"), &filter);
    if (path.isEmpty())
        return;
    if (QFileInfo(path).suffix().isEmpty())
        path += filter.contains(QLatin1String("ply")) ? QStringLiteral(".ply") : QStringLiteral(".obj");
    const bool ply = path.endsWith(QLatin1String(".ply"), Qt::CaseInsensitive);
    inBackground<Message>([surface, design = m_session.document().design(), path, ply] {
        return ply ? exportPly(*surface, design, path) : exportObj(*surface, design, path);
    }).then(this, [this, path](const Message& problem) {
        if (problem.empty())
            emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
        else
            fail(tr("The surface could not be exported."), problem);
    });
}

void FileFlow::exportPicture(const QImage& picture)
{
    const QString name = QFileInfo(m_session.title()).completeBaseName() + QStringLiteral(".png");
    const QString path = QFileDialog::getSaveFileName(m_window, tr("Export picture"),
                                                      QDir(startFolder()).filePath(name), tr("PNG (*.png)"));
    if (path.isEmpty())
        return;
    if (picture.save(path, "PNG"))
        emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
    else
        fail(tr("The picture could not be exported."),
             {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be written"), {path.toStdString()}});
}

void FileFlow::offerRecovery()
{
    const QList<Recovery::Orphan> orphans = Recovery::orphans();
    if (orphans.isEmpty())
        return;
    const Recovery::Orphan& newest = orphans.front();
    const QString name = newest.original.isEmpty() || FrameFiles::isOwnFolder(newest.frameFolder())
                             ? tr("a new design")
                             : QFileInfo(newest.original).fileName();
    m_recoveryOffer = tr("Bolster did not end properly. Unsaved work on %1 from %2 was kept.")
                          .arg(name, QLocale().toString(newest.when, QLocale::ShortFormat));
    if (newest.fileIsNewer())
        m_recoveryOffer += u' ' + tr("The file itself was saved later; the copy opens as a new design.");
    m_banner->announce(Banner::Kind::Information, m_recoveryOffer,
                       {{tr("Restore"), [this, newest] { keepWork([this, newest] { restore(newest); }); }},
                        {tr("Discard"), [this, newest] {
                             DesignSession::discard(newest);
                             offerRecovery(); // the next one
                         }}});
}

bool FileFlow::offersRecovery() const
{
    return m_banner->shown() && m_banner->text() == m_recoveryOffer;
}

void FileFlow::restore(const Recovery::Orphan& orphan)
{
    m_session.restore(orphan, [this](const Message& problem) {
        if (!problem.empty())
            fail(tr("The unsaved work could not be restored."), problem);
        else
            offerRecovery(); // the next one
    });
}

} // namespace bolster
