#include "CoverSelectTool.h"

#include "CurveEdits.h"
#include "Document.h"
#include "MouseStyle.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "ToolGeometry.h"
#include "Units.h"

#include <QKeyEvent>

#include <cmath>

namespace bolster {

namespace {

/// The world's axis that runs most along a direction, with its sign.
Vec3 nearestAxis(const Vec3& direction)
{
    Eigen::Index axis = 0;
    direction.cwiseAbs().maxCoeff(&axis);
    Vec3 result = Vec3::Zero();
    result[axis] = direction[axis] < 0 ? -1 : 1;
    return result;
}

/// Keys move along the axes as the eye sees them: right and up in the picture, the third one into it.
std::optional<Vec3> keyDirection(int key, const Camera& camera)
{
    const Vec3 right = nearestAxis(camera.rightward());
    const Vec3 seenUp = camera.upward();
    const Vec3 up = nearestAxis(seenUp - seenUp.cwiseProduct(right.cwiseAbs()));
    const Vec3 away = nearestAxis(-camera.backward().cwiseProduct(right.cross(up).cwiseAbs()));
    switch (key) {
    case Qt::Key_Left:
        return -right;
    case Qt::Key_Right:
        return right;
    case Qt::Key_Up:
        return up;
    case Qt::Key_Down:
        return -up;
    case Qt::Key_PageUp:
        return away;
    case Qt::Key_PageDown:
        return -away;
    default:
        return {};
    }
}

std::optional<CoverPointDrag::Axis> axisOf(int key)
{
    switch (key) {
    case Qt::Key_X:
        return CoverPointDrag::Axis::X;
    case Qt::Key_Y:
        return CoverPointDrag::Axis::Y;
    case Qt::Key_Z:
        return CoverPointDrag::Axis::Z;
    default:
        return {};
    }
}

} // namespace

void CoverSelectTool::press(const CoverPointer& pointer)
{
    m_nudges.end();
    if (m_gizmo.press(pointer)) {
        m_context.refresh();
        return;
    }
    m_pressed = pointer;
    m_pressedHit = m_context.hit(pointer.pixel);
    // Only points are dragged; other things are selected on release, because a drag on them turns the view.
    m_alreadySelected = false;
    if (m_pressedHit.kind == CoverHit::Kind::Point)
        select(pointer);
    m_context.refresh();
}

void CoverSelectTool::select(const CoverPointer& pointer)
{
    Selection& selection = m_context.selection();
    const bool add = pointer.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
    const CoverHit& hit = m_pressedHit;
    if (hit.kind == CoverHit::Kind::Point) {
        const Selection::Point point{hit.element, hit.point};
        m_alreadySelected = selection.contains(point) && !add;
        if (add)
            selection.toggle(point);
        else if (!m_alreadySelected)
            selection.set({hit.element}, {point});
    } else if (hit && add) {
        selection.toggle(hit.element);
    } else if (hit) {
        selection.set({hit.element});
    } else if (!add) {
        selection.clear();
    }
}

bool CoverSelectTool::drag(const CoverPointer& pointer)
{
    if (!m_drag) {
        const QPointF way = pointer.pixel - m_pressed->pixel;
        if (std::hypot(way.x(), way.y()) < dragDistance)
            return true;
        const Selection::Point point{m_pressedHit.element, m_pressedHit.point};
        if (m_pressedHit.kind != CoverHit::Kind::Point || !m_context.selection().contains(point)) {
            m_pressed.reset();
            return false;
        }
        m_drag = std::make_unique<CoverPointDrag>(m_context, *m_pressed, m_pressedHit.position);
    }
    m_drag->update(pointer);
    return true;
}

bool CoverSelectTool::move(const CoverPointer& pointer)
{
    if (m_drag && !m_drag->active()) {
        m_drag.reset(); // undone or replaced meanwhile
        m_pressed.reset();
    }
    bool mine = true;
    if (!m_pressed && m_gizmo.move(pointer)) {
        m_hover = {};
        m_context.selection().hover(noElement);
    } else if (m_pressed) {
        mine = drag(pointer);
    } else {
        m_hover = m_context.hit(pointer.pixel);
        m_context.selection().hover(m_hover.element);
    }
    m_context.refresh();
    return mine;
}

void CoverSelectTool::release(const CoverPointer& pointer)
{
    if (m_gizmo.dragging()) {
        m_gizmo.release(pointer);
    } else if (m_drag) {
        // What is finished must not be there any more when its edit is announced.
        const std::unique_ptr<CoverPointDrag> finished = std::move(m_drag);
        m_pressed.reset();
        if (finished->active()) {
            finished->update(pointer);
            finished->finish();
        }
    } else if (m_pressed) {
        m_pressed.reset();
        if (m_pressedHit.kind != CoverHit::Kind::Point)
            select(pointer);
        else if (m_alreadySelected)
            m_context.selection().set({m_pressedHit.element}, {{m_pressedHit.element, m_pressedHit.point}});
    }
    move(pointer);
}

void CoverSelectTool::doubleClick(const CoverPointer& pointer)
{
    m_drag.reset();
    m_pressed.reset();
    if (m_gizmo.press(pointer))
        return;
    const CoverHit hit = m_context.hit(pointer.pixel);
    if (hit.kind != CoverHit::Kind::Curve)
        return;
    Document& document = m_context.document();
    const Edit edit = edits::insertCurvePoint(document.design(), hit.element, hit.parameter);
    if (edit.empty()) {
        m_context.report(tr("There is a control point already."));
        return;
    }
    document.commit(edit);
    const Element& changed = *document.design().element(hit.element);
    const int point = selectionPoint(changed, spaceCurve(changed)->pointAt(hit.parameter));
    m_context.selection().set({hit.element}, {{hit.element, point}});
    m_context.refresh();
}

bool CoverSelectTool::startNudge(const QKeyEvent& event)
{
    const std::optional<Vec3> direction = keyDirection(event.key(), m_context.toolCamera());
    const std::set<std::pair<ElementId, int>>& points = m_context.selection().points();
    if (!direction || points.empty())
        return false;
    m_nudges.step(
        m_context.document(), m_context.selection(),
        *direction * nudgeLength(event.modifiers() & Qt::ShiftModifier),
        [points](const Design& start, const Vec3& way) { return moveCurvePointsTogether(start, points, way); });
    return true;
}

void CoverSelectTool::removePoints()
{
    Document& document = m_context.document();
    QString problem;
    const Edit edit = removeSelected(document.design(), m_context.selection(), &problem);
    if (edit.empty())
        m_context.report(problem);
    else
        removeAndForget(document, m_context.selection(), edit);
}

bool CoverSelectTool::keyPress(const QKeyEvent& event)
{
    if (m_drag) {
        const std::optional<CoverPointDrag::Axis> axis = axisOf(event.key());
        const bool surface = event.key() == Qt::Key_S;
        if (axis)
            m_drag->constrain(*axis);
        else if (surface)
            m_drag->toggleSurface();
        m_context.refresh();
        return axis || surface;
    }
    if (event.key() == Qt::Key_Delete || event.key() == Qt::Key_Backspace) {
        if (m_context.selection().elements().empty())
            return false;
        removePoints();
        return true;
    }
    if (startNudge(event))
        return true;
    if (event.key() != Qt::Key_Shift)
        m_nudges.end();
    return false;
}

bool CoverSelectTool::keyRelease(const QKeyEvent& event)
{
    if (!m_nudges.keyIsDown() || event.isAutoRepeat() || !keyDirection(event.key(), m_context.toolCamera()))
        return false;
    m_nudges.release(m_context.document());
    return true;
}

bool CoverSelectTool::escape()
{
    if (m_drag || m_nudges.keyIsDown() || m_gizmo.dragging()) {
        m_gizmo.cancel();
        m_drag.reset();
        m_nudges.cancel();
        m_pressed.reset();
        m_context.refresh();
        return true;
    }
    m_nudges.end();
    if (!m_context.selection().narrow()) {
        return false;
    }
    m_context.refresh();
    return true;
}

void CoverSelectTool::leave()
{
    m_nudges.end();
    if (m_drag || m_pressed || m_gizmo.dragging())
        return;
    m_gizmo.cancel();
    m_hover = {};
    m_context.selection().hover(noElement);
    m_context.refresh();
}

QString CoverSelectTool::prompt() const
{
    if (m_drag)
        return m_drag->prompt();
    if (const QString prompt = m_gizmo.prompt(); !prompt.isEmpty())
        return prompt;
    switch (m_hover.kind) {
    case CoverHit::Kind::Point:
        return tr("Drag to move the control point \u2013 Shift+click selects several, Del removes");
    case CoverHit::Kind::Curve:
        return tr("Click to select the curve, double click to add a control point here");
    case CoverHit::Kind::Seam:
        return m_context.document().design().find<Measurement>(m_hover.element)
                   ? tr("Click to select the measurement, Delete removes it")
                   : tr("Click to select the seam");
    case CoverHit::Kind::Cover:
        return tr("Click to select the patch, drag to turn the view");
    case CoverHit::Kind::Frame:
        return tr("Click to select what stands here, drag to turn the view");
    case CoverHit::Kind::Nothing:
        break;
    }
    return tr("Click to select, drag to turn \u2013 %1 pans, %2 zooms")
        .arg(mouseText(MouseView::Cover, ViewMove::Pan), mouseText(MouseView::Cover, ViewMove::Zoom));
}

QCursor CoverSelectTool::cursor() const
{
    if (m_drag || m_gizmo.hovering())
        return Qt::SizeAllCursor;
    switch (m_hover.kind) {
    case CoverHit::Kind::Point:
        return Qt::SizeAllCursor;
    case CoverHit::Kind::Curve:
    case CoverHit::Kind::Seam:
        return Qt::PointingHandCursor;
    default:
        return Qt::ArrowCursor;
    }
}

std::optional<std::pair<ElementId, int>> CoverSelectTool::hoveredPoint() const
{
    if (m_drag)
        return std::pair(m_pressedHit.element, m_pressedHit.point);
    if (m_hover.kind == CoverHit::Kind::Point)
        return std::pair(m_hover.element, m_hover.point);
    return {};
}

std::vector<SceneLine> CoverSelectTool::guides() const
{
    return m_drag ? m_drag->guides() : m_gizmo.guides();
}

} // namespace bolster
