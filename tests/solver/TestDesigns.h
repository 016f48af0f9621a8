// Small designs for the solver's tests.
#pragma once

#include "Design.h"
#include "RestingSolve.h"
#include "SewnMesh.h"

#include <string>

namespace bolster::test {

/// Adds elements one by one and remembers their ids.
class DesignBuilder {
public:
    explicit DesignBuilder(double edgeLength);

    ElementId fabric(double poisson, double bendingLength, double stiffness = 1);
    ElementId patch(std::vector<Vec2> polygon, ElementId fabric, double pressure = 0);
    ElementId patch(BSpline2 outline, ElementId fabric, double pressure = 0);
    ElementId seam(Stretch a, Stretch b, bool reversed = true, Match match = Match::Length);
    ElementId fix(Stretch stretch, BSpline3 curve, bool reversed = false, Match match = Match::Length);
    template <class T>
    ElementId add(T element)
    {
        const ElementId id = m_design.nextId();
        m_design = m_design.with({{}, {{id, nullptr, makeElement(std::move(element))}}});
        return id;
    }

    const Design& design() const { return m_design; }

private:
    Design m_design;
};

std::vector<Vec2> rectangle(double width, double height);
BSpline3 polyline(std::vector<Vec3> points, bool closed = false);
/// A closed cubic within 1e-4 of the radius of a circle about the z axis through (radius, 0, z), counter-clockwise.
BSpline3 circle(double radius, double z);
/// A rectangle of the given width sewn into a tube and fixed at both rims to circles of that circumference.
Design tube(double width, double height, double edgeLength, double bendingLength);
/// A top and four sides, sewn, fixed along the bottom.
Design box(double size, double height, double edgeLength, double bendingLength, double pressure);
Design sample(const std::string& name);

/// The smallest angle of all triangles in the pattern, degrees.
double leastAngle(const SewnMesh& mesh);

/// Solves to 1e-8 and expects it to succeed.
SolveResult solved(const Design& design, double tolerance = 1e-8);

} // namespace bolster::test
