#include "MeshBuilder.h"

#include "MeshReaders.h"

#include "PlaceHash.h"
#include "PolygonSplit.h"

#include <algorithm>
#include <random>

namespace bolster {
namespace {

constexpr std::size_t largestPartCount = 100'000;

[[noreturn]] void refuseCount(FilePlace place)
{
    refuseFile(place,
               QT_TRANSLATE_NOOP("Message", "%1: the mesh is too large, the limit is %2 points and as many "
                                            "triangles"),
               {std::to_string(largestMeshCount)});
}

/// A stray point would make the frame look larger than it is.
void dropUnusedPoints(TriangleMesh& mesh)
{
    std::vector<std::uint32_t> newIndex(mesh.points.size(), 0);
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle)
            newIndex[index] = 1;
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        if (newIndex[i] == 0)
            continue;
        mesh.points[kept] = mesh.points[i];
        newIndex[i] = kept++;
    }
    mesh.points.resize(kept);
    for (auto& triangle : mesh.triangles)
        for (std::uint32_t& index : triangle)
            index = newIndex[index];
}

} // namespace

MeshBuilder::MeshBuilder()
    : m_weldingSeed(std::random_device{}())
    , m_doubles(m_weldingSeed)
{}

void MeshBuilder::reservePoints(std::uint64_t count, FilePlace place)
{
    if (count > largestMeshCount)
        refuseCount(place);
    m_points.reserve(static_cast<std::size_t>(count));
}

std::uint32_t MeshBuilder::addPoint(const Vec3& point, FilePlace place)
{
    if (!(point.array().abs() <= largestMeshCoordinate).all()) // so that NaN is refused too
        refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the point is not finite, or beyond 10,000,000"));
    if (m_points.size() >= largestMeshCount)
        refuseCount(place);
    m_points.push_back(point);
    return static_cast<std::uint32_t>(m_points.size() - 1);
}

std::uint32_t MeshBuilder::addWeldedPoint(const Vec3& point, FilePlace place)
{
    if (2 * m_points.size() >= m_welded.size())
        growWelding();
    const Vec3 positive = point + Vec3::Zero(); // -0 is the same place as 0
    const std::size_t slot = weldingSlot(positive);
    if (m_welded[slot] == 0)
        m_welded[slot] = addPoint(positive, place) + 1;
    return m_welded[slot] - 1;
}

void MeshBuilder::growWelding()
{
    m_welded.assign(std::max<std::size_t>(1024, 2 * m_welded.size()), 0);
    for (std::size_t i = 0; i < m_points.size(); ++i)
        m_welded[weldingSlot(m_points[i])] = static_cast<std::uint32_t>(i + 1);
}

std::size_t MeshBuilder::weldingSlot(const Vec3& point) const
{
    const std::size_t mask = m_welded.size() - 1; // the size is a power of two
    std::size_t slot = placeHash(point, m_weldingSeed) & mask;
    while (m_welded[slot] != 0 && m_points[m_welded[slot] - 1] != point)
        slot = (slot + 1) & mask;
    return slot;
}

void MeshBuilder::beginPart(std::string_view name)
{
    m_partName = name.substr(0, 200);
    m_part = noPart;
}

