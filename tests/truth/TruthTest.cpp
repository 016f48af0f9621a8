// How far reconstructions lie from the true surfaces. Prints the figures.
#include "DesignFile.h"
#include "MeshImport.h"
#include "RestingSolve.h"
#include "TestPaths.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <iostream>

namespace bolster {
namespace {

using Kernel = CGAL::Simple_cartesian<double>;
using Triangles = std::vector<Kernel::Triangle_3>;
using Tree = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_triangle_primitive<Kernel, Triangles::iterator>>>;

Kernel::Point_3 toCgal(const Vec3& p)
{
    return {p.x(), p.y(), p.z()};
}

struct Distances {
    double rms = 0;
    double median = 0;
    double largest = 0;
};

Distances distancesTo(const TriangleMesh& truth, const SurfaceMesh& surface)
{
    Triangles triangles;
    for (const auto& t : truth.triangles)
        triangles.emplace_back(toCgal(truth.points[t[0]]), toCgal(truth.points[t[1]]), toCgal(truth.points[t[2]]));
    const Tree tree(triangles.begin(), triangles.end());
    std::vector<double> distances;
    double squares = 0;
    for (const Vec3& p : surface.positions) {
        const double squared = tree.squared_distance(toCgal(p));
        squares += squared;
        distances.push_back(std::sqrt(squared));
    }
    std::sort(distances.begin(), distances.end());
    const auto count = distances.size();
    return {std::sqrt(squares / static_cast<double>(count)), distances[count / 2], distances.back()};
}

SolveResult solved(const std::string& designPath)
{
    const OpenedDesign opened = openDesign(QString::fromStdString(designPath));
    EXPECT_TRUE(opened.readable) << designPath;
    SolveResult result = solveResting({opened.design, opened.files}, {});
    EXPECT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
    return result;
}

std::shared_ptr<const TriangleMesh> truthOf(const std::string& name)
{
    const ImportedMesh truth = importMesh(QString::fromStdString(test::dataFolder() + "/truth/" + name));
    EXPECT_TRUE(truth.mesh) << truth.problem.english();
    return truth.mesh;
}

Distances distancesOf(const std::string& designPath, const std::string& truthName)
{
    const SolveResult result = solved(designPath);
    const auto truth = truthOf(truthName);
    if (!truth || !result.surface)
        return {1e9, 1e9, 1e9};
    const Distances d = distancesTo(*truth, *result.surface);
    std::cout << truthName << ": rms " << d.rms << " mm, median " << d.median << ", max " << d.largest
              << "; strain rms " << result.report.strain.rms << ", " << result.report.iterations << " iterations\n";
    return d;
}

/// Of a cover fitted to a scan with holes of 100 mm: where it was scanned, and in the holes.
struct FitDistances {
    Distances scanned;
    Distances holes;
};

FitDistances fitDistances(const std::string& sample, const std::string& truthName, const std::array<Vec3, 3>& holes)
{
    const SolveResult result = solved(test::samplesFolder() + "/" + sample + "/" + sample + ".json");
    const auto truth = truthOf(truthName);
    if (!truth || !result.surface)
        return {{1e9, 1e9, 1e9}, {1e9, 1e9, 1e9}};
    SurfaceMesh scanned, inHoles;
    for (const Vec3& p : result.surface->positions) {
        const bool hole = std::ranges::any_of(holes, [&](const Vec3& h) { return (p - h).norm() < 50; });
        (hole ? inHoles : scanned).positions.push_back(p);
    }
    const FitDistances d{distancesTo(*truth, scanned), distancesTo(*truth, inHoles)};
    std::cout << sample << ": scanned rms " << d.scanned.rms << " mm, max " << d.scanned.largest << "; holes rms "
              << d.holes.rms << ", max " << d.holes.largest << "; strain rms " << result.report.strain.rms << ", "
              << result.report.iterations << " iterations, " << result.report.time.iterate << " ms\n";
    return d;
}

TEST(Truth, ArmchairBody)
{
    const Distances d = distancesOf(test::dataFolder() + "/truth/armchair-body.json", "armchair-truth.ply");
    EXPECT_LT(d.rms, 8);
}

TEST(Truth, TiedCarSeat)
{
    const Distances d = distancesOf(test::samplesFolder() + "/car-seat/car-seat.json", "car-seat-truth.ply");
    EXPECT_LT(d.rms, 9);
}

TEST(Truth, CushionedCarSeat)
{
    const Distances d =
        distancesOf(test::samplesFolder() + "/car-seat-cushioned/car-seat-cushioned.json", "car-seat-truth.ply");
    EXPECT_LT(d.rms, 6);
}

TEST(Truth, ArmchairFittedToItsScan)
{
    const FitDistances d =
        fitDistances("armchair-scan", "armchair-truth.ply",
                     {Vec3(122.2, 172.2, 196.8), Vec3(-89.3, -177.6, -75.6), Vec3(22.1, -60.6, -310.9)});
    EXPECT_LT(d.scanned.rms, 0.7);
    EXPECT_LT(d.holes.rms, 1.5);
}

TEST(Truth, CarSeatFittedToItsScan)
{
    const FitDistances d =
        fitDistances("car-seat-scan", "car-seat-truth.ply",
                     {Vec3(-21.6, -289.2, 404.1), Vec3(193.7, -236.3, 442.2), Vec3(28.3, 183.3, 690.4)});
    EXPECT_LT(d.scanned.rms, 0.7);
    EXPECT_LT(d.holes.rms, 1.5);
}

} // namespace
} // namespace bolster
