// What all mesh readers share: limits, checks, welding, and polygons split into triangles.
#pragma once

#include "FaceDoubles.h"
#include "FileRefused.h"
#include "TriangleMesh.h"

#include <map>
#include <span>

namespace bolster {

inline constexpr double largestMeshCoordinate = 1e7;          ///< file units
inline constexpr std::uint64_t largestMeshCount = 20'000'000; ///< points, and triangles

inline constexpr std::size_t mostFaceCorners = 10'000;

class MeshBuilder {
public:
    MeshBuilder();

    std::uint64_t pointCount() const { return m_points.size(); }
    /// Makes room for points that a header promises and the file has the bytes for.
    void reservePoints(std::uint64_t count, FilePlace place);

    /// Refuses coordinates that are not finite or too large, and more points than the limit.
    std::uint32_t addPoint(const Vec3& point, FilePlace place);
    /// The same, but a point that is there already is used again.
    std::uint32_t addWeldedPoint(const Vec3& point, FilePlace place);

    /// Triangles belong to this part from now on; a name that was there continues that part.
    void beginPart(std::string_view name);
    /// A face by indices from 0. Refuses indices out of range, and faces with too many corners. Corners that repeat
    /// their predecessor are dropped, and so are faces with fewer than three corners.
    void addFace(std::span<const std::int64_t> corners, FilePlace place);

    /// The mesh, without points that no triangle uses. Refuses one without triangles.
    TriangleMesh finish();

private:
    struct Part {
        std::string name;
        std::vector<std::array<std::uint32_t, 3>> triangles;
    };

    void addTriangle(std::array<std::uint32_t, 3> triangle, FilePlace place);
    bool turnLikeItsDouble();
    Part& currentPart(FilePlace place);
    void growWelding();
    std::size_t weldingSlot(const Vec3& point) const;

    std::vector<Vec3> m_points;
    std::vector<Part> m_parts; // made when their first triangle comes
    std::map<std::string, std::size_t, std::less<>> m_partByName;
    std::string m_partName;
    std::size_t m_part = noPart;
    std::uint64_t m_triangleCount = 0;
    bool m_anyFace = false; // also of those that are dropped

    std::vector<std::uint32_t> m_face; // scratch of addFace
    std::vector<Vec3> m_corners;
    std::vector<std::array<std::uint32_t, 3>> m_split;
    std::int64_t m_effort = 1'000'000'000; // a few seconds of splitting concave faces

    std::vector<std::uint32_t> m_welded; // open addressing: index of a point + 1, or 0
    std::uint64_t m_weldingSeed;         // random, so that no file can be made to collide
    FaceDoubles m_doubles;
    static constexpr std::size_t noPart = static_cast<std::size_t>(-1);
};

} // namespace bolster