void MeshBuilder::addFace(std::span<const std::int64_t> corners, FilePlace place)
{
    if (corners.size() > mostFaceCorners) // splitting them takes the square of it
        refuseFile(place,
                   QT_TRANSLATE_NOOP("Message", "%1: a face has %2 corners, and at most %3 are read; have it split "
                                                "into triangles by the program that has made the file"),
                   {std::to_string(corners.size()), std::to_string(mostFaceCorners)});
    m_anyFace = true;
    m_face.clear();
    for (const std::int64_t corner : corners) {
        if (corner < 0 || static_cast<std::uint64_t>(corner) >= m_points.size())
            refuseFile(place,
                       QT_TRANSLATE_NOOP("Message", "%1: a face refers to point %2, but there are %3 points"),
                       {std::to_string(corner + 1), std::to_string(m_points.size())});
        const auto index = static_cast<std::uint32_t>(corner);
        if (m_face.empty() || m_face.back() != index)
            m_face.push_back(index);
    }
    while (m_face.size() > 1 && m_face.back() == m_face.front())
        m_face.pop_back();
    if (m_face.size() == 3) {
        addTriangle({m_face[0], m_face[1], m_face[2]}, place);
    } else if (m_face.size() > 3) {
        const bool turned = turnLikeItsDouble();
        m_corners.clear();
        for (const std::uint32_t index : m_face)
            m_corners.push_back(m_points[index]);
        m_split.clear();
        splitPolygon(m_corners, m_split, m_effort);
        for (const auto& [a, b, c] : m_split)
            addTriangle({m_face[a], m_face[turned ? c : b], m_face[turned ? b : c]}, place);
    }
}

/// A face that was there before becomes the same triangles, also when its corners are listed from another one or
/// the other way round: bodies whose faces are all there twice are told by that. True if it is the other way round.
bool MeshBuilder::turnLikeItsDouble()
{
    m_corners.clear();
    for (const std::uint32_t index : m_face)
        m_corners.push_back(m_points[index]);
    const FaceDoubles::Order order = m_doubles.meet(m_corners);
    if (order.backwards)
        std::ranges::reverse(m_face);
    const auto first = m_face.begin() + static_cast<std::ptrdiff_t>(order.first);
    std::rotate(m_face.begin(), first, m_face.end());
    return order.backwards;
}

void MeshBuilder::addTriangle(std::array<std::uint32_t, 3> triangle, FilePlace place)
{
    const auto [a, b, c] = triangle;
    if (a == b || b == c || c == a)
        return;
    if (++m_triangleCount > largestMeshCount)
        refuseCount(place);
    currentPart(place).triangles.push_back(triangle);
}

MeshBuilder::Part& MeshBuilder::currentPart(FilePlace place)
{
    if (m_part == noPart) {
        m_part = m_partByName.try_emplace(m_partName, m_parts.size()).first->second;
        if (m_part == m_parts.size())
            m_parts.push_back({m_partName, {}});
        if (m_parts.size() > largestPartCount)
            refuseFile(place, QT_TRANSLATE_NOOP("Message", "%1: the mesh has too many groups, the limit is %2"),
                       {std::to_string(largestPartCount)});
    }
    return m_parts[m_part];
}

TriangleMesh MeshBuilder::finish()
{
    constexpr auto* noArea = QT_TRANSLATE_NOOP("Message", "%1: none of its triangles has an area");
    if (m_triangleCount == 0)
        refuseFile({}, m_points.empty() ? QT_TRANSLATE_NOOP("Message", "%1 holds no mesh")
                       : m_anyFace      ? noArea
                                        : holdsPointsOnly);
    TriangleMesh mesh;
    mesh.triangles.reserve(m_triangleCount);
    for (Part& part : m_parts) {
        mesh.parts.push_back({std::move(part.name), static_cast<std::uint32_t>(mesh.triangles.size()),
                              static_cast<std::uint32_t>(part.triangles.size())});
        mesh.triangles.insert(mesh.triangles.end(), part.triangles.begin(), part.triangles.end());
        std::vector<std::array<std::uint32_t, 3>>().swap(part.triangles); // never twice in memory
    }
    mesh.points = std::move(m_points);
    const bool flat = std::ranges::none_of(mesh.triangles, [&](const auto& t) {
        return (mesh.points[t[1]] - mesh.points[t[0]]).cross(mesh.points[t[2]] - mesh.points[t[0]]).norm() > 0;
    });
    if (flat) // a cover would have nothing to lie on
        refuseFile({}, noArea);
    dropUnusedPoints(mesh);
    return mesh;
}

} // namespace bolster
