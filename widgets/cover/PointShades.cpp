#include "PointShades.h"

#include <Eigen/Eigenvalues>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <unordered_map>

namespace bolster {

namespace {

constexpr double wantedInCell = 6;
constexpr int mostCells = 1 << 19; // along an axis
constexpr float unknown = 0.75F;   // of points that have too few beside them

/// Points of a cube of a grid, from the middle of all.
struct Cell {
    double count = 0;
    Vec3 sum = Vec3::Zero();
    Eigen::Matrix3d squares = Eigen::Matrix3d::Zero();

    void add(const Vec3& point)
    {
        ++count;
        sum += point;
        squares += point * point.transpose();
    }
    void add(const Cell& other)
    {
        count += other.count;
        sum += other.sum;
        squares += other.squares;
    }
};

class ShadedCloud {
public:
    explicit ShadedCloud(const std::vector<Vec3>& points)
        : m_points(points)
    {
        for (const Vec3& point : points)
            m_box.extend(point);
    }

    std::vector<float> shades()
    {
        std::vector<float> shades(m_points.size(), unknown);
        const double size = m_box.isEmpty() ? 0 : m_box.sizes().maxCoeff();
        if (!(size > 0) || !std::isfinite(size))
            return shades;
        fill(size / 64);
        // Of a surface the cells are as many as its area has squares of that size.
        const double filled = static_cast<double>(m_points.size()) / static_cast<double>(m_cells.size());
        fill(std::max(size / mostCells, m_edge * std::sqrt(wantedInCell / filled)));
        std::unordered_map<std::uint64_t, float> ofCell;
        for (const auto& [key, cell] : m_cells)
            ofCell.emplace(key, shade(key));
        for (std::size_t i = 0; i < m_points.size(); ++i)
            shades[i] = ofCell.at(keyOf(m_points[i]));
        return shades;
    }

private:
    static std::uint64_t packed(const std::array<std::uint64_t, 3>& at)
    {
        return at[0] << 42U | at[1] << 21U | at[2];
    }
    std::uint64_t keyOf(const Vec3& point) const
    {
        std::array<std::uint64_t, 3> at{};
        for (int axis = 0; axis < 3; ++axis) // from 1: each cell has neighbours
            at[static_cast<std::size_t>(axis)] =
                1 + static_cast<std::uint64_t>((point[axis] - m_box.min()[axis]) / m_edge);
        return packed(at);
    }

    void fill(double edge)
    {
        m_edge = edge;
        m_cells.clear();
        const Vec3 middle = m_box.center();
        for (const Vec3& point : m_points)
            m_cells[keyOf(point)].add(point - middle);
    }

    float shade(std::uint64_t key) const
    {
        Cell around;
        for (std::uint64_t x = 0; x < 3; ++x)
            for (std::uint64_t y = 0; y < 3; ++y)
                for (std::uint64_t z = 0; z < 3; ++z)
                    if (const auto cell = m_cells.find(key + packed({x, y, z}) - packed({1, 1, 1}));
                        cell != m_cells.end())
                        around.add(cell->second);
        if (around.count < 4)
            return unknown;
        const Vec3 middle = around.sum / around.count;
        Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes;
        axes.computeDirect(around.squares / around.count - middle * middle.transpose());
        const Vec3 normal = axes.eigenvectors().col(0);
        const Vec3 light = Vec3(-0.35, -0.6, 0.72).normalized();
        // Nobody knows which side is the outer one.
        return normal.allFinite() ? static_cast<float>(0.3 + 0.7 * std::abs(normal.dot(light))) : unknown;
    }

    const std::vector<Vec3>& m_points;
    Box3 m_box;
    double m_edge = 0;
    std::unordered_map<std::uint64_t, Cell> m_cells;
};

} // namespace

std::vector<float> pointShades(const std::vector<Vec3>& points)
{
    return ShadedCloud(points).shades();
}

} // namespace bolster
