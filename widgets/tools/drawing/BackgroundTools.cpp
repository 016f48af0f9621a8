#include "BackgroundTools.h"

#include "BackgroundPicture.h"
#include "LengthExpression.h"
#include "SnapHints.h"
#include "Units.h"

#include <QKeyEvent>
#include <QPainter>

namespace bolster {

void BackgroundScaleTool::press(const PatternPointer& pointer)
{
    if (m_context.background().empty()) {
        m_context.report(tr("There is no background picture yet."));
        m_context.endTool();
        return;
    }
    if (m_points.size() == 2)
        m_points.clear();
    m_points.push_back(pointer.layout);
    move(pointer);
}

void BackgroundScaleTool::move(const PatternPointer& pointer)
{
    m_pointer = pointer.layout;
    m_context.refresh();
}

double BackgroundScaleTool::distance() const
{
    return m_points.size() < 2 ? 0 : (m_points[1] - m_points[0]).norm();
}

bool BackgroundScaleTool::keyPress(const QKeyEvent& event)
{
    const bool enter = event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter;
    if (m_points.size() < 2 || !(enter || m_typed.keyPress(event)))
        return false;
    if (enter)
        apply();
    m_context.refresh();
    return true;
}

bool BackgroundScaleTool::wants(int key) const
{
    return m_points.size() == 2 && (m_typed.wants(key) || key == Qt::Key_Return || key == Qt::Key_Enter);
}

void BackgroundScaleTool::apply()
{
    const std::optional<double> wanted = parseLength(m_typed.text());
    if (!wanted || !(*wanted > 0) || !(distance() > 0)) {
        m_context.report(tr("Type the true distance of the two points, for example 500 or 20 in."));
        return;
    }
    m_context.setBackground(m_context.background().scaled(*wanted / distance(), m_points[0]));
    m_context.endTool();
}

bool BackgroundScaleTool::escape()
{
    if (m_typed.open())
        m_typed.clear();
    else if (!m_points.empty())
        m_points.clear();
    else
        m_context.endTool();
    m_context.refresh();
    return true;
}

QString BackgroundScaleTool::prompt() const
{
    if (m_points.empty())
        return tr("Click the first of two points of the picture whose distance you know \u2013 Esc ends the tool");
    return m_points.size() == 1 ? tr("Click the second point") : tr("Type their true distance, then Enter");
}

void BackgroundScaleTool::paint(QPainter& painter, const ViewColors& colors) const
{
    if (m_points.empty())
        return;
    const PatternTransform& transform = m_context.transform();
    const QPointF a = transform.toPixels(m_points[0]);
    const QPointF b = transform.toPixels(m_points.size() == 2 ? m_points[1] : m_pointer);
    painter.setPen(QPen(colors.accent, 1.6));
    painter.setBrush(colors.pointFill);
    painter.drawLine(a, b);
    painter.drawEllipse(a, 4, 4);
    painter.drawEllipse(b, 4, 4);
    if (m_typed.open())
        m_typed.paint(painter, colors, b, parseLength(m_typed.text()).has_value());
    else if (m_points.size() == 2)
        paintNote(painter, colors, b, {tr("now %1").arg(lengthText(distance()))});
}

void BackgroundMoveTool::press(const PatternPointer& pointer)
{
    if (m_context.background().empty()) {
        m_context.report(tr("There is no background picture yet."));
        m_context.endTool();
        return;
    }
    m_pressed = pointer.layout;
    m_corner = m_context.background().corner;
}

void BackgroundMoveTool::move(const PatternPointer& pointer)
{
    if (!m_pressed)
        return;
    BackgroundPicture picture = m_context.background();
    picture.corner = m_corner + pointer.layout - *m_pressed;
    m_context.setBackground(picture);
}

bool BackgroundMoveTool::keyPress(const QKeyEvent& event)
{
    if (event.key() != Qt::Key_Return && event.key() != Qt::Key_Enter)
        return false;
    m_context.endTool();
    return true;
}

bool BackgroundMoveTool::escape()
{
    if (!m_pressed) {
        m_context.endTool();
        return true;
    }
    BackgroundPicture picture = m_context.background();
    picture.corner = m_corner;
    m_pressed.reset();
    m_context.setBackground(picture);
    return true;
}

QString BackgroundMoveTool::prompt() const
{
    return tr("Drag the picture to its place \u2013 Enter or Esc ends the tool");
}

void BackgroundMoveTool::paint(QPainter& painter, const ViewColors& colors) const
{
    const BackgroundPicture& picture = m_context.background();
    if (picture.empty())
        return;
    const Box2 box = picture.box();
    const PatternTransform& transform = m_context.transform();
    painter.setPen(QPen(colors.accent, 1.2, Qt::DashLine));
    painter.setBrush(Qt::NoBrush);
    painter.drawRect(QRectF(transform.toPixels(box.min()), transform.toPixels(box.max())).normalized());
}

} // namespace bolster
