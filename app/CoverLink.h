// Refines the solver's surface for display, beside the GUI thread.
#pragma once

#include "CoverMesh.h"
#include "SurfaceJob.h"

#include <QTimer>

namespace bolster {

class SurfaceRefiner;

/// While surfaces follow each other quickly none is refined: the coarse one is quicker to draw, and nobody sees the
/// difference.
class CoverLink : public QObject {
    Q_OBJECT

public:
    explicit CoverLink(QObject* parent = nullptr);
    ~CoverLink() override;

public slots:
    void setSurface(const bolster::SurfaceMeshPtr& surface);

signals:
    void refined(const bolster::CoverMeshPtr& cover);

private:
    SurfaceMeshPtr m_surface;
    QTimer m_rest;
    SurfaceJob<SurfaceMeshPtr, CoverMeshPtr> m_job; ///< last: it uses the others
};

} // namespace bolster
