#include "DartRotation.h"

#include "ArcLength.h"
#include "DartClosing.h"
#include "DartEdits.h"
#include "DesignCheck.h"
#include "EditBuilder.h"
#include "OutlineCrossings.h"
#include "OutlinePlaces.h"
#include "PatchPoints.h"
#include "PlaneCurves.h"
#include "StretchRemap.h"
#include "Twins.h"

#include <cmath>
#include <numbers>

namespace bolster::edits {

namespace {

constexpr double asLong = 0.05;   // mm: legs that nobody could tell apart
constexpr double shortestArc = 5; // mm of the outline, from a mouth's end to the new place

/// The ring of an outline: legs from a over the tip to b, then the arc to p, then the arc back to a; unwrapped.
struct DartRing {
    double a = 0, tip = 0, b = 0, p = 0, end = 0;

    double opening() const { return b - a; }
};

/// The same place as t, after `from`, by a period at most.
double nextAfter(const BSpline2& outline, double from, double t)
{
    const double period = outline.period();
    const double way = t - from - period * std::floor((t - from) / period);
    return way > 0 ? from + way : from + period;
}

std::optional<DartRing> ringOf(const Design& design, ElementId seam, double to)
{
    const std::optional<DartShape> dart = dartOf(design, seam);
    if (!dart)
        return std::nullopt;
    const Seam& sewn = *design.find<Seam>(seam);
    const BSpline2& outline = design.find<Patch>(dart->patch)->outline;
    const auto after = [&](double from, double t) { return nextAfter(outline, from, t); };
    DartRing ring;
    ring.a = dart->from;
    ring.tip = after(ring.a, sewn.a.from == dart->from ? sewn.a.to : sewn.b.to);
    ring.b = after(ring.tip, dart->to);
    ring.p = after(ring.b, to);
    ring.end = ring.a + outline.period();
    return ring;
}

class Rotation {
public:
    Rotation(const Design& design, ElementId patch, const DartRing& ring)
        : m_design(design)
        , m_id(patch)
        , m_patch(*design.find<Patch>(patch))
        , m_outline(m_patch.outline)
        , m_ring(ring)
        , m_length(m_outline)
        , m_tip(at(ring.tip))
        , m_turnsFirst(m_length.between(ring.b, ring.p) <= m_length.between(ring.p, ring.end))
        , m_builder(design)
    {
        const Vec2 a = at(ring.a) - m_tip, b = at(ring.b) - m_tip;
        const double angle = std::atan2(cross(b, a), b.dot(a)); // from leg to leg
        m_turn = Eigen::Translation2d(m_tip) * Eigen::Rotation2Dd(m_turnsFirst ? angle : -angle) *
                 Eigen::Translation2d(-m_tip);
    }

    /// Why not, if not.
    std::optional<Message> run()
    {
        if (std::optional<Message> problem = lineProblem())
            return problem;
        m_region = joined({turnedArc(), legs(turnedArc().points().back(), turnedArc().points().front())}, nullptr);
        Patch changed = m_patch;
        changed.outline = opened();
        if (changed.cutting.label && side(changed.cutting.label->position) > 0) {
            PieceLabelPlace& label = *changed.cutting.label;
            label.position = m_turn * label.position;
            label.rotation += Eigen::Rotation2Dd(m_turn.linear()).angle() * 180 / std::numbers::pi;
        }
        if (outlineProblem(changed.outline))
            return Message{QT_TRANSLATE_NOOP("Message", "Opened there, the outline of %1 would cross itself."),
                           {displayName(m_design, m_id)}};
        m_builder.replace(m_id, std::move(changed));
        std::vector<ElementId> dropped;
        remapStretches(m_design, {{m_id, arcs()}}, {}, m_builder, dropped);
        return turnWhatLiesInside();
    }

    const Design& result() const { return m_builder.now(); }

private:
    Vec2 at(double t) const { return m_outline.at(m_outline.wrapped(t)); }
    BSpline2 part(double from, double to) const
    {
        return m_outline.part(m_outline.wrapped(from), m_outline.wrapped(to));
    }
    BSpline2 turnedArc() const { return m_turnsFirst ? part(m_ring.b, m_ring.p) : part(m_ring.p, m_ring.end); }

    std::optional<Message> lineProblem() const
    {
        if (std::abs((at(m_ring.a) - m_tip).norm() - (at(m_ring.b) - m_tip).norm()) > asLong)
            return Message{QT_TRANSLATE_NOOP("Message", "The legs of the dart must be of one length to be rotated: "
                                                        "drag its tip onto the dotted line."),
                           {}};
        if (std::min(m_length.between(m_ring.b, m_ring.p), m_length.between(m_ring.p, m_ring.end)) < shortestArc)
            return Message{
                QT_TRANSLATE_NOOP("Message", "A dart is rotated to a place at least 5 mm from its mouth."), {}};
        const Vec2 to = at(m_ring.p);
        bool leaves = !isInside(m_outline, (m_tip + to) / 2);
        for (const OutlineCrossing& crossing : outlineCrossings(m_outline, {m_tip, to}))
            leaves = leaves || ((crossing.point - m_tip).norm() > 0.1 && (crossing.point - to).norm() > 0.1);
        if (leaves)
            return Message{
                QT_TRANSLATE_NOOP("Message", "The line from the tip of the dart to there would leave %1."),
                {displayName(m_design, m_id)}};
        return std::nullopt;
    }

