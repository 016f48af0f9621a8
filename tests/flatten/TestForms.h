// Forms of which it is known what they look like flat.
#pragma once

#include "Form.h"
#include "TriangleMesh.h"

#include <functional>
#include <string>
#include <vector>

namespace bolster::test {

/// A grid of columns x rows squares, each two triangles, over [0, 1] x [0, 1]; one part of that name.
TriangleMesh gridMesh(int columns, int rows, const std::function<Vec3(double u, double v)>& place,
                      const std::string& name = "Sheet");
/// The parts of both, points in the same place being doubled as files have them.
TriangleMesh sideBySide(const TriangleMesh& a, const TriangleMesh& b);
/// Half of a pipe around the z axis: radius and height in mm, bulging to -y.
TriangleMesh halfPipe(double radius, double height, int columns = 60, int rows = 24);
/// A ring around the z axis, open above and below, a cone when the radii differ.
TriangleMesh ringMesh(double lower, double upper, double height, int columns = 90, int rows = 16);
/// A body open below, on z = 0, with walls of `height` mm, of which each is two triangles: parts "Top" and "Side".
/// The plan is rows of squares of `side` mm, the farthest first; what is no blank belongs to it.
TriangleMesh trayMesh(const std::vector<std::string>& plan, double side, double height);
/// Walls and the top of a prism, mm; its first corner lies at x = `radius`.
TriangleMesh hollowPrism(unsigned corners, double radius, double height);
/// A straight line over its top: where it crosses the edges, and the walls below (0: after the first corner).
struct PrismCrossing {
    Vec3 begin, end;
    unsigned first = 0, last = 0;
};
/// At right angles to the direction of an angle, `off` mm from the middle.
PrismCrossing acrossPrism(unsigned corners, double radius, double height, double angle, double off);
/// Each triangle as four.
TriangleMesh quartered(const TriangleMesh& mesh);

/// Why it, or a piece of it, cannot be laid flat; "" if it can.
std::string problemOf(const Form& form);

} // namespace bolster::test
