// Makes twins of two elements that were drawn separately.
#include "TwinEdits.h"

#include "ArcLength.h"
#include "EditHelpers.h"
#include "ElementRules.h"
#include "OutlinePlaces.h"
#include "PatchMark.h"
#include "SewnMirror.h"
#include "Twins.h"

#include <algorithm>
#include <limits>
#include <numbers>

namespace bolster::edits {

namespace {

constexpr int twinSamples = 96;
constexpr double mostDeviation = 0.05; // rms, of the size: more are different shapes
constexpr double snapDistance = 2;     // mm
constexpr double straight = 1e-5;      // radians: what is turned less is not turned
constexpr int refinements = 8;

/// Points at equal fractions of the length from a parameter on, the end of an open curve included.
template <int Dim>
std::vector<typename BSpline<Dim>::Point> spread(const BSpline<Dim>& curve, double start, bool backwards = false)
{
    const ArcLength<Dim> length(curve);
    const double step = length.total() / (curve.closed() ? twinSamples : twinSamples - 1) * (backwards ? -1 : 1);
    std::vector<typename BSpline<Dim>::Point> points;
    for (int i = 0; i < twinSamples; ++i)
        points.push_back(curve.at(length.parameterAt(length.at(start) + i * step)));
    return points;
}

/// How one outline lies on another: q = R(angle) p + shift.
struct Fit {
    double angle = 0;
    Vec2 shift = Vec2::Zero();
    bool backwards = false;
    double rms = std::numeric_limits<double>::infinity();

    Vec2 to(const Vec2& p) const { return Eigen::Rotation2Dd(angle) * p + shift; }
    Vec2 from(const Vec2& q) const { return Eigen::Rotation2Dd(-angle) * (q - shift); }
};

Vec2 middleOf(const std::vector<Vec2>& points)
{
    Vec2 sum = Vec2::Zero();
    for (const Vec2& point : points)
        sum += point;
    return sum / static_cast<double>(points.size());
}

/// Lays points on others (least squares); rms is that of what remains.
Fit fitOf(const std::vector<Vec2>& p, const std::vector<Vec2>& q)
{
    const Vec2 middleP = middleOf(p);
    const Vec2 middleQ = middleOf(q);
    double dot = 0;
    double cross = 0;
    double sum = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        const Vec2 a = p[i] - middleP;
        const Vec2 b = q[i] - middleQ;
        dot += a.dot(b);
        cross += a.x() * b.y() - a.y() * b.x();
        sum += a.squaredNorm() + b.squaredNorm();
    }
    Fit fit;
    fit.angle = std::atan2(cross, dot);
    if (std::abs(fit.angle) < straight)
        fit.angle = 0;
    fit.shift = middleQ - Eigen::Rotation2Dd(fit.angle) * middleP;
    fit.rms = std::sqrt(std::max(0.0, sum - 2 * std::hypot(dot, cross)) / static_cast<double>(p.size()));
    return fit;
}

/// The best of all knots as starts, both ways round; of equally good ones that with the least turn.
Fit bestFit(const BSpline2& outline, const BSpline2& onto)
{
    const std::vector<Vec2> p = spread(outline, outline.domainStart());
    Fit best;
    double least = std::numeric_limits<double>::infinity();
    for (const bool backwards : {false, true})
        for (const double start : onto.breaks()) {
            const Fit fit = fitOf(p, spread(onto, start, backwards));
            const double cost =
                fit.rms * fit.rms + 1e-4 * outline.boundingBox().diagonal().squaredNorm() * std::abs(fit.angle);
            if (cost >= least)
                continue;
            least = cost;
            best = fit;
            best.backwards = backwards;
        }
    for (int i = 0; i < refinements; ++i) { // their knots need not be the same
        std::vector<Vec2> q;
        for (const Vec2& point : p)
            q.push_back(onto.closest(best.to(point)).point);
        const bool backwards = best.backwards;
        best = fitOf(p, q);
        best.backwards = backwards;
    }
    return best;
}

/// The place on the curve that is meant, at a knot if there is one.
template <int Dim>
double parameterNear(const BSpline<Dim>& curve, const typename BSpline<Dim>::Point& point)
{
    for (const double knot : curve.breaks())
        if ((curve.at(knot) - point).norm() <= snapDistance)
            return curve.wrapped(knot);
    return curve.closest(point).parameter;
}

class TwinLinker {
public:
    TwinLinker(const Design& design, ElementId original, ElementId follower)
        : m_design(design)
        , m_original(original)
        , m_follower(follower)
    {
        Settings settings = design.settings();
        if (!settings.symmetry)
            settings.symmetry = Symmetry();
        m_symmetry = *settings.symmetry;
        put(settingsId, settings);
    }

    /// Says what is wrong, if anything.
    std::optional<Message> link()
    {
        const ElementPtr element = m_design.element(m_original);
        if (const auto* patch = std::get_if<Patch>(element.get()))
            return linkPatch(*patch, *m_design.find<Patch>(m_follower));
        if (const auto* curve = std::get_if<FixationCurve>(element.get()))
            return linkCurve(*curve, *m_design.find<FixationCurve>(m_follower));
        return linkDrawn(*element);
    }

