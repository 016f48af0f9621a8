#include "MeshScan.h"

#include "CloudBuilder.h"
#include "CloudReaders.h"
#include "MeshReaders.h"
#include "TextScanner.h"

#include <algorithm>
#include <cmath>

namespace bolster {
namespace {

constexpr double gapsAcross = 400;         // in the diagonal of the mesh
constexpr double mostFilling = 500'000;    // points
constexpr double largeTriangle = 8;        // gaps long: smaller ones are a scanner's, and stay as they are
constexpr std::size_t denseMesh = 200'000; // corners: it is seen as it is
constexpr std::size_t trianglesBetweenChecks = 1 << 12;

struct FilledTriangle {
    Vec3 a, ab, ac;

    FilledTriangle(const TriangleMesh& mesh, const std::array<std::uint32_t, 3>& corners)
        : a(mesh.points[corners[0]])
        , ab(mesh.points[corners[1]] - a)
        , ac(mesh.points[corners[2]] - a)
    {}
    double area() const { return 0.5 * ab.cross(ac).norm(); }
    bool isLarge(double gap) const
    {
        return std::max({ab.norm(), ac.norm(), (ab - ac).norm()}) > largeTriangle * gap;
    }
};

/// Two numbers from 0 to 1 that fill the square evenly, one pair after the other. Source: M. Roberts, "The
/// Unreasonable Effectiveness of Quasirandom Sequences", 2018.
Vec2 evenPair(std::uint64_t number)
{
    constexpr double root = 1.32471795724474602596; // of x^3 = x + 1
    const Vec2 far = (static_cast<double>(number) + 0.5) * Vec2(1 / root, 1 / (root * root));
    return far - Vec2(far.array().floor());
}

double areaOfLarge(const TriangleMesh& mesh, double gap, const ImportWatch& watch)
{
    double area = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i % trianglesBetweenChecks == 0)
            watch.checkStop();
        if (const FilledTriangle triangle(mesh, mesh.triangles[i]); triangle.isLarge(gap))
            area += triangle.area();
    }
    return area;
}

/// The corners of a mesh as a scan. A frame's reader says what is wrong with the mesh.
PointCloud scanOfMesh(const TriangleMesh& mesh, const FileBytes& bytes)
{
    CloudBuilder builder(bytes);
    for (const Vec3& point : mesh.points)
        builder.addPoint(point, {});
    PointCloud cloud = builder.finish();
    fillLargeTriangles(cloud, mesh, bytes.watch());
    return cloud;
}

/// What is behind the points of a file may be broken: they are a scan without it.
void fillFrom(PointCloud& cloud, TriangleMesh (*read)(const FileBytes&), const FileBytes& bytes)
{
    if (!cloud.colors.empty() || cloud.points.size() > denseMesh)
        return;
    try {
        fillLargeTriangles(cloud, read(bytes.quietly()), bytes.watch());
    } catch (const FileRefused&) { // NOLINT(bugprone-empty-catch)
    }
}

/// Behind the coordinates, as programs for meshes write it: 0 to 1, or bytes.
std::optional<std::uint32_t> objColor(TextScanner& text)
{
    std::array<double, 3> channels{};
    for (double& channel : channels) {
        const std::string_view word = text.word();
        if (word.empty())
            return std::nullopt;
        channel = text.number(word);
    }
    if (text.moreOnLine() || !std::ranges::all_of(channels, [](double c) { return c >= 0 && c <= 255; }))
        return std::nullopt;
    const bool bytes = std::ranges::any_of(channels, [](double c) { return c > 1; });
    std::uint32_t color = 0;
    for (const double channel : channels)
        color = color << 8 | static_cast<std::uint32_t>(std::lround(bytes ? channel : 255 * channel));
    return color;
}

} // namespace

void fillLargeTriangles(PointCloud& cloud, const TriangleMesh& mesh, const ImportWatch& watch)
{
    Box3 box;
    for (const Vec3& point : mesh.points)
        box.extend(point);
    double gap = box.isEmpty() ? 0 : box.diagonal().norm() / gapsAcross;
    if (!(gap > 0) || cloud.thinnedFrom > 0)
        return;
    const double room = std::min(mostFilling, static_cast<double>(mostCloudPoints - cloud.points.size()));
    const double area = areaOfLarge(mesh, gap, watch);
    const double perPoint = std::max(gap * gap, area / std::max(room, 1.0));
    double due = 0; // what small parts of a surface leave goes to the next one
    std::uint64_t number = 0;
    for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
        if (i % trianglesBetweenChecks == 0)
            watch.checkStop();
        const FilledTriangle triangle(mesh, mesh.triangles[i]);
        if (!triangle.isLarge(gap))
            continue;
        for (due += triangle.area() / perPoint; due >= 1 && cloud.points.size() < mostCloudPoints; --due) {
            Vec2 at = evenPair(number++);
            if (at.sum() > 1)
                at = Vec2(1 - at.x(), 1 - at.y());
            cloud.points.emplace_back(triangle.a + at.x() * triangle.ab + at.y() * triangle.ac);
        }
    }
}

PointCloud readObjScan(const FileBytes& bytes)
{
    TextScanner text(bytes);
    CloudBuilder builder(bytes);
    bool faces = false;
    while (text.nextLine()) {
        const std::string_view keyword = text.word();
        faces = faces || keyword == "f";
        if (keyword != "v")
            continue;
        const double x = text.number(), y = text.number(), z = text.number();
        builder.addPoint({x, y, z}, text.place(), objColor(text));
    }
    PointCloud cloud = builder.finish();
    if (faces)
        fillFrom(cloud, readObj, bytes);
    return cloud;
}

PointCloud readPlyScan(const FileBytes& bytes)
{
    PointCloud cloud = readPlyCloud(bytes);
    fillFrom(cloud, readPly, bytes);
    return cloud;
}

PointCloud readStlScan(const FileBytes& bytes)
{
    return scanOfMesh(readStl(bytes), bytes);
}

PointCloud readOffScan(const FileBytes& bytes)
{
    return scanOfMesh(readOff(bytes), bytes);
}

} // namespace bolster
