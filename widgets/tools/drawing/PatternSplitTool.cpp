#include "PatternSplitTool.h"

#include "Document.h"
#include "DrawingKeys.h"
#include "OutlineCrossings.h"
#include "PatchSplit.h"
#include "Selection.h"
#include "Translated.h"
#include "ViewColors.h"

#include <QKeyEvent>
#include <QPainter>

#include <cmath>

namespace bolster {

namespace {

// Pixels.
constexpr double splitReach = 9;
constexpr double splitPointRadius = 4;

Vec2 middleOf(const std::vector<Vec2>& line)
{
    double length = 0;
    for (std::size_t i = 1; i < line.size(); ++i)
        length += (line[i] - line[i - 1]).norm();
    double left = length / 2;
    for (std::size_t i = 1; i < line.size(); ++i) {
        const double here = (line[i] - line[i - 1]).norm();
        if (left <= here && here > 0)
            return line[i - 1] + left / here * (line[i] - line[i - 1]);
        left -= here;
    }
    return line.back();
}

/// The patch that the edit cuts.
ElementId splitPiece(const Edit& edit)
{
    for (const Change& change : edit.changes)
        if (change.before && std::holds_alternative<Patch>(*change.before))
            return change.id;
    return {};
}

} // namespace

void PatternSplitTool::press(const PatternPointer& pointer)
{
    m_points.push_back(snapped(pointer));
    m_next.reset();
    changeLine();
}

void PatternSplitTool::move(const PatternPointer& pointer)
{
    m_next = snapped(pointer);
    changeLine();
}

void PatternSplitTool::doubleClick(const PatternPointer&)
{
    finish(); // its first click has set the last point
}

bool PatternSplitTool::wants(int key) const
{
    return isDrawingKey(key, false);
}

bool PatternSplitTool::keyPress(const QKeyEvent& event)
{
    if (!pressDrawingKey(event.key(), m_points, nullptr, [this] { finish(); }))
        return false;
    changeLine();
    return true;
}

ToolKeys PatternSplitTool::keys() const
{
    return m_points.empty() ? ToolKeys() : DrawingKeys::ofLine(false);
}

bool PatternSplitTool::escape()
{
    if (m_points.empty())
        m_context.endTool();
    m_points.clear();
    m_next.reset();
    changeLine();
    return true;
}

void PatternSplitTool::leave()
{
    m_next.reset();
    changeLine();
}

/// In a corner or on an outline where that is near; with Shift beside or above the last point.
Vec2 PatternSplitTool::snapped(const PatternPointer& pointer) const
{
    Vec2 at = pointer.layout;
    if (pointer.modifiers & Qt::ShiftModifier && !m_points.empty()) {
        const Vec2 way = at - m_points.back();
        const int axis = std::abs(way.x()) < std::abs(way.y()) ? 0 : 1;
        at[axis] = m_points.back()[axis];
    }
    double nearest = m_context.transform().millimetres(splitReach);
    Vec2 best = at;
    const auto offer = [&](const Patch& patch, const Vec2& place, double preference) {
        const Vec2 there = toLayout(patch, place);
        if (const double distance = (there - at).norm() * preference; distance <= nearest) {
            nearest = distance;
            best = there;
        }
    };
    for (const auto& entry : m_context.scene().patches()) {
        const PatternPatch& shown = entry.second;
        if (shown.patch().outline.empty() || shown.box.exteriorDistance(at) > nearest)
            continue;
        const BSpline2& outline = shown.patch().outline;
        offer(shown.patch(), outline.closest(fromLayout(shown.patch(), at)).point, 1);
        for (const double corner : outline.corners())
            offer(shown.patch(), outline.at(corner), 0.3); // wins over the edges beside it
    }
    return best;
}

/// Of the patch that the line's middle lies in; else of the first one that it splits, or could if it crossed it
/// twice.
edits::Outcome PatternSplitTool::outcome(const std::vector<Vec2>& line) const
{
    const Design& design = m_context.document().design();
    if (line.size() < 2)
        return edits::splitPatch(design, noElement, line);
    const PatternHit hit = m_context.hit(m_context.transform().toPixels(middleOf(line)));
    const ElementPtr element = hit ? design.element(hit.patch) : nullptr;
    const PatchCurve* drawn = element ? patchCurve(*element) : nullptr;
    edits::Outcome first = edits::splitPatch(design, drawn ? drawn->patch : hit.patch, line);
    if (!first.edit.empty() || (element && design.find<Patch>(hit.patch)))
        return first;
    for (const auto& entry : m_context.scene().patches()) {
        edits::Outcome other = edits::splitPatch(design, entry.first, line);
        if (!other.edit.empty())
            return other;
        if (entry.second.patch().outline.empty())
            continue;
        std::vector<Vec2> there;
        for (const Vec2& point : line)
            there.push_back(fromLayout(entry.second.patch(), point));
        if (!edits::outlineCrossings(entry.second.patch().outline, there).empty())
            first = std::move(other); // it says how often
    }
    return first;
}

void PatternSplitTool::changeLine()
{
    std::vector<Vec2> line = m_points;
    if (m_next && !line.empty())
        line.push_back(*m_next);
    m_splits = line.size() >= 2 ? splitPiece(outcome(line).edit) : ElementId{};
    m_context.refresh();
}

void PatternSplitTool::finish()
{
    edits::Outcome split = outcome(m_points);
    if (split.edit.empty()) {
        m_context.report(translated(split.problem));
        return;
    }
    std::set<ElementId> pieces;
    for (const Change& change : split.edit.changes)
        if (change.after && std::holds_alternative<Patch>(*change.after))
            pieces.insert(change.id);
    m_points.clear();
    m_next.reset();
    m_context.document().commit(std::move(split));
    m_context.selection().set(std::move(pieces));
    m_context.endTool();
}

QString PatternSplitTool::prompt() const
{
    if (m_points.empty())
        return tr("Click beside a patch or on its outline to begin the cut \u2013 Esc ends the tool");
    if (m_splits != noElement)
        return tr(
            "Double click or Enter splits the patch \u2013 click to bend the cut, Backspace takes a point back");
    return tr(
        "Click on the other side of the patch \u2013 Shift keeps the cut straight, Backspace takes a point back");
}

void PatternSplitTool::paint(QPainter& painter, const ViewColors& colors) const
{
    std::vector<Vec2> points = m_points;
    if (m_next)
        points.push_back(*m_next);
    QPolygonF line;
    for (const Vec2& point : points)
        line.append(m_context.transform().toPixels(point));
    paintLine(painter, line, colors);
    painter.setPen(QPen(colors.accent, 1.4));
    painter.setBrush(colors.pointFill);
    for (const QPointF& point : line)
        painter.drawEllipse(point, splitPointRadius, splitPointRadius);
}

/// Dashed, and solid where it would cut.
void PatternSplitTool::paintLine(QPainter& painter, const QPolygonF& line, const ViewColors& colors) const
{
    painter.setBrush(Qt::NoBrush);
    painter.setPen(QPen(colors.accent, 1.4, Qt::DashLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    const PatternPatch* patch = m_context.scene().patch(m_splits);
    if (!patch)
        return;
    painter.save();
    painter.setClipPath(m_context.transform().matrix().map(patch->path), Qt::IntersectClip);
    painter.setPen(QPen(colors.accent, 3, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPolyline(line);
    painter.restore();
}

} // namespace bolster
