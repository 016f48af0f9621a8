#include "BoxShapeTool.h"

#include "CurvePath.h"
#include "FreeRoom.h"
#include "OutlineDraft.h"
#include "SnapHints.h"
#include "ToolGeometry.h"
#include "Units.h"

#include <QPainter>

#include <cmath>

namespace bolster {

void BoxShapeTool::press(const PatternPointer& pointer)
{
    m_pointer = pointer;
    pointerMoved();
    if (m_first) {
        enter(); // what is shown
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
    if (m_first && std::hypot(way.x(), way.y()) >= dragDistance && !add())
        giveUp();
    m_context.refresh();
}

void BoxShapeTool::pointerMoved()
{
    m_next.reset();
    m_shifted.reset();
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
    const Vec2 way = m_next ? Vec2(m_next->point - *m_first) : Vec2::Zero();
    const auto size = typedSize(m_typed.text(), way);
    m_typedGood = size.has_value();
    if (size)
        place(*size, way.norm() * m_context.transform().scale() >= dragDistance);
}

/// What is typed grows where the pointer is; if it has not been moved, where there is room.
void BoxShapeTool::place(const Vec2& size, bool pointed)
{
    m_shifted.reset();
    m_next = Snapped{*m_first + size, {}};
    if (pointed || patchesUnder(m_context.scene(), box()).isEmpty())
        return;
    if (const auto free = freeQuadrant(m_context.scene(), *m_first, size.cwiseAbs())) {
        m_next->point = *free;
    } else {
        const Box2 room = freeBox(m_context.scene(), *m_first, size.cwiseAbs());
        m_shifted = room.min();
        m_next->point = room.max();
    }
}

Box2 BoxShapeTool::box() const
{
    Box2 box(m_shifted.value_or(*m_first));
    box.extend(m_next->point);
    return box;
}

/// Adds it and says what else would be a surprise.
bool BoxShapeTool::add()
{
    const QStringList under = m_first && m_next ? patchesUnder(m_context.scene(), box()) : QStringList();
    const bool shifted = m_first && m_next && m_shifted;
    if (!finish(outline()))
        return false;
    if (shifted)
        m_context.report(tr("There was no room where you clicked: the patch lies beside the others."));
    else if (!under.isEmpty())
        m_context.report(tr("The new patch lies on %1: drag it away, or let all be arranged (Pattern > Arrange).")
                             .arg(under.join(QStringLiteral(", "))));
    return true;
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
        add();
}

std::optional<BSpline2> BoxShapeTool::outline() const
{
    if (!m_first || !m_next)
        return std::nullopt;
    const Vec2 first = m_shifted.value_or(*m_first);
    return m_shape == BoxShape::Rectangle ? rectangleOutline(first, m_next->point)
                                          : ellipseOutline(first, m_next->point);
}

QString BoxShapeTool::prompt() const
{
    if (m_typed.open())
        return tr("Enter makes it as wide and high as typed, for example 300 x 200");
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
            painter.drawRect(QRectF(transform.toPixels(box().min()), transform.toPixels(box().max())).normalized());
        }
    }
    const Vec2 size = box().sizes();
    const QStringList under = patchesUnder(m_context.scene(), box());
    const QString on = under.isEmpty() ? QString() : tr("lies on %1").arg(under.join(QStringLiteral(", ")));
    if (m_typed.open())
        m_typed.paint(painter, colors, beside, m_typedGood);
    else
        paintNote(
            painter, colors, beside,
            {tr("%1 \u00d7 %2").arg(lengthText(size.x()), lengthText(size.y())), snapText(m_next->hints), on});
}

} // namespace bolster
