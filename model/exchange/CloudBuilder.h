// What all readers of scans share: limits and checks.
#pragma once

#include "FileRefused.h"
#include "MeshBuilder.h"
#include "PointCloud.h"

namespace bolster {

class CloudBuilder {
public:
    /// Makes room for points that a header promises and the file has the bytes for.
    void reservePoints(std::uint64_t count, FilePlace place)
    {
        requireRoom(count, place);
        m_cloud.points.reserve(static_cast<std::size_t>(count));
    }

    /// Leaves out what is not finite; refuses what is too large, and more points than the limit.
    void addPoint(const Vec3& point, FilePlace place)
    {
        if (!point.allFinite())
            return;
        if (!(point.array().abs() <= largestMeshCoordinate).all())
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the point is not finite, or beyond 10,000,000"));
        requireRoom(m_cloud.points.size() + 1, place);
        m_cloud.points.push_back(point);
    }

    /// Refuses an empty one.
    PointCloud finish()
    {
        if (m_cloud.points.empty())
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 holds no points"));
        return std::move(m_cloud);
    }

private:
    static void requireRoom(std::uint64_t count, FilePlace place)
    {
        if (count > largestMeshCount)
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the scan is too large, the limit is %2 points"),
                       {std::to_string(largestMeshCount)});
    }

    PointCloud m_cloud;
};

} // namespace bolster
