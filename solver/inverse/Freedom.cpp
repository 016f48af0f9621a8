#include "Freedom.h"

#include "EditBuilder.h"
#include "FollowEdits.h"
#include "FrameSlide.h"
#include "MeetingCurves.h"
#include "NumberField.h"
#include "SeamEnds.h"
#include "SlippedOutline.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <set>

namespace bolster {

namespace {

constexpr double smoothTurn = 0.9;     // cosine: an outline that turns more at a point has a corner there
constexpr double stiffnessStep = 0.02; // of it
constexpr double poissonStep = 0.01;
constexpr double edgeOn = 0.3; // cosine: edges that meet flatter than that have no corner to be prolonged to

const char* const axisNames[] = {"x", "y", "z"};

/// Whether it follows another one, so that its numbers are not free.
template <class T>
bool follows(const Design& design, const T& value)
{
    return value.twin && design.find<T>(value.twin->of);
}

/// Direction to the outside of an outline beside a place on it.
struct Side {
    Vec2 along, outward;
};

Side sideAt(const BSpline2& outline, double parameter, bool before)
{
    const double t = outline.wrapped(parameter + (before ? -1 : 1) * 1e-6 * outline.period());
    const Vec2 along = outline.derivative(t).normalized();
    const Vec2 right(along.y(), -along.x()); // outside, where it runs counter-clockwise
    return {along, outline.signedArea() > 0 ? right : Vec2(-right)};
}

bool liesIn(const BSpline2& outline, double parameter, double from, double to)
{
    if (from == to)
        return true;
    const double period = outline.period(), slack = 1e-6 * period;
    const double end = unwrappedEnd(from, to, outline.domainStart(), outline.domainEnd());
    double at = parameter;
    while (at < from - slack)
        at += period;
    return at <= end + slack;
}

/// Corners that move along a curved edge take its points along, less and less towards its other end, so that the
/// edge stays on its line: it moves by its derivative times what grows evenly. Exact where it is one Bezier piece.
void slideAlong(const BSpline2& outline, std::vector<Vec2>& moves)
{
    const int count = outline.pointCount();
    const auto later = [&](int from, int to) { // in the parameter, from one point to a later one
        const double way = outline.parameterOfPoint(to) - outline.parameterOfPoint(from);
        return way > 0 ? way : way + outline.period();
    };
    const auto leg = [&](int k) -> Vec2 { // a control point of the derivative
        const int next = (k + 1) % count;
        return (outline.points()[static_cast<std::size_t>(next)] - outline.points()[static_cast<std::size_t>(k)]) /
               later(k, next);
    };
    std::vector<int> corners;
    for (const double corner : outline.corners())
        corners.push_back(outline.pointAt(corner));
    for (std::size_t c = 0; c < corners.size(); ++c) {
        const int first = corners[c], last = corners[(c + 1) % corners.size()];
        const Vec2 begin = leg(first), end = leg((last + count - 1) % count);
        if (begin.isZero() || end.isZero())
            continue;
        const double slideFirst = moves[static_cast<std::size_t>(first)].dot(begin) / begin.squaredNorm();
        const double slideLast = moves[static_cast<std::size_t>(last)].dot(end) / end.squaredNorm();
        for (int k = (first + 1) % count; k != last; k = (k + 1) % count) {
            const double share = later(first, k) / later(first, last);
            moves[static_cast<std::size_t>(k)] +=
                slideFirst * (1 - share) * leg(k) + slideLast * share * leg((k + count - 1) % count);
        }
    }
}

/// Where control points go when the outline (or the edges on a part of it) lies 1 mm farther outside. Edges that
/// stay are prolonged to the corners of those that go.
std::vector<Vec2> outwardMoves(const BSpline2& outline, double from, double to)
{
    std::vector<Vec2> moves(outline.points().size(), Vec2::Zero());
    const double small = 1e-4 * outline.period();
    for (int k = 0; k < outline.pointCount(); ++k) {
        const double at = outline.parameterOfPoint(k);
        const Side before = sideAt(outline, at, true), after = sideAt(outline, at, false);
        const bool goesBefore = liesIn(outline, outline.wrapped(at - small), from, to);
        const bool goesAfter = liesIn(outline, outline.wrapped(at + small), from, to);
        const double cosine = before.outward.dot(after.outward);
        Vec2& move = moves[static_cast<std::size_t>(k)];
        if (goesBefore && goesAfter)
            move = (before.outward + after.outward) / std::max(1 + cosine, edgeOn);
        else if (goesBefore || goesAfter) {
            const Side& going = goesBefore ? before : after;
            const Side& staying = goesBefore ? after : before;
            const double reach = going.outward.dot(staying.along);
            move = std::abs(reach) > edgeOn ? Vec2(staying.along / reach) : going.outward;
        }
    }
    slideAlong(outline, moves);
    return moves;
}

class Mover {
public:
    explicit Mover(const Design& design)
        : m_design(design)
    {}

