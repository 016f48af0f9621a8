#include "MarkTool.h"

#include "CuttingEdits.h"
#include "Document.h"
#include "MarkDrag.h"
#include "Selection.h"
#include "StretchPick.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QCursor>
#include <QPainter>

#include <algorithm>

namespace bolster {

namespace {

constexpr double cornerReach = 14; // pixels

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

} // namespace

MarkTool::Target MarkTool::targetAt(const PatternPointer& pointer) const
{
    const PatternHit hit = m_context.hit(pointer.pixel);
    Target target;
    if (hit.kind == PatternHit::Kind::Mark) {
        target.mark = hit.seam;
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
        if (onOutline)
            target.stretch = stretchUnder(m_context, pointer.pixel);
        break;
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

Edit MarkTool::edit(const Target& target, Message& problem) const
{
    const Design& design = m_context.document().design();
    switch (m_kind) {
    case MarkKind::Notch:
        return edits::addNotch(design, {target.patch, target.at}, design.settings().cutting.notches.shape,
                               &problem);
    case MarkKind::DrillHole: {
        int count = 1;
        design.each<DrillHole>([&](ElementId, const DrillHole&) { ++count; });
        const Patch& patch = *design.find<Patch>(target.patch);
        return edits::addDrillHole(design, {target.patch, fromLayout(patch, target.place)},
                                   tr("Hole %1").arg(count).toStdString(), &problem);
    }
    case MarkKind::EdgeAllowance: {
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

void MarkTool::press(const PatternPointer& pointer)
{
    const Target target = targetAt(pointer);
    Document& document = m_context.document();
    ElementId mark = target.mark;
    if (mark == noElement && (target.patch != noElement || target.stretch)) {
        mark = document.design().nextId();
        Message problem;
        const Edit added = edit(target, problem);
        if (added.empty()) {
            m_context.report(translated(problem));
            return;
        }
        document.commit(added);
    }
    if (mark == noElement) {
        m_context.report(prompt());
        return;
    }
    m_context.selection().set({mark});
    m_drag = dragMark(m_context, pointer, mark);
    m_pressedAt = pointer.pixel;
    m_moved = false;
    m_context.refresh();
}

void MarkTool::move(const PatternPointer& pointer)
{
    if (m_drag && !m_drag->active())
        m_drag.reset(); // undone meanwhile
    if (m_drag) {
        m_moved = m_moved || (pointer.pixel - m_pressedAt).manhattanLength() > 4;
        if (m_moved)
            m_drag->update(pointer);
    } else {
        m_hover = targetAt(pointer);
    }
    m_context.refresh();
}

void MarkTool::release(const PatternPointer& pointer)
{
    if (const std::unique_ptr<PatternDrag> drag = std::move(m_drag); drag && m_moved)
        drag->finish();
    m_hover = targetAt(pointer);
    m_context.refresh();
}

bool MarkTool::escape()
{
    if (m_drag)
        m_drag.reset();
    else
        m_context.endTool();
    return true;
}

void MarkTool::leave()
{
    m_hover = {};
    m_context.refresh();
}

QString MarkTool::prompt() const
{
    if (m_drag)
        return m_drag->prompt();
    if (m_hover.mark != noElement)
        return tr("Click to select it, drag to move it \u2013 its properties say what it is like");
    switch (m_kind) {
    case MarkKind::Notch:
        return tr(
            "Click an outline to place a notch; on a seam the other side gets one, too \u2013 Esc ends the tool");
    case MarkKind::DrillHole:
        return tr("Click inside a patch to place a drill hole \u2013 Esc ends the tool");
    case MarkKind::EdgeAllowance:
        return tr("Click an edge to give it a seam allowance of its own, drag its handle \u2013 Esc ends the tool");
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
        painter.setPen(QPen(colors.accent, 2));
        painter.setBrush(Qt::NoBrush);
        painter.drawEllipse(m_context.transform().toPixels(m_hover.place), 5, 5);
    }
}

} // namespace bolster
