#include "MeanCurvature.h"

#include <OpenMesh/Core/Mesh/TriMesh_ArrayKernelT.hh>

#include <limits>

namespace bolster {

namespace {

struct Traits : OpenMesh::DefaultTraits {
    using Point = OpenMesh::Vec3d;
    using Normal = OpenMesh::Vec3d;
};
using HalfEdgeMesh = OpenMesh::TriMesh_ArrayKernelT<Traits>;

/// The sewn cover. Where sewing makes more of it meet than a surface can have, as three patches in one seam, a
/// triangle gets corners of its own.
class SewnCover {
public:
    explicit SewnCover(const SurfaceMesh& surface)
        : m_surface(surface)
        , m_sewn(surface.topology->unknown.size() == surface.topology->vertexCount())
    {
        const SurfaceTopology& topology = *surface.topology;
        const std::size_t count = m_sewn ? topology.unknownCount : topology.vertexCount();
        m_mesh.reserve(count, topology.triangles.size() * 3 / 2, topology.triangles.size());
        for (std::size_t v = 0; v < count; ++v)
            add(static_cast<int>(v), OpenMesh::Vec3d(0.0));
        for (std::uint32_t v = 0; v < topology.vertexCount(); ++v)
            m_mesh.set_point(Vertex(merged(v)), OpenMesh::Vec3d(surface.positions[v].data()));
        for (const auto& triangle : topology.triangles)
            add(triangle);
    }

    std::vector<float> measured() const
    {
        std::vector<double> area(m_mesh.n_vertices()), bend(m_mesh.n_vertices());
        for (const auto face : m_mesh.faces())
            for (const auto corner : face.vertices())
                area[source(corner)] += m_mesh.calc_face_area(face) / 3;
        for (const auto edge : m_mesh.edges()) {
            if (edge.is_boundary())
                continue;
            const double share = m_mesh.calc_dihedral_angle(edge) * m_mesh.calc_edge_length(edge) / 4;
            for (const auto end : {edge.v0(), edge.v1()})
                bend[source(end)] += share;
        }
        std::vector<float> ofVertex(m_surface.positions.size(), std::numeric_limits<float>::quiet_NaN());
        for (std::uint32_t v = 0; v < ofVertex.size(); ++v)
            if (const auto at = static_cast<std::size_t>(merged(v)); area[at] > 0)
                ofVertex[v] = static_cast<float>(1000 * bend[at] / area[at]);
        return ofVertex;
    }

private:
    using Vertex = OpenMesh::VertexHandle;

    int merged(std::uint32_t v) const { return static_cast<int>(m_sewn ? m_surface.topology->unknown[v] : v); }
    std::size_t source(Vertex vertex) const { return static_cast<std::size_t>(m_source[vertex.idx()]); }

    Vertex add(int source, OpenMesh::Vec3d at) // of the mesh itself, perhaps, which grows
    {
        m_source.push_back(source);
        return m_mesh.add_vertex(at);
    }

    /// Whether a triangle leaves the mesh a surface.
    bool fits(const std::array<Vertex, 3>& corners) const
    {
        for (std::size_t k = 0; k < 3; ++k) {
            const auto edge = m_mesh.find_halfedge(corners[k], corners[(k + 1) % 3]);
            if (!m_mesh.is_boundary(corners[k]) || (edge.is_valid() && !m_mesh.is_boundary(edge)))
                return false;
        }
        return true;
    }

    void add(const std::array<std::uint32_t, 3>& triangle)
    {
        std::array<Vertex, 3> corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = Vertex(merged(triangle[k]));
        const auto at = [&](std::size_t k) { return m_mesh.point(corners[k]); };
        if (!(OpenMesh::cross(at(1) - at(0), at(2) - at(0)).sqrnorm() > 0)) // nor where a number is none
            return;
        if (fits(corners) && m_mesh.add_face(corners[0], corners[1], corners[2]).is_valid())
            return;
        for (Vertex& corner : corners)
            corner = add(m_source[corner.idx()], m_mesh.point(corner));
        m_mesh.add_face(corners[0], corners[1], corners[2]);
    }

    const SurfaceMesh& m_surface;
    bool m_sewn;
    HalfEdgeMesh m_mesh;
    std::vector<int> m_source; ///< of each vertex of the mesh: the merged one
};

} // namespace

std::vector<float> meanCurvature(const SurfaceMesh& surface)
{
    return SewnCover(surface).measured();
}

} // namespace bolster