    void move(const Freedom& freedom, double value)
    {
        using enum Freedom::Kind;
        if (value == 0)
            return;
        switch (freedom.kind) {
        case OutlinePoint:
            if (std::vector<Vec2>* points = outline(freedom.element))
                (*points)[static_cast<std::size_t>(freedom.index)] += value * freedom.direction;
            break;
        case Offset:
            if (std::vector<Vec2>* points = outline(freedom.element)) {
                const BSpline2& before = m_design.find<Patch>(freedom.element)->outline;
                const std::vector<Vec2> moves = outwardMoves(before, freedom.from, freedom.to);
                for (std::size_t k = 0; k < points->size(); ++k)
                    (*points)[k] += value * moves[k];
            }
            break;
        case Size:
            if (std::vector<Vec2>* points = outline(freedom.element)) {
                const Vec2 middle = m_design.find<Patch>(freedom.element)->outline.boundingBox().center();
                for (Vec2& point : *points)
                    point = middle + (1 + value / 100) * (point - middle);
            }
            break;
        case Slip:
            if (std::vector<Vec2>* points = outline(freedom.element)) {
                const BSpline2& before = m_design.find<Patch>(freedom.element)->outline;
                const BSpline2 slipped = slippedOutline(before, freedom.from, freedom.to, value);
                for (std::size_t k = 0; k < points->size(); ++k)
                    (*points)[k] += slipped.points()[k] - before.points()[k];
            }
            break;
        case SeamEnd:
            m_ends.push_back({freedom.element, freedom.from, value});
            break;
        case CurvePlace:
            m_shifts.emplace(freedom.element, Vec3::Zero()).first->second[freedom.axis] += value;
            break;
        case CurveSlide: {
            Slide& slide = m_slides[freedom.element];
            slide.onFrame = freedom.onFrame;
            slide.ways[static_cast<std::size_t>(freedom.axis)] += value;
            break;
        }
        case Number:
            m_numbers[{freedom.element, freedom.field}] += value;
            break;
        }
    }

    Design result() const
    {
        Design moved = m_design;
        const auto set = [&](ElementId id, ElementPtr element) {
            moved = moved.with({{}, {{id, moved.element(id), std::move(element)}}});
        };
        for (const auto& [id, points] : m_outlines) {
            Patch patch = *moved.find<Patch>(id);
            patch.outline = patch.outline.withPoints(points);
            set(id, makeElement(std::move(patch)));
        }
        for (const auto& [id, shift] : m_shifts) {
            const auto* found = moved.find<FixationCurve>(id);
            if (!found)
                continue;
            FixationCurve curve = *found;
            std::vector<Vec3> points = curve.curve.points();
            for (Vec3& point : points)
                point += shift;
            curve.curve = curve.curve.withPoints(std::move(points));
            set(id, makeElement(std::move(curve)));
        }
        for (const auto& [id, slide] : m_slides) {
            const auto* found = moved.find<FixationCurve>(id);
            if (!found)
                continue;
            FixationCurve curve = *found;
            curve.curve = curve.curve.withPoints(slide.onFrame->places(slide.ways[0], slide.ways[1]));
            set(id, makeElement(std::move(curve)));
        }
        for (const auto& [place, value] : m_numbers) {
            const ElementPtr element = moved.element(place.first);
            if (!element)
                continue;
            const std::optional<double> now = numberAt(*element, place.second);
            if (now)
                set(place.first, withNumber(*element, place.second, *now + value));
        }
        moved = withSeamEnds(moved, m_ends);
        moved = m_design.with(edits::withFollowers(m_design, editBetween(m_design, moved, {})));
        return m_shifts.empty() && m_slides.empty() ? moved : withMeetingCurves(m_design, moved);
    }

private:
    std::vector<Vec2>* outline(ElementId id)
    {
        const auto* patch = m_design.find<Patch>(id);
        return patch ? &m_outlines.emplace(id, patch->outline.points()).first->second : nullptr;
    }

