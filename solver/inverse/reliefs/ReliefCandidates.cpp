#include "ReliefCandidates.h"

#include "ArcLength.h"
#include "DartEdits.h"
#include "EditBuilder.h"
#include "EditCheck.h"
#include "FollowEdits.h"
#include "SeamEdits.h"
#include "TwinEdits.h"

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

constexpr std::array dartWidths{4.0, 10.0}; // mm
constexpr std::size_t dartPatches = 4;      // those with most over the limit
constexpr double dartDepth = 0.8;           // of the way to where it is worst: beyond the tip cloth puckers
constexpr double shortestDart = 30;         // mm
constexpr double spotRadius = 40;           // mm around a triangle that count for how bad it is there

std::string nameOf(const Design& design, ElementId patch)
{
    const auto* found = design.find<Patch>(patch);
    return found ? found->name : std::string();
}

/// Whether another one stands for it, which it mirrors.
bool isMirrored(const Design& design, ElementId id)
{
    const ElementId mirrored = edits::mirroredElement(design, id);
    return mirrored != noElement && mirrored < id;
}

/// As rulers have it.
std::string textOf(const Design& design, const ReliefPlace& place)
{
    const Vec2 there = toLayout(*design.find<Patch>(place.patch), place.at);
    return numberText(std::round(there.x())) + ", " + numberText(std::round(there.y()));
}

ReliefPlace middleOf(const Design& design, const Stretch& side)
{
    const BSpline2& outline = design.find<Patch>(side.patch)->outline;
    const double end = unwrappedEnd(side.from, side.to, outline.domainStart(), outline.domainEnd());
    return {side.patch, outline.at(outline.wrapped((side.from + end) / 2))};
}

/// Of the patch; of the sides of a patch that is sewn to itself with the place, or nobody could tell them apart.
std::string sideName(const Design& design, const Seam& seam, const Stretch& side)
{
    std::string name = nameOf(design, side.patch);
    if (seam.a.patch == seam.b.patch)
        name.append(" (").append(textOf(design, middleOf(design, side))).append(")");
    return name;
}

Freedom offsetOf(const Stretch& side, double step)
{
    Freedom freedom{.kind = Freedom::Kind::Offset, .element = side.patch, .from = side.from, .to = side.to};
    freedom.step = step;
    return freedom;
}

/// Both ends apart along the edge, what lies between them in proportion.
std::vector<Freedom> lengthening(const Design& design, const Stretch& side)
{
    std::vector<Freedom> freedoms;
    const BSpline2& outline = design.find<Patch>(side.patch)->outline;
    const ArcLength2 length(outline);
    const double end = unwrappedEnd(side.from, side.to, outline.domainStart(), outline.domainEnd());
    const double small = 1e-6 * outline.period();
    for (const int point : edits::pointsOnStretch(outline, side.from, side.to)) {
        double at = outline.parameterOfPoint(point);
        while (at < side.from - small)
            at += outline.period();
        const double share = std::clamp(length.between(side.from, at) / length.between(side.from, end), 0.0, 1.0);
        const double inside = std::clamp(at, side.from + small, end - small);
        Freedom freedom{.kind = Freedom::Kind::OutlinePoint, .element = side.patch, .index = point};
        freedom.direction = outline.derivative(outline.wrapped(inside)).normalized();
        freedom.step = share - 0.5;
        freedoms.push_back(std::move(freedom));
    }
    return freedoms;
}

void addMovesOf(std::vector<ReliefMove>& moves, const Design& design, ElementId id, const Seam& seam)
{
    const std::string a = sideName(design, seam, seam.a), b = sideName(design, seam, seam.b);
    for (const bool second : {false, true}) {
        const Stretch& side = second ? seam.b : seam.a;
        const std::vector<std::string> names = second ? std::vector{b, a} : std::vector{a, b};
        moves.push_back({Relief::Kind::Ease, id, middleOf(design, side), lengthening(design, side),
                         QT_TRANSLATE_NOOP("Message", "Make %1 longer by %3 mm where it is sewn to %2"),
                         QT_TRANSLATE_NOOP("Message", "Make %1 shorter by %3 mm where it is sewn to %2"), names});
        moves.push_back({Relief::Kind::LetOut,
                         id,
                         middleOf(design, side),
                         {offsetOf(side, 1)},
                         QT_TRANSLATE_NOOP("Message", "Let out %1 by %3 mm where it is sewn to %2"),
                         QT_TRANSLATE_NOOP("Message", "Take in %1 by %3 mm where it is sewn to %2"),
                         names});
    }
    if (seam.a.patch != seam.b.patch)
        moves.push_back({Relief::Kind::MoveSeam,
                         id,
                         middleOf(design, seam.a),
                         {offsetOf(seam.a, 1), offsetOf(seam.b, -1)},
                         QT_TRANSLATE_NOOP("Message", "Move the seam of %1 and %2 by %3 mm into %2"),
                         QT_TRANSLATE_NOOP("Message", "Move the seam of %1 and %2 by %3 mm into %1"),
                         {a, b}});
}

