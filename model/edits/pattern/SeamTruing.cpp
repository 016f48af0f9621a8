#include "SeamTruing.h"

#include "EditBuilder.h"
#include "PlaneCurves.h"

#include <cmath>
#include <numbers>

namespace bolster::edits {

namespace {

constexpr double sameDirection = 1e-9; // radians
constexpr double sameKnot = 1e-9;      // of the parameter

/// One side of a seam at one of its ends: a corner of an outline, with the control points beside it.
struct SeamCorner {
    ElementId patch{};
    int corner = -1;
    bool begins = true; ///< the seam's stretch begins here, and its neighbour comes before it
};

const BSpline2& truedOutline(const Design& design, ElementId patch)
{
    return design.find<Patch>(patch)->outline;
}

std::optional<SeamCorner> cornerAt(const Design& design, const Stretch& stretch, bool begins)
{
    const Patch* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return std::nullopt;
    const BSpline2& outline = patch->outline;
    const double t = outline.wrapped(begins ? stretch.from : stretch.to);
    const int point = outline.pointAt(t);
    if (point < 0 || !isCorner(outline, point) ||
        std::abs(std::remainder(outline.parameterOfPoint(point) - t, outline.period())) > sameKnot)
        return std::nullopt;
    return SeamCorner{stretch.patch, point, begins};
}

std::pair<std::optional<SeamCorner>, std::optional<SeamCorner>> cornersAt(const Design& design, const Seam& seam,
                                                                          bool first)
{
    return {cornerAt(design, seam.a, first), cornerAt(design, seam.b, first != seam.reversed)};
}

int beside(const BSpline2& outline, int point, int step)
{
    return (point + step + outline.pointCount()) % outline.pointCount();
}

const Vec2& pointOf(const BSpline2& outline, int index)
{
    return outline.points()[static_cast<std::size_t>(index)];
}

/// Inside the patch, from the seam to its neighbour, radians.
double angleAt(const Design& design, const SeamCorner& at)
{
    const BSpline2& outline = truedOutline(design, at.patch);
    const Vec2& corner = pointOf(outline, at.corner);
    const Vec2 out = pointOf(outline, beside(outline, at.corner, 1)) - corner;
    const Vec2 back = pointOf(outline, beside(outline, at.corner, -1)) - corner;
    const double turn = outline.signedArea() < 0 ? std::atan2(cross(back, out), back.dot(out))
                                                 : std::atan2(cross(out, back), out.dot(back));
    return turn < 0 ? turn + 2 * std::numbers::pi : turn;
}

/// Turns the neighbour's control point so that the angle inside becomes larger.
void widen(EditBuilder& builder, const SeamCorner& at, double angle)
{
    Patch patch = *builder.now().find<Patch>(at.patch);
    const BSpline2& outline = patch.outline;
    const int neighbour = beside(outline, at.corner, at.begins ? -1 : 1);
    const double turn = (outline.signedArea() < 0) == at.begins ? -angle : angle;
    const Vec2 corner = pointOf(outline, at.corner);
    const Vec2 moved = corner + Eigen::Rotation2Dd(turn) * (pointOf(outline, neighbour) - corner);
    patch.outline = outline.withPoint(neighbour, moved);
    builder.replace(at.patch, std::move(patch));
}

void makeCubic(EditBuilder& builder, ElementId id)
{
    Patch patch = *builder.now().find<Patch>(id);
    if (patch.outline.degree() == 3)
        return;
    patch.outline = raisedToCubic(patch.outline);
    builder.replace(id, std::move(patch));
}

/// Whether both ends are one: a dart's tip.
bool isTip(const SeamCorner& a, const SeamCorner& b)
{
    return a.patch == b.patch && a.corner == b.corner;
}

} // namespace

std::optional<double> kinkAtSeamEnd(const Design& design, const Seam& seam, bool first)
{
    const auto [a, b] = cornersAt(design, seam, first);
    if (!a || !b || isTip(*a, *b))
        return std::nullopt;
    return 180 - (angleAt(design, *a) + angleAt(design, *b)) * 180 / std::numbers::pi;
}

Edit smoothAcrossSeamEnds(const Design& design, std::span<const ElementId> seams, Message* problem)
{
    EditBuilder builder(design);
    bool found = false, wanted = false;
    for (const ElementId id : seams) {
        const Seam* seam = design.find<Seam>(id);
        for (const bool first : {true, false}) {
            const std::optional<double> kink = seam ? kinkAtSeamEnd(builder.now(), *seam, first) : std::nullopt;
            found = found || kink;
            wanted = wanted || (kink && std::abs(*kink) > largestKink);
            const double angle = kink.value_or(0) * std::numbers::pi / 180;
            if (std::abs(angle) < sameDirection || std::abs(*kink) > largestKink)
                continue;
            makeCubic(builder, seam->a.patch);
            makeCubic(builder, seam->b.patch);
            const auto [a, b] = cornersAt(builder.now(), *seam, first);
            widen(builder, *a, angle / 2);
            widen(builder, *b, angle / 2);
        }
    }
    Edit edit = builder.result({QT_TRANSLATE_NOOP("Message", "Smooth outlines across ends of seams"), {}});
    if (!edit.empty() || !problem)
        return edit;
    if (!found)
        *problem = {QT_TRANSLATE_NOOP("Message", "This seam ends in no corners: there is nothing to smooth."), {}};
    else if (wanted)
        *problem = {QT_TRANSLATE_NOOP("Message", "The outlines meet at more than 60\u00b0 there: that is a corner, "
                                                 "and stays one."),
                    {}};
    return {};
}

} // namespace bolster::edits