    const Design& m_design;
    std::map<ElementId, std::vector<Vec2>> m_outlines;
    struct Slide {
        std::shared_ptr<const FrameSlide> onFrame;
        std::array<double, 2> ways{};
    };

    std::map<ElementId, Vec3> m_shifts;
    std::map<ElementId, Slide> m_slides;
    std::vector<MovedSeamEnd> m_ends;
    std::map<std::pair<ElementId, std::string>, double> m_numbers;
};

} // namespace

Design withFreedoms(const Design& design, std::span<const Freedom> freedoms, const Eigen::VectorXd& values)
{
    Mover mover(design);
    for (std::size_t k = 0; k < freedoms.size(); ++k)
        mover.move(freedoms[k], values[static_cast<Eigen::Index>(k)]);
    return mover.result();
}

std::vector<Freedom> outlineFreedoms(const Design& design, std::span<const ElementId> patches)
{
    std::vector<Freedom> freedoms;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (follows(design, patch) || (!patches.empty() && std::ranges::find(patches, id) == patches.end()))
            return;
        for (int k = 0; k < patch.outline.pointCount(); ++k) {
            const double at = patch.outline.parameterOfPoint(k);
            const Side before = sideAt(patch.outline, at, true), after = sideAt(patch.outline, at, false);
            const auto add = [&](const Vec2& direction, const char* word) {
                freedoms.push_back({.kind = Freedom::Kind::OutlinePoint,
                                    .element = id,
                                    .index = k,
                                    .direction = direction,
                                    .name = patch.name + ", point " + std::to_string(k) + word});
            };
            if (before.along.dot(after.along) > smoothTurn) {
                add(after.outward, "");
            } else {
                add(Vec2::UnitX(), ", x");
                add(Vec2::UnitY(), ", y");
            }
        }
    });
    return freedoms;
}

namespace {

Freedom numberFreedom(const Design& design, ElementId id, const std::string& field, std::string name, double step)
{
    Freedom freedom{
        .kind = Freedom::Kind::Number, .element = id, .field = field, .name = std::move(name), .step = step};
    const ElementPtr element = design.element(id);
    const std::optional<double> now = numberAt(*element, field);
    if (const auto limits = numberLimits(*element, field); limits && now) {
        freedom.least = limits->first - *now;
        freedom.most = limits->second - *now;
    }
    return freedom;
}

} // namespace

std::vector<Freedom> foamFreedoms(const Design& design)
{
    std::vector<Freedom> freedoms;
    const auto add = [&](ElementId id, const std::string& name, double step) {
        freedoms.push_back(numberFreedom(design, id, "dilation_mm", name + ", thickness", step));
    };
    design.each<Cushion>([&](ElementId id, const Cushion& cushion) {
        if (!cushion.enabled)
            return;
        add(id, cushion.name, cushion.voxel); // it grows by whole ones
        design.each<Foam>([&](ElementId foamId, const Foam& foam) {
            if (foam.cushion == id && !foam.cut)
                add(foamId, foam.name, cushion.voxel);
        });
    });
    return freedoms;
}