void addCornersOf(std::vector<ReliefMove>& moves, const Design& design, ElementId id, const Patch& patch)
{
    const BSpline2& outline = patch.outline;
    const double small = 1e-6 * outline.period(), around = outline.signedArea() > 0 ? 1 : -1;
    for (const double corner : outline.corners()) {
        const Vec2 in = outline.derivative(outline.wrapped(corner - small)).normalized();
        const Vec2 out = outline.derivative(outline.wrapped(corner + small)).normalized();
        const double turn = around * (in.x() * out.y() - in.y() * out.x());
        if (std::abs(turn) < 0.3)
            continue; // no corner to be let out
        const ReliefPlace place{id, outline.at(corner)};
        Freedom freedom{.kind = Freedom::Kind::OutlinePoint, .element = id, .index = outline.pointAt(corner)};
        freedom.direction = (in - out).normalized() * (turn > 0 ? 1 : -1);
        moves.push_back({Relief::Kind::Corner,
                         id,
                         place,
                         {std::move(freedom)},
                         QT_TRANSLATE_NOOP("Message", "Let out the corner of %1 at %2 by %3 mm"),
                         QT_TRANSLATE_NOOP("Message", "Take in the corner of %1 at %2 by %3 mm"),
                         {patch.name, textOf(design, place)}});
    }
}

double lengthOf(const BSpline2& outline, const Stretch& side)
{
    return ArcLength2(outline).between(
        side.from, unwrappedEnd(side.from, side.to, outline.domainStart(), outline.domainEnd()));
}

/// Of seams that both designs have: the most by which the difference of their sides changes, mm.
double sewnChange(const Design& before, const Design& after)
{
    double most = 0;
    const auto difference = [](const Design& design, const Seam& seam) {
        return lengthOf(design.find<Patch>(seam.b.patch)->outline, seam.b) -
               lengthOf(design.find<Patch>(seam.a.patch)->outline, seam.a);
    };
    before.each<Seam>([&](ElementId id, const Seam& seam) {
        if (const auto* now = after.find<Seam>(id))
            most = std::max(most, std::abs(difference(after, *now) - difference(before, seam)));
    });
    return most;
}

double outlineChange(const Design& before, const Design& after)
{
    double most = 0;
    before.each<Patch>([&](ElementId id, const Patch& patch) {
        const auto* now = after.find<Patch>(id);
        if (!now || now->outline == patch.outline || now->outline.pointCount() != patch.outline.pointCount())
            return;
        for (std::size_t k = 0; k < patch.outline.points().size(); ++k)
            most = std::max(most, (now->outline.points()[k] - patch.outline.points()[k]).norm());
    });
    return most;
}

/// What is over the limit at a triangle and around it, and where.
struct Spot {
    double energy = 0;
    Vec2 at = Vec2::Zero();
};

struct StrainedPatch {
    ElementId patch{};
    double energy = 0;
    Vec2 worst = Vec2::Zero();
};

std::vector<Spot> spotsOf(const SurfaceTopology& topology, const CoverStrains& strains,
                          const SurfaceTopology::PatchRange& range)
{
    std::vector<Spot> spots;
    for (std::size_t k = 0; k < strains.triangles.size(); ++k) {
        const std::uint32_t t = strains.triangles[k];
        if (t < range.firstTriangle || t >= range.firstTriangle + range.triangleCount)
            continue;
        const auto column = static_cast<Eigen::Index>(k);
        const Eigen::Array3d over =
            (strains.strains.col(column).array().abs() - strains.limits.col(column).array()).max(0);
        const auto& corners = topology.triangles[t];
        const Vec2 middle =
            (topology.pattern[corners[0]] + topology.pattern[corners[1]] + topology.pattern[corners[2]]) / 3;
        if (const double energy = over.square().sum() * strains.areas[column]; energy > 0)
            spots.push_back({energy, middle});
    }
    return spots;
}

StrainedPatch strainedPatch(ElementId id, const std::vector<Spot>& spots)
{
    StrainedPatch result{id, 0, Vec2::Zero()};
    double most = 0;
    for (const Spot& middle : spots) {
        double around = 0;
        for (const Spot& other : spots)
            if ((other.at - middle.at).norm() < spotRadius)
                around += other.energy;
        result.energy += middle.energy;
        if (around > most) {
            most = around;
            result.worst = middle.at;
        }
    }
    return result;
}

