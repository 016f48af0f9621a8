// Exporting covers for other programs and for customers, surfaces and pictures.
#include "Background.h"
#include "CoverFileWriting.h"
#include "FileFlow.h"
#include "FileFormats.h"
#include "Jobs.h"
#include "SurfaceExport.h"
#include "Translated.h"
#include "ViewerParts.h"
#include "WholeFile.h"

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

} // namespace

void FileFlow::exportCover(const SurfaceMeshPtr& surface, const FabricBaker& bake)
{
    chooseTarget(tr("Export cover"), proposed(QStringLiteral("html"), tr("-cover")), filtersOf(FileUse::CoverOut),
                 endingsOf(FileUse::CoverOut), [this, surface, bake](const QString& path) {
                     exportCoverTo(surface, bake, formatFor(FileUse::CoverOut, path), path);
                 });
}

void FileFlow::exportFoam(const SurfaceMeshPtr& surface)
{
    chooseTarget(tr("Export foam"), proposed(QStringLiteral("stl"), tr("-foam")), filtersOf(FileUse::FoamOut),
                 endingsOf(FileUse::FoamOut), [this, surface](const QString& path) {
                     exportCoverTo(surface, {}, formatFor(FileUse::FoamOut, path), path);
                 });
}

void FileFlow::exportCoverTo(const SurfaceMeshPtr& surface, const FabricBaker& bake, CoverFormat format,
                             const QString& path)
{
    const ModelSubject subject{surface, m_session.document().design(), m_session.files(), bake};
    CoverFileOptions options;
    options.title = name().toStdString();
    options.stem = QFileInfo(path).completeBaseName().toStdString();
    if (format == CoverFormat::Page)
        options.page = viewerParts();
    std::stop_source stop;
    const QString text = tr("Exporting %1 \u2026").arg(QFileInfo(path).fileName());
    auto* const progress = openProgress(m_window, text).dialog;
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

void FileFlow::finishCoverExport(const CoverFile& file, const QString& path)
{
    const Message problem =
        writeCoverFile(file, path, [this](const QString& name) { return m_session.isElementFile(name); });
    if (!problem.empty()) {
        fail(tr("The cover could not be exported."), problem);
        return;
    }
    QString said = tr("Exported to %1").arg(QDir::toNativeSeparators(path));
    for (const Message& note : file.notes)
        said += QStringLiteral(": ") + translated(note);
    emit done(said);
    emit exported();
    if (file.notes.size() < 2)
        return;
    QStringList lines; // more than anybody reads in the status bar before it is gone
    for (const Message& note : file.notes)
        lines << asSentence(translated(note)) + u'.';
    tell(m_window, QMessageBox::Information, tr("\"%1\" is written.").arg(QFileInfo(path).fileName()),
         lines.join(u'\n'));
}

void FileFlow::exportSurface(const SurfaceMeshPtr& surface)
{
    if (!surface)
        return;
    chooseTarget(tr("Export surface"), proposed(QStringLiteral("obj"), tr("-cover")),
                 filtersOf(FileUse::SurfaceOut), endingsOf(FileUse::SurfaceOut),
                 [this, surface](const QString& path) { exportSurfaceTo(surface, path); });
}

void FileFlow::exportSurfaceTo(const SurfaceMeshPtr& surface, const QString& path)
{
    const bool ply = path.endsWith(QLatin1String(".ply"), Qt::CaseInsensitive);
    auto job = std::make_shared<RunningJob>(tr("Exporting %1 \u2026").arg(QFileInfo(path).fileName()),
                                            std::function<void()>()); // soon done
    inBackground<Message>([surface, design = m_session.document().design(), path, ply] {
        return ply ? exportPly(*surface, design, path) : exportObj(*surface, design, path);
    }).then(this, [this, path, job](const Message& problem) mutable {
        job.reset();
        if (problem.empty()) {
            emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
            emit exported();
        } else {
            fail(tr("The surface could not be exported."), problem);
        }
    });
}

namespace {

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

void FileFlow::exportPicture(const QImage& picture)
{
    chooseTarget(tr("Export picture"), proposedPicture(), tr("PNG (*.png)"), {QStringLiteral("png")},
                 [this, picture](const QString& path) {
                     if (const Message problem = writePng(picture, path); problem.empty()) {
                         emit done(tr("Exported to %1").arg(QDir::toNativeSeparators(path)));
                         emit exported();
                     } else {
                         fail(tr("The picture could not be exported."), problem);
                     }
                 });
}

} // namespace bolster