    Edit result() const
    {
        Edit edit = m_edit;
        edit.verb = {QT_TRANSLATE_NOOP("Message", "Make %1 and %2 twins"),
                     {displayName(m_design, m_original), displayName(m_design, m_follower)}};
        return editBetween(m_design, withMarksOfBoth(m_design.with(edit)), edit.verb);
    }

private:
    /// What lies on one of them alone - an allowance, a notch - comes to lie on the other one, too, where there is
    /// nothing of its kind.
    Design withMarksOfBoth(const Design& linked) const
    {
        const SewnMirror mirror(linked, twinPairs(linked));
        Design result = linked;
        eachMarkKind([&]<class T>() {
            linked.each<T>([&](ElementId, const T& mark) {
                const ElementId patch = whereOf(mark).patch;
                if ((patch != m_original && patch != m_follower) || mirror.counterpart(mark).id != noElement)
                    return;
                if (const auto image = mirror.of(mark); image && !isTaken(result, *image))
                    result = result.with({{}, {{result.nextId(), nullptr, makeElement(*image)}}});
            });
        });
        return result;
    }

    template <class T>
    static bool isTaken(const Design& design, const T& image)
    {
        const BSpline2& outline = design.find<Patch>(whereOf(image).patch)->outline;
        bool taken = false;
        design.each<T>([&](ElementId, const T& other) {
            taken = taken ||
                    (whereOf(other).patch == whereOf(image).patch && meet(outline, whereOf(other), whereOf(image)));
        });
        return taken;
    }
    static bool meet(const BSpline2& outline, const Stretch& a, const Stretch& b)
    {
        return stretchesOverlap(outline, a, b);
    }
    static bool meet(const BSpline2& outline, const OutlinePlace& a, const OutlinePlace& b)
    {
        return (outline.at(outline.wrapped(a.at)) - outline.at(outline.wrapped(b.at))).norm() < snapDistance;
    }
    static bool meet(const BSpline2&, const PatchPoint& a, const PatchPoint& b)
    {
        return (a.position - b.position).norm() < snapDistance;
    }

    template <class T>
    void put(ElementId id, T value)
    {
        m_edit.changes.push_back({id, nullptr, makeElement(std::move(value))});
    }

    static Message tooDifferent(double rms)
    {
        return {QT_TRANSLATE_NOOP("Message",
                                  "They are no mirror images: they differ by %1 mm. Twins must be alike; "
                                  "make a mirror twin of one of them instead."),
                {numberText(rms, 3)}};
    }

    std::optional<Message> linkPatch(const Patch& original, const Patch& before)
    {
        const auto outline = mirroredCurve(original.outline);
        if (!outline || outline->empty() || before.outline.empty())
            return Message{QT_TRANSLATE_NOOP("Message", "These two cannot be twins.")};
        const Fit fit = bestFit(*outline, before.outline);
        if (fit.rms > mostDeviation * outline->boundingBox().diagonal().norm())
            return tooDifferent(fit.rms);
        Patch patch = original;
        patch.name = before.name;
        patch.outline = *outline;
        patch.grain = mirroredGrain(original.grain);
        patch.position = toLayout(before, fit.shift);
        patch.rotation = std::remainder(before.rotation + fit.angle * 180 / std::numbers::pi, 360);
        patch.twin = Twin{m_original, {}};
        put(m_follower, patch);
        moveDrawn(fit, before.outline, *outline);
        const auto at = [&](double t) { return parameterNear(*outline, fit.from(before.outline.at(t))); };
        const auto stretch = [&](const Stretch& s) {
            return fit.backwards ? Stretch{s.patch, at(s.to), at(s.from)} : Stretch{s.patch, at(s.from), at(s.to)};
        };
        const auto moved = [&]<class Where>(const Where& where) {
            if constexpr (std::is_same_v<Where, Stretch>)
                return stretch(where);
            else if constexpr (std::is_same_v<Where, OutlinePlace>)
                return OutlinePlace{where.patch, at(where.at)};
            else
                return PatchPoint{where.patch, fit.from(where.position)};
        };
        moveSewn(stretch, moved, fit.backwards);
        return std::nullopt;
    }

    /// The curves in the follower stay where they are in the layout; what lies on its outline stays on it.
    void moveDrawn(const Fit& fit, const BSpline2& before, const BSpline2& outline)
    {
        const OutlinePlaces places(before);
        for (const auto& [id, element] : m_design.elements()) {
            const PatchCurve* drawn = patchCurve(*element);
            if (!drawn || drawn->patch != m_follower)
                continue;
            std::vector<Vec2> points = drawn->curve.points();
            for (Vec2& point : points) {
                const bool on = places.parameter(point).has_value();
                if (!(fit.angle == 0 && fit.shift.isZero()))
                    point = fit.from(point);
                if (on)
                    point = outline.at(parameterNear(outline, point));
            }
            if (points != drawn->curve.points())
                m_edit.changes.push_back({id, nullptr, withPlaneCurve(*element, drawn->curve.withPoints(points))});
        }
    }

