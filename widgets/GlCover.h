// The cover on the graphics card.
#pragma once

#include "GlBuffer.h"
#include "GlView.h"

namespace bolster {

class GlCover {
public:
    explicit GlCover(GlFunctions& gl);

    /// Uploads what has changed: positions and normals only, while the topology stays.
    void update(const SurfaceScene& scene);
    void draw(const SurfaceScene& scene, const GlView& view);
    void drawEdges(const GlView& view, const QColor& color);

private:
    void putTopology(const SurfaceTopology& topology);
    void putEdges();
    void putPositions(const SurfaceMesh& mesh);
    void putOpenness(const SurfaceScene& scene);
    void putMap();

    GlFunctions& m_gl;
    GlProgram m_program;
    GlProgram m_plain;
    QOpenGLVertexArrayObject m_array;
    GlBuffer m_positions;
    GlBuffer m_normals;
    GlBuffer m_cloth;
    GlBuffer m_openness;
    GlBuffer m_mapColors;
    GlBuffer m_triangles{QOpenGLBuffer::IndexBuffer};
    GlBuffer m_edges{QOpenGLBuffer::IndexBuffer};
    GLsizei m_edgeCount = 0;

    SurfaceMeshPtr m_surface;
    std::shared_ptr<const SurfaceTopology> m_topology;
    std::shared_ptr<const SurfaceOcclusion> m_occlusion;
    SurfaceMapPtr m_map;
};

} // namespace bolster
