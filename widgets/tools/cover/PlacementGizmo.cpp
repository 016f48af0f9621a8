#include "PlacementGizmo.h"

#include "Document.h"
#include "ElementEdits.h"
#include "ElementText.h"
#include "Selection.h"
#include "ToolGeometry.h"
#include "Units.h"

#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

// Pixels.
constexpr double arrowStart = 22;
constexpr double arrowEnd = 96;
constexpr double ringRadius = 74;
constexpr double middleSize = 9;
constexpr double gizmoReach = 7;

constexpr double snapAngle = 15 * std::numbers::pi / 180;

double snapped(double value, double step, Qt::KeyboardModifiers modifiers)
{
    return modifiers & Qt::ControlModifier ? step * std::round(value / step) : value;
}

} // namespace

std::optional<ElementId> PlacementGizmo::subject() const
{
    const Selection::Elements& elements = m_context.selection().elements();
    if (elements.size() != 1)
        return {};
    const ElementPtr element = m_context.document().design().element(*elements.begin());
    return element && elementPlacement(*element) ? std::optional(*elements.begin()) : std::nullopt;
}

Vec3 PlacementGizmo::pivot(ElementId id) const
{
    return m_drag ? Vec3(m_drag->pivot + m_drag->moved) : m_context.middleOf(id);
}

std::vector<PlacementGizmo::Shape> PlacementGizmo::shapes(const Vec3& pivot) const
{
    const Camera& camera = m_context.toolCamera();
    const double pixel = camera.pixelSize(pivot);
    std::vector<Shape> shapes;
    for (int axis = 0; axis < 3; ++axis) {
        const Vec3 along = Vec3::Unit(axis);
        Vec3 across = along.cross(camera.backward());
        across = across.norm() > 1e-6 ? Vec3(across.normalized()) : camera.rightward();
        const Vec3 tip = pivot + arrowEnd * pixel * along, back = tip - 13 * pixel * along;
        shapes.push_back({{Handle::Kind::Arrow, axis},
                          {pivot + arrowStart * pixel * along, tip, back + 5 * pixel * across, tip,
                           back - 5 * pixel * across, tip}});
    }
    for (int axis = 0; axis < 3; ++axis) {
        constexpr int count = 64;
        Shape ring{{Handle::Kind::Ring, axis}, {}};
        for (int i = 0; i <= count; ++i) {
            const double angle = 2 * std::numbers::pi * i / count;
            ring.points.push_back(pivot + ringRadius * pixel *
                                              (std::cos(angle) * Vec3::Unit((axis + 1) % 3) +
                                               std::sin(angle) * Vec3::Unit((axis + 2) % 3)));
        }
        shapes.push_back(std::move(ring));
    }
    const Vec3 u = middleSize * pixel * camera.rightward(), v = middleSize * pixel * camera.upward();
    shapes.push_back(
        {{Handle::Kind::Middle, 0}, {pivot - u - v, pivot + u - v, pivot + u + v, pivot - u + v, pivot - u - v}});
    return shapes;
}

PlacementGizmo::Handle PlacementGizmo::handleAt(QPointF position) const
{
    const std::optional<ElementId> id = subject();
    if (!id)
        return {};
    const Camera& camera = m_context.toolCamera();
    const Vec2 pixel(position.x(), position.y());
    const Vec3 centre = pivot(*id);
    if (const std::optional<Vec2> middle = camera.pixel(centre);
        middle && (*middle - pixel).cwiseAbs().maxCoeff() < middleSize + 2)
        return {Handle::Kind::Middle, 0};
    Handle best;
    double nearest = gizmoReach;
    for (const Shape& shape : shapes(centre))
        if (const double d = distanceInPicture(camera, shape.points, pixel); d < nearest) {
            nearest = d;
            best = shape.handle;
        }
    return best;
}

bool PlacementGizmo::press(const CoverPointer& pointer)
{
    const std::optional<ElementId> id = subject();
    m_hovered = handleAt(pointer.pixel);
    if (!id || !hovering())
        return false;
    m_drag = std::make_unique<Drag>(m_context.document(), *id, m_context.middleOf(*id), pointer);
    return true;
}

bool PlacementGizmo::move(const CoverPointer& pointer)
{
    if (m_drag && !m_drag->gesture.active())
        m_drag.reset(); // undone or replaced meanwhile
    if (m_drag)
        update(pointer);
    else
        m_hovered = handleAt(pointer.pixel);
    return hovering();
}

void PlacementGizmo::release(const CoverPointer& pointer)
{
    if (!m_drag)
        return;
    if (m_drag->gesture.active() && pointer.pixel != m_drag->pressed.pixel)
        update(pointer);
    // What is finished must not be there any more when its edit is announced.
    const std::unique_ptr<Drag> finished = std::move(m_drag);
    finished->gesture.commit();
}

void PlacementGizmo::cancel()
{
    m_drag.reset();
    m_hovered = {};
}

