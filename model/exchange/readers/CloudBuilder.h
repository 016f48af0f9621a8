// What all readers of scans share: limits and checks, and no more points than fit into memory.
#pragma once

#include "CloudThinner.h"
#include "FileBytes.h"
#include "MeshBuilder.h"

#include <algorithm>

namespace bolster {

inline constexpr std::uint64_t largestCloudCount = 2'000'000'000; ///< points in a file
inline constexpr std::size_t mostCloudPoints = 5'000'000;         ///< that are kept of them

class CloudBuilder {
public:
    explicit CloudBuilder(const FileBytes& bytes)
        : m_watch(bytes.watch())
        , m_thinner(mostCloudPoints, m_watch)
    {}

    /// Makes room for points that a header promises and the file has the bytes for.
    void reservePoints(std::uint64_t count, FilePlace place)
    {
        requireRoom(count, place);
        m_thinner.reserve(count);
    }

    /// Leaves out what is not finite; refuses what is too large, and more points than the limit.
    void addPoint(const Vec3& point, FilePlace place, std::optional<std::uint32_t> color = {})
    {
        if (!point.allFinite()) {
            ++m_leftOut;
            return;
        }
        if (!(point.array().abs() <= largestMeshCoordinate).all())
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the point is not finite, or beyond 10,000,000"));
        requireRoom(m_thinner.count() + 1, place);
        m_thinner.add(point, color);
    }

    /// Refuses an empty one.
    PointCloud finish()
    {
        if (m_thinner.count() == 0 && m_leftOut > 0)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1: none of its %2 points has a place"),
                       {std::to_string(m_leftOut)});
        if (m_thinner.count() == 0)
            refuseFile({}, QT_TRANSLATE_NOOP("Message", "%1 holds no points"));
        PointCloud cloud = m_thinner.take();
        // Some programs write black for what they do not know; of three numbers behind a point some are normals.
        if (std::ranges::none_of(cloud.colors, [](std::uint32_t color) { return (color & 0xfefefeU) != 0; }))
            cloud.colors = {};
        if (m_leftOut > 0 && m_watch.warn)
            m_watch.warn(QT_TRANSLATE_NOOP("Message", "%1: %2 points are left out: they have no place, as where a "
                                                      "scanner saw nothing"),
                         std::to_string(m_leftOut));
        return cloud;
    }

private:
    static void requireRoom(std::uint64_t count, FilePlace place)
    {
        if (count > largestCloudCount)
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the scan is too large, the limit is %2 points"),
                       {std::to_string(largestCloudCount)});
    }

    const ImportWatch& m_watch;
    CloudThinner m_thinner;
    std::uint64_t m_leftOut = 0;
};

} // namespace bolster
