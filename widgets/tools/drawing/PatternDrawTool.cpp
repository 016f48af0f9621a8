#include "PatternDrawTool.h"

#include "CurvePath.h"
#include "CuttingEdits.h"
#include "Document.h"
#include "DrawingKeys.h"
#include "HandleEdits.h"
#include "PatchDrawingTool.h"
#include "PatternMarks.h"
#include "Selection.h"
#include "SnapHints.h"
#include "ViewColors.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double lineReach = 8;
constexpr double linePointRadius = 4;

} // namespace

const Patch* PatternDrawTool::patch() const
{
    return m_context.document().design().find<Patch>(m_patch);
}

void PatternDrawTool::press(const PatternPointer& pointer)
{
    if (!m_points.empty() && !patch())
        m_points.clear(); // it is gone meanwhile
    if (m_points.empty()) {
        const PatternHit hit = m_context.hit(pointer.pixel);
        const ElementId on = hit.kind == PatternHit::Kind::Point ? noElement : hit.patch;
        if (!m_context.document().design().find<Patch>(on)) {
            m_context.report(tr("Begin inside a patch."));
            return;
        }
        m_patch = on;
    }
    if (closes(pointer)) {
        finish(true);
        return;
    }
    m_points.push_back(snapped(pointer).point);
    m_next.reset();
    m_context.refresh();
}

void PatternDrawTool::move(const PatternPointer& pointer)
{
    m_closing = closes(pointer);
    m_next.reset();
    m_hints.clear();
    if (m_closing) {
        m_next = m_points.front();
    } else if (!m_points.empty()) {
        Snapped next = snapped(pointer);
        m_next = next.point;
        m_hints = std::move(next.hints);
    }
    m_context.refresh();
}

void PatternDrawTool::doubleClick(const PatternPointer&)
{
    finish(false); // its first click has set the last point
}

bool PatternDrawTool::wants(int key) const
{
    return isDrawingKey(key, true);
}

bool PatternDrawTool::keyPress(const QKeyEvent& event)
{
    if (!pressDrawingKey(event.key(), m_points, &m_smooth, [this] { finish(false); }))
        return false;
    m_context.refresh();
    return true;
}

ToolKeys PatternDrawTool::keys() const
{
    return m_points.empty() ? ToolKeys() : DrawingKeys::ofLine(true);
}

bool PatternDrawTool::escape()
{
    if (m_points.empty())
        m_context.endTool();
    m_points.clear();
    m_next.reset();
    m_context.refresh();
    return true;
}

void PatternDrawTool::leave()
{
    m_next.reset();
    m_context.refresh();
}

/// On the outline where that is near; with Shift beside or above the last point.
Snapped PatternDrawTool::snapped(const PatternPointer& pointer) const
{
    Vec2 at = pointer.layout;
    if (!(pointer.modifiers & Qt::ShiftModifier)) {
        SnapQuery query;
        query.own = m_points;
        if (!m_points.empty())
            query.from = m_points.back();
        if (m_points.size() > 1)
            query.before = m_points[m_points.size() - 2];
        if (Snapped found = snappedPointer(m_context, pointer, query); !found.hints.empty())
            return found;
    }
    if (pointer.modifiers & Qt::ShiftModifier && !m_points.empty()) {
        const Vec2 way = at - m_points.back();
        (std::abs(way.x()) < std::abs(way.y()) ? at.x() : at.y()) =
            std::abs(way.x()) < std::abs(way.y()) ? m_points.back().x() : m_points.back().y();
    }
    const Patch* on = patch();
    if (!on || on->outline.empty())
        return {at, {}};
    const BSpline2::Closest closest = on->outline.closest(fromLayout(*on, at));
    const bool near = closest.distance <= m_context.transform().millimetres(lineReach);
    return {near ? toLayout(*on, closest.point) : at, {}};
}

bool PatternDrawTool::closes(const PatternPointer& pointer) const
{
    return m_points.size() >= 3 &&
           (pointer.layout - m_points.front()).norm() <= m_context.transform().millimetres(lineReach);
}

