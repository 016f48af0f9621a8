#include "OutlineTool.h"

#include "CurvePath.h"
#include "DesignCheck.h"
#include "SnapHints.h"
#include "Translated.h"
#include "Units.h"

#include <QPainter>

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

// Pixels.
constexpr double closeReach = 9;
constexpr double pullDistance = 4;
constexpr double outlinePointRadius = 4;

double distance(QPointF a, QPointF b)
{
    return std::hypot(a.x() - b.x(), a.y() - b.y());
}

} // namespace

void OutlineTool::press(const PatternPointer& pointer)
{
    m_pointer = pointer;
    pointerMoved();
    if (m_closing) {
        close();
        return;
    }
    m_typed.clear();
    m_points.push_back({snappedPointer(m_context, pointer, {}).point});
    if (m_next)
        m_points.back().at = m_next->point;
    m_pressed = pointer.pixel;
    m_next.reset();
    findProblem();
    m_context.refresh();
}

void OutlineTool::move(const PatternPointer& pointer)
{
    m_pointer = pointer;
    if (m_pressed && (m_points.back().handle || distance(pointer.pixel, *m_pressed) >= pullDistance))
        pullHandle(pointer);
    else
        pointerMoved();
    m_context.refresh();
}

void OutlineTool::release(const PatternPointer& pointer)
{
    m_pressed.reset();
    move(pointer);
}

void OutlineTool::doubleClick(const PatternPointer&)
{
    m_pressed.reset(); // its first click has set the last point
    close();
}

void OutlineTool::pullHandle(const PatternPointer& pointer)
{
    Vec2 handle = pointer.layout - m_points.back().at;
    if (pointer.modifiers & Qt::ShiftModifier) {
        const double step = std::numbers::pi / 4;
        const double angle = step * std::round(std::atan2(handle.y(), handle.x()) / step);
        handle = handle.norm() * Vec2(std::cos(angle), std::sin(angle));
    }
    m_next.reset();
    if (handle.norm() > 1e-6)
        m_points.back().handle = handle;
    findProblem();
}

bool OutlineTool::closes() const
{
    if (!m_pointer || m_typed.open() || !draftOutline(m_points))
        return false;
    return distance(m_pointer->pixel, m_context.transform().toPixels(m_points.front().at)) <= closeReach;
}

void OutlineTool::pointerMoved()
{
    m_closing = closes();
    m_next.reset();
    m_typedGood = false;
    if (m_pointer && !m_pressed) {
        SnapQuery query;
        for (const DraftPoint& point : m_points)
            query.own.push_back(point.at);
        if (!m_points.empty())
            query.from = m_points.back().at;
        if (m_points.size() > 1)
            query.before = m_points[m_points.size() - 2].at;
        m_next = m_closing ? Snapped{m_points.front().at, {}} : snappedPointer(m_context, *m_pointer, query);
    }
    if (m_typed.open() && !m_points.empty()) {
        const Vec2 last = m_points.back().at;
        const Vec2 way = m_next ? Vec2(m_next->point - last) : Vec2::Zero();
        const auto step = typedStep(m_typed.text(), way.norm() > 1e-6 ? way : Vec2::UnitX());
        m_typedGood = step.has_value();
        if (step)
            m_next = Snapped{last + *step, {}};
    }
    findProblem();
}

void OutlineTool::findProblem()
{
    m_problem.clear();
    if (m_closing) {
        if (const auto outline = draftOutline(m_points))
            if (const std::optional<Message> problem = outlineProblem(*outline))
                m_problem = tr("This cannot be a patch: %1").arg(translated(*problem));
    } else if (crossesItself(draftPath(shown()), m_context.transform().scale())) {
        m_problem = tr("The outline would cross itself here \u2013 Backspace takes a point back");
    }
}

void OutlineTool::giveUp()
{
    m_points.clear();
    m_typed.clear();
    m_pressed.reset();
    pointerMoved();
}

void OutlineTool::takeBack()
{
    m_points.pop_back();
    m_pressed.reset();
    pointerMoved();
}

void OutlineTool::enter()
{
    if (!m_typed.open()) {
        close();
    } else if (m_typedGood) {
        m_points.push_back({m_next->point});
        m_typed.clear();
        pointerMoved();
    } else {
        m_context.report(tr("\"%1\" is no length: try 500, 500<30 or 120, 40").arg(m_typed.text()));
    }
}

