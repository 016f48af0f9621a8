// A form before lines are cut into it. Private to the library.
#pragma once

#include "FormTree.h"
#include "LinedMesh.h"
#include "SegmentDistance.h"
#include "SharpEdges.h"

namespace bolster {

/// A place of a line on the form.
struct LinePlace {
    Vec3 at, normal;
    double away = 0; ///< mm from the form
};

/// Where places of lines lie on a form, and where it ends, bends sharply or is cut whatever lines say. All in mm.
class UncutForm {
public:
    UncutForm(const TriangleSoup& form, const FormCuts& cuts, const std::stop_token& stop);

    /// Else lines cannot be cut into it: edges of more than two faces, or sheets that touch in a point, at this
    /// place.
    bool whole() const { return m_whole; }
    const Vec3& notWholeAt() const { return m_mesh.refusedAt(); }

    /// Points inside where cuts end that no line has made.
    std::set<int> loosePoints() const { return m_mesh.loosePoints(m_cuts); }

    LinePlace placeOf(const Vec3& at) const;
    Vec3 nearest(const Vec3& at) const { return m_tree.nearestTo(at).at; }
    /// Whether a place lies beside the form, outside of its border;
    bool isBeyond(const Vec3& at) const;
    /// or outside of a sharp edge, where the form goes on in another direction.
    bool isOutside(const Vec3& at) const;

    /// The place of a border, or of where it is cut anyway, that is nearest to a place on the form; none where none
    /// is near.
    std::optional<Vec3> borderNear(const Vec3& at) const;
    double distanceFromBorder(const Vec3& at) const;
    /// The place of such a border or of a sharp edge that is nearest to where a line's place lies on the form.
    std::optional<Vec3> edgeNear(const Vec3& at, double within) const;
    /// Calls visit(place) with the nearest one of each such edge that is no farther than `within` from `at`.
    template <class Visit>
    void eachBorderNear(const Vec3& at, double within, const Visit& visit) const;
    /// Ends of each such edge.
    template <class Visit>
    void eachEdgeCutAnyway(const Visit& visit) const
    {
        for (const FormEdge e : m_mesh.mesh.edges())
            if (m_mesh.isCutAnyway(e, m_cuts)) {
                const auto [a, b] = m_mesh.endsOf(e);
                visit(a, b);
            }
    }

    const SharpEdges& sharpEdges() const { return m_sharp; }

private:
    std::pair<Vec3, Face> faceNear(const Vec3& place) const;

    const FormCuts& m_cuts;
    LinedMesh m_mesh;
    bool m_whole;
    FormTree m_tree;
    SharpEdges m_sharp;
};

template <class Visit>
void UncutForm::eachBorderNear(const Vec3& at, double within, const Visit& visit) const
{
    for (const FormEdge e : m_mesh.mesh.edges())
        if (const auto [a, b] = m_mesh.endsOf(e);
            segmentDistance<3>(at, a, b) < within && m_mesh.isCutAnyway(e, m_cuts))
            visit(nearestOnSegment<3>(at, a, b));
}

} // namespace bolster
