#include "DartRotateTool.h"

#include "CurvePath.h"
#include "DartDrag.h"
#include "DartPicture.h"
#include "DartRotation.h"
#include "Document.h"
#include "Selection.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QPainter>

namespace bolster {

DartRotateTool::DartRotateTool(PatternToolContext& context)
    : PatternTool(context)
    , m_seam(selectedDart(context.document().design(), context.selection()))
{}

void DartRotateTool::move(const PatternPointer& pointer)
{
    const Design& design = m_context.document().design();
    m_edit = {};
    m_problem = {};
    m_to.reset();
    if (const auto dart = edits::dartOf(design, m_seam))
        m_to = placeOnOutline(m_context, dart->patch, pointer);
    if (m_to)
        m_edit = edits::rotateDart(design, m_seam, *m_to, &m_problem);
    m_context.refresh();
}

void DartRotateTool::press(const PatternPointer& pointer)
{
    move(pointer);
    if (m_edit.empty()) {
        m_context.report(m_problem.empty() ? prompt() : translated(m_problem));
        return;
    }
    const Edit edit = std::exchange(m_edit, {});
    m_to.reset();
    m_context.document().commit(edit);
    m_context.selection().set({m_seam});
    m_context.endTool();
}

bool DartRotateTool::escape()
{
    m_context.endTool();
    return true;
}

void DartRotateTool::leave()
{
    m_to.reset();
    m_edit = {};
    m_context.refresh();
}

QString DartRotateTool::prompt() const
{
    if (!m_problem.empty())
        return translated(m_problem);
    if (!edits::dartOf(m_context.document().design(), m_seam))
        return tr("Select the seam of a dart first \u2013 Esc ends the tool");
    return tr("Click the outline where the dart shall open instead \u2013 Ctrl does not snap, Esc ends the tool");
}

void DartRotateTool::paint(QPainter& painter, const ViewColors& colors) const
{
    const Design& design = m_context.document().design();
    const auto dart = edits::dartOf(design, m_seam);
    if (!dart || !m_to)
        return;
    painter.setRenderHint(QPainter::Antialiasing);
    const PatternTransform& transform = m_context.transform();
    const Patch& patch = *design.find<Patch>(dart->patch);
    const QColor color = m_edit.empty() ? colors.error : colors.accent;
    if (!m_edit.empty()) {
        const Design now = design.with(m_edit);
        const QPainterPath path = transform.matrix().map(
            curvePath(now.find<Patch>(dart->patch)->outline, [&](const Vec2& p) { return toLayout(patch, p); }));
        QColor fill = color;
        fill.setAlphaF(0.10F);
        painter.fillPath(path, fill);
        painter.strokePath(path, QPen(color, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    }
    const QPointF to = transform.toPixels(toLayout(patch, patch.outline.at(*m_to)));
    painter.setPen(QPen(color, 1.4, Qt::DashLine));
    painter.drawLine(transform.toPixels(toLayout(patch, dart->tip)), to);
    painter.setPen(QPen(color, 1.6));
    painter.setBrush(colors.pointFill);
    painter.drawEllipse(to, 4, 4);
}

} // namespace bolster
