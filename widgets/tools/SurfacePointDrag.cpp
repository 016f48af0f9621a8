#include "SurfacePointDrag.h"

#include "CurveEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "ToolGeometry.h"

#include <QCoreApplication>
#include <QLocale>

#include <array>
#include <cmath>

namespace bolster {

namespace {

using Axis = SurfacePointDrag::Axis;

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

SurfacePointDrag::SurfacePointDrag(SurfaceToolContext& context, const SurfacePointer& pressed, const Vec3& grabbed)
    : m_context(context)
    , m_gesture(context.document())
    , m_points(context.selection().points())
    , m_pressed(pressed)
    , m_now(pressed)
    , m_grabbed(grabbed)
{}

void SurfacePointDrag::update(const SurfacePointer& pointer)
{
    m_now = pointer;
    apply();
}

void SurfacePointDrag::constrain(Axis axis)
{
    m_wanted = m_wanted == axis ? Axis::None : axis;
    apply();
}

/// How far the point goes along the axis to come as near to the pointer as it can.
Vec3 SurfacePointDrag::alongAxis(Axis axis) const
{
    const auto parameter = [&](QPointF pixel) {
        return alongLine(m_context.toolCamera(), m_grabbed, direction(axis), pixel);
    };
    return (parameter(m_now.pixel) - parameter(m_pressed.pixel)) * direction(axis);
}

void SurfacePointDrag::apply()
{
    const Camera& camera = m_context.toolCamera();
    const auto onPlane = [&](QPointF p) { return camera.onPlaneThrough(m_grabbed, {p.x(), p.y()}); };
    const Vec3 free = onPlane(m_now.pixel) - onPlane(m_pressed.pixel);
    m_axis = m_wanted;
    if (m_axis == Axis::None && m_now.modifiers & Qt::ShiftModifier)
        m_axis = dominantAxis(free);
    m_delta = m_axis == Axis::None ? free : alongAxis(m_axis);
    m_gesture.update(moveCurvePointsTogether(m_gesture.start(), m_points, m_delta));
}

QString SurfacePointDrag::prompt() const
{
    const QLocale locale;
    const auto mm = [&](double value) { return locale.toString(value, 'f', 1); };
    const QString moved = QCoreApplication::translate("bolster::SurfaceSelectTool", "Moved by x %1, y %2, z %3 mm")
                              .arg(mm(m_delta.x()), mm(m_delta.y()), mm(m_delta.z()));
    const QString hint =
        m_axis == Axis::None
            ? QCoreApplication::translate("bolster::SurfaceSelectTool",
                                          "X, Y, Z or Shift keep to an axis, Escape cancels")
            : QCoreApplication::translate("bolster::SurfaceSelectTool", "Kept to an axis; the same key frees it");
    return moved + QStringLiteral(" \u2013 ") + hint;
}

std::vector<SurfaceLine> SurfacePointDrag::guides() const
{
    std::vector<SurfaceLine> lines;
    const double reach = 4000;
    const auto add = [&](const Vec3& a, const Vec3& b, const QColor& color) {
        SurfaceLine line;
        line.points = {a.cast<float>(), b.cast<float>()};
        line.color = color;
        line.width = 1.4F;
        line.hidden = 0.6F;
        lines.push_back(std::move(line));
    };
    if (m_axis != Axis::None)
        add(m_grabbed - reach * direction(m_axis), m_grabbed + reach * direction(m_axis), colorOf(m_axis));
    else
        add(m_grabbed, grabbedNow(), m_context.colors().hover);
    return lines;
}

} // namespace bolster
