// Refines the solver's surface for display and trims its seams, beside the GUI thread.
#pragma once

#include "CoverMesh.h"
#include "Design.h"
#include "LatestJob.h"
#include "TrimMesh.h"

#include <QTimer>

namespace bolster {

/// While surfaces follow each other quickly none is refined: the coarse one is quicker to draw, and nobody sees the
/// difference.
class CoverLink : public QObject {
    Q_OBJECT

public:
    explicit CoverLink(QObject* parent = nullptr);
    ~CoverLink() override;

    /// No seam of the present surface waits for its stitches and its piping.
    bool isTrimmed() const;

public slots:
    void setSurface(const bolster::SurfaceMeshPtr& surface);
    /// mm that a pixel of the picture shows: triangles that are small enough on the screen are not divided.
    void setPixelSize(double mm);
    /// The cover is shown with the triangles of its surface, not with finer ones.
    void setReduced(bool reduced);
    /// Whose seams are trimmed.
    void setDesign(const bolster::Design& design);

signals:
    /// `trims` is null when there are none.
    void refined(const bolster::CoverMeshPtr& cover, const bolster::TrimMeshPtr& trims);
    /// What isTrimmed says may be another answer now.
    void trimmed();

private:
    struct Wanted {
        SurfaceMeshPtr surface;
        Design design;
        int levels = 0;
    };
    struct Made {
        SurfaceMeshPtr of;
        CoverMeshPtr cover; ///< null where the surface is drawn as it is
        TrimMeshPtr trims;
    };
    class Maker;

    int levels() const;
    void ask();

    SurfaceMeshPtr m_surface;
    SurfaceMeshPtr m_made; ///< what was made last is of this one
    Design m_design;
    double m_pixelSize = 0; ///< 0: not known
    int m_asked = 0;        ///< levels
    bool m_reduced = false;
    QTimer m_rest;
    LatestJob<Wanted, Made> m_job; ///< last: it uses the others
};

} // namespace bolster
