// Exporting covers for other programs and for customers.
#include "Background.h"
#include "CoverFileWriting.h"
#include "FileFlow.h"
#include "Translated.h"
#include "ViewerParts.h"

#include <QDir>
#include <QFileInfo>

#include <array>

namespace bolster {

namespace {

struct CoverTarget {
    const char* ending;
    CoverFormat format;
    const char* filter;
};

constexpr std::array coverTargets = {
    CoverTarget{"html", CoverFormat::Page,
                QT_TRANSLATE_NOOP("bolster::FileFlow", "Page for the customer (*.html)")},
    CoverTarget{"glb", CoverFormat::Glb, QT_TRANSLATE_NOOP("bolster::FileFlow", "glTF (*.glb)")},
    CoverTarget{"usdz", CoverFormat::Usdz, QT_TRANSLATE_NOOP("bolster::FileFlow", "USDZ, for phones (*.usdz)")},
    CoverTarget{"obj", CoverFormat::Obj, QT_TRANSLATE_NOOP("bolster::FileFlow", "OBJ with materials (*.obj)")},
    CoverTarget{"stl", CoverFormat::Stl, QT_TRANSLATE_NOOP("bolster::FileFlow", "STL, with a thickness (*.stl)")},
    CoverTarget{"3mf", CoverFormat::ThreeMf,
                QT_TRANSLATE_NOOP("bolster::FileFlow", "3MF, with a thickness (*.3mf)")},
    CoverTarget{"step", CoverFormat::Step, QT_TRANSLATE_NOOP("bolster::FileFlow", "STEP, curves alone (*.step)")},
};

constexpr std::array foamTargets = {
    CoverTarget{"stl", CoverFormat::FoamStl, QT_TRANSLATE_NOOP("bolster::FileFlow", "STL (*.stl)")},
    CoverTarget{"3mf", CoverFormat::FoamThreeMf, QT_TRANSLATE_NOOP("bolster::FileFlow", "3MF (*.3mf)")},
};

template <class Targets>
QString filtersOf(const Targets& targets)
{
    QStringList filters;
    for (const CoverTarget& target : targets)
        filters << FileFlow::tr(target.filter);
    return filters.join(QStringLiteral(";;"));
}

template <class Targets>
QStringList endingsOf(const Targets& targets)
{
    QStringList endings;
    for (const CoverTarget& target : targets)
        endings << QLatin1String(target.ending);
    return endings;
}

template <class Targets>
CoverFormat formatFor(const Targets& targets, const QString& path)
{
    for (const CoverTarget& target : targets)
        if (path.endsWith(QStringLiteral(".") + QLatin1String(target.ending), Qt::CaseInsensitive))
            return target.format;
    return targets.front().format;
}

} // namespace

void FileFlow::exportCover(const SurfaceMeshPtr& surface, const FabricBaker& bake)
{
    chooseTarget(tr("Export cover"), proposed(QStringLiteral("html"), tr("-cover")), filtersOf(coverTargets),
                 endingsOf(coverTargets), [this, surface, bake](const QString& path) {
                     exportCoverTo(surface, bake, formatFor(coverTargets, path), path);
                 });
}

void FileFlow::exportFoam(const SurfaceMeshPtr& surface)
{
    chooseTarget(tr("Export foam"), proposed(QStringLiteral("stl"), tr("-foam")), filtersOf(foamTargets),
                 endingsOf(foamTargets), [this, surface](const QString& path) {
                     exportCoverTo(surface, {}, formatFor(foamTargets, path), path);
                 });
}

void FileFlow::exportCoverTo(const SurfaceMeshPtr& surface, const FabricBaker& bake, CoverFormat format,
                             const QString& path)
{
    const ModelSubject subject{surface, m_session.document().design(), m_session.files(), bake};
    CoverFileOptions options;
    options.title = m_session.title().toStdString();
    options.stem = QFileInfo(path).completeBaseName().toStdString();
    if (format == CoverFormat::Page)
        options.page = viewerParts();
    std::stop_source stop;
    auto* const progress = openProgress(m_window, tr("Exporting %1 \u2026").arg(QFileInfo(path).fileName())).dialog;
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    connect(progress, &QObject::destroyed, [stop]() mutable { stop.request_stop(); }); // with its window
    inBackground<CoverFile>([subject, options, format, token = stop.get_token()] {
        return CoverFiles(subject, options).make(format, token);
    }).then(this, [this, path, shown = QPointer(progress)](const CoverFile& file) {
        const bool cancelled = !shown || shown->wasCanceled();
        closeProgress(shown);
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
}

} // namespace bolster
