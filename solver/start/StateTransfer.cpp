#include "StateTransfer.h"

#include "PatternLocator.h"
#include "StartPlacement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

int partOf(const SewnMesh& mesh, ElementId patch)
{
    for (int p = 0; p < std::ssize(mesh.parts); ++p)
        if (mesh.parts[p].patch == patch)
            return p;
    return -1;
}

Vec3 positionAt(const SewnMesh& mesh, const SheetState& state, const PatternPlace& at)
{
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        sum += at.weights[k] * state.positions.col(mesh.topology->unknown[at.corners[k]]);
    return sum;
}

/// The same on the curved surface that the frames of the corners describe: half way to their tangent planes, which
/// is right for any constant curvature (Boubekeur and Alexa, Phong tessellation, 2008). Without it a finer mesh
/// would begin with the facets of a coarser one.
Vec3 curvedPositionAt(const SewnMesh& mesh, const SheetState& state, const PatternPlace& at)
{
    const Vec3 flat = positionAt(mesh, state, at);
    Vec3 raised = Vec3::Zero();
    for (int k = 0; k < 3; ++k) {
        const Vec3 normal = rotationOf(state.frames.col(at.corners[k])).col(2);
        const Vec3 corner = state.positions.col(mesh.topology->unknown[at.corners[k]]);
        raised += at.weights[k] * normal.dot(corner - flat) * normal;
    }
    return flat + 0.5 * raised;
}

Eigen::Vector4d frameAt(const SheetState& state, const PatternPlace& at)
{
    Eigen::Index nearest = 0;
    at.weights.maxCoeff(&nearest);
    const Eigen::Vector4d reference = state.frames.col(at.corners[nearest]);
    Eigen::Vector4d sum = Eigen::Vector4d::Zero();
    for (int k = 0; k < 3; ++k) {
        const Eigen::Vector4d q = state.frames.col(at.corners[k]);
        sum += (q.dot(reference) < 0 ? -1 : 1) * at.weights[k] * q;
    }
    return sum.norm() > 1e-6 ? Eigen::Vector4d(sum.normalized()) : reference;
}

/// Adds up the places of the vertices of chosen patches; shared unknowns get the mean.
class Carrier {
public:
    explicit Carrier(const SewnMesh& to)
        : m_to(to)
        , m_sum(Eigen::Matrix3Xd::Zero(3, to.unknownCount()))
        , m_count(Eigen::VectorXi::Zero(to.unknownCount()))
    {}

    void carry(const SewnMesh& from, const SheetState& state, const SewnMesh::Part& part, SheetState& result)
    {
        const int old = partOf(from, part.patch);
        if (old < 0)
            return;
        const PatternLocator locator(*from.topology, from.topology->patches[old]);
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const PatternPlace at = locator.locate(m_to.rest()[v]);
            const auto unknown = m_to.topology->unknown[v];
            m_sum.col(unknown) += curvedPositionAt(from, state, at);
            ++m_count[unknown];
            result.frames.col(v) = frameAt(state, at);
        }
    }

    void finish(SheetState& result) const
    {
        for (int u = 0; u < m_to.freeCount; ++u)
            if (m_count[u] > 0)
                result.positions.col(u) = m_sum.col(u) / m_count[u];
    }

private:
    const SewnMesh& m_to;
    Eigen::Matrix3Xd m_sum;
    Eigen::VectorXi m_count;
};

} // namespace

SheetState transferState(const SewnMesh& from, const SheetState& state, const SewnMesh& to)
{
    SheetState result = startPlacement(to);
    Carrier carrier(to);
    for (const SewnMesh::Part& part : to.parts)
        carrier.carry(from, state, part, result);
    carrier.finish(result);
    return result;
}

void fillMissing(const SewnMesh& older, const SheetState& olderState, const SewnMesh& from, const SewnMesh& to,
                 SheetState& state)
{
    Carrier carrier(to);
    for (const SewnMesh::Part& part : to.parts)
        if (partOf(from, part.patch) < 0)
            carrier.carry(older, olderState, part, state);
    carrier.finish(state);
}

double surfaceDistance(const SewnMesh& a, const SheetState& stateA, const SewnMesh& b, const SheetState& stateB)
{
    double largest = 0;
    for (const SewnMesh::Part& part : a.parts) {
        const int other = partOf(b, part.patch);
        if (other < 0)
            return std::numeric_limits<double>::infinity();
        const PatternLocator locator(*b.topology, b.topology->patches[other]);
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const Vec3 there = positionAt(b, stateB, locator.locate(a.rest()[v]));
            largest = std::max(largest, (there - stateA.positions.col(a.topology->unknown[v])).norm());
        }
    }
    return largest;
}

} // namespace bolster
