// Stitches and piping on the graphics card.
#pragma once

#include "GlFabrics.h"
#include "GlTriangles.h"
#include "GlView.h"
#include "TrimMesh.h"

namespace bolster {

/// Uploads what has changed only. A context must be current whenever it is used or destroyed.
class GlTrims {
public:
    GlTrims(GlFunctions& gl, GlFabrics& fabrics);

    void update(const ViewScene& scene);
    /// `quick`: something moves; plainer cloth.
    void draw(const ViewScene& scene, const GlView& view, bool quick);

private:
    GlProgram m_program;
    GlTriangles m_triangles;
    GlFabrics& m_fabrics;
    TrimMeshPtr m_trims; ///< that is uploaded
};

} // namespace bolster
