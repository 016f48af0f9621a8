// What goes out to the cutter, to other programs and to customers: patterns, covers, foam, surfaces, pictures.
#pragma once

#include "FileTalk.h"
#include "Scene.h"
#include "SurfaceMesh.h"

#include <QImage>

#include <functional>

namespace bolster {

enum class CoverFormat;
struct CoverFile;
struct PatternOrder;

class ExportFlow : public QObject {
    Q_OBJECT

public:
    ExportFlow(DesignSession& session, FileTalk& talk);

    void exportSurface(const SurfaceMeshPtr& surface);
    /// Ask where, and by that in which format.
    void exportCover(const SurfaceMeshPtr& surface, const FabricBaker& bake);
    void exportFoam(const SurfaceMeshPtr& surface);
    void exportPicture(const QImage& picture);
    /// Asks how, then where. `takePicture`: of the cover, for the sewing sheet; null when there is none.
    void exportPattern(std::function<QImage()> takePicture);
    /// Named like the design and beside it.
    QString proposedPicture() const { return m_talk.proposed(QStringLiteral("png")); }

signals:
    /// A file for others was written.
    void exported();
    /// Something in the pattern shall be seen: in outline coordinates, mm.
    void placeWanted(bolster::ElementId element, bolster::ElementId patch, const bolster::Vec2& place);

private:
    void exportPatternTo(const QString& path, const PatternOrder& order, const QImage& cover);
    void exportSurfaceTo(const SurfaceMeshPtr& surface, const QString& path);
    void exportCoverTo(const SurfaceMeshPtr& surface, const FabricBaker& bake, CoverFormat format,
                       const QString& path);
    void finishCoverExport(const CoverFile& file, const QString& path);

    DesignSession& m_session;
    FileTalk& m_talk;
};

} // namespace bolster
