#include "BoxShapeTool.h"

#include "CurvePath.h"
#include "OutlineDraft.h"
#include "SnapHints.h"
#include "ToolGeometry.h"
#include "Units.h"

#include <QPainter>

#include <cmath>

namespace bolster {

namespace {} // namespace

void BoxShapeTool::press(const PatternPointer& pointer)
{
    m_pointer = pointer;
    pointerMoved();
    if (m_first) {
        m_typed.clear();
        pointerMoved();
        finish(outline());
    } else {
        m_first = m_next->point;
        m_pressed = pointer.pixel;
    }
    m_context.refresh();
}

void BoxShapeTool::move(const PatternPointer& pointer)
{
    m_pointer = pointer;
    pointerMoved();
    m_context.refresh();
}

void BoxShapeTool::release(const PatternPointer& pointer)
{
    move(pointer);
    if (!m_pressed)
        return;
    const QPointF way = pointer.pixel - *m_pressed;
    m_pressed.reset();
    if (m_first && std::hypot(way.x(), way.y()) >= dragDistance && !finish(outline()))
        giveUp();
    m_context.refresh();
}

void BoxShapeTool::pointerMoved()
{
    m_next.reset();
    m_typedGood = false;
    if (m_pointer) {
        SnapQuery query;
        if (m_first)
            query.own.push_back(*m_first);
        query.boxFrom = m_first;
        m_next = snappedPointer(m_context, *m_pointer, query);
        if (m_first && (m_pointer->modifiers & Qt::ShiftModifier)) {
            const Vec2 way = m_pointer->layout - *m_first;
            const double side = way.cwiseAbs().maxCoeff();
            m_next = Snapped{*m_first + Vec2(std::copysign(side, way.x()), std::copysign(side, way.y())), {}};
        }
    }
    if (!m_typed.open() || !m_first)
        return;
    const auto size = typedSize(m_typed.text(), m_next ? Vec2(m_next->point - *m_first) : Vec2(1, 1));
    m_typedGood = size.has_value();
    if (size)
        m_next = Snapped{*m_first + *size, {}};
}

void BoxShapeTool::giveUp()
{
    m_first.reset();
    m_pressed.reset();
    m_typed.clear();
    pointerMoved();
}

void BoxShapeTool::enter()
{
    if (m_typed.open() && !m_typedGood)
        m_context.report(tr("\"%1\" is no size: try 300 x 200").arg(m_typed.text()));
    else if (m_first && m_next)
        finish(outline());
}

std::optional<BSpline2> BoxShapeTool::outline() const
{
    if (!m_first || !m_next)
        return std::nullopt;
    return m_shape == BoxShape::Rectangle ? rectangleOutline(*m_first, m_next->point)
                                          : ellipseOutline(*m_first, m_next->point);
}

QString BoxShapeTool::prompt() const
{
    if (m_typed.open())
        return tr("Enter makes it this wide and high: 300 x 200");
    if (!m_first)
        return m_shape == BoxShape::Rectangle
                   ? tr("Drag a rectangle, or click two opposite corners \u2013 Esc ends the tool")
                   : tr("Drag an ellipse, or click two opposite corners of its box \u2013 Esc ends the tool");
    return tr(
        "Click the opposite corner, or type width x height \u2013 Shift makes both equal, Ctrl does not snap");
}

void BoxShapeTool::paint(QPainter& painter, const ViewColors& colors) const
{
    if (!m_next)
        return;
    const PatternTransform& transform = m_context.transform();
    paintSnapHints(painter, colors, transform, m_next->hints);
    const QPointF beside = m_pointer ? m_pointer->pixel : transform.toPixels(m_next->point);
    if (!m_first) {
        paintNote(painter, colors, beside, {snapText(m_next->hints)});
        return;
    }
    if (const auto shape = outline()) {
        const QPainterPath path = transform.matrix().map(curvePath(*shape, [](const Vec2& p) { return p; }));
        QColor fill = colors.accent;
        fill.setAlphaF(0.08F);
        painter.fillPath(path, fill);
        painter.strokePath(path, QPen(colors.accent, 2, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
        if (m_shape == BoxShape::Ellipse) {
            painter.setPen(QPen(mixed(colors.canvas, colors.accent, 0.5), 1, Qt::DashLine));
            painter.setBrush(Qt::NoBrush);
            painter.drawRect(QRectF(transform.toPixels(*m_first), transform.toPixels(m_next->point)).normalized());
        }
    }
    const Vec2 size = (m_next->point - *m_first).cwiseAbs();
    if (m_typed.open())
        m_typed.paint(painter, colors, beside, m_typedGood);
    else
        paintNote(painter, colors, beside,
                  {tr("%1 \u00d7 %2").arg(lengthText(size.x()), lengthText(size.y())), snapText(m_next->hints)});
}

} // namespace bolster
