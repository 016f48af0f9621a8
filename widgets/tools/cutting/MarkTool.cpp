#include "MarkTool.h"

#include "CornerMeasure.h"
#include "CutPattern.h"
#include "CuttingEdits.h"
#include "Document.h"
#include "DrawingKeys.h"
#include "MarkDrag.h"
#include "Selection.h"
#include "StretchPick.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QCursor>
#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <limits>

namespace bolster {

namespace {

// Pixels.
constexpr double cornerReach = 14;
constexpr double cutLineReach = 7;

/// The corner of the outline next to a parameter, if it is near on the screen.
std::optional<double> cornerNear(const Patch& patch, const Vec2& layout, double reach)
{
    std::optional<double> nearest;
    double best = reach;
    for (const double corner : patch.outline.corners())
        if (const double distance = (toLayout(patch, patch.outline.at(corner)) - layout).norm(); distance < best) {
            best = distance;
            nearest = corner;
        }
    return nearest;
}

/// Of a place in outline coordinates from the cut line, mm, as it is drawn.
double distanceToLine(const CutPiece& piece, const Vec2& at)
{
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < piece.cut.size(); ++i) {
        const Vec2 from = piece.shrunk(piece.cut[i].at);
        const Vec2 way = piece.shrunk(piece.cut[(i + 1) % piece.cut.size()].at) - from;
        const double length = way.squaredNorm();
        const double share = length > 0 ? std::clamp((at - from).dot(way) / length, 0.0, 1.0) : 0.0;
        nearest = std::min(nearest, (from + share * way - at).norm());
    }
    return nearest;
}

} // namespace

MarkTool::Target MarkTool::targetAt(const PatternPointer& pointer) const
{
    const PatternHit hit = m_context.hit(pointer.pixel);
    Target target;
    if (hit.kind == PatternHit::Kind::Mark) {
        target.mark = hit.seam;
        return target;
    }
    if (m_kind == MarkKind::EdgeAllowance) {
        findEdge(pointer, hit, target);
        return target;
    }
    const PatternPatch* on = m_context.scene().patch(hit.patch);
    if (!on || on->patch().outline.empty())
        return target;
    const Patch& patch = on->patch();
    const bool onOutline = hit.kind == PatternHit::Kind::Outline || hit.kind == PatternHit::Kind::Point;
    switch (m_kind) {
    case MarkKind::Notch:
        if (onOutline) {
            target.patch = hit.patch;
            target.at = patch.outline.closest(fromLayout(patch, pointer.layout)).parameter;
            target.place = toLayout(patch, patch.outline.at(target.at));
        }
        break;
    case MarkKind::DrillHole:
        if (!onOutline && hit) {
            target.patch = hit.patch;
            target.place = pointer.layout;
        }
        break;
    case MarkKind::EdgeAllowance:
        break; // found already
    case MarkKind::CutCorner:
        if (const auto corner = cornerNear(patch, pointer.layout, m_context.transform().millimetres(cornerReach))) {
            target.patch = hit.patch;
            target.at = *corner;
            target.place = toLayout(patch, patch.outline.at(*corner));
        }
        break;
    }
    return target;
}

/// Its cut line counts as the edge, too: that is what an allowance is seen by.
void MarkTool::findEdge(const PatternPointer& pointer, const PatternHit& hit, Target& target) const
{
    if (hit.kind == PatternHit::Kind::Outline || hit.kind == PatternHit::Kind::Point)
        target.stretch = stretchUnder(m_context, pointer.pixel);
    else if (!hit)
        target.stretch = stretchOfCutLine(pointer);
    m_context.document().design().each<EdgeAllowance>([&](ElementId id, const EdgeAllowance& edge) {
        if (target.stretch == edge.stretch)
            target.mark = id;
    });
    if (target.mark != noElement)
        target.stretch.reset();
}

std::optional<Stretch> MarkTool::stretchOfCutLine(const PatternPointer& pointer) const
{
    const CutPattern* cut = m_context.cut();
    if (!cut)
        return std::nullopt;
    const double reach = m_context.transform().millimetres(cutLineReach);
    for (const CutPiece& piece : cut->pieces) {
        const PatternPatch* on = m_context.scene().patch(piece.patch);
        if (!on || on->patch().outline.empty())
            continue;
        const Vec2 at = fromLayout(on->patch(), pointer.layout);
        if (distanceToLine(piece, at) > reach)
            continue;
        const BSpline2& outline = on->patch().outline;
        const Vec2 edge = toLayout(on->patch(), outline.closest(at).point);
        return stretchUnder(m_context, m_context.transform().toPixels(edge));
    }
    return std::nullopt;
}

