// How far reconstructions lie from the true surfaces. Prints the figures.
#include "DesignFile.h"
#include "MeshImport.h"
#include "RestingSolve.h"

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <gtest/gtest.h>

#include <algorithm>
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

Distances distancesOf(const std::string& designPath, const std::string& truthName)
{
    const OpenedDesign opened = openDesign(QString::fromStdString(designPath));
    const SolveResult result = solveResting({opened.design, {opened.frames, {}}}, {});
    EXPECT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
    const ImportedMesh truth =
        importMesh(QString::fromStdString(std::string(BOLSTER_TEST_DATA) + "/truth/" + truthName));
    EXPECT_TRUE(truth.mesh) << truth.problem.english();
    if (!truth.mesh || !result.surface)
        return {1e9, 1e9, 1e9};
    const Distances d = distancesTo(*truth.mesh, *result.surface);
    std::cout << truthName << ": rms " << d.rms << " mm, median " << d.median << ", max " << d.largest
              << "; strain rms " << result.report.strain.rms << ", " << result.report.iterations << " iterations\n";
    return d;
}

TEST(Truth, ArmchairBody)
{
    const Distances d =
        distancesOf(std::string(BOLSTER_TEST_DATA) + "/truth/armchair-body.json", "armchair-truth.ply");
    EXPECT_LT(d.rms, 8);
}

TEST(Truth, TiedCarSeat)
{
    const Distances d = distancesOf(std::string(BOLSTER_SAMPLES) + "/car-seat/car-seat.json", "car-seat-truth.ply");
    EXPECT_LT(d.rms, 9);
}

TEST(Truth, CushionedCarSeat)
{
    const Distances d = distancesOf(std::string(BOLSTER_SAMPLES) + "/car-seat-cushioned/car-seat-cushioned.json",
                                    "car-seat-truth.ply");
    EXPECT_LT(d.rms, 6);
}

} // namespace
} // namespace bolster
