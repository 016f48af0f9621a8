#include "MeasureTool.h"

#include "CurvePath.h"
#include "Document.h"
#include "DrawingKeys.h"
#include "KeptMeasure.h"
#include "PatchDrawingTool.h"
#include "SnapHints.h"
#include "Units.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>
#include <numbers>

namespace bolster {

void MeasureTool::press(const PatternPointer& pointer)
{
    move(pointer);
    if (!m_first || m_second) {
        m_first = m_next->point;
        m_second.reset();
    } else {
        m_second = m_next->point;
    }
    m_context.refresh();
}

void MeasureTool::move(const PatternPointer& pointer)
{
    m_pointer = pointer;
    SnapQuery query;
    if (m_first && !m_second) {
        query.from = *m_first;
        query.own.push_back(*m_first);
    }
    m_next = snappedPointer(m_context, pointer, query);
    m_edge = m_first && !m_second ? std::nullopt : edgeAt(pointer);
    m_context.refresh();
}

std::optional<MeasureTool::Edge> MeasureTool::edgeAt(const PatternPointer& pointer) const
{
    const PatternHit hit = m_context.hit(pointer.pixel);
    const PatternPatch* patch = m_context.scene().patch(hit.patch);
    if (hit.kind != PatternHit::Kind::Outline || !patch)
        return std::nullopt;
    const BSpline2& outline = patch->patch().outline;
    for (const PatternEdge& edge : patch->edges) {
        const double t = hit.parameter < edge.from ? hit.parameter + outline.period() : hit.parameter;
        if (t >= edge.from && t <= edge.to)
            return Edge{curvePath(outline, edge.from, edge.to,
                                  [patch](const Vec2& p) { return toLayout(patch->patch(), p); }),
                        edge.length};
    }
    return std::nullopt;
}

/// The patch it lies in, or on the outline of which it was snapped.
std::optional<PatchPoint> MeasureTool::inPatch(const Vec2& layout) const
{
    const PatternHit hit =
        m_context.scene().hit(layout, m_context.transform().millimetres(1), [](ElementId) { return false; });
    const PatternPatch* patch = m_context.scene().patch(hit.patch);
    if (!patch)
        return std::nullopt;
    return PatchPoint{hit.patch, fromLayout(patch->patch(), layout)};
}

/// What Enter keeps of two points: nothing of what lies beside patches.
std::optional<std::pair<PatchPoint, PatchPoint>> MeasureTool::kept() const
{
    if (!m_first || !m_second)
        return std::nullopt;
    const auto from = inPatch(*m_first), to = inPatch(*m_second);
    return from && to ? std::optional(std::pair(*from, *to)) : std::nullopt;
}

bool MeasureTool::wants(int key) const
{
    return isEnterKey(key) && m_second;
}

bool MeasureTool::keyPress(const QKeyEvent& event)
{
    if (!isEnterKey(event.key()) || !m_second)
        return false;
    const auto ends = kept();
    if (!ends) {
        m_context.report(tr("Only a measurement between two points of patches can be kept."));
        return true;
    }
    keepMeasure(m_context, ends->first, ends->second);
    m_first.reset();
    m_second.reset();
    m_context.refresh();
    return true;
}

ToolKeys MeasureTool::keys() const
{
    if (!kept())
        return {};
    return {{Qt::Key_Return, tr("&Keep the measurement")}};
}

bool MeasureTool::escape()
{
    if (m_first) {
        m_first.reset();
        m_second.reset();
    } else {
        m_context.endTool();
    }
    m_context.refresh();
    return true;
}

void MeasureTool::leave()
{
    m_next.reset();
    m_pointer.reset();
    m_edge.reset();
    m_context.refresh();
}

std::optional<Vec2> MeasureTool::end() const
{
    if (!m_first || m_second || !m_next)
        return m_second;
    return m_next->point;
}

QStringList MeasureTool::figures() const
{
    const std::optional<Vec2> to = end();
    if (!to)
        return {};
    const Vec2 way = *to - *m_first;
    return {lengthText(way.norm(), 2), tr("dx %1, dy %2").arg(lengthText(way.x(), 2), lengthText(way.y(), 2)),
            angleText(std::atan2(way.y(), way.x()) * 180 / std::numbers::pi)};
}

QString MeasureTool::prompt() const
{
    if (m_edge)
        return tr("This edge is %1 long \u2013 click for a point to measure from")
            .arg(lengthText(m_edge->length, 2));
    if (m_second && !kept())
        return tr("%1 \u2013 a click begins anew").arg(figures().join(QStringLiteral(", ")));
    if (m_second)
        return tr("%1 \u2013 Enter keeps the measurement, a click begins anew")
            .arg(figures().join(QStringLiteral(", ")));
    if (m_first && end())
        return figures().join(QStringLiteral(", "));
    return tr("Click two points of the pattern or of the cover to measure, or point at an outline \u2013 Esc ends "
              "the tool");
}

void MeasureTool::paint(QPainter& painter, const ViewColors& colors) const
{
    const PatternTransform& transform = m_context.transform();
    if (m_edge)
        painter.strokePath(transform.matrix().map(m_edge->path),
                           QPen(colors.accent, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    if (m_next)
        paintSnapHints(painter, colors, transform, m_next->hints);
    const std::optional<Vec2> to = end();
    if (to) {
        const QPointF a = transform.toPixels(*m_first);
        const QPointF b = transform.toPixels(*to);
        painter.setPen(QPen(colors.accent, 1.6));
        painter.drawLine(a, b);
        painter.setBrush(colors.pointFill);
        painter.drawEllipse(a, 3.5, 3.5);
        painter.drawEllipse(b, 3.5, 3.5);
        paintNote(painter, colors, m_second ? (a + b) / 2 : b,
                  figures() << (m_second || !m_next ? QString() : snapText(m_next->hints)));
    }
    if (m_edge && m_pointer && (!to || m_second))
        paintNote(painter, colors, m_pointer->pixel, {tr("Edge: %1").arg(lengthText(m_edge->length, 2))});
}

} // namespace bolster
