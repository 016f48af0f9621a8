// The points of a scan, ready to be searched. In the units of its file, so that moving the scan changes nothing.
#pragma once

#include "PointCloud.h"
#include "Scan.h"

#include <limits>
#include <memory>
#include <stop_token>

namespace bolster {

/// Immutable; may be searched by several threads.
class ScanIndex {
public:
    /// Without the points that the cuts remove. When stopped, its normals and its spacing mean nothing.
    ScanIndex(const PointCloud& cloud, const std::vector<ScanCut>& cuts, const std::stop_token& stop = {});
    ~ScanIndex();

    bool empty() const { return m_points.empty(); }
    int size() const { return static_cast<int>(m_points.size()); }
    const Vec3& point(int i) const { return m_points[static_cast<std::size_t>(i)]; }
    /// Unit normal of the plane that the neighbours lie in, pointing to either side.
    Vec3 normal(int i) const { return m_normals[static_cast<std::size_t>(i)].cast<double>(); }
    /// The usual distance of neighbours: 1 / sqrt(points per area).
    double spacing() const { return m_spacing; }

    /// The two nearest points; -1 where there is none within the radius.
    struct Nearest {
        int first = -1;
        int second = -1;
        double firstDistance = std::numeric_limits<double>::infinity();
        double secondDistance = std::numeric_limits<double>::infinity();
    };
    Nearest search(const Vec3& at, double radius) const;

private:
    struct Tree;

    /// Squared distance of the last of its neighbours, file units.
    float lookAround(std::size_t point);

    std::vector<Vec3> m_points;
    std::vector<Eigen::Vector3f> m_normals;
    std::unique_ptr<Tree> m_tree;
    double m_spacing = 0;
};

/// A nearest point that is searched for again only when another one may have come nearer.
class ScanMatch {
public:
    /// The nearest point to `at`, or -1 when none lies within `radius`.
    int follow(const ScanIndex& index, const Vec3& at, double radius);

private:
    Vec3 m_at = Vec3::Zero(); // of the last search
    double m_safe = -1;       // so far from there nothing changes
    int m_first = -1;
    int m_second = -1;
};

} // namespace bolster