namespace {

/// Calls visit(id, curve) for those that hold something and don't follow a twin.
template <class Visit>
void eachFreeCurve(const Design& design, Visit visit)
{
    std::set<ElementId> used;
    design.each<FixationSeam>([&](ElementId, const FixationSeam& fixation) { used.insert(fixation.curve); });
    design.each<FixationCurve>([&](ElementId id, const FixationCurve& curve) {
        if (used.contains(id) && !follows(design, curve))
            visit(id, curve);
    });
}

void addShifts(ElementId id, const FixationCurve& curve, std::vector<Freedom>& freedoms)
{
    for (int axis = 0; axis < 3; ++axis)
        freedoms.push_back({.kind = Freedom::Kind::CurvePlace,
                            .element = id,
                            .axis = axis,
                            .name = curve.name + ", " + axisNames[axis]});
}

void addSlides(ElementId id, const FixationCurve& curve, const std::shared_ptr<const FrameSlide>& slide,
               std::vector<Freedom>& freedoms)
{
    const int ways = curve.curve.closed() ? 1 : 2;
    for (int way = 0; way < ways; ++way)
        freedoms.push_back({.kind = Freedom::Kind::CurveSlide,
                            .element = id,
                            .axis = way,
                            .name = curve.name + (way == 0 ? ", sideways on the frame" : ", turned on the frame"),
                            .onFrame = slide});
}

} // namespace

std::vector<Freedom> fixationFreedoms(const Design& design)
{
    std::vector<Freedom> freedoms;
    eachFreeCurve(design, [&](ElementId id, const FixationCurve& curve) { addShifts(id, curve, freedoms); });
    return freedoms;
}

std::vector<Freedom> fixationFreedoms(const Design& design, const DesignFiles& files)
{
    constexpr double around = 100; // mm
    Box3 near;
    eachFreeCurve(design, [&](ElementId, const FixationCurve& curve) {
        for (const Vec3& point : curve.curve.points())
            near.extend(point);
    });
    near = Box3(near.min() - Vec3::Constant(around), near.max() + Vec3::Constant(around));
    std::vector<std::shared_ptr<const FrameSurface>> frames;
    design.each<Frame>([&](ElementId id, const Frame& frame) {
        if (const auto mesh = files.meshes.find(id); mesh != files.meshes.end() && mesh->second)
            frames.push_back(std::make_shared<FrameSurface>(frame, *mesh->second, near));
    });
    std::vector<Freedom> freedoms;
    eachFreeCurve(design, [&](ElementId id, const FixationCurve& curve) {
        for (const auto& frame : frames)
            if (const auto slide = curve.curve.empty() ? nullptr : FrameSlide::of(curve.curve, frame))
                return addSlides(id, curve, slide, freedoms);
        addShifts(id, curve, freedoms);
    });
    return freedoms;
}

std::vector<Freedom> pressureFreedoms(const Design& design)
{
    std::vector<Freedom> freedoms;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (!follows(design, patch))
            freedoms.push_back(numberFreedom(design, id, "pressure", patch.name + ", pressure", 0.05));
    });
    return freedoms;
}

std::vector<Freedom> stretchFreedoms(const Design& design)
{
    std::set<ElementId> used;
    design.each<Patch>([&](ElementId, const Patch& patch) { used.insert(patch.fabric); });
    std::vector<Freedom> freedoms;
    design.each<Fabric>([&](ElementId id, const Fabric& fabric) {
        if (!used.contains(id))
            return;
        freedoms.push_back(
            numberFreedom(design, id, "stiffness", fabric.name + ", stiffness", stiffnessStep * fabric.stiffness));
        freedoms.push_back(numberFreedom(design, id, "poisson", fabric.name + ", Poisson number", poissonStep));
    });
    return freedoms;
}

std::vector<Freedom> seamEndFreedoms(const Design& design)
{
    std::set<ElementId> mirrored; // a change of one alone would tear twins apart
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (follows(design, patch))
            mirrored.insert({id, patch.twin->of});
    });
    std::vector<Freedom> freedoms;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (mirrored.contains(id))
            return;
        int count = 0;
        for (const double end : seamEnds(design, id)) {
            const Side before = sideAt(patch.outline, end, true), after = sideAt(patch.outline, end, false);
            if (before.along.dot(after.along) > smoothTurn)
                freedoms.push_back({.kind = Freedom::Kind::SeamEnd,
                                    .element = id,
                                    .index = count,
                                    .from = end,
                                    .name = patch.name + ", end of a seam " + std::to_string(++count)});
        }
    });
    return freedoms;
}

} // namespace bolster
