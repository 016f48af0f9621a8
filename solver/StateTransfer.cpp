#include "StateTransfer.h"

#include "StartPlacement.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace bolster {

namespace {

struct Location {
    std::array<std::uint32_t, 3> corners{};
    Eigen::Vector3d weights = Eigen::Vector3d::Zero(); // barycentric, clamped into the triangle
};

double cross(const Vec2& a, const Vec2& b)
{
    return a.x() * b.y() - a.y() * b.x();
}

/// Finds the triangle of a patch at a point of the pattern plane, through a grid.
class PatchLocator {
public:
    PatchLocator(const SewnMesh& mesh, int part)
        : m_mesh(mesh)
        , m_range(mesh.topology->patches[part])
    {
        const auto& rest = mesh.rest();
        for (std::uint32_t v = m_range.firstVertex; v < m_range.firstVertex + m_range.vertexCount; ++v)
            m_box.extend(rest[v]);
        m_cell = std::max(1e-6, 1.5 * mesh.parts[part].meanEdge);
        m_columns = 1 + static_cast<int>(m_box.sizes().x() / m_cell);
        m_rows = 1 + static_cast<int>(m_box.sizes().y() / m_cell);
        m_cells.resize(static_cast<std::size_t>(m_columns) * m_rows);
        for (std::uint32_t t = m_range.firstTriangle; t < m_range.firstTriangle + m_range.triangleCount; ++t) {
            Box2 box;
            for (std::uint32_t v : mesh.topology->triangles[t])
                box.extend(rest[v]);
            const auto [c0, r0] = cellOf(box.min());
            const auto [c1, r1] = cellOf(box.max());
            for (int r = r0; r <= r1; ++r)
                for (int c = c0; c <= c1; ++c)
                    cell(c, r).push_back(t);
        }
    }

    /// Rings of cells around the point, until one has a triangle and the next cannot have a nearer one.
    Location locate(const Vec2& p) const
    {
        Location best;
        double bestDistance = std::numeric_limits<double>::max();
        const auto [c, r] = cellOf(p);
        const int rings = std::max(m_columns, m_rows);
        const double found = 1e-20 * m_cell * m_cell; // no nearer one is possible, but for rounding
        for (int ring = 0; ring <= rings && bestDistance > std::max(found, std::pow((ring - 1) * m_cell, 2));
             ++ring)
            for (int row = r - ring; row <= r + ring; ++row)
                for (int column = c - ring; column <= c + ring; ++column)
                    if (std::max(std::abs(row - r), std::abs(column - c)) == ring && inside(column, row))
                        for (std::uint32_t t : cell(column, row))
                            tryTriangle(t, p, best, bestDistance);
        return best;
    }

private:
    std::pair<int, int> cellOf(const Vec2& p) const
    {
        const Vec2 q = (p - m_box.min()) / m_cell;
        return {static_cast<int>(std::clamp(q.x(), 0.0, m_columns - 1.0)),
                static_cast<int>(std::clamp(q.y(), 0.0, m_rows - 1.0))};
    }
    bool inside(int c, int r) const { return c >= 0 && r >= 0 && c < m_columns && r < m_rows; }
    const std::vector<std::uint32_t>& cell(int c, int r) const
    {
        return m_cells[static_cast<std::size_t>(r) * m_columns + c];
    }
    std::vector<std::uint32_t>& cell(int c, int r) { return m_cells[static_cast<std::size_t>(r) * m_columns + c]; }

    void tryTriangle(std::uint32_t t, const Vec2& p, Location& best, double& bestDistance) const
    {
        const auto& corners = m_mesh.topology->triangles[t];
        const Vec2 &a = m_mesh.rest()[corners[0]], &b = m_mesh.rest()[corners[1]], &c = m_mesh.rest()[corners[2]];
        const double area = cross(b - a, c - a);
        Eigen::Vector3d weights(cross(b - p, c - p) / area, cross(c - p, a - p) / area, 0);
        weights[2] = 1 - weights[0] - weights[1];
        weights = weights.cwiseMax(0.0);
        weights /= weights.sum();
        const double distance = (weights[0] * a + weights[1] * b + weights[2] * c - p).squaredNorm();
        if (distance < bestDistance) {
            bestDistance = distance;
            best = {corners, weights};
        }
    }

    const SewnMesh& m_mesh;
    const SurfaceTopology::PatchRange& m_range;
    Box2 m_box;
    double m_cell = 1;
    int m_columns = 1, m_rows = 1;
    std::vector<std::vector<std::uint32_t>> m_cells;
};

int partOf(const SewnMesh& mesh, ElementId patch)
{
    for (int p = 0; p < std::ssize(mesh.parts); ++p)
        if (mesh.parts[p].patch == patch)
            return p;
    return -1;
}

Vec3 positionAt(const SewnMesh& mesh, const SheetState& state, const Location& at)
{
    Vec3 sum = Vec3::Zero();
    for (int k = 0; k < 3; ++k)
        sum += at.weights[k] * state.positions.col(mesh.topology->unknown[at.corners[k]]);
    return sum;
}

Eigen::Vector4d frameAt(const SheetState& state, const Location& at)
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
        const PatchLocator locator(from, old);
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const Location at = locator.locate(m_to.rest()[v]);
            const auto unknown = m_to.topology->unknown[v];
            m_sum.col(unknown) += positionAt(from, state, at);
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
        const PatchLocator locator(b, other);
        for (int v = part.firstVertex; v < part.firstVertex + part.vertexCount; ++v) {
            const Vec3 there = positionAt(b, stateB, locator.locate(a.rest()[v]));
            largest = std::max(largest, (there - stateA.positions.col(a.topology->unknown[v])).norm());
        }
    }
    return largest;
}

} // namespace bolster
