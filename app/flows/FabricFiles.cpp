// Fabrics from files and to files, and pictures for them.
#include "Ask.h"
#include "Background.h"
#include "DesignFolder.h"
#include "ElementEdits.h"
#include "FabricCommands.h"
#include "FileFormats.h"
#include "ImageImport.h"
#include "Project.h"
#include "TemporaryFile.h"

#include <QDir>
#include <QFileInfo>
#include <QPointer>
#include <QProgressDialog>
#include <QStandardPaths>
#include <QTemporaryDir>

namespace bolster {

namespace {

/// A fabric file is a design that has nothing but the fabric; its picture lies beside it.
Message writeFabric(const Fabric& fabric, const QString& picture, const QString& path)
{
    Fabric written = fabric;
    const QFileInfo target(path);
    if (!picture.isEmpty()) {
        const QString name = target.completeBaseName() + u'.' + QFileInfo(picture).suffix().toLower();
        const QString copy = target.dir().filePath(name);
        if (QFileInfo(copy).canonicalFilePath() != QFileInfo(picture).canonicalFilePath()) {
            TemporaryFile temporary(copy); // an older one stays until this one is whole
            if (Message problem = temporary.copyFrom(picture); !problem.empty())
                return problem;
            if (Message problem = temporary.moveIntoPlace(); !problem.empty())
                return problem;
        }
        written.look.file = name.toStdString();
    }
    const Design empty;
    return saveDesign(empty.with(edits::addElement(empty, makeElement(std::move(written)))), path);
}

} // namespace

QString FabricCommands::startFolder() const
{
    if (!m_folder.isEmpty() && QFileInfo(m_folder).isDir())
        return m_folder;
    return m_session.path().isEmpty() ? QStandardPaths::writableLocation(QStandardPaths::DocumentsLocation)
                                      : QFileInfo(m_session.path()).absolutePath();
}

void FabricCommands::choosePicture(ElementId fabric, const QString& path)
{
    if (!path.isEmpty()) {
        readPicture(path, fabric);
        return;
    }
    askForFile(m_window, tr("Picture of a fabric"), startFolder(),
               tr("Pictures (%1)").arg(patternsOf(FileUse::Picture)),
               [this, fabric](const QString& file) { readPicture(file, fabric); });
}

void FabricCommands::readPicture(const QString& file, ElementId fabric)
{
    QProgressDialog* progress =
        openProgress(m_window, tr("Reading %1 \u2026").arg(QFileInfo(file).fileName())).dialog;
    std::stop_source stop;
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    inBackground<ImageOutcome>([file, token = stop.get_token()] {
        return importImage(file, token);
    }).then(this, [this, file, fabric, progress = QPointer(progress), stop](const ImageOutcome& read) {
        closeProgress(progress);
        if (stop.stop_requested())
            return;
        if (!read.pixels)
            fail(tr("The picture could not be read."), read.problem);
        else
            takePicture(file, fabric);
    });
}

void FabricCommands::takePicture(const QString& path, ElementId fabric)
{
    const Fabric* before = design().find<Fabric>(fabric);
    Fabric shown = before ? *before : Fabric{};
    const bool other = shown.look.kind != FabricLook::Kind::Image;
    if (other)
        shown.look = usualLook(FabricLook::Kind::Image);
    if (!before)
        shown.name = QFileInfo(path).completeBaseName().toStdString();
    const ElementId id = before ? fabric : design().nextId();
    const Message problem = m_session.addWithFile(path, {}, shown, before ? std::optional(fabric) : std::nullopt);
    if (!problem.empty())
        fail(tr("The picture could not be taken into the design."), problem);
    else if (!before)
        emit added(id);
}

void FabricCommands::importFabrics(const QString& path)
{
    if (!path.isEmpty())
        readFabrics(path);
    else
        askForFile(m_window, tr("Import fabrics"), startFolder(),
                   tr("Fabrics, designs and projects (*.json *.bolster)"),
                   [this](const QString& file) { readFabrics(file); });
}

void FabricCommands::readFabrics(const QString& file)
{
    QProgressDialog* progress =
        openProgress(m_window, tr("Reading %1 \u2026").arg(QFileInfo(file).fileName())).dialog;
    const auto folder = std::make_shared<QTemporaryDir>();
    inBackground<OpenedDesign>([file, folder] {
        if (!looksLikeProject(file))
            return openDesign(file);
        OpenedDesign opened;
        const OpenedProject project = openProject(file);
        if (!project.problem.empty()) {
            opened.problems.push_back({settingsId, {}, {}, project.problem});
            return opened;
        }
        opened.design = project.design;
        opened.readable = true;
        (void)extractAssets(project, project.design, folder->path()); // what is missing is said when it is shown
        return opened;
    }).then(this, [this, file, folder, progress = QPointer(progress)](const OpenedDesign& opened) {
        const bool cancelled = !progress || progress->wasCanceled();
        closeProgress(progress);
        if (cancelled)
            return;
        if (!opened.readable)
            fail(tr("\"%1\" could not be read.").arg(QFileInfo(file).fileName()),
                 opened.problems.empty() ? Message{} : opened.problems.front().message);
        else
            takeFabrics(file, opened.design,
                        looksLikeProject(file) ? folder->path() : QFileInfo(file).absolutePath());
    });
}

void FabricCommands::takeFabrics(const QString& path, const Design& from, const QString& folder)
{
    int taken = 0;
    from.each<Fabric>([&](ElementId, const Fabric& fabric) {
        Message problem;
        const QString picture = fabric.look.kind == FabricLook::Kind::Image
                                    ? elementFilePath(*makeElement(Fabric(fabric)), folder, problem)
                                    : QString();
        ++taken;
        if (picture.isEmpty())
            add(fabric);
        else if (problem = m_session.addWithFile(picture, {}, fabric); !problem.empty())
            fail(tr("The picture could not be taken into the design."), problem);
    });
    if (taken == 0)
        fail(tr("Nothing was imported."), {QT_TRANSLATE_NOOP("Message", "there is no fabric in \"%1\""),
                                           {QFileInfo(path).fileName().toStdString()}});
    else
        emit done(tr("%n fabrics imported from %1", nullptr, taken).arg(QFileInfo(path).fileName()));
}

void FabricCommands::exportFabric(const QString& path)
{
    const Fabric* found = design().find<Fabric>(fabric());
    if (!found)
        return;
    if (!path.isEmpty())
        exportTo(path, *found);
    else
        askWhereToWrite(m_window, tr("Export fabric"),
                        QDir(startFolder()).filePath(QString::fromStdString(found->name) + QStringLiteral(".json")),
                        tr("Fabrics (*.json)"), {QStringLiteral("json")},
                        [this, fabric = *found](const QString& file) { exportTo(file, fabric); });
}

void FabricCommands::exportTo(const QString& file, const Fabric& fabric)
{
    const QString picture = fabric.look.kind == FabricLook::Kind::Image
                                ? m_session.findFile(QString::fromStdString(fabric.look.file))
                                : QString();
    if (m_session.isElementFile(file)) {
        fail(tr("The fabric could not be exported."),
             {QT_TRANSLATE_NOOP("Message", "the design uses \"%1\" itself; choose another name"),
              {file.toStdString()}});
        return;
    }
    inBackground<Message>([fabric, picture, file] {
        return writeFabric(fabric, picture, file);
    }).then(this, [this, file](const Message& problem) {
        if (problem.empty())
            emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(file)));
        else
            fail(tr("The fabric could not be exported."), problem);
    });
}

} // namespace bolster