Edit MarkTool::edit(const Target& target, Message& problem) const
{
    const Design& design = m_context.document().design();
    switch (m_kind) {
    case MarkKind::Notch:
        return edits::addNotch(design, {target.patch, target.at}, design.settings().cutting.notches.shape,
                               &problem);
    case MarkKind::DrillHole: {
        const Patch& patch = *design.find<Patch>(target.patch);
        return edits::addDrillHole(design, {target.patch, fromLayout(patch, target.place)},
                                   tr("Hole %1").arg(design.count<DrillHole>() + 1).toStdString(), &problem);
    }
    case MarkKind::EdgeAllowance: {
        if (m_typed.open())
            return edits::setEdgeAllowance(design, *target.stretch, m_typedWidth, &problem);
        const Patch* patch = design.find<Patch>(target.stretch->patch);
        const CutAllowance usual = patch && patch->allowance
                                       ? *patch->allowance
                                       : design.settings().cutting.allowance.value_or(CutAllowance());
        return edits::setEdgeAllowance(design, *target.stretch, usual.width, &problem);
    }
    case MarkKind::CutCorner:
        break;
    }
    return edits::setCutCorner(design, {target.patch, target.at}, CornerJoin::Rounded, &problem);
}

void MarkTool::find()
{
    m_typedGood = false;
    m_hover = m_pointer ? targetAt(*m_pointer) : Target{};
    if (m_typed.open() && takesTyped())
        readTyped();
}

bool MarkTool::takesTyped() const
{
    const Design& design = m_context.document().design();
    if (const ElementId mark = m_hover.mark; mark != noElement)
        return design.find<EdgeAllowance>(mark) || design.find<Notch>(mark) || design.find<DrillHole>(mark);
    return m_hover.stretch || (m_hover.patch != noElement && m_kind != MarkKind::CutCorner);
}

void MarkTool::readTyped()
{
    if (m_hover.mark != noElement) {
        m_typedGood = typedMark(m_context.document().design(), m_hover.mark, m_typed.text()).has_value();
        return;
    }
    if (m_hover.stretch) {
        const std::optional<double> width = typedAllowance(m_typed.text());
        m_typedGood = width.has_value();
        m_typedWidth = width.value_or(0);
        return;
    }
    const Patch& patch = m_context.scene().patch(m_hover.patch)->patch(); // it was found there
    if (m_kind == MarkKind::DrillHole) {
        if (const std::optional<Vec2> at = typedPosition(m_typed.text())) {
            m_hover.place = toLayout(patch, *at);
            m_typedGood = true;
        }
    } else if (const auto at = typedAlongOutline(patch.outline, m_hover.at, m_typed.text())) {
        m_hover.at = *at;
        m_hover.place = toLayout(patch, patch.outline.at(*at));
        m_typedGood = true;
    }
}

ElementId MarkTool::place()
{
    Document& document = m_context.document();
    if (m_typed.open() && takesTyped() && !m_typedGood) {
        m_context.report(typedProblem());
        return noElement;
    }
    if (m_hover.mark != noElement) {
        if (m_typedGood)
            document.commit(*typedMark(document.design(), m_hover.mark, m_typed.text()));
        m_typed.clear();
        return m_hover.mark;
    }
    if (m_hover.patch == noElement && !m_hover.stretch) {
        m_context.report(prompt());
        return noElement;
    }
    const ElementId mark = document.design().nextId();
    Message problem;
    const Edit added = edit(m_hover, problem);
    if (added.empty()) {
        m_context.report(translated(problem));
        return noElement;
    }
    m_typed.clear();
    document.commit(added);
    return mark;
}

QString MarkTool::typedProblem() const
{
    const Design& design = m_context.document().design();
    if (m_hover.stretch || design.find<EdgeAllowance>(m_hover.mark))
        return tr("\"%1\" is no width of an allowance: try 12").arg(m_typed.text());
    if (m_kind == MarkKind::DrillHole || design.find<DrillHole>(m_hover.mark))
        return tr("\"%1\" is no place: try 120, 40").arg(m_typed.text());
    return tr("\"%1\" is no distance from the corner on this edge.").arg(m_typed.text());
}

void MarkTool::press(const PatternPointer& pointer)
{
    m_pointer = pointer;
    find();
    const bool typed = m_typed.open();
    const ElementId mark = place();
    if (mark == noElement)
        return;
    m_context.selection().set({mark});
    if (!typed) // it does not lie under the pointer
        m_drag = dragMark(m_context, pointer, mark);
    m_pressedAt = pointer.pixel;
    m_moved = false;
    m_context.refresh();
}

void MarkTool::move(const PatternPointer& pointer)
{
    m_pointer = pointer;
    if (m_drag && !m_drag->active())
        m_drag.reset(); // undone meanwhile
    if (m_drag) {
        m_moved = m_moved || (pointer.pixel - m_pressedAt).manhattanLength() > 4;
        if (m_moved)
            m_drag->update(pointer);
    } else {
        find();
    }
    m_context.refresh();
}

