#include "ScanIndex.h"

#include "WorkerPool.h"

#include <Eigen/Eigenvalues>
#include <flann/algorithms/dist.h>
#include <flann/algorithms/kdtree_single_index.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

using Distance = flann::L2_Simple<float>;

// Of a point: so many that they surround it, so few that what is a few points wide is seen.
constexpr std::size_t neighbours = 8;

/// The two nearest points of a search that begins with a bound.
class TwoNearest : public flann::ResultSet<float> {
public:
    explicit TwoNearest(float bound)
        : m_distances{bound, bound}
    {}

    bool full() const override { return true; }
    float worstDist() const override { return m_distances[1]; }
    void addPoint(float distance, std::size_t index) override
    {
        if (distance >= m_distances[1])
            return;
        const bool nearest = distance < m_distances[0];
        if (nearest) {
            m_distances[1] = m_distances[0];
            m_indices[1] = m_indices[0];
        }
        m_distances[nearest ? 0 : 1] = distance;
        m_indices[nearest ? 0 : 1] = static_cast<int>(index);
    }
    int index(int rank) const { return m_indices[static_cast<std::size_t>(rank)]; }

private:
    std::array<float, 2> m_distances; // squared
    std::array<int, 2> m_indices = {-1, -1};
};

} // namespace

/// Relative to the middle of the points, so that floats are exact enough.
struct ScanIndex::Tree {
    explicit Tree(const std::vector<Vec3>& points)
        : rows(makeRows(points))
        , kdTree(flann::Matrix<float>(rows.data(), points.size(), 3), flann::KDTreeSingleIndexParams(8))
    {
        kdTree.buildIndex();
    }

    std::vector<float> makeRows(const std::vector<Vec3>& points)
    {
        Box3 box;
        for (const Vec3& point : points)
            box.extend(point);
        middle = box.center();
        std::vector<float> coordinates;
        coordinates.reserve(3 * points.size());
        for (const Vec3& point : points)
            for (const double x : point - middle)
                coordinates.push_back(static_cast<float>(x));
        return coordinates;
    }

    Eigen::Vector3f local(const Vec3& at) const { return (at - middle).cast<float>(); }

    Vec3 middle = Vec3::Zero();
    std::vector<float> rows;
    flann::KDTreeSingleIndex<Distance> kdTree;
};

ScanIndex::ScanIndex(const PointCloud& cloud, const std::vector<ScanCut>& cuts, const std::stop_token& stop)
{
    m_points.reserve(cloud.points.size());
    std::copy_if(cloud.points.begin(), cloud.points.end(), std::back_inserter(m_points), [&](const Vec3& point) {
        return std::none_of(cuts.begin(), cuts.end(), [&](const ScanCut& cut) { return cut.removes(point); });
    });
    m_points.shrink_to_fit();
    if (m_points.empty())
        return;
    m_tree = std::make_unique<Tree>(m_points);
    m_normals.assign(m_points.size(), Eigen::Vector3f::UnitZ());
    std::vector<float> distances(m_points.size());
    WorkerPool pool(0);
    pool.forChunks(size(), [&](int, int begin, int end) {
        for (int i = begin; i < end && !stop.stop_requested(); ++i)
            distances[i] = lookAround(static_cast<std::size_t>(i));
    });
    // Scanners see what is far less densely, so the median.
    std::nth_element(distances.begin(), distances.begin() + std::ssize(distances) / 2, distances.end());
    m_spacing = std::sqrt(distances[distances.size() / 2] * std::numbers::pi / neighbours);
}

ScanIndex::~ScanIndex() = default;

float ScanIndex::lookAround(std::size_t point)
{
    flann::KNNSimpleResultSet<float> nearest(neighbours + 1); // and the point itself
    m_tree->kdTree.findNeighbors(nearest, m_tree->local(m_points[point]).data(), flann::SearchParams(-1));
    const std::size_t count = std::min(nearest.size(), neighbours + 1);
    std::array<std::size_t, neighbours + 1> indices{};
    std::array<float, neighbours + 1> squares{};
    nearest.copy(indices.data(), squares.data(), count);
    Eigen::Vector3f mean = Eigen::Vector3f::Zero();
    for (std::size_t k = 0; k < count; ++k)
        mean += m_tree->local(m_points[indices[k]]) / static_cast<float>(count);
    Eigen::Matrix3f spread = Eigen::Matrix3f::Zero();
    for (std::size_t k = 0; k < count; ++k) {
        const Eigen::Vector3f offset = m_tree->local(m_points[indices[k]]) - mean;
        spread += offset * offset.transpose();
    }
    Eigen::SelfAdjointEigenSolver<Eigen::Matrix3f> axes;
    axes.computeDirect(spread);
    if (const Eigen::Vector3f normal = axes.eigenvectors().col(0);
        normal.allFinite() && normal.squaredNorm() > 0.5F)
        m_normals[point] = normal;
    return squares[count - 1];
}

ScanIndex::Nearest ScanIndex::search(const Vec3& at, double radius) const
{
    Nearest found;
    if (empty())
        return found;
    TwoNearest nearest(static_cast<float>(radius * radius));
    m_tree->kdTree.findNeighbors(nearest, m_tree->local(at).data(), flann::SearchParams(-1));
    found.first = nearest.index(0);
    found.second = nearest.index(1);
    if (found.first >= 0)
        found.firstDistance = (point(found.first) - at).norm();
    if (found.second >= 0)
        found.secondDistance = (point(found.second) - at).norm();
    return found;
}

int ScanMatch::follow(const ScanIndex& index, const Vec3& at, double radius)
{
    if ((at - m_at).norm() < m_safe)
        return m_first;
    constexpr double farther = 1.1; // so that what has nothing near needs not be searched for every time
    double bound = farther * radius;
    if (m_second >= 0) { // a little more, because distances are compared as floats
        const double known = std::max((index.point(m_first) - at).norm(), (index.point(m_second) - at).norm());
        bound = std::min(bound, 1.001 * known);
    }
    const ScanIndex::Nearest nearest = index.search(at, bound);
    m_at = at;
    m_first = nearest.first;
    m_second = nearest.second;
    if (m_first < 0)
        m_safe = bound - radius;
    else
        m_safe = 0.5 * (std::min(bound, nearest.secondDistance) - nearest.firstDistance);
    return m_first;
}

} // namespace bolster