void OutlineTool::close()
{
    if (m_points.empty())
        return;
    finish(draftOutline(m_points));
    m_context.refresh();
}

std::vector<DraftPoint> OutlineTool::shown() const
{
    std::vector<DraftPoint> points = m_points;
    if (m_next && !m_closing && !points.empty())
        points.push_back({m_next->point});
    return points;
}

QString OutlineTool::prompt() const
{
    if (!m_problem.isEmpty())
        return m_problem;
    if (m_points.empty())
        return tr("Click to set the first corner, press and drag for a smooth point \u2013 Esc ends the tool");
    if (m_closing)
        return tr("Click to close the outline");
    if (m_typed.open())
        return tr("Enter sets the point: 500 goes that far, 500<30 at an angle, 120, 40 to the right and up");
    return m_points.size() < 3
               ? tr("Click for a corner, drag for a smooth point, or type a length \u2013 Ctrl does not snap")
               : tr("Click for a corner, drag for a smooth point, type a length \u2013 Enter or a click on the "
                    "first "
                    "point closes, Backspace takes a point back");
}

void OutlineTool::paint(QPainter& painter, const ViewColors& colors) const
{
    const PatternTransform& transform = m_context.transform();
    const std::vector<DraftPoint> points = shown();
    const QColor color = m_problem.isEmpty() ? colors.accent : colors.error;
    if (m_next)
        paintSnapHints(painter, colors, transform, m_next->hints);
    if (points.size() > 2 || m_closing) {
        QPainterPath inside = draftPath(points);
        inside.connectPath(closingPath(points));
        QColor fill = color;
        fill.setAlphaF(0.08F);
        painter.fillPath(transform.matrix().map(inside), fill);
        painter.strokePath(transform.matrix().map(closingPath(points)),
                           QPen(mixed(colors.canvas, color, m_closing ? 1 : 0.5), m_closing ? 2 : 1,
                                m_closing ? Qt::SolidLine : Qt::DashLine));
    }
    painter.strokePath(transform.matrix().map(draftPath(points)),
                       QPen(color, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    paintHandles(painter, colors);
    for (std::size_t i = 0; i < points.size(); ++i) {
        const bool target = i == 0 && m_closing;
        const QPointF at = transform.toPixels(points[i].at);
        const double r = target ? outlinePointRadius + 2 : outlinePointRadius;
        painter.setPen(QPen(color, 1.6));
        painter.setBrush(target ? color : colors.pointFill);
        if (points[i].handle)
            painter.drawEllipse(at, r, r);
        else
            painter.drawRect(QRectF(at - QPointF(r, r), QSizeF(2 * r, 2 * r)));
    }
    paintNotes(painter, colors);
}

void OutlineTool::paintHandles(QPainter& painter, const ViewColors& colors) const
{
    if (m_points.empty() || !m_points.back().handle || !m_pressed)
        return;
    const PatternTransform& transform = m_context.transform();
    const DraftPoint& last = m_points.back();
    const QPointF before = transform.toPixels(last.at - *last.handle);
    const QPointF after = transform.toPixels(last.at + *last.handle);
    painter.setPen(QPen(mixed(colors.canvas, colors.accent, 0.7), 1));
    painter.drawLine(before, after);
    painter.setBrush(colors.accent);
    painter.drawEllipse(before, 2.5, 2.5);
    painter.drawEllipse(after, 2.5, 2.5);
}

void OutlineTool::paintNotes(QPainter& painter, const ViewColors& colors) const
{
    if (!m_next || m_points.empty()) {
        if (m_next && m_pointer)
            paintNote(painter, colors, m_pointer->pixel, {snapText(m_next->hints)});
        return;
    }
    const QPointF beside = m_pointer ? m_pointer->pixel : m_context.transform().toPixels(m_next->point);
    if (m_typed.open()) {
        m_typed.paint(painter, colors, beside, m_typedGood);
        return;
    }
    const Vec2 way = m_next->point - m_points.back().at;
    const double degrees = std::atan2(way.y(), way.x()) * 180 / std::numbers::pi;
    if (m_closing)
        paintNote(painter, colors, beside, {tr("Close")});
    else if (way.norm() > 1e-6)
        paintNote(painter, colors, beside,
                  {tr("%1, %2").arg(lengthText(way.norm()), angleText(degrees)), snapText(m_next->hints)});
}

} // namespace bolster
