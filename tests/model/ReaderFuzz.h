// One run of a reader of meshes or scans over any bytes; for the tests of every build and for the fuzzers.
#pragma once

#include "FileBytes.h"
#include "PointCloud.h"
#include "TriangleMesh.h"

#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <optional>

namespace bolster::test {

inline void mustBe(bool condition, const char* what)
{
    if (condition)
        return;
    std::fprintf(stderr, "broken: %s\n", what);
    std::abort();
}

inline void checkPoints(const std::vector<Vec3>& points)
{
    mustBe(!points.empty(), "there are points");
    for (const Vec3& point : points)
        mustBe((point.array().abs() <= 1e7).all(), "points are finite and not far away");
}

inline void checkContent(const PointCloud& cloud)
{
    checkPoints(cloud.points);
}

inline void checkContent(const TriangleMesh& mesh)
{
    checkPoints(mesh.points);
    mustBe(!mesh.triangles.empty(), "there are triangles");
    for (const auto& triangle : mesh.triangles)
        for (const std::uint32_t index : triangle)
            mustBe(index < mesh.points.size(), "triangles have points");
    std::uint32_t covered = 0;
    for (const TriangleMesh::Part& part : mesh.parts) {
        mustBe(part.firstTriangle == covered, "parts follow each other");
        covered += part.triangleCount;
    }
    mustBe(covered == mesh.triangles.size(), "parts have all triangles");
}

inline bool isSame(const PointCloud& a, const PointCloud& b)
{
    return a.points == b.points;
}

inline bool isSame(const TriangleMesh& a, const TriangleMesh& b)
{
    return a.points == b.points && a.triangles == b.triangles;
}

/// As from a disk, a few bytes at a time.
inline FileBytes inPieces(std::string_view bytes, std::size_t piece)
{
    const auto read = [bytes](std::uint64_t at, char* to, std::size_t count) {
        mustBe(at <= bytes.size() && count <= bytes.size() - at, "nothing is read beyond the end");
        if (count > 0) // an empty file has no bytes to point to
            std::memcpy(to, bytes.data() + at, count);
        return true;
    };
    return {read, bytes.size(), {}, piece};
}

template <class Content>
std::optional<Content> readOrRefuse(Content (*read)(const FileBytes&), const FileBytes& bytes)
{
    try {
        return read(bytes);
    } catch (const FileRefused& refused) {
        mustBe(!refused.sentence.empty(), "a refusal has a reason");
        return std::nullopt;
    }
}

/// Aborts when the reader returns something that is not sound, or something else when it gets the bytes piece by
/// piece. Says whether it returned anything.
template <class Content>
bool fuzzReader(Content (*read)(const FileBytes&), std::string_view bytes)
{
    const auto whole = readOrRefuse(read, bytes);
    const auto pieces = readOrRefuse(read, inPieces(bytes, 24));
    mustBe(whole.has_value() == pieces.has_value(), "pieces are refused when the whole is");
    if (!whole)
        return false;
    checkContent(*whole);
    mustBe(isSame(*whole, *pieces), "pieces say what the whole says");
    return true;
}

} // namespace bolster::test
