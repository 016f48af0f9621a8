// Drags that change the design: computed from the state at the press, or from numbers that are typed meanwhile.
#pragma once

#include "PatternDrags.h"
#include "SnapHints.h"
#include "TypedEntry.h"

#include <vector>

namespace bolster {

class EditingDrag : public PatternDrag {
public:
    EditingDrag(PatternToolContext& context, const PatternPointer& from)
        : PatternDrag(context, from)
        , m_gesture(context.document())
    {}

    void update(const PatternPointer& pointer) final;
    void finish() override { m_gesture.commit(); }
    bool active() const override { return m_gesture.active(); }
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override { return m_typed.wants(key); }
    bool clearTyped() override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

protected:
    /// What the drag means with the pointer there, or with what is typed if that can be understood.
    virtual Edit editAt(const PatternPointer& pointer) = 0;

    /// What `read` makes of the typed text; `dragged` when that is nothing.
    template <class T, class Read>
    T typedOr(const T& dragged, const Read& read)
    {
        const std::optional<T> typed = m_typed.open() ? read(m_typed.text()) : std::nullopt;
        m_typedGood = typed.has_value();
        return typed.value_or(dragged);
    }
    Vec2 typedOr(const Vec2& dragged)
    {
        return typedOr(dragged, [&](const QString& text) { return typedStep(text, dragged); });
    }

    /// Shift keeps to an axis, Ctrl and Alt let go: then nothing snaps.
    static bool free(const PatternPointer& pointer)
    {
        return pointer.modifiers & (Qt::ShiftModifier | Qt::ControlModifier | Qt::AltModifier);
    }

    Gesture m_gesture;
    std::vector<SnapHint> m_hints;
    PatternPointer m_pointer = m_from; ///< the last one
    TypedEntry m_typed;
    bool m_typedGood = false;
};

} // namespace bolster
