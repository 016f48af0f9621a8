#include "TestDesigns.h"

#include "DesignJson.h"
#include "TestPaths.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <numbers>
#include <sstream>

namespace bolster::test {

DesignBuilder::DesignBuilder(double edgeLength)
{
    Settings settings;
    settings.edgeLength = edgeLength;
    m_design = m_design.with({{}, {{settingsId, nullptr, makeElement(settings)}}});
}

ElementId DesignBuilder::fabric(double poisson, double bendingLength, double stiffness)
{
    Fabric fabric;
    fabric.name = "Fabric";
    fabric.poisson = poisson;
    fabric.bendingLength = bendingLength;
    fabric.stiffness = stiffness;
    return add(fabric);
}

ElementId DesignBuilder::patch(std::vector<Vec2> polygon, ElementId fabric, double pressure)
{
    return patch(BSpline2(1, true, std::move(polygon)), fabric, pressure);
}

ElementId DesignBuilder::patch(BSpline2 outline, ElementId fabric, double pressure)
{
    Patch patch;
    patch.name = "Patch";
    patch.fabric = fabric;
    patch.pressure = pressure;
    patch.outline = std::move(outline);
    return add(patch);
}

ElementId DesignBuilder::seam(Stretch a, Stretch b, bool reversed, Match match)
{
    Seam seam;
    seam.a = a;
    seam.b = b;
    seam.reversed = reversed;
    seam.match = match;
    return add(seam);
}

ElementId DesignBuilder::fix(Stretch stretch, BSpline3 curve, bool reversed, Match match)
{
    FixationSeam fixation;
    fixation.stretch = stretch;
    fixation.curve = add(FixationCurve{"Curve", std::move(curve)});
    fixation.reversed = reversed;
    fixation.match = match;
    return add(fixation);
}

std::vector<Vec2> rectangle(double width, double height)
{
    return {{0, 0}, {width, 0}, {width, height}, {0, height}};
}

BSpline3 polyline(std::vector<Vec3> points, bool closed)
{
    return BSpline3(1, closed, std::move(points));
}

BSpline3 circle(double radius, double z)
{
    // A uniform cubic through control points at this radius passes at (4 + 2 cos(step)) / 6 of it.
    constexpr int n = 48;
    const double step = 2 * std::numbers::pi / n;
    const double control = radius * 6 / (4 + 2 * std::cos(step));
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i)
        points.emplace_back(control * std::cos(i * step), control * std::sin(i * step), z);
    return BSpline3(3, true, std::move(points));
}

Design tube(double width, double height, double edgeLength, double bendingLength)
{
    DesignBuilder b(edgeLength);
    const ElementId patch = b.patch(rectangle(width, height), b.fabric(0.3, bendingLength));
    const double radius = width / (2 * std::numbers::pi);
    b.seam({patch, 1, 2}, {patch, 3, 4});
    b.fix({patch, 0, 1}, circle(radius, 0));
    b.fix({patch, 2, 3}, circle(radius, height), true);
    return b.design();
}

Design box(double size, double height, double edgeLength, double bendingLength, double pressure)
{
    DesignBuilder b(edgeLength);
    const ElementId fabric = b.fabric(0.3, bendingLength);
    const ElementId top = b.patch(rectangle(size, size), fabric, pressure);
    const Vec3 corners[] = {{0, 0, 0}, {size, 0, 0}, {size, size, 0}, {0, size, 0}};
    std::vector<ElementId> sides;
    for (int k = 0; k < 4; ++k) {
        sides.push_back(b.patch(rectangle(size, height), fabric, pressure));
        b.seam({top, double(k), double(k + 1)}, {sides[k], 2, 3});
        b.fix({sides[k], 0, 1}, polyline({corners[k], corners[(k + 1) % 4]}));
    }
    for (int k = 0; k < 4; ++k)
        b.seam({sides[k], 1, 2}, {sides[(k + 1) % 4], 3, 4});
    return b.design();
}

Design sample(const std::string& name)
{
    std::ifstream file(samplesFolder() + "/" + name + "/" + name + ".json");
    std::stringstream text;
    text << file.rdbuf();
    const ReadDesign read = readDesign(text.str());
    EXPECT_TRUE(read.readable) << name;
    EXPECT_TRUE(read.problems.empty()) << name;
    return read.design;
}

double leastAngle(const SewnMesh& mesh)
{
    double least = 180;
    for (const auto& triangle : mesh.topology->triangles)
        for (std::size_t k = 0; k < 3; ++k) {
            const auto at = [&](std::size_t i) { return mesh.rest()[triangle[(k + i) % 3]]; };
            const Vec2 u = (at(1) - at(0)).normalized(), v = (at(2) - at(0)).normalized();
            least = std::min(least, std::acos(u.dot(v)) * 180 / std::numbers::pi);
        }
    return least;
}

SolveResult solved(const Design& design, double tolerance)
{
    SolveOptions options;
    options.tolerance = tolerance;
    SolveResult result = solveResting(design, options);
    EXPECT_EQ(result.status, SolveResult::Status::Solved) << result.reason.english();
    return result;
}

} // namespace bolster::test
