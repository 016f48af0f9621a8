#include "PatternSelectTool.h"

#include "Document.h"
#include "HitSelection.h"
#include "LabelDrag.h"
#include "MarkDrag.h"
#include "MouseStyle.h"
#include "PatchEdits.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "StretchLength.h"
#include "StretchPick.h"
#include "StretchToFix.h"
#include "ToolGeometry.h"
#include "Units.h"
#include "ViewColors.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <iterator>

namespace bolster {

namespace {

// Pixels.
constexpr double handleStem = 26;
constexpr double handleRadius = 6;
constexpr double cornerGap = 12; // beside the corner, where often a control point lies
constexpr double cornerSize = 4;
constexpr double sameClick = 3; // between two clicks at one place

constexpr Box2::CornerType boxCorners[] = {Box2::BottomLeft, Box2::BottomRight, Box2::TopLeft, Box2::TopRight};

std::optional<Vec2> arrowDirection(int key)
{
    switch (key) {
    case Qt::Key_Left:
        return Vec2(-1, 0);
    case Qt::Key_Right:
        return Vec2(1, 0);
    case Qt::Key_Up:
        return Vec2(0, 1);
    case Qt::Key_Down:
        return Vec2(0, -1);
    default:
        return {};
    }
}

} // namespace

void PatternSelectTool::press(const PatternPointer& pointer)
{
    m_nudges.end();
    m_pressed = pointer;
    m_pressedHandle = onTurnHandle(pointer.pixel);
    m_pressedCorner = m_pressedHandle ? std::nullopt : scaleHandleAt(pointer.pixel);
    m_pressedDart = m_pressedHandle || m_pressedCorner ? std::nullopt : dartHandleAt(m_context, pointer.pixel);
    m_pressedEnd =
        m_pressedHandle || m_pressedCorner || m_pressedDart ? std::nullopt : stretchEndAt(m_context, pointer.pixel);
    const bool onHandle = m_pressedHandle || m_pressedCorner || m_pressedEnd || m_pressedDart;
    m_pressedHit = onHandle ? PatternHit{} : m_context.hit(pointer.pixel);
    // What is selected there is meant before what a first click would take.
    m_clickedAgain = m_lastClick && (pointer.pixel - *m_lastClick).manhattanLength() <= sameClick;
    if (m_clickedAgain && !onHandle)
        for (const PatternHit& there : hitsThere(m_context.scene(), m_pressedHit))
            if (isOnlySelected(there))
                m_pressedHit = there;
    m_pressedLabel = onHandle ? noElement : labelUnder(m_pressedHit, pointer.pixel);
    m_alreadySelected = m_onSelectedEdge = false;
    if (!onHandle)
        select(pointer);
    m_context.refresh();
}

bool PatternSelectTool::isOnlySelected(const PatternHit& hit) const
{
    const Selection& selection = m_context.selection();
    return selection.elements().size() == 1 && selection.edges().size() == 1 &&
           isSelected(selection, m_context.scene(), hit);
}

/// A second click at the same place goes on to the next thing there: seam, fixation, patch.
void PatternSelectTool::selectClicked()
{
    PatternHit clicked = m_pressedHit;
    if (m_clickedAgain && isOnlySelected(clicked)) {
        const std::vector<PatternHit> there = hitsThere(m_context.scene(), clicked);
        const auto now = std::ranges::find(there, clicked.seam, &PatternHit::seam);
        clicked = now == there.end() || std::next(now) == there.end() ? there.front() : *std::next(now);
    }
    selectOnly(m_context.selection(), m_context.scene(), clicked);
}

void PatternSelectTool::select(const PatternPointer& pointer)
{
    Selection& selection = m_context.selection();
    const bool add = pointer.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
    m_alreadySelected = !add && isSelected(selection, m_context.scene(), m_pressedHit);
    const auto edge = edgeAt(m_context.scene(), m_pressedHit);
    m_onSelectedEdge = m_alreadySelected && edge && selection.contains(*edge);
    if (add)
        selectToo(selection, m_context.scene(), m_pressedHit);
    else if (m_pressedHit && !m_alreadySelected)
        selectOnly(selection, m_context.scene(), m_pressedHit);
}

std::unique_ptr<PatternDrag> PatternSelectTool::newDrag() const
{
    const Selection& selection = m_context.selection();
    if (m_pressedHandle)
        return turnPatches(m_context, *m_pressed);
    if (m_pressedCorner)
        return scalePatches(m_context, *m_pressed, *m_pressedCorner);
    if (m_pressedDart)
        return dragDart(m_context, *m_pressed, *m_pressedDart);
    if (m_pressedEnd)
        return dragStretchEnd(m_context, *m_pressed, *m_pressedEnd);
    if (m_pressedLabel != noElement)
        return dragLabel(m_context, *m_pressed, m_pressedLabel);
    switch (m_pressedHit.kind) {
    case PatternHit::Kind::Nothing:
        return m_context.lasso() != bool(m_pressed->modifiers & Qt::AltModifier)
                   ? selectLasso(m_context, *m_pressed)
                   : selectBox(m_context, *m_pressed);
    case PatternHit::Kind::Point:
        if (selectedDart(m_context.document().design(), selection) != noElement) // its tip
            return dragDart(m_context, *m_pressed, DartHandle::Tip);
        return selection.contains(Selection::Point{m_pressedHit.patch, m_pressedHit.point})
                   ? dragPoints(m_context, *m_pressed, selection.points())
                   : nullptr;
    case PatternHit::Kind::Mark:
        return selection.contains(m_pressedHit.seam) ? dragMark(m_context, *m_pressed, m_pressedHit.seam) : nullptr;
    case PatternHit::Kind::Measure:
        return nullptr;
    case PatternHit::Kind::Line:
        return selection.contains(m_pressedHit.seam)
                   ? dragPoints(m_context, *m_pressed, allPoints(m_pressedHit.seam))
                   : nullptr;
    case PatternHit::Kind::Outline:
        if (m_onSelectedEdge)
            return dragPoints(m_context, *m_pressed, pointsOfEdges(m_context.document().design(), selection));
        break;
    case PatternHit::Kind::Inside:
        break;
    }
    // A seam is not moved itself: who drags it means the patch under the pointer.
    if (!selection.contains(m_pressedHit.patch) && selection.contains(m_pressedHit.element()))
        m_context.selection().set({m_pressedHit.patch});
    return selection.contains(m_pressedHit.patch) ? dragPatches(m_context, *m_pressed) : nullptr;
}

Selection::Points PatternSelectTool::allPoints(ElementId line) const
{
    Selection::Points points;
    if (const auto found = m_context.scene().lines().find(line); found != m_context.scene().lines().end())
        for (std::size_t i = 0; i < found->second.points.size(); ++i)
            points.emplace(line, static_cast<int>(i));
    return points;
}

void PatternSelectTool::move(const PatternPointer& pointer)
{
    if (m_drag && !m_drag->active()) {
        m_drag.reset(); // undone or replaced meanwhile
        m_pressed.reset();
    }
    if (m_pressed && !m_drag) {
        const QPointF way = pointer.pixel - m_pressed->pixel;
        if (std::hypot(way.x(), way.y()) >= dragDistance && !(m_drag = newDrag()))
            m_pressed.reset();
    }
    if (m_drag) {
        m_drag->update(pointer);
    } else if (!m_pressed) {
        hover(pointer.pixel);
    }
    m_context.refresh();
}

/// What a press would take.
void PatternSelectTool::hover(QPointF pixel)
{
    m_overHandle = onTurnHandle(pixel);
    m_overCorner = m_overHandle ? std::nullopt : scaleHandleAt(pixel);
    m_overDart = m_overHandle || m_overCorner ? std::nullopt : dartHandleAt(m_context, pixel);
    m_overEnd = m_overHandle || m_overCorner || m_overDart ? std::nullopt : stretchEndAt(m_context, pixel);
    const bool onHandle = m_overHandle || m_overCorner || m_overDart || m_overEnd;
    m_hover = onHandle ? PatternHit{} : m_context.hit(pixel);
    m_overLabel = onHandle ? noElement : labelUnder(m_hover, pixel);
    m_context.selection().hover(m_hover ? m_hover.element() : noElement);
}

/// Everything else that can be picked lies above labels.
ElementId PatternSelectTool::labelUnder(const PatternHit& hit, QPointF pixel) const
{
    const bool free = hit.kind == PatternHit::Kind::Nothing || hit.kind == PatternHit::Kind::Inside;
    return free ? labelAt(m_context, pixel) : noElement;
}

void PatternSelectTool::release(const PatternPointer& pointer)
{
    m_lastClick = m_drag || !m_pressed ? std::nullopt : std::optional(pointer.pixel);
    if (m_drag) {
        // What is finished must not be there any more when its edit is announced.
        const std::unique_ptr<PatternDrag> drag = std::move(m_drag);
        m_pressed.reset();
        if (drag->active()) {
            drag->update(pointer);
            drag->finish();
        }
    } else if (m_pressed) {
        m_pressed.reset();
        const bool add = pointer.modifiers & (Qt::ShiftModifier | Qt::ControlModifier);
        if (m_alreadySelected)
            selectClicked();
        else if (!m_pressedHit && !m_pressedHandle && !m_pressedCorner && !m_pressedEnd && !m_pressedDart && !add)
            m_context.selection().clear();
    }
    move(pointer);
}

void PatternSelectTool::doubleClick(const PatternPointer& pointer)
{
    m_drag.reset();
    m_pressed.reset();
    const PatternHit hit = m_context.hit(pointer.pixel);
    if (hit.kind != PatternHit::Kind::Outline && hit.kind != PatternHit::Kind::Line)
        return;
    const ElementId id = hit.kind == PatternHit::Kind::Line ? hit.seam : hit.patch;
    if (const PatternPatch* on = m_context.scene().patch(id)) {
        const Vec2 at = toLayout(on->patch(), on->patch().outline.at(hit.parameter));
        if ((at - pointer.layout).norm() > m_context.transform().millimetres(2 * handleRadius))
            return; // on the letter of a seam: no place of the outline is meant
    }
    Document& document = m_context.document();
    const Edit edit = edits::insertPatchPoint(document.design(), id, hit.parameter);
    if (edit.empty()) {
        m_context.report(tr("There is a control point already."));
        return;
    }
    document.commit(edit);
    m_context.selection().set({id}, {{id, planeCurve(*document.design().element(id))->pointAt(hit.parameter)}});
    m_context.refresh();
}

bool PatternSelectTool::wants(int key) const
{
    return m_drag && (m_drag->wants(key) || key == Qt::Key_Return || key == Qt::Key_Enter);
}

/// Enter lets go.
bool PatternSelectTool::keyDuringDrag(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter) {
        const std::unique_ptr<PatternDrag> drag = std::move(m_drag);
        m_pressed.reset();
        if (drag->active())
            drag->finish();
    } else if (!m_drag->keyPress(event)) {
        return false;
    }
    m_context.refresh();
    return true;
}