std::optional<Relief> dartAt(const Design& design, const StrainedPatch& strained, double width)
{
    const BSpline2& outline = design.find<Patch>(strained.patch)->outline;
    const BSpline2::Closest edge = outline.closest(strained.worst);
    const double depth = dartDepth * edge.distance;
    if (depth < shortestDart)
        return std::nullopt;
    const ArcLength2 length(outline);
    const double from = outline.wrapped(length.parameterAt(length.at(edge.parameter) - width / 2));
    const std::optional<double> to = edits::mouthEnd(outline, from, width, true);
    if (!to)
        return std::nullopt;
    edits::DartShape dart = edits::dartBetween(design, strained.patch, from, *to);
    const edits::DartAxis axis = edits::dartAxis(outline, dart);
    dart.tip = axis.middle + depth * axis.inwards;
    Relief relief{.kind = Relief::Kind::Dart,
                  .element = strained.patch,
                  .place = {strained.patch, axis.middle},
                  .text = {},
                  .edit = {}};
    relief.edit = edits::withFollowers(design, edits::addDart(design, dart));
    if (relief.edit.empty() || edits::brokenBy(design, relief.edit))
        return std::nullopt;
    relief.text = {QT_TRANSLATE_NOOP("Message", "Cut a dart into %1 at %2, %3 mm wide and %4 mm deep"),
                   {nameOf(design, strained.patch), textOf(design, relief.place), numberText(width),
                    numberText(std::round(depth))}};
    relief.sewn = std::hypot(depth, width / 2);
    relief.moved = width / 2;
    return relief;
}

} // namespace

std::vector<ReliefMove> reliefMoves(const Design& design)
{
    std::vector<ReliefMove> moves;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (!isMirrored(design, id))
            addMovesOf(moves, design, id, seam);
    });
    design.each<FixationSeam>([&](ElementId id, const FixationSeam& fixation) {
        if (!fixation.hasCurve() || isMirrored(design, id))
            return;
        const auto* curve = design.find<FixationCurve>(fixation.curve);
        moves.push_back({Relief::Kind::LetOut,
                         id,
                         middleOf(design, fixation.stretch),
                         {offsetOf(fixation.stretch, 1)},
                         QT_TRANSLATE_NOOP("Message", "Let out %1 by %3 mm where the curve %2 holds it"),
                         QT_TRANSLATE_NOOP("Message", "Take in %1 by %3 mm where the curve %2 holds it"),
                         {nameOf(design, fixation.stretch.patch), curve ? curve->name : std::string()}});
    });
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (!isMirrored(design, id))
            addCornersOf(moves, design, id, patch);
    });
    return moves;
}

Design withMove(const Design& design, const ReliefMove& move, double amount)
{
    return sampleDesign(design, {.all = {{move.freedoms, 1, {}}}}, Eigen::VectorXd::Constant(1, amount));
}

Relief reliefOf(const Design& design, const ReliefMove& move, double amount)
{
    Relief relief{.kind = move.kind, .element = move.element, .place = move.place, .text = {}, .edit = {}};
    std::vector<std::string> arguments = move.names;
    arguments.push_back(numberText(std::abs(amount), 2));
    relief.text = {amount > 0 ? move.more : move.less, std::move(arguments)};
    const Design moved = withMove(design, move, amount);
    relief.edit = editBetween(design, moved, relief.text);
    relief.sewn = sewnChange(design, moved);
    relief.moved = outlineChange(design, moved);
    return relief;
}

std::vector<Relief> continuityReliefs(const Design& design)
{
    std::vector<Relief> reliefs;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (isMirrored(design, id))
            return;
        const bool sharp = seam.continuity == Continuity::C0;
        Relief relief{.kind = Relief::Kind::Continuity,
                      .element = id,
                      .place = middleOf(design, seam.a),
                      .text = {},
                      .edit = {}};
        relief.text = {sharp ? QT_TRANSLATE_NOOP("Message", "Make the seam of %1 and %2 smooth")
                             : QT_TRANSLATE_NOOP("Message", "Let the seam of %1 and %2 be sharp"),
                       {sideName(design, seam, seam.a), sideName(design, seam, seam.b)}};
        relief.edit = edits::withFollowers(
            design, edits::setContinuity(design, std::array{id}, sharp ? Continuity::G1 : Continuity::C0));
        reliefs.push_back(std::move(relief));
    });
    return reliefs;
}

std::vector<Relief> dartReliefs(const Design& design, const SurfaceTopology& topology, const CoverStrains& strains)
{
    std::vector<StrainedPatch> strained;
    for (const SurfaceTopology::PatchRange& range : topology.patches)
        if (!isMirrored(design, range.patch))
            strained.push_back(strainedPatch(range.patch, spotsOf(topology, strains, range)));
    std::erase_if(strained, [](const StrainedPatch& patch) { return !(patch.energy > 0); });
    std::ranges::stable_sort(strained, std::ranges::greater(), &StrainedPatch::energy);
    strained.resize(std::min(strained.size(), dartPatches));
    std::vector<Relief> reliefs;
    for (const StrainedPatch& patch : strained)
        for (const double width : dartWidths)
            if (std::optional<Relief> dart = dartAt(design, patch, width))
                reliefs.push_back(std::move(*dart));
    return reliefs;
}

} // namespace bolster
