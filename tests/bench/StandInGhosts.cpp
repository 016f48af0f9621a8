#include "StandInGhosts.h"

#include "Scenes.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <random>

namespace bolster::bench {

namespace {

/// Boxes of one size in which things lie.
struct Grid {
    Grid(const Box3& box, double cellSize)
        : origin(box.min())
        , cell(cellSize)
        , size((box.sizes() / cellSize).array().ceil().cast<int>() + 1)
    {}

    std::size_t count() const { return static_cast<std::size_t>(size.prod()); }
    std::size_t index(const Eigen::Array3i& at) const
    {
        return static_cast<std::size_t>((at.z() * size.y() + at.y()) * size.x() + at.x());
    }
    /// In cells, inside the grid.
    Eigen::Array3d place(const Vec3& p) const
    {
        return ((p - origin).array() / cell).max(0).min(size.cast<double>() - 1.001);
    }

    Vec3 origin;
    double cell;
    Eigen::Array3i size;
};

Box3 around(double margin)
{
    const Box3 box = seatBox();
    return {box.min() - Vec3::Constant(margin), box.max() + Vec3::Constant(margin)};
}

class Cushion : public GhostSource {
public:
    Cushion()
        : m_grid(around(40), 5)
        , m_force(m_grid.count())
    {
        const Vec3 centre = seatBox().center();
        Eigen::Array3i at;
        for (at.z() = 0; at.z() < m_grid.size.z(); ++at.z())
            for (at.y() = 0; at.y() < m_grid.size.y(); ++at.y())
                for (at.x() = 0; at.x() < m_grid.size.x(); ++at.x()) {
                    const Vec3 p = m_grid.origin + m_grid.cell * at.cast<double>().matrix();
                    m_force[m_grid.index(at)] = 0.02 * (p - centre);
                }
    }

    double gamma(const SewnMesh::Part&) const override { return 100; }
    void displace(const SheetView& sheet, const SewnMesh::Part& part, int begin, int end,
                  Columns& displacements) const override
    {
        for (int v = begin; v < end; ++v) {
            const Vec3 normal = sheet.outside(part, v);
            const double push = std::max(0.0, normal.dot(force(sheet.position(v))));
            displacements.col(v).head<3>() = 0.5 * push * normal;
        }
    }

private:
    /// Between the eight nearest voxels.
    Vec3 force(const Vec3& p) const
    {
        const Eigen::Array3d place = m_grid.place(p);
        const Eigen::Array3i low = place.cast<int>();
        const Eigen::Array3d far = place - low.cast<double>();
        Vec3 sum = Vec3::Zero();
        for (int corner = 0; corner < 8; ++corner) {
            const Eigen::Array3i step(corner & 1, corner >> 1 & 1, corner >> 2);
            const double weight = (step == 0).select(1 - far, far).prod();
            sum += weight * m_force[m_grid.index(low + step)];
        }
        return sum;
    }

    Grid m_grid;
    std::vector<Vec3> m_force;
};

class Scan : public GhostSource {
public:
    Scan(const SewnMesh& mesh, int points)
        : m_grid(around(20), 10)
        , m_start(m_grid.count() + 1, 0)
        , m_nearest(Columns::Zero(4, mesh.vertexCount()))
    {
        std::mt19937 random(1);
        std::vector<std::pair<std::size_t, Vec3>> sorted;
        for (int k = 0; k < points; ++k) {
            const Vec3 p = pointOnSeat(random);
            sorted.emplace_back(m_grid.index(m_grid.place(p).cast<int>()), p);
        }
        std::ranges::sort(sorted, {}, &std::pair<std::size_t, Vec3>::first);
        for (const auto& [cell, p] : sorted) {
            ++m_start[cell + 1];
            m_points.push_back(p);
        }
        for (std::size_t c = 0; c < m_grid.count(); ++c)
            m_start[c + 1] += m_start[c];
    }

    double gamma(const SewnMesh::Part&) const override { return 1e4; }
    void follow(const SheetView& sheet, WorkerPool& pool) override
    {
        pool.forChunks(sheet.mesh.vertexCount(), [&](int, int begin, int end) {
            for (int v = begin; v < end; ++v)
                m_nearest.col(v).head<3>() = nearest(sheet.position(v));
        });
    }
    void displace(const SheetView& sheet, const SewnMesh::Part& part, int begin, int end,
                  Columns& displacements) const override
    {
        for (int v = begin; v < end; ++v) {
            const Vec3 normal = sheet.outside(part, v);
            const Vec3 way = m_nearest.col(v).head<3>() - sheet.position(v);
            displacements.col(v).head<3>() = normal.dot(way) * normal;
        }
    }

private:
    /// On the top or one of the panels, a little outside.
    static Vec3 pointOnSeat(std::mt19937& random)
    {
        std::uniform_real_distribution<double> uniform;
        const Box3 box = around(5);
        Vec3 p = box.min() + Vec3(uniform(random), uniform(random), uniform(random)).cwiseProduct(box.sizes());
        const unsigned face = random() % 8;
        if (face < 4)
            p[face / 2] = face % 2 == 0 ? box.min()[face / 2] : box.max()[face / 2];
        else
            p.z() = box.max().z();
        return p;
    }

    /// The point itself when there is none in its cell and the 26 around it.
    Vec3 nearest(const Vec3& p) const
    {
        const Eigen::Array3i at = m_grid.place(p).cast<int>();
        const Eigen::Array3i low = (at - 1).max(0), high = (at + 1).min(m_grid.size - 1);
        Vec3 best = p;
        double bestDistance = std::numeric_limits<double>::infinity();
        for (int z = low.z(); z <= high.z(); ++z)
            for (int y = low.y(); y <= high.y(); ++y) {
                const std::size_t first = m_start[m_grid.index({low.x(), y, z})];
                const std::size_t last = m_start[m_grid.index({high.x(), y, z}) + 1];
                for (std::size_t k = first; k < last; ++k) {
                    const double distance = (m_points[k] - p).squaredNorm();
                    if (distance < bestDistance) {
                        bestDistance = distance;
                        best = m_points[k];
                    }
                }
            }
        return best;
    }

    Grid m_grid;
    std::vector<std::size_t> m_start; // of each cell's points, and one more
    std::vector<Vec3> m_points;
    Columns m_nearest; // per vertex
};

template <class Source, class... Arguments>
Ghosts only(Arguments&&... arguments)
{
    Ghosts ghosts;
    ghosts.push_back(std::make_unique<Source>(std::forward<Arguments>(arguments)...));
    return ghosts;
}

} // namespace

Ghosts standInCushion(const SewnMesh&)
{
    return only<Cushion>();
}

Ghosts standInScan(const SewnMesh& mesh, int points)
{
    return only<Scan>(mesh, points);
}

} // namespace bolster::bench