bool PatternSelectTool::keyPress(const QKeyEvent& event)
{
    if (m_drag)
        return keyDuringDrag(event);
    const std::optional<Vec2> direction = arrowDirection(event.key());
    if (!direction) {
        if (event.key() != Qt::Key_Shift)
            m_nudges.end();
        return false;
    }
    m_nudges.step(m_context.document(), m_context.selection(),
                  *direction * nudgeLength(event.modifiers() & Qt::ShiftModifier),
                  [&selection = m_context.selection()](const Design& start, const Vec2& way) {
                      return nudge(start, selection, way);
                  });
    return true;
}

bool PatternSelectTool::keyRelease(const QKeyEvent& event)
{
    if (!m_nudges.keyIsDown() || event.isAutoRepeat() || !arrowDirection(event.key()))
        return false;
    m_nudges.release(m_context.document());
    return true;
}

bool PatternSelectTool::escape()
{
    if (m_drag && m_drag->clearTyped()) { // what is dragged follows the pointer again
        m_context.refresh();
        return true;
    }
    if (m_drag || m_nudges.keyIsDown()) {
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

void PatternSelectTool::leave()
{
    m_nudges.end();
    if (m_drag || m_pressed)
        return;
    m_hover = {};
    m_overHandle = false;
    m_overCorner.reset();
    m_overEnd.reset();
    m_overDart.reset();
    m_overLabel = noElement;
    m_context.selection().hover(noElement);
    m_context.refresh();
}

Box2 PatternSelectTool::selectedBox() const
{
    const Selection& selection = m_context.selection();
    if (!selection.points().empty() || !selection.edges().empty())
        return {};
    const std::vector<ElementId> patches = selectedOf<Patch>(m_context.document().design(), selection.elements());
    return m_context.scene().boundingBox({patches.begin(), patches.end()});
}

std::optional<QPointF> PatternSelectTool::turnHandle() const
{
    const Box2 box = selectedBox();
    if (box.isEmpty() || m_drag)
        return {};
    const QPointF top = m_context.transform().toPixels({box.center().x(), box.max().y()});
    return top - QPointF(0, handleStem);
}

bool PatternSelectTool::onTurnHandle(QPointF pixel) const
{
    const std::optional<QPointF> handle = turnHandle();
    return handle && std::hypot(pixel.x() - handle->x(), pixel.y() - handle->y()) <= handleRadius + 3;
}

std::optional<QPointF> PatternSelectTool::scaleHandle(Box2::CornerType corner) const
{
    const Box2 box = selectedBox();
    if (box.isEmpty() || m_drag || !(box.sizes().minCoeff() > 0))
        return {};
    const QPointF out(corner & 1 ? cornerGap : -cornerGap, corner & 2 ? -cornerGap : cornerGap);
    return m_context.transform().toPixels(box.corner(corner)) + out;
}

std::optional<Box2::CornerType> PatternSelectTool::scaleHandleAt(QPointF pixel) const
{
    for (const Box2::CornerType corner : boxCorners)
        if (const auto handle = scaleHandle(corner);
            handle && (pixel - *handle).manhattanLength() <= 2 * cornerSize)
            return corner;
    return std::nullopt;
}

QString PatternSelectTool::prompt() const
{
    if (m_drag)
        return m_drag->prompt();
    if (m_overHandle)
        return tr("Drag to turn the selected patches in the layout");
    if (m_overCorner)
        return tr("Drag to scale the selected patches \u2013 Shift keeps the proportions");
    if (m_overDart)
        return *m_overDart == DartHandle::Tip ? tr("Drag the tip of the dart")
                                              : tr("Drag the dart along the outline");
    if (m_overLabel != noElement)
        return tr("Drag the label to where it can be read, click to select the patch");
    if (m_overEnd)
        return tr("Drag to move this end of the stretch along the outline");
    switch (m_hover.kind) {
    case PatternHit::Kind::Point:
        return tr("Drag to move the control point \u2013 Shift+click selects several, Del removes");
    case PatternHit::Kind::Outline: {
        const auto edge = edgeAt(m_context.scene(), m_hover);
        if (edge && m_context.selection().contains(*edge))
            return tr("Drag to move the edge, double click to add a control point here \u2013 its length is in the "
                      "properties");
        return m_hover.seam == noElement
                   ? tr("Click to select the edge, double click to add a control point here, drag to move the "
                        "patch")
                   : tr("Click to select the seam and the edge, double click to add a control point here");
    }
    case PatternHit::Kind::Mark:
        return tr("Click to select it, drag to move it, Delete removes it");
    case PatternHit::Kind::Measure:
        return tr("Click to select the measurement, Delete removes it");
    case PatternHit::Kind::Line:
        return tr("Click to select the curve, drag to move it, double click to add a control point here");
    case PatternHit::Kind::Inside:
        return tr("Click to select the patch, drag to move it in the layout");
    case PatternHit::Kind::Nothing:
        break;
    }
    return tr("Click to select, drag a box to select several \u2013 %1 or Space pans, %2 zooms")
        .arg(mouseText(MouseView::Pattern, ViewMove::Pan), mouseText(MouseView::Pattern, ViewMove::Zoom));
}

QCursor PatternSelectTool::cursor() const
{
    if (m_drag)
        return m_drag->cursor();
    if (m_overHandle)
        return Qt::OpenHandCursor;
    if (m_overEnd || m_overDart)
        return Qt::SizeAllCursor;
    if (m_overLabel != noElement)
        return Qt::OpenHandCursor;
    if (m_overCorner)
        return *m_overCorner == Box2::TopLeft || *m_overCorner == Box2::BottomRight ? Qt::SizeFDiagCursor
                                                                                    : Qt::SizeBDiagCursor;
    switch (m_hover.kind) {
    case PatternHit::Kind::Point:
    case PatternHit::Kind::Mark:
        return Qt::SizeAllCursor;
    case PatternHit::Kind::Outline:
    case PatternHit::Kind::Line:
    case PatternHit::Kind::Measure:
        return Qt::PointingHandCursor;
    case PatternHit::Kind::Inside:
    case PatternHit::Kind::Nothing:
        break;
    }
    return Qt::ArrowCursor;
}

/// The selected ones with their lengths; of a proposed seam also a part of an edge.
void PatternSelectTool::paintEdges(QPainter& painter, const ViewColors& colors) const
{
    const auto isThere = [this](const Stretch& stretch) {
        const Patch* patch = m_context.document().design().find<Patch>(stretch.patch);
        return patch && !patch->outline.empty() && stretchRange(stretch, patch->outline);
    };
    for (const Selection::Edge& edge : m_context.selection().edges())
        if (isThere(edge.stretch))
            paintStretch(painter, m_context, edge.stretch, colors.accent);
    for (const Selection::Edge& edge : m_context.selection().edges())
        if (isThere(edge.stretch))
            paintEdgeLength(painter, colors, m_context, edge.stretch);
}

void PatternSelectTool::paint(QPainter& painter, const ViewColors& colors) const
{
    if (m_drag) {
        paintEdges(painter, colors);
        m_drag->paint(painter, colors);
        return;
    }
    if (m_hover.kind == PatternHit::Kind::Point)
        if (const auto twin = m_context.scene().twins().follower(m_context.scene(), m_hover.patch, m_hover.point))
            paintFollower(painter, m_context.transform().toPixels(*twin), colors);
    paintEdges(painter, colors);
    paintStretchEnds(painter, colors, m_context, m_overEnd);
    paintDartHandles(painter, colors, m_context, m_overDart);
    if (m_overLabel != noElement)
        paintLabelFrame(painter, colors, m_context, m_overLabel);
    const std::optional<QPointF> handle = turnHandle();
    if (!handle)
        return;
    const Box2 box = selectedBox();
    const PatternTransform& transform = m_context.transform();
    painter.setPen(QPen(mixed(colors.canvas, colors.accent, 0.6), 1, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(transform.toPixels(box.min()), transform.toPixels(box.max())).normalized());
    painter.setPen(QPen(colors.accent, 1.2));
    painter.drawLine(*handle, *handle + QPointF(0, handleStem));
    painter.setPen(QPen(colors.accent, 1.6));
    painter.setBrush(m_overHandle ? colors.accent : colors.pointFill);
    painter.drawEllipse(*handle, handleRadius, handleRadius);
    for (const Box2::CornerType corner : boxCorners)
        if (const auto at = scaleHandle(corner)) {
            painter.setBrush(m_overCorner == corner ? colors.accent : colors.pointFill);
            painter.drawRect(QRectF(*at - QPointF(cornerSize, cornerSize), QSizeF(2 * cornerSize, 2 * cornerSize)));
        }
}

} // namespace bolster
