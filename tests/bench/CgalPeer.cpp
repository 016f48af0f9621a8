#include "CgalPeer.h"

#define CGAL_EIGEN3_ENABLED
#include <CGAL/Eigen_solver_traits.h>
#include <CGAL/Simple_cartesian.h>
#include <CGAL/Surface_mesh.h>
#include <CGAL/Surface_mesh_deformation.h>

#include <Eigen/UmfPackSupport>

namespace bolster::bench {

using Kernel = CGAL::Simple_cartesian<double>;
using Mesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Matrix = CGAL::Eigen_sparse_matrix<double>::EigenType;

/// UMFPACK without iterative refinement: faster than CGAL's default, Eigen's SparseLU with COLAMD, and less than a
/// third of SparseLU with AMD. The matrix is not symmetric, because held vertices are rows of their own, so it has
/// no Cholesky factor.
struct Umfpack : Eigen::UmfPackLU<Matrix> {
    Umfpack() { umfpackControl()(UMFPACK_IRSTEP) = 0; }
};

struct CgalPeer::Deformation {
    virtual ~Deformation() = default;
    virtual void iterate(int iterations) = 0;

    Mesh mesh;
};

namespace {

Mesh meshOf(const HeldSurface& surface)
{
    Mesh mesh;
    for (const auto& p : surface.rest.colwise())
        mesh.add_vertex({p.x(), p.y(), p.z()});
    for (const auto& [a, b, c] : surface.triangles)
        mesh.add_face(Mesh::Vertex_index(a), Mesh::Vertex_index(b), Mesh::Vertex_index(c));
    return mesh;
}

template <CGAL::Deformation_algorithm_tag tag, class Solver>
struct Arap : CgalPeer::Deformation {
    explicit Arap(const HeldSurface& surface)
        : deformation((mesh = meshOf(surface)))
    {
        deformation.insert_roi_vertices(mesh.vertices_begin(), mesh.vertices_end());
        for (std::size_t k = 0; k < surface.held.size(); ++k) {
            const Mesh::Vertex_index vertex(surface.held[k]);
            const Vec3& target = surface.targets[k];
            deformation.insert_control_vertex(vertex);
            deformation.set_target_position(vertex, {target.x(), target.y(), target.z()});
        }
        deformation.preprocess();
    }
    void iterate(int iterations) override { deformation.deform(iterations, 0); }

    CGAL::Surface_mesh_deformation<Mesh, CGAL::Default, CGAL::Default, tag, CGAL::Default, Solver> deformation;
};

} // namespace

CgalPeer::CgalPeer(const HeldSurface& surface, Energy energy, Solver solver)
{
    const auto make = [&]<CGAL::Deformation_algorithm_tag tag>() -> std::unique_ptr<Deformation> {
        if (solver == Solver::Default)
            return std::make_unique<Arap<tag, CGAL::Default>>(surface);
        return std::make_unique<Arap<tag, CGAL::Eigen_solver_traits<Umfpack>>>(surface);
    };
    m_deformation =
        energy == Energy::Original ? make.operator()<CGAL::ORIGINAL_ARAP>() : make.operator()<CGAL::SRE_ARAP>();
}

CgalPeer::~CgalPeer() = default;
CgalPeer::CgalPeer(CgalPeer&&) noexcept = default;

void CgalPeer::iterate(int iterations)
{
    m_deformation->iterate(iterations);
}

Eigen::Matrix3Xd CgalPeer::positions() const
{
    const Mesh& mesh = m_deformation->mesh;
    Eigen::Matrix3Xd result(3, mesh.number_of_vertices());
    for (const Mesh::Vertex_index v : mesh.vertices())
        result.col(v) << mesh.point(v).x(), mesh.point(v).y(), mesh.point(v).z();
    return result;
}

} // namespace bolster::bench