    template <class Map, class Moved>
    void moveSewn(const Map& stretch, const Moved& moved, bool backwards)
    {
        m_design.each<Seam>([&](ElementId id, Seam seam) {
            for (Stretch* side : {&seam.a, &seam.b})
                if (side->patch == m_follower) {
                    *side = stretch(*side);
                    seam.reversed = seam.reversed != backwards;
                }
            put(id, seam);
        });
        m_design.each<FixationSeam>([&](ElementId id, FixationSeam seam) {
            if (seam.stretch.patch != m_follower)
                return;
            seam.stretch = stretch(seam.stretch);
            seam.reversed = seam.reversed != backwards;
            if (backwards)
                std::reverse(seam.orientation.directions.begin(), seam.orientation.directions.end());
            put(id, seam);
        });
        eachMarkKind([&]<class T>() {
            m_design.each<T>([&](ElementId id, T mark) {
                if (whereOf(mark).patch != m_follower)
                    return;
                whereOf(mark) = moved(whereOf(mark));
                put(id, mark);
            });
        });
    }

    std::optional<Message> linkCurve(const FixationCurve& original, const FixationCurve& before)
    {
        const auto curve = mirroredCurve(original.curve, m_symmetry);
        if (!curve || curve->empty() || before.curve.empty() || curve->closed() != before.curve.closed())
            return Message{QT_TRANSLATE_NOOP("Message", "These two cannot be twins.")};
        const auto p = spread(*curve, curve->domainStart());
        const auto q = spread(before.curve, before.curve.domainStart());
        double ahead = 0;
        double back = 0;
        for (std::size_t i = 0; i < p.size(); ++i) {
            ahead += (p[i] - q[i]).squaredNorm();
            back += (p[i] - q[p.size() - 1 - i]).squaredNorm();
        }
        const double rms = std::sqrt(std::min(ahead, back) / twinSamples);
        if (!curve->closed() && rms > mostDeviation * ArcLength3(*curve).total())
            return tooDifferent(rms);
        FixationCurve moved = before;
        moved.curve = *curve;
        moved.twin = Twin{m_original, {}};
        put(m_follower, moved);
        const bool backwards = back < ahead;
        m_design.each<FixationSeam>([&](ElementId id, FixationSeam seam) {
            if (seam.curve != m_follower)
                return;
            if (auto& range = seam.curveRange) {
                const double from = parameterNear(*curve, before.curve.at(range->first));
                const double to = parameterNear(*curve, before.curve.at(range->second));
                range = backwards ? std::pair(to, from) : std::pair(from, to);
            }
            seam.reversed = seam.reversed != backwards;
            put(id, seam);
        });
        return std::nullopt;
    }

    std::optional<Message> linkDrawn(const Element& original)
    {
        const ElementPtr before = m_design.element(m_follower);
        const auto curve = mirroredCurve(*planeCurve(original));
        if (!curve)
            return Message{QT_TRANSLATE_NOOP("Message", "These two cannot be twins.")};
        if (const auto* handle = std::get_if<HandleCurve>(&original)) {
            const auto target = mirroredCurve(handle->target, m_symmetry);
            if (!target)
                return Message{QT_TRANSLATE_NOOP("Message", "These two cannot be twins.")};
            HandleCurve twin = *handle;
            twin.target = *target;
            twin.orientation = mirroredOrientation(handle->orientation, m_symmetry);
            putDrawn(twin, *before, *curve);
        } else if (const auto* fancy = std::get_if<FancySeam>(&original)) {
            putDrawn(FancySeam(*fancy), *before, *curve);
        } else if (const auto* line = std::get_if<InternalLine>(&original)) {
            putDrawn(InternalLine(*line), *before, *curve);
        }
        return std::nullopt;
    }

    template <class T>
    void putDrawn(T twin, const Element& before, const BSpline2& curve)
    {
        twin.name = elementName(before);
        twin.patch = patchCurve(before)->patch;
        twin.curve = curve;
        twin.twin = Twin{m_original, {}};
        put(m_follower, std::move(twin));
    }

    const Design& m_design;
    ElementId m_original;
    ElementId m_follower;
    Symmetry m_symmetry;
    Edit m_edit;
};

} // namespace

Edit linkTwins(const Design& design, ElementId original, ElementId follower, Message* problem)
{
    const ElementPtr a = design.element(original);
    const ElementPtr b = design.element(follower);
    std::optional<Message> wrong;
    if (!a || !b || a == b || a->index() != b->index() || !canBeTwin(*a) || twinOf(design, original) != noElement ||
        twinOf(design, follower) != noElement)
        wrong = Message{QT_TRANSLATE_NOOP("Message", "These two cannot be twins.")};
    TwinLinker linker(design, original, follower);
    if (!wrong)
        wrong = linker.link();
    if (!wrong)
        return linker.result();
    if (problem)
        *problem = *wrong;
    return {};
}

} // namespace bolster::edits
