// Draws rectangles and ellipses as new patches.
#pragma once

#include "PatchDrawingTool.h"

namespace bolster {

enum class BoxShape { Rectangle, Ellipse };

/// From corner to corner of the box around the shape: by a drag, two clicks, or a typed width and height. Shift
/// makes both equal. What is typed without moving the pointer never lies on another patch; else that is said.
/// Escape gives up what is typed, then the shape, then the tool.
class BoxShapeTool : public PatchDrawingTool {
    Q_DECLARE_TR_FUNCTIONS(BoxShapeTool)

public:
    BoxShapeTool(PatternToolContext& context, BoxShape shape)
        : PatchDrawingTool(context)
        , m_shape(shape)
    {}

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    void release(const PatternPointer& pointer) override;

    QString prompt() const override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    bool begun() const override { return m_first.has_value(); }
    void giveUp() override;
    void takeBack() override { giveUp(); }
    void enter() override;
    void pointerMoved() override;

    std::optional<BSpline2> outline() const;
    void place(const Vec2& size, bool pointed);
    Box2 box() const;
    bool add();

    BoxShape m_shape;
    std::optional<Vec2> m_first; ///< corner, layout mm
    std::optional<Snapped> m_next;
    std::optional<Vec2> m_shifted; ///< the first corner where there was no room at the clicked one
    bool m_typedGood = false;
    std::optional<QPointF> m_pressed; ///< the first corner was set there, the button is still down
};

} // namespace bolster