Edit PatternDrawTool::edit(BSpline2 curve) const
{
    const Design& design = m_context.document().design();
    int count = 1;
    if (m_kind == DrawnKind::FancySeam) {
        design.each<FancySeam>([&](ElementId, const FancySeam&) { ++count; });
        return edits::addFancySeam(design, m_patch, std::move(curve), tr("Fancy seam %1").arg(count).toStdString());
    }
    if (m_kind == DrawnKind::InternalLine) {
        design.each<InternalLine>([&](ElementId, const InternalLine&) { ++count; });
        return edits::addInternalLine(design, m_patch, std::move(curve), InternalLine::Purpose::Guide,
                                      tr("Line %1").arg(count).toStdString());
    }
    design.each<HandleCurve>([&](ElementId, const HandleCurve&) { ++count; });
    const SurfaceMeshPtr surface = m_context.surface();
    return surface ? edits::addHandleCurve(design, *surface, m_patch, std::move(curve),
                                           tr("Handle %1").arg(count).toStdString())
                   : Edit{};
}

void PatternDrawTool::finish(bool closed)
{
    const Patch* on = patch();
    std::vector<Vec2> points;
    for (const Vec2& p : m_points)
        if (const Vec2 q = on ? fromLayout(*on, p) : p; points.empty() || (q - points.back()).norm() > 1e-3)
            points.push_back(q);
    std::optional<BSpline2> curve = edits::drawnCurve(points, closed, m_smooth);
    if (!curve) {
        m_context.report(tr("A curve needs two points, a closed one three."));
        return;
    }
    const Edit added = edit(std::move(*curve));
    if (added.empty()) {
        m_context.report(tr("There is no surface in this patch yet on which the handle could lie."));
        return;
    }
    m_points.clear();
    m_next.reset();
    m_context.document().commit(added);
    m_context.selection().set({added.changes.front().id});
    m_context.endTool();
}

QString PatternDrawTool::prompt() const
{
    if (m_points.empty() && m_kind == DrawnKind::InternalLine)
        return tr("Click inside a patch or on its outline to begin a line for the cutter \u2013 Esc ends the tool");
    if (m_points.empty())
        return m_kind == DrawnKind::HandleCurve
                   ? tr("Click inside a patch to begin a handle curve \u2013 Esc ends the tool")
                   : tr("Click inside a patch or on its outline to begin a fancy seam \u2013 Esc ends the tool");
    if (m_closing)
        return tr("Click to close the curve");
    return m_smooth
               ? tr("Click for the next point, double click or Enter ends \u2013 B makes it straight, Backspace "
                    "takes a point back")
               : tr("Click for the next point, double click or Enter ends \u2013 B makes it smooth, Backspace "
                    "takes a point back");
}

void PatternDrawTool::paint(QPainter& painter, const ViewColors& colors) const
{
    std::vector<Vec2> points = m_points;
    if (m_next && !m_closing)
        points.push_back(*m_next);
    const PatternTransform& transform = m_context.transform();
    if (m_next)
        paintSnapHints(painter, colors, transform, m_hints);
    const QColor color = m_kind == DrawnKind::FancySeam ? colors.fancySeam : colors.handle;
    if (const auto curve = edits::drawnCurve(points, m_closing, m_smooth)) {
        const QPainterPath path = transform.matrix().map(curvePath(*curve, [](const Vec2& p) { return p; }));
        if (m_kind == DrawnKind::FancySeam)
            paintFancyStrip(painter, path, FancySeam{}.width * transform.scale(), color, true);
        else
            painter.strokePath(path, QPen(color, 2.2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (m_smooth) {
            painter.setPen(QPen(mixed(colors.canvas, color, 0.6), 1, Qt::DotLine));
            for (std::size_t i = 0; i + 1 < points.size(); ++i)
                painter.drawLine(transform.toPixels(points[i]), transform.toPixels(points[i + 1]));
        }
    }
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool target = i == 0 && m_closing;
        painter.setPen(QPen(color, 1.4));
        painter.setBrush(target ? color : colors.pointFill);
        const double radius = target ? linePointRadius + 2 : linePointRadius;
        painter.drawEllipse(transform.toPixels(points[i]), radius, radius);
    }
}

} // namespace bolster