void MarkTool::release(const PatternPointer& pointer)
{
    m_pointer = pointer;
    if (const std::unique_ptr<PatternDrag> drag = std::move(m_drag); drag && m_moved)
        drag->finish();
    find();
    m_context.refresh();
}

bool MarkTool::keyPress(const QKeyEvent& event)
{
    const bool enter = isEnterKey(event.key());
    if (m_drag) {
        if (enter)
            return release(*m_pointer), true;
        if (!m_drag->keyPress(event))
            return false;
        m_moved = true;
    } else if (enter && m_typed.open()) {
        if (const ElementId mark = place(); mark != noElement)
            m_context.selection().set({mark});
        find();
    } else if ((m_typed.open() || takesTyped()) && m_typed.keyPress(event)) {
        find();
    } else if (missesTarget(event.key()) && !event.modifiers().testFlag(Qt::ControlModifier)) {
        m_context.report(pointFirst());
    } else {
        return false;
    }
    m_context.refresh();
    return true;
}

bool MarkTool::missesTarget(int key) const
{
    return m_kind != MarkKind::CutCorner && m_pointer && isDigitKey(key);
}

QString MarkTool::pointFirst() const
{
    switch (m_kind) {
    case MarkKind::Notch:
        return tr("Point at an outline, then type how far the notch is from the corner");
    case MarkKind::DrillHole:
        return tr("Point into a patch, then type where the drill hole lies: 120, 40");
    case MarkKind::EdgeAllowance:
    case MarkKind::CutCorner:
        break;
    }
    return tr("Point at an edge, then type how wide its allowance is");
}

bool MarkTool::wants(int key) const
{
    if (m_drag)
        return m_drag->wants(key) || isEnterKey(key);
    if (!m_typed.open() && !takesTyped())
        return missesTarget(key);
    return m_typed.wants(key) || (isEnterKey(key) && m_typed.open());
}

bool MarkTool::escape()
{
    if (m_drag && m_drag->clearTyped()) {
        m_context.refresh();
        return true;
    }
    if (m_drag) {
        m_drag.reset();
    } else if (m_typed.open()) {
        m_typed.clear();
        find();
    } else {
        m_context.endTool();
    }
    m_context.refresh();
    return true;
}

void MarkTool::leave()
{
    m_pointer.reset();
    m_typed.clear();
    find();
    m_context.refresh();
}

QString MarkTool::prompt() const
{
    if (m_drag)
        return m_drag->prompt();
    if (m_hover.mark != noElement)
        return m_context.document().design().find<EdgeAllowance>(m_hover.mark)
                   ? tr("Drag its handle, or type its width \u2013 its properties say what it is like")
                   : tr("Click to select it, drag to move it \u2013 its properties say what it is like");
    return hint();
}

QString MarkTool::hint() const
{
    switch (m_kind) {
    case MarkKind::Notch:
        return tr(
            "Click an outline to place a notch, or type how far it is from the corner; on a seam the other side "
            "gets one, too \u2013 Esc ends the tool");
    case MarkKind::DrillHole:
        return tr("Click inside a patch to place a drill hole, or type where: 120, 40 \u2013 Esc ends the tool");
    case MarkKind::EdgeAllowance:
        return tr("Click an edge to give it a seam allowance of its own, or type its width; drag its handle \u2013 "
                  "Esc ends "
                  "the tool");
    case MarkKind::CutCorner:
        break;
    }
    return tr("Click a corner of an outline to choose how its cut lines are joined \u2013 Esc ends the tool");
}

QCursor MarkTool::cursor() const
{
    if (m_drag)
        return m_drag->cursor();
    const bool something = m_hover.mark != noElement || m_hover.patch != noElement || m_hover.stretch;
    return something ? Qt::PointingHandCursor : Qt::CrossCursor;
}

void MarkTool::paint(QPainter& painter, const ViewColors& colors) const
{
    painter.setRenderHint(QPainter::Antialiasing);
    if (m_drag) {
        m_drag->paint(painter, colors);
    } else if (m_hover.stretch) {
        paintStretch(painter, m_context, *m_hover.stretch, colors.accent);
    } else if (m_hover.patch != noElement) {
        if (m_kind == MarkKind::Notch && m_context.scene().patch(m_hover.patch))
            paintWayFromCorner(painter, colors, m_context, m_hover.patch,
                               m_context.scene().patch(m_hover.patch)->patch(), m_hover.at);
        painter.setPen(QPen(colors.accent, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(m_context.transform().toPixels(m_hover.place), 5, 5);
    }
    if (!m_drag && m_pointer && m_typed.open())
        m_typed.paint(painter, colors, m_pointer->pixel, m_typedGood);
}

} // namespace bolster
