#include "EditingDrag.h"

#include "Document.h"
#include "PatchDrawingTool.h"
#include "ViewColors.h"

#include <QPainter>

#include <cmath>

namespace bolster {

Vec2 PatternDrag::moved(const PatternPointer& pointer) const
{
    Vec2 delta = pointer.layout - m_from.layout;
    if (pointer.modifiers & Qt::ShiftModifier)
        (std::abs(delta.x()) < std::abs(delta.y()) ? delta.x() : delta.y()) = 0;
    return delta;
}

void EditingDrag::update(const PatternPointer& pointer)
{
    m_pointer = pointer;
    m_hints.clear();
    m_typedGood = false;
    m_gesture.update(editAt(pointer));
    if (m_typedGood)
        m_hints.clear();
}

bool EditingDrag::keyPress(const QKeyEvent& event)
{
    if (!m_typed.keyPress(event))
        return false;
    update(m_pointer);
    return true;
}

bool EditingDrag::clearTyped()
{
    if (!m_typed.open())
        return false;
    m_typed.clear();
    update(m_pointer);
    return true;
}

void EditingDrag::paint(QPainter& painter, const ViewColors& colors) const
{
    paintSnapHints(painter, colors, m_context.transform(), m_hints);
    if (m_typed.open())
        m_typed.paint(painter, colors, m_pointer.pixel, m_typedGood);
    else if (!m_hints.empty())
        paintNote(painter, colors, m_context.transform().toPixels(m_hints.front().to), {snapText(m_hints)});
}

} // namespace bolster