    /// From one point over the tip to another, in as much of the parameter as the legs had.
    BSpline2 legs(const Vec2& from, const Vec2& to) const
    {
        const auto leg = [&](const Vec2& a, const Vec2& b, double start, double span) {
            return polyline({a, b}, m_outline.degree(), start, (b - a).norm() / span);
        };
        const BSpline2 one = leg(from, m_tip, 0, m_ring.tip - m_ring.a);
        const BSpline2 two = leg(m_tip, to, 0, m_ring.b - m_ring.tip);
        // As one open curve: the knots of the second follow those of the first.
        std::vector<Vec2> points = one.points();
        points.insert(points.end(), two.points().begin() + 1, two.points().end());
        std::vector<double> knots(one.knots().begin(), one.knots().end() - 1);
        for (std::size_t k = static_cast<std::size_t>(m_outline.degree()) + 1; k < two.knots().size(); ++k)
            knots.push_back(two.knots()[k] + one.domainEnd());
        return {m_outline.degree(), false, std::move(points), std::move(knots)};
    }

    BSpline2 opened() const
    {
        const BSpline2 first = part(m_ring.b, m_ring.p), second = part(m_ring.p, m_ring.end);
        const BSpline2 turned = *mapped(m_turnsFirst ? first : second, m_turn);
        const Vec2 fixed = at(m_ring.p), moved = m_turn * fixed;
        const BSpline2 whole = m_turnsFirst ? joined({second, turned, legs(moved, fixed)}, nullptr)
                                            : joined({first, legs(fixed, moved), turned}, nullptr);
        const double start = inFirstTurn(m_outline, m_turnsFirst ? m_ring.p : m_ring.b);
        // Where the dart was: it may have been opened there, and come back.
        return withoutJoint(beginningAt(whole, start), m_turnsFirst ? start + m_ring.end - m_ring.p : start);
    }

    std::vector<OutlineArc> arcs() const
    {
        const double open = m_ring.opening();
        const OutlineArc first{m_ring.b, m_ring.p, m_id, m_turnsFirst ? m_ring.b - open : m_ring.b};
        const OutlineArc second{m_ring.p, m_ring.end, m_id, m_turnsFirst ? m_ring.p : m_ring.p + open};
        const OutlineArc legs{m_ring.a, m_ring.b, m_id, m_turnsFirst ? m_ring.p - open : m_ring.p};
        return {first, second, legs};
    }

    /// 1: in the turned part, -1: in the other one, 0: on the line between them, or on a leg.
    int side(const Vec2& point) const
    {
        const BSpline2::Closest closest = m_outline.closest(point);
        if (closest.distance <= onOutline) {
            const double t = nextAfter(m_outline, m_ring.a, closest.parameter);
            if (t < m_ring.b || t == m_ring.end)
                return 0;
            return (t < m_ring.p) == m_turnsFirst ? 1 : -1;
        }
        if (m_region.closest(point).distance <= onOutline)
            return 0;
        return isInside(m_region, point) ? 1 : -1;
    }

    std::optional<Message> turnWhatLiesInside()
    {
        movePatchPoints(
            m_design.elements(), m_id,
            [&](PatchPoint& point) {
                if (side(point.position) > 0)
                    point.position = m_turn * point.position;
            },
            [&](ElementId id, ElementPtr moved) { m_builder.set(id, std::move(moved)); });
        for (const auto& [id, element] : m_design.elements()) {
            const PatchCurve* drawn = patchCurve(*element);
            if (!drawn || drawn->patch != m_id || drawn->curve.empty())
                continue;
            const std::optional<int> where = sideOf(drawn->curve);
            if (!where)
                return Message{QT_TRANSLATE_NOOP("Message", "%1 lies across the line from the tip of the dart to "
                                                            "there: move it, or rotate the dart elsewhere."),
                               {displayName(m_design, id)}};
            if (const auto turned = *where > 0 ? mapped(drawn->curve, m_turn) : std::nullopt)
                m_builder.set(id, withPlaneCurve(*element, *turned));
        }
        return std::nullopt;
    }

    /// Nothing for a curve that lies on both sides.
    std::optional<int> sideOf(const BSpline2& curve) const
    {
        constexpr int samples = 100;
        bool in = false, out = false;
        for (int k = 0; k <= samples; ++k) {
            const int where = side(curve.at(curve.domainStart() + curve.period() * k / samples));
            in = in || where > 0;
            out = out || where < 0;
            if (where == 0 && (k == 0 || k == samples)) // its end would hang on what is no outline any more
                in = out = true;
        }
        return in && out ? std::nullopt : std::optional(in ? 1 : -1);
    }

    const Design& m_design;
    ElementId m_id;
    const Patch& m_patch;
    const BSpline2& m_outline;
    DartRing m_ring;
    ArcLength2 m_length;
    Vec2 m_tip;
    bool m_turnsFirst; ///< the arc that follows the dart, else the one before it
    Map2 m_turn;
    BSpline2 m_region; ///< the turned part where it was
    EditBuilder m_builder;
};

} // namespace

Edit rotateDart(const Design& design, ElementId seam, double to, Message* problem)
{
    const auto refuse = [&](Message why) {
        if (problem)
            *problem = std::move(why);
        return Edit{};
    };
    const std::optional<DartShape> dart = dartOf(design, seam);
    if (!dart)
        return refuse({QT_TRANSLATE_NOOP("Message", "Select the seam of a dart."), {}});
    Design now = design;
    for (const ElementId each : {seam, twinDart(design, *dart)}) {
        const std::optional<DartRing> ring = ringOf(now, each, to);
        if (!ring)
            continue;
        Rotation rotation(now, dartOf(now, each)->patch, *ring);
        if (std::optional<Message> why = rotation.run())
            return refuse(std::move(*why));
        now = Design(rotation.result());
    }
    return editBetween(design, now,
                       {QT_TRANSLATE_NOOP("Message", "Rotate a dart of %1"), {displayName(design, dart->patch)}});
}

} // namespace bolster::edits
