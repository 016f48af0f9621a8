// Triangles of a form as CGAL has them, some of their edges along lines. Private to the library.
#pragma once

#include "FormLines.h"

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <optional>
#include <set>
#include <utility>
#include <vector>

namespace bolster {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using CgalMesh = CGAL::Surface_mesh<Kernel::Point_3>;
using Vertex = CgalMesh::Vertex_index;
using FormEdge = CgalMesh::Edge_index;
using Face = CgalMesh::Face_index;

inline Kernel::Point_3 toCgal(const Vec3& p)
{
    return {p.x(), p.y(), p.z()};
}

inline Vec3 fromCgal(const Kernel::Point_3& p)
{
    return {p.x(), p.y(), p.z()};
}

struct LinedMesh {
    CgalMesh mesh;
    CgalMesh::Property_map<Face, int> part;
    CgalMesh::Property_map<FormEdge, bool> cut;

    /// Of these triangles; none: of all. False where an edge has three of them, or two sheets meet in a point; and
    /// when stopped.
    bool build(const TriangleSoup& soup, std::vector<int> chosen, const std::stop_token& stop = {});
    /// A place of the triangle with which that was so.
    const Vec3& refusedAt() const { return m_refusedAt; }
    /// In place of the triangles that it was made of.
    void putBack(TriangleSoup& soup) const;

    /// CGAL numbers edges that cutting has made by where they lie in memory; now by faces and corners.
    void renumberEdges();
    /// What cutting has left of triangles goes: points that are nearly one, and triangles that are nearly an edge.
    void tidy();
    /// Whether the form ends at an edge, or is cut there whatever lines say.
    bool isCutAnyway(FormEdge edge, const FormCuts& cuts) const;
    /// What hangs over where a line has met another one, or where the form is cut anyway.
    void pruneSpurs(const FormCuts& cuts);
    /// Where lines end inside.
    std::vector<Vertex> looseEnds(const FormCuts& cuts) const;
    std::set<int> loosePoints(const FormCuts& cuts) const; ///< the same, points of the soup
    std::pair<Vec3, Vec3> endsOf(FormEdge e) const;        ///< mm

private:
    bool isCutAnywayAt(Vertex v, const FormCuts& cuts) const;
    Vec3 normalBeside(CgalMesh::Halfedge_index half) const;
    int pointOf(Vertex v) const { return m_point[v.idx()]; }
    bool isShared(Vertex v) const { return v.idx() < m_shared.size() && m_shared[v.idx()]; }
    double lengthOf(FormEdge e) const;
    double heightOf(Vertex a, Vertex b, Vertex c) const;
    bool isCap(Vertex a, Vertex b, Vertex c) const;
    bool isHeld(FormEdge e) const;
    bool isOnLine(Vertex v) const;
    bool bothHeldBeside(CgalMesh::Halfedge_index half) const;
    std::optional<FormEdge> lineBeside(CgalMesh::Halfedge_index half) const;
    bool isCrumb(CgalMesh::Halfedge_index half) const;
    bool canCollapse(FormEdge e) const;
    std::vector<FormEdge> cutsAt(Vertex v) const;
    bool joinNearPoints();
    bool flattenCaps();

    std::vector<int> m_triangles; // of the soup
    std::vector<int> m_point;     // of each vertex that it had from the beginning
    Vec3 m_refusedAt = Vec3::Zero();
    std::set<int> m_ends;       // of the soup
    std::vector<bool> m_shared; // by triangles that are not chosen, of the same
};

} // namespace bolster
