// One mesh of the cover on the graphics card: the solver's, or the refined one.
#pragma once

#include "CoverMesh.h"
#include "CoverOcclusion.h"
#include "GlBuffer.h"
#include "SeamRelief.h"
#include "VertexMap.h"

#include <functional>

namespace bolster {

/// Uploads what has changed only. A context must be current whenever it is used or destroyed.
class GlCoverMesh {
public:
    explicit GlCoverMesh(GlFunctions& gl);

    /// The solver's mesh as it is.
    void put(const SurfaceMeshPtr& surface);
    void put(const CoverMeshPtr& cover);
    void forget();
    /// Nothing where the map is of another topology.
    void putMap(const VertexMapPtr& map);
    /// Keeps what there is where it is of an older topology: the next one is on its way.
    void putOpenness(const std::shared_ptr<const CoverOcclusion>& occlusion);

    /// Of the seams; it must fit.
    void putRelief(const SeamReliefPtr& relief);

    bool empty() const { return !m_coarse; }
    std::uint32_t vertexCount() const { return m_fine ? m_fine->vertexCount() : m_coarse->vertexCount(); }
    using Ranges = std::vector<SurfaceTopology::PatchRange>;
    /// Of those patches of the mesh that `shown` has.
    Ranges patches(const SurfaceTopology& shown) const;
    enum class Detail {
        Fewer,  ///< than the solver's triangles, where there are too many for something that moves
        Solved, ///< the solver's triangles on the refined vertices
        Refined
    };
    /// Calls `begin` before each patch.
    void draw(const Ranges& patches, const std::function<void(const SurfaceTopology::PatchRange&)>& begin,
              Detail detail);
    void drawEdges(const Ranges& patches);

private:
    void putTopology(const std::vector<Eigen::Vector2f>& cloth, const std::vector<CoverTopology::Triangle>& all);
    void putFewer();
    void putEdges(const Ranges& patches);
    template <class T>
    std::vector<T> ofVertices(std::vector<T> ofCoarse) const;

    GlFunctions& m_gl;
    QOpenGLVertexArrayObject m_array;
    GlBuffer m_positions;
    GlBuffer m_normals;
    GlBuffer m_cloth;
    GlBuffer m_openness;
    GlBuffer m_mapColors;
    GlBuffer m_seamDistances;
    GlBuffer m_seamShapes;
    GlBuffer m_triangles{QOpenGLBuffer::IndexBuffer};
    GlBuffer m_coarseTriangles{QOpenGLBuffer::IndexBuffer};
    GlBuffer m_fewerTriangles{QOpenGLBuffer::IndexBuffer};
    std::vector<std::size_t> m_fewerOf; ///< as in FewerTriangles; empty until something moves
    GlBuffer m_edges{QOpenGLBuffer::IndexBuffer};
    GLsizei m_edgeCount = 0;
    std::vector<ElementId> m_edgesOf;

    std::shared_ptr<const SurfaceTopology> m_coarse; ///< null: nothing to draw
    std::shared_ptr<const CoverTopology> m_fine;     ///< null: the solver's mesh
    SurfaceMeshPtr m_surface;
    CoverMeshPtr m_cover;
    std::shared_ptr<const CoverOcclusion> m_occlusion;
    VertexMapPtr m_map;
    SeamReliefPtr m_relief;
};

} // namespace bolster
