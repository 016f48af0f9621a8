#include "MarkDrag.h"

#include "CuttingEdits.h"
#include "Document.h"
#include "ElementText.h"
#include "Units.h"

#include <QCoreApplication>

#include <array>
#include <cmath>

namespace bolster {

namespace {

QString markText(const char* words)
{
    return QCoreApplication::translate("MarkDrag", words);
}

class MarkDrag : public PatternDrag {
public:
    MarkDrag(PatternToolContext& context, const PatternPointer& from, ElementId mark, const Patch& patch)
        : PatternDrag(context, from)
        , m_gesture(context.document())
        , m_mark(mark)
        , m_patch(patch)
    {}

    void update(const PatternPointer& pointer) override { m_gesture.update(editAt(pointer)); }
    void finish() override { m_gesture.commit(); }
    bool active() const override { return m_gesture.active(); }
    Qt::CursorShape cursor() const override { return Qt::SizeAllCursor; }

    QString prompt() const override
    {
        if (const auto* edge = m_context.document().design().find<EdgeAllowance>(m_mark))
            return markText(QT_TRANSLATE_NOOP("MarkDrag",
                                              "Allowance of %1 \u2013 Ctrl for any width, Esc takes it back"))
                .arg(lengthText(edge->width));
        return markText(QT_TRANSLATE_NOOP("MarkDrag", "Drag it to where it belongs \u2013 Esc takes it back"));
    }

private:
    Edit editAt(const PatternPointer& pointer) const
    {
        const Design& start = m_gesture.start();
        const Vec2 at = fromLayout(m_patch, pointer.layout);
        if (start.find<DrillHole>(m_mark))
            return edits::moveDrillHoles(start, std::array{m_mark}, at - fromLayout(m_patch, m_from.layout));
        if (const auto* edge = start.find<EdgeAllowance>(m_mark))
            return edits::setEdgeAllowance(start, edge->stretch, widthAt(at, pointer.modifiers));
        return edits::movePlace(start, m_mark, m_patch.outline.closest(at).parameter);
    }

    /// How far outside of the sewing line the pointer is.
    double widthAt(const Vec2& at, Qt::KeyboardModifiers modifiers) const
    {
        const BSpline2& outline = m_patch.outline;
        const BSpline2::Closest closest = outline.closest(at);
        const Vec2 along = outline.derivative(closest.parameter);
        const bool left = cross(along, at - closest.point) > 0;
        const double width = left == (outline.signedArea() > 0) ? 0 : std::min(closest.distance, 200.0);
        return modifiers & (Qt::ControlModifier | Qt::AltModifier) ? width : std::round(2 * width) / 2;
    }

    Gesture m_gesture;
    ElementId m_mark;
    Patch m_patch;
};

} // namespace

std::unique_ptr<PatternDrag> dragMark(PatternToolContext& context, const PatternPointer& from, ElementId mark)
{
    const auto found = context.scene().marks().find(mark);
    const PatternPatch* patch =
        found == context.scene().marks().end() ? nullptr : context.scene().patch(found->second.patch);
    return patch ? std::make_unique<MarkDrag>(context, from, mark, patch->patch()) : nullptr;
}

} // namespace bolster