Vec3 PlacementGizmo::wayOf(const CoverPointer& pointer) const
{
    const Camera& camera = m_context.toolCamera();
    if (m_hovered.kind == Handle::Kind::Arrow) {
        const Vec3 along = Vec3::Unit(m_hovered.axis);
        const double way = alongLine(camera, m_drag->pivot, along, pointer.pixel) -
                           alongLine(camera, m_drag->pivot, along, m_drag->pressed.pixel);
        return snapped(way, nudgeLength(true), pointer.modifiers) * along;
    }
    const auto onPlane = [&](QPointF p) { return camera.onPlaneThrough(m_drag->pivot, {p.x(), p.y()}); };
    Vec3 way = onPlane(pointer.pixel) - onPlane(m_drag->pressed.pixel);
    for (double& value : way)
        value = snapped(value, nudgeLength(true), pointer.modifiers);
    return way;
}

/// Around the pivot in the picture, from where it was grabbed; the axis may point towards the eye or away.
double PlacementGizmo::angleOf(const CoverPointer& pointer) const
{
    const Camera& camera = m_context.toolCamera();
    const std::optional<Vec2> middle = camera.pixel(m_drag->pivot);
    if (!middle)
        return 0;
    const auto angle = [&](QPointF p) { return std::atan2(middle->y() - p.y(), p.x() - middle->x()); };
    const double turned = std::remainder(angle(pointer.pixel) - angle(m_drag->pressed.pixel), 2 * std::numbers::pi);
    const Vec3 towardsEye = camera.perspective ? Vec3(camera.eye() - m_drag->pivot) : camera.backward();
    return snapped(towardsEye[m_hovered.axis] < 0 ? -turned : turned, snapAngle, pointer.modifiers);
}

void PlacementGizmo::update(const CoverPointer& pointer)
{
    const Design& start = m_drag->gesture.start();
    const ElementPtr element = start.element(m_drag->element);
    Placement placement = *elementPlacement(*element);
    const bool turns = m_hovered.kind == Handle::Kind::Ring;
    if (turns) {
        m_drag->turned = angleOf(pointer);
        const Quat turn(Eigen::AngleAxisd(m_drag->turned, Vec3::Unit(m_hovered.axis)));
        placement.rotation = (turn * placement.rotation).normalized();
        placement.position = m_drag->pivot + turn * (placement.position - m_drag->pivot);
    } else {
        m_drag->moved = wayOf(pointer);
        placement.position += m_drag->moved;
    }
    const std::string name = displayName(start, m_drag->element).toStdString();
    m_drag->gesture.update(edits::replaceElement(start, m_drag->element, withPlacement(*element, placement),
                                                 turns ? Message{QT_TRANSLATE_NOOP("Message", "Turn %1"), {name}}
                                                       : Message{QT_TRANSLATE_NOOP("Message", "Move %1"), {name}}));
}

QString PlacementGizmo::prompt() const
{
    if (m_drag && m_hovered.kind == Handle::Kind::Ring)
        return tr("Turned by %1\u00b0 \u2013 Ctrl snaps to 15\u00b0, Escape cancels")
            .arg(decimalText(m_drag->turned * 180 / std::numbers::pi, 1, true));
    if (m_drag)
        return tr("Moved by x %1, y %2, z %3 \u2013 Ctrl snaps to %4, Escape cancels")
            .arg(steadyLengthFigure(m_drag->moved.x()), steadyLengthFigure(m_drag->moved.y()),
                 steadyLengthText(m_drag->moved.z()), lengthText(nudgeLength(true)));
    switch (m_hovered.kind) {
    case Handle::Kind::Arrow:
        return tr("Drag to move it along this axis");
    case Handle::Kind::Ring:
        return tr("Drag to turn it about this axis");
    case Handle::Kind::Middle:
        return tr("Drag to move it parallel to the picture");
    case Handle::Kind::None:
        break;
    }
    return {};
}

std::vector<SceneLine> PlacementGizmo::guides() const
{
    std::vector<SceneLine> lines;
    const std::optional<ElementId> id = subject();
    if (!id)
        return lines;
    for (const Shape& shape : shapes(pivot(*id))) {
        if (m_drag && shape.handle != m_hovered)
            continue;
        SceneLine line;
        for (const Vec3& p : shape.points)
            line.points.push_back(p.cast<float>());
        line.color =
            shape.handle.kind == Handle::Kind::Middle ? QColor(0xf4, 0xf4, 0xf4) : axisColor(shape.handle.axis);
        const bool strong = shape.handle == m_hovered;
        line.width = strong ? 4 : shape.handle.kind == Handle::Kind::Ring ? 1.6F : 2.6F;
        line.hidden = strong ? 1 : 0.65F;
        line.casing = 0.8F;
        lines.push_back(std::move(line));
    }
    return lines;
}

} // namespace bolster
