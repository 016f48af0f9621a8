#include "CoverPointDrag.h"

#include "CurveEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "ToolGeometry.h"
#include "Units.h"

#include <QCoreApplication>
#include <QLocale>

#include <algorithm>
#include <array>
#include <cmath>

namespace bolster {

namespace {

using Axis = CoverPointDrag::Axis;

Vec3 direction(Axis axis)
{
    return axis == Axis::X ? Vec3::UnitX() : axis == Axis::Y ? Vec3::UnitY() : Vec3::UnitZ();
}

QColor colorOf(Axis axis)
{
    return axisColor(axis == Axis::X ? 0 : axis == Axis::Y ? 1 : 2);
}

Axis dominantAxis(const Vec3& way)
{
    Eigen::Index axis = 0;
    way.cwiseAbs().maxCoeff(&axis);
    return std::array{Axis::X, Axis::Y, Axis::Z}[static_cast<std::size_t>(axis)];
}

constexpr double touching = 2; // mm: a point so near lies on the frame

std::optional<CoverFoot> footOf(const CoverToolContext& context, const Vec3& point)
{
    return context.nearest(point, CoverHit::Kind::Frame);
}

bool touches(const CoverToolContext& context, const Vec3& point)
{
    const std::optional<CoverFoot> foot = footOf(context, point);
    return foot && (foot->position - point).norm() <= touching;
}

} // namespace

Edit moveCurvePointsTogether(const Design& design, const std::set<std::pair<ElementId, int>>& points,
                             const Vec3& delta)
{
    std::map<ElementId, std::vector<int>> byCurve;
    for (const auto& [id, point] : points)
        if (const int index = spacePoint(design, {id, point}); index >= 0)
            byCurve[id].push_back(index);
    EditChain chain(design);
    for (const auto& [id, indices] : byCurve)
        chain.add(edits::moveCurvePoints(chain.design(), id, indices, delta));
    return chain.result(
        Message{QT_TRANSLATE_NOOP("Message", "Move points of %1 curves"), {std::to_string(byCurve.size())}});
}

CoverPointDrag::CoverPointDrag(CoverToolContext& context, const CoverPointer& pressed, const Vec3& grabbed)
    : m_context(context)
    , m_gesture(context.document())
    , m_points(context.selection().points())
    , m_pressed(pressed)
    , m_now(pressed)
    , m_grabbed(grabbed)
{
    const bool fixations = std::ranges::all_of(
        m_points, [&](const auto& point) { return m_gesture.start().find<FixationCurve>(point.first) != nullptr; });
    m_onSurface = fixations && touches(context, grabbed);
    if (const std::optional<Vec2> at = context.toolCamera().pixel(grabbed)) {
        const CoverHit hit = context.ground({at->x(), at->y()});
        m_visible = hit.kind == CoverHit::Kind::Frame && (hit.position - grabbed).norm() <= 2 * touching;
    }
}

void CoverPointDrag::update(const CoverPointer& pointer)
{
    m_now = pointer;
    apply();
}

void CoverPointDrag::constrain(Axis axis)
{
    m_wanted = m_wanted == axis ? Axis::None : axis;
    apply();
}

/// How far the point goes along the axis to come as near to the pointer as it can.
Vec3 CoverPointDrag::alongAxis(Axis axis) const
{
    const auto parameter = [&](QPointF pixel) {
        return alongLine(m_context.toolCamera(), m_grabbed, direction(axis), pixel);
    };
    return (parameter(m_now.pixel) - parameter(m_pressed.pixel)) * direction(axis);
}

void CoverPointDrag::toggleSurface()
{
    m_onSurface = !m_onSurface;
    m_wanted = Axis::None;
    const std::optional<CoverFoot> foot = footOf(m_context, m_grabbed);
    const double height = foot ? (m_grabbed - foot->position).dot(foot->normal) : 0;
    m_height = std::abs(height) > touching ? height : 0;
    m_visible = m_visible && m_height == 0;
    apply();
}

/// In the plane parallel to the picture.
Vec3 CoverPointDrag::parallel() const
{
    const Camera& camera = m_context.toolCamera();
    const auto onPlane = [&](QPointF p) { return camera.onPlaneThrough(m_grabbed, {p.x(), p.y()}); };
    return onPlane(m_now.pixel) - onPlane(m_pressed.pixel);
}

/// Under the pointer where the frame is seen, else as near as the frame comes to it.
std::optional<Vec3> CoverPointDrag::alongSurface() const
{
    const std::optional<Vec2> grabbed = m_context.toolCamera().pixel(m_grabbed);
    Vec3 wanted = m_grabbed + parallel();
    if (grabbed && m_visible) {
        const QPointF pixel = QPointF(grabbed->x(), grabbed->y()) + m_now.pixel - m_pressed.pixel;
        if (const CoverHit hit = m_context.ground(pixel); hit.kind == CoverHit::Kind::Frame)
            wanted = hit.position;
    }
    const std::optional<CoverFoot> foot = footOf(m_context, wanted);
    if (!foot)
        return std::nullopt;
    return foot->position + m_height * foot->normal - m_grabbed;
}

Vec3 CoverPointDrag::lifted() const
{
    const auto parameter = [&](QPointF pixel) {
        return alongLine(m_context.toolCamera(), m_grabbed + m_lift->delta, m_lift->normal, pixel);
    };
    return m_lift->delta + (parameter(m_now.pixel) - parameter(m_lift->from.pixel)) * m_lift->normal;
}

Vec3 CoverPointDrag::wanted()
{
    if (!liftWanted())
        m_lift.reset();
    else if (const auto foot = footOf(m_context, grabbedNow()); foot && !m_lift)
        m_lift = Lift{m_now, m_delta, foot->normal};
    if (m_lift)
        return lifted();
    const Vec3 free = parallel();
    m_axis = m_wanted;
    if (m_axis == Axis::None && m_now.modifiers & Qt::ShiftModifier)
        m_axis = dominantAxis(free);
    if (m_axis != Axis::None)
        return alongAxis(m_axis);
    return m_onSurface ? alongSurface().value_or(free) : free;
}

void CoverPointDrag::apply()
{
    m_delta = wanted();
    m_gesture.update(edit());
}

/// Of several points each that lies on the frame stays on it.
Edit CoverPointDrag::edit() const
{
    const Design& start = m_gesture.start();
    const Edit together = moveCurvePointsTogether(start, m_points, m_delta);
    if (!m_onSurface || m_lift || m_axis != Axis::None || m_points.size() < 2)
        return together;
    EditChain chain(start);
    chain.add(together);
    for (const auto& [id, point] : m_points) {
        const int index = spacePoint(start, {id, point});
        if (index < 0)
            continue;
        const Vec3 before = spaceCurve(*start.element(id))->points()[static_cast<std::size_t>(index)];
        const std::optional<CoverFoot> foot = footOf(m_context, before + m_delta);
        if (foot && touches(m_context, before))
            chain.add(
                edits::moveCurvePoints(chain.design(), id, std::array{index}, foot->position - before - m_delta));
    }
    return chain.result(together.verb);
}

QString CoverPointDrag::hint() const
{
    if (m_lift)
        return QCoreApplication::translate("bolster::CoverSelectTool",
                                           "Lifted off the frame along its normal; let go of Ctrl to slide on it");
    if (m_axis != Axis::None)
        return QCoreApplication::translate("bolster::CoverSelectTool", "Kept to an axis; the same key frees it");
    return m_onSurface
               ? QCoreApplication::translate(
                     "bolster::CoverSelectTool",
                     "On the frame: Ctrl lifts off, S lets go of it, X, Y, Z or Shift keep to an axis")
               : QCoreApplication::translate(
                     "bolster::CoverSelectTool",
                     "X, Y, Z or Shift keep to an axis, S keeps to the frame, Ctrl lifts off, Escape cancels");
}

QString CoverPointDrag::prompt() const
{
    const QString moved =
        QCoreApplication::translate("bolster::CoverSelectTool", "Moved by x %1, y %2, z %3")
            .arg(steadyLengthFigure(m_delta.x()), steadyLengthFigure(m_delta.y()), steadyLengthText(m_delta.z()));
    return moved + QStringLiteral(" \u2013 ") + hint();
}

std::vector<SceneLine> CoverPointDrag::guides() const
{
    std::vector<SceneLine> lines;
    const double reach = 4000;
    const auto add = [&](const Vec3& a, const Vec3& b, const QColor& color) {
        SceneLine line;
        line.points = {a.cast<float>(), b.cast<float>()};
        line.color = color;
        line.width = 1.4F;
        line.hidden = 0.6F;
        lines.push_back(std::move(line));
    };
    if (m_lift)
        add(m_grabbed + m_lift->delta, grabbedNow(), m_context.colors().accent);
    else if (m_axis != Axis::None)
        add(m_grabbed - reach * direction(m_axis), m_grabbed + reach * direction(m_axis), colorOf(m_axis));
    else
        add(m_grabbed, grabbedNow(), m_context.colors().hover);
    return lines;
}

} // namespace bolster
