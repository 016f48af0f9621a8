#include "CoverMeasureTool.h"

#include "DrawingKeys.h"
#include "KeptMeasure.h"
#include "ToolGeometry.h"
#include "Units.h"
#include "ViewColors.h"

#include <QKeyEvent>

namespace bolster {

void CoverMeasureTool::press(const CoverPointer& pointer)
{
    m_pressed = pointer.pixel;
    find(pointer.pixel);
    m_context.refresh();
}

bool CoverMeasureTool::move(const CoverPointer& pointer)
{
    if (m_pressed && (pointer.pixel - *m_pressed).manhattanLength() > dragDistance) {
        m_pressed.reset();
        m_next.reset();
        m_context.refresh();
        return false; // it turns the view
    }
    find(pointer.pixel);
    m_context.refresh();
    return true;
}

void CoverMeasureTool::release(const CoverPointer& pointer)
{
    if (!m_pressed)
        return;
    m_pressed.reset();
    find(pointer.pixel);
    if (!m_next) {
        m_context.report(tr("There is no cover here: click on the cover."));
    } else if (!m_first || m_second) {
        m_first = m_next;
        m_second.reset();
    } else {
        m_second = m_next;
    }
    m_context.refresh();
}

void CoverMeasureTool::find(QPointF pixel)
{
    m_pointer = pixel;
    m_next = m_context.inPattern(m_context.solid(pixel));
}

std::optional<PatchPoint> CoverMeasureTool::end() const
{
    return !m_first || m_second ? m_second : m_next;
}

/// Of the cover as it is now.
std::optional<double> CoverMeasureTool::length() const
{
    const std::optional<PatchPoint> to = end();
    const auto a = to ? m_context.onCover(*m_first) : std::nullopt, b = to ? m_context.onCover(*to) : std::nullopt;
    return a && b ? std::optional((*b - *a).norm()) : std::nullopt;
}

bool CoverMeasureTool::wants(int key) const
{
    return key == Qt::Key_Escape || (isEnterKey(key) && m_second);
}

bool CoverMeasureTool::keyPress(const QKeyEvent& event)
{
    if (!isEnterKey(event.key()) || !m_second)
        return false;
    keepMeasure(m_context, *m_first, *m_second);
    m_first.reset();
    m_second.reset();
    m_context.refresh();
    return true;
}

ToolKeys CoverMeasureTool::keys() const
{
    if (!m_second)
        return {};
    return {{Qt::Key_Return, tr("&Keep the measurement")}};
}

bool CoverMeasureTool::escape()
{
    if (!m_first)
        m_context.endTool();
    m_first.reset();
    m_second.reset();
    m_context.refresh();
    return true;
}

void CoverMeasureTool::leave()
{
    m_next.reset();
    m_pressed.reset();
    m_context.refresh();
}

QString CoverMeasureTool::prompt() const
{
    if (const std::optional<double> measured = length())
        return m_second
                   ? tr("%1 \u2013 Enter keeps the measurement, a click begins anew").arg(lengthText(*measured, 1))
                   : lengthText(*measured, 1);
    return m_first ? tr("Click the second point on the cover \u2013 Esc gives it up")
                   : tr("Click two points of the cover or of the pattern to measure \u2013 Esc ends the tool");
}

std::optional<SceneNote> CoverMeasureTool::note() const
{
    const std::optional<double> measured = length();
    return measured ? std::optional(SceneNote{lengthText(*measured, 1), m_pointer}) : std::nullopt;
}

std::vector<SceneLine> CoverMeasureTool::guides() const
{
    const std::optional<PatchPoint> to = end();
    const auto a = m_first ? m_context.onCover(*m_first) : std::nullopt;
    const auto b = to ? m_context.onCover(*to) : std::nullopt;
    if (!a || !b)
        return {};
    SceneLine line;
    line.points = {a->cast<float>(), b->cast<float>()};
    line.color = m_context.colors().accent;
    line.width = 2;
    line.hidden = 1;
    return {line};
}

} // namespace bolster
