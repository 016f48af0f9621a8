#include "StraightCorner.h"

#include "PatchMark.h"

#include <cmath>

namespace bolster::edits {

namespace {

constexpr double sameParameter = 1e-6;
constexpr double straightWithin = 1e-6; // mm

/// Whether something on this outline begins, ends or lies between two parameters, at most a period apart.
bool hasPlaceBetween(const Design& design, ElementId patch, const BSpline2& outline, double from, double to)
{
    const double period = outline.period();
    bool found = false;
    const auto look = [&](double t) {
        const double ahead = t - from - period * std::floor((t - from) / period);
        found = found || (ahead > sameParameter && ahead < to - from - sameParameter);
    };
    const auto lookAt = [&](const auto& where) {
        if constexpr (requires { where.from; }) {
            if (where.patch == patch) {
                look(where.from);
                look(where.to);
            }
        } else if constexpr (requires { where.at; }) {
            if (where.patch == patch)
                look(where.at);
        }
    };
    design.each<Seam>([&](ElementId, const Seam& seam) {
        lookAt(seam.a);
        lookAt(seam.b);
    });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& held) { lookAt(held.stretch); });
    eachMarkKind([&]<class T>() { design.each<T>([&](ElementId, const T& mark) { lookAt(whereOf(mark)); }); });
    return found;
}

} // namespace

void dropStraightCorner(ElementId id, double corner, EditBuilder& builder)
{
    const Patch& patch = *builder.now().find<Patch>(id);
    const BSpline2& outline = patch.outline;
    const int count = outline.pointCount(), point = outline.pointAt(outline.wrapped(corner));
    if (outline.degree() != 1 || count <= 3 ||
        std::abs(std::remainder(outline.parameterOfPoint(point) - corner, outline.period())) > sameParameter)
        return;
    const auto at = [&](int i) { return outline.points()[static_cast<std::size_t>((i + count) % count)]; };
    const auto knot = [&](int i) {
        const int turn = i < 0 ? -1 : i / count;
        return outline.knots()[static_cast<std::size_t>(i - turn * count)] + turn * outline.period();
    };
    const Vec2 in = at(point) - at(point - 1), out = at(point + 1) - at(point);
    const bool bends = in.dot(out) <= 0 || std::abs(cross(in, out)) > straightWithin * (in + out).norm();
    if (bends || hasPlaceBetween(builder.now(), id, outline, knot(point - 1), knot(point + 1)))
        return;
    std::vector<Vec2> points = outline.points();
    std::vector<double> knots = outline.knots();
    points.erase(points.begin() + point);
    knots.erase(knots.begin() + point);
    if (point == 0) // the domain begins at the next one
        knots.back() = knots.front() + outline.period();
    Patch changed = patch;
    changed.outline = BSpline2(1, true, std::move(points), std::move(knots));
    builder.replace(id, std::move(changed));
}

} // namespace bolster::edits
