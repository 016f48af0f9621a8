#include "ScanField.h"

#include "BoxTree.h"
#include "NearestOnTriangle.h"

#include <cmath>
#include <limits>
#include <numeric>

namespace bolster {

namespace {

constexpr double fewestPoints = 1;  // around a vertex
constexpr double leastAcross = 0.5; // cosine: what lies flatter to the cover is beside its border

/// A point of the scan as the cover sees it.
struct Seen {
    int triangle = -1;          ///< none: it does not belong to the cover
    Vec3 shares = Vec3::Zero(); ///< of the corners
    double outside = 0;
};

Vec3 sharesOf(const Vec3& at, const Vec3& a, const Vec3& b, const Vec3& c)
{
    const Vec3 whole = (b - a).cross(c - a);
    const double size = whole.squaredNorm();
    if (!(size > 0))
        return Vec3::UnitX();
    const double v = (at - a).cross(c - a).dot(whole) / size, w = (b - a).cross(at - a).dot(whole) / size;
    return {1 - v - w, v, w};
}

class CoverTree {
public:
    explicit CoverTree(const SurfaceMesh& cover)
        : m_cover(cover)
    {
        std::vector<std::uint32_t> all(cover.topology->triangles.size());
        std::iota(all.begin(), all.end(), 0U);
        m_tree.build(all, [&](std::uint32_t t) { return corners(t); });
    }

    Seen see(const Vec3& point, double within) const
    {
        double reach = within * within;
        Seen seen;
        Vec3 nearest = Vec3::Zero();
        m_tree.walk([&](const auto& box) { return box.squaredExteriorDistance(point); }, reach,
                    [&](std::uint32_t place) {
                        const std::uint32_t t = m_tree.order()[place];
                        const auto [a, b, c] = corners(t);
                        const Vec3 at = nearestOnTriangle(point, a, b, c);
                        if (const double distance = (point - at).squaredNorm(); distance < reach) {
                            reach = distance;
                            nearest = at;
                            seen.triangle = static_cast<int>(t);
                        }
                        return false;
                    });
        if (seen.triangle >= 0)
            measure(point, nearest, seen);
        return seen;
    }

private:
    BoxTree<double>::Triangle corners(std::uint32_t t) const
    {
        const auto& triangle = m_cover.topology->triangles[t];
        return {m_cover.positions[triangle[0]], m_cover.positions[triangle[1]], m_cover.positions[triangle[2]]};
    }

    void measure(const Vec3& point, const Vec3& nearest, Seen& seen) const
    {
        const auto [a, b, c] = corners(static_cast<std::uint32_t>(seen.triangle));
        const Vec3 normal = (b - a).cross(c - a).normalized();
        seen.outside = normal.dot(point - nearest);
        if (std::abs(seen.outside) < leastAcross * (point - nearest).norm())
            seen.triangle = -1;
        seen.shares = sharesOf(nearest, a, b, c);
    }

    const SurfaceMesh& m_cover;
    BoxTree<double> m_tree;
};

} // namespace

ScanField scanField(const SurfaceMesh& cover, const FitTarget& scan, WorkerPool& pool)
{
    const CoverTree tree(cover);
    std::vector<Seen> points(static_cast<std::size_t>(scan.index->size()));
    pool.forChunks(scan.index->size(), [&](int, int begin, int end) {
        for (int k = begin; k < end; ++k)
            points[static_cast<std::size_t>(k)] =
                tree.see(scan.place.placed(scan.index->point(k)), scan.place.threshold);
    });
    const std::size_t count = cover.positions.size();
    std::vector<double> sums(count, 0), weights(count, 0);
    std::vector<Eigen::Triplet<double>> shared;
    for (const Seen& seen : points) {
        if (seen.triangle < 0)
            continue;
        const auto& corners = cover.topology->triangles[static_cast<std::size_t>(seen.triangle)];
        for (int i = 0; i < 3; ++i) {
            sums[corners[i]] += seen.shares[i] * seen.outside;
            weights[corners[i]] += seen.shares[i];
            for (int j = 0; j < 3; ++j)
                shared.emplace_back(static_cast<int>(corners[i]), static_cast<int>(corners[j]),
                                    seen.shares[i] * seen.shares[j]);
        }
    }
    ScanField field;
    field.mean.resize(static_cast<Eigen::Index>(count), static_cast<Eigen::Index>(count));
    field.mean.setFromTriplets(shared.begin(), shared.end());
    field.outside.assign(count, std::numeric_limits<double>::quiet_NaN());
    for (std::size_t v = 0; v < count; ++v)
        if (weights[v] >= fewestPoints) {
            field.outside[v] = sums[v] / weights[v];
            field.mean.row(static_cast<Eigen::Index>(v)) /= weights[v];
        }
    return field;
}

} // namespace bolster
