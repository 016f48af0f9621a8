#include "ExportFlow.h"

#include "Background.h"
#include "CoverFileWriting.h"
#include "ExportPatternDialog.h"
#include "FileFormats.h"
#include "Jobs.h"
#include "SurfaceExport.h"
#include "TemporaryFile.h"
#include "Translated.h"
#include "ViewerParts.h"
#include "WholeFile.h"
#include "WithProgress.h"

#include <QBuffer>
#include <QDir>
#include <QFileInfo>

namespace bolster {

namespace {

struct CoverTarget {
    FileUse use;
    const char* ending;
    CoverFormat format;
};

constexpr CoverTarget coverTargets[] = {
    {FileUse::CoverOut, "html", CoverFormat::Page},      {FileUse::CoverOut, "glb", CoverFormat::Glb},
    {FileUse::CoverOut, "usdz", CoverFormat::Usdz},      {FileUse::CoverOut, "obj", CoverFormat::Obj},
    {FileUse::CoverOut, "stl", CoverFormat::Stl},        {FileUse::CoverOut, "3mf", CoverFormat::ThreeMf},
    {FileUse::CoverOut, "step", CoverFormat::Step},      {FileUse::FoamOut, "stl", CoverFormat::FoamStl},
    {FileUse::FoamOut, "3mf", CoverFormat::FoamThreeMf}, {FileUse::FoamOut, "step", CoverFormat::FoamStep},
};

/// Without any ending that is known, the first one.
CoverFormat formatFor(FileUse use, const QString& path)
{
    const QString ending = isFileOf(use, path) ? endingOf(path) : endingsOf(use).front();
    for (const CoverTarget& target : coverTargets)
        if (target.use == use && ending == QLatin1String(target.ending))
            return target.format;
    return CoverFormat::Glb;
}

/// QImage does not tell when the disk is full.
Message writePng(const QImage& picture, const QString& path)
{
    QByteArray png;
    QBuffer buffer(&png);
    buffer.open(QIODevice::WriteOnly);
    if (!picture.save(&buffer, "PNG"))
        return {QT_TRANSLATE_NOOP("Message", "there is no picture to write"), {}};
    return replaceWholeFile(path, {png.constData(), static_cast<std::size_t>(png.size())});
}

} // namespace

ExportFlow::ExportFlow(DesignSession& session, FileTalk& talk)
    : m_session(session)
    , m_talk(talk)
{}

void ExportFlow::exportPattern(std::function<QImage()> takePicture)
{
    auto* dialog = new ExportPatternDialog(m_session.document().design(), m_talk.designName(),
                                           std::move(takePicture), m_talk.window());
    connect(dialog, &ExportPatternDialog::placeWanted, this, &ExportFlow::placeWanted);
    connect(dialog, &QDialog::accepted, this, [this, dialog] {
        const PatternOrder order = dialog->order();
        const QString ending = patternEnding(order.format);
        m_talk.chooseTarget(
            tr("Export pattern"),
            m_talk.proposed(ending, order.format == PatternFormat::SewingSheet ? tr("-sewing") : tr("-pattern")),
            tr("%1 (*.%2)").arg(ending.toUpper(), ending), {ending},
            [this, order, picture = dialog->picture()](const QString& path) {
                exportPatternTo(path, order, picture);
            });
    });
    openDialog(dialog);
}

void ExportFlow::exportPatternTo(const QString& path, const PatternOrder& order, const QImage& cover)
{
    withProgress<Message>(
        this, m_talk.window(), tr("Writing %1 \u2026").arg(QFileInfo(path).fileName()),
        [design = m_session.document().design(), path, order, cover](const ImportWatch& watch) -> Message {
            const std::string bytes = patternBytes(design, order, cover, {watch.stop, watch.progress});
            if (watch.stop.stop_requested())
                return {};
            removeLeftTemporaryFiles(QFileInfo(path).absolutePath());
            return replaceWholeFile(path, bytes);
        },
        [this, path](const Message& problem) {
            if (problem.empty()) {
                m_talk.say(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
                emit exported();
            } else {
                m_talk.fail(tr("The pattern could not be exported."), problem);
            }
        });
}

void ExportFlow::exportCover(const SurfaceMeshPtr& surface, const FabricBaker& bake)
{
    m_talk.chooseTarget(tr("Export cover"), m_talk.proposed(QStringLiteral("html"), tr("-cover")),
                        filtersOf(FileUse::CoverOut), endingsOf(FileUse::CoverOut),
                        [this, surface, bake](const QString& path) {
                            exportCoverTo(surface, bake, formatFor(FileUse::CoverOut, path), path);
                        });
}

void ExportFlow::exportFoam(const SurfaceMeshPtr& surface)
{
    m_talk.chooseTarget(tr("Export foam"), m_talk.proposed(QStringLiteral("stl"), tr("-foam")),
                        filtersOf(FileUse::FoamOut), endingsOf(FileUse::FoamOut),
                        [this, surface](const QString& path) {
                            exportCoverTo(surface, {}, formatFor(FileUse::FoamOut, path), path);
                        });
}

void ExportFlow::exportCoverTo(const SurfaceMeshPtr& surface, const FabricBaker& bake, CoverFormat format,
                               const QString& path)
{
    const ModelSubject subject{surface, m_session.document().design(), m_session.files(), bake};
    CoverFileOptions options;
    options.title = m_talk.designName().toStdString();
    options.stem = QFileInfo(path).completeBaseName().toStdString();
    if (format == CoverFormat::Page)
        options.page = viewerParts();
    std::stop_source stop;
    const QString text = tr("Exporting %1 \u2026").arg(QFileInfo(path).fileName());
    auto* const progress = openProgress(m_talk.window(), text).dialog;
    auto job = std::make_shared<RunningJob>(text, [progress = QPointer(progress)] {
        if (progress)
            progress->cancel();
    });
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    connect(progress, &QObject::destroyed, [stop]() mutable { stop.request_stop(); }); // with its window
    inBackground<CoverFile>([subject, options, format, token = stop.get_token()] {
        return CoverFiles(subject, options).make(format, token);
    }).then(this, [this, path, job, shown = QPointer(progress)](const CoverFile& file) mutable {
        const bool cancelled = !shown || shown->wasCanceled();
        closeProgress(shown);
        job.reset();
        if (!cancelled)
            finishCoverExport(file, path);
    });
}

void ExportFlow::finishCoverExport(const CoverFile& file, const QString& path)
{
    const Message problem =
        writeCoverFile(file, path, [this](const QString& name) { return m_session.isElementFile(name); });
    if (!problem.empty()) {
        m_talk.fail(tr("The cover could not be exported."), problem);
        return;
    }
    QString said = tr("Exported to %1").arg(QDir::toNativeSeparators(path));
    for (const Message& note : file.notes)
        said += QStringLiteral(": ") + translated(note);
    m_talk.say(said);
    emit exported();
    if (file.notes.size() < 2)
        return;
    QStringList lines; // more than anybody reads in the status bar before it is gone
    for (const Message& note : file.notes)
        lines << asSentence(translated(note)) + u'.';
    tell(m_talk.window(), QMessageBox::Information, tr("\"%1\" is written.").arg(QFileInfo(path).fileName()),
         lines.join(u'\n'));
}

void ExportFlow::exportSurface(const SurfaceMeshPtr& surface)
{
    if (!surface)
        return;
    m_talk.chooseTarget(tr("Export surface"), m_talk.proposed(QStringLiteral("obj"), tr("-surface")),
                        filtersOf(FileUse::SurfaceOut), endingsOf(FileUse::SurfaceOut),
                        [this, surface](const QString& path) { exportSurfaceTo(surface, path); });
}

void ExportFlow::exportSurfaceTo(const SurfaceMeshPtr& surface, const QString& path)
{
    const bool ply = path.endsWith(QLatin1String(".ply"), Qt::CaseInsensitive);
    auto job = std::make_shared<RunningJob>(tr("Exporting %1 \u2026").arg(QFileInfo(path).fileName()),
                                            std::function<void()>()); // soon done
    inBackground<Message>([surface, design = m_session.document().design(), path, ply] {
        return ply ? exportPly(*surface, design, path) : exportObj(*surface, design, path);
    }).then(this, [this, path, job](const Message& problem) mutable {
        job.reset();
        if (problem.empty()) {
            m_talk.say(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
            emit exported();
        } else {
            m_talk.fail(tr("The surface could not be exported."), problem);
        }
    });
}

void ExportFlow::exportPicture(const QImage& picture)
{
    m_talk.chooseTarget(tr("Export picture"), proposedPicture(), tr("PNG (*.png)"), {QStringLiteral("png")},
                        [this, picture](const QString& path) {
                            if (const Message problem = writePng(picture, path); problem.empty()) {
                                m_talk.say(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
                                emit exported();
                            } else {
                                m_talk.fail(tr("The picture could not be exported."), problem);
                            }
                        });
}

} // namespace bolster
