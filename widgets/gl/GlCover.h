// The cover on the graphics card: refined where that is known, else as the solver has it.
#pragma once

#include "GlCoverMesh.h"
#include "GlFabrics.h"
#include "GlView.h"

namespace bolster {

class GlCover {
public:
    GlCover(GlFunctions& gl, GlFabrics& fabrics);

    /// Uploads what has changed: positions and normals only, while the topology stays.
    void update(const ViewScene& scene);
    /// `quick`: something moves; fewer triangles, and plainer cloth.
    void draw(const ViewScene& scene, const GlView& view, bool quick);
    /// How near it is, where its looks are not seen.
    void drawDepth(const ViewScene& scene, const GlView& view, bool quick);
    void drawEdges(const ViewScene& scene, const GlView& view, const QColor& color);

private:
    GlCoverMesh& shown(const ViewScene& scene) { return scene.cover ? m_refined : m_solved; }
    void draw(const ViewScene& scene, const GlView& view, bool quick, GlCoverMesh::Detail detail);
    void updateRelief(const ViewScene& scene);
    void setCloth(const ViewScene& scene, ElementId patch, bool quick);

    GlFunctions& m_gl;
    GlProgram m_program;
    GlProgram m_plain;
    GlCoverMesh m_solved;
    GlCoverMesh m_refined;
    GlFabrics& m_fabrics;
    SeamReliefPtr m_relief; ///< the last one: while something moves it is that of the solver's mesh, too
};

} // namespace bolster
