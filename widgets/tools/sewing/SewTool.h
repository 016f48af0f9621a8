// Sews outlines together: one edge, then the one it belongs to.
#pragma once

#include "PatternTool.h"

#include <QCoreApplication>

namespace bolster {

/// A click takes the edge between two corners, or what is free of it; a drag along the outline or two clicks with
/// Shift take the stretch between two points, which snap to corners, control points and the ends of seams. The
/// second click sews. Ctrl or M takes several stretches in a row for the second side, until Enter sews them. F
/// flips, Backspace takes back a stretch, Escape goes back a step.
class SewTool : public PatternTool {
    Q_DECLARE_TR_FUNCTIONS(SewTool)

public:
    using PatternTool::PatternTool;

    void press(const PatternPointer& pointer) override;
    void move(const PatternPointer& pointer) override;
    void release(const PatternPointer& pointer) override;
    void doubleClick(const PatternPointer& pointer) override;
    bool keyPress(const QKeyEvent& event) override;
    bool wants(int key) const override;
    ToolKeys keys() const override;
    bool escape() override;
    void leave() override;

    QString prompt() const override;
    QCursor cursor() const override;
    void paint(QPainter& painter, const ViewColors& colors) const override;

private:
    /// A point of an outline.
    struct Place {
        ElementId patch{};
        double parameter = 0;
        Vec2 at = Vec2::Zero(); ///< in the layout, mm
    };

    const Design& design() const;
    bool isTaken(const Place& place) const;
    std::optional<Place> placeAt(const Vec2& layout) const;
    Place snapped(const Place& place) const;
    std::optional<Place> snappedOn(ElementId patch, const Vec2& layout) const;

    void offer(const PatternPointer& pointer);
    void offerEdge(const PatternPointer& pointer);
    void offerDragged(const PatternPointer& pointer);
    void offerBetween(const PatternPointer& pointer);
    void judgeOffer();
    void take(const PatternPointer& pointer);
    void sew();
    void takeBack();
    void forgetAll();
    void forgetGone();
    void forgetOffer();
    std::vector<Stretch> row() const;
    std::optional<QPointF> flipButton() const;
    bool onFlipButton(QPointF pixel) const;

    std::vector<Stretch> m_taken; ///< the first side, then those of the second
    bool m_flipped = false;
    bool m_several = false; ///< each click takes one more, Enter sews

    std::optional<Stretch> m_offer; ///< what a click would take
    QString m_refusal;              ///< why it would take nothing here
    std::optional<Place> m_mark;    ///< where the pointer is on an outline
    bool m_pointing = false;        ///< a click sets a point there
    std::optional<Place> m_from;    ///< the first end of a stretch between two points
    double m_way = 0;               ///< from there along the outline to the pointer, while dragging
    bool m_dragging = false;
    std::optional<PatternPointer> m_pressed;
    std::optional<Place> m_pressedPlace;
    QPointF m_pointer;
};

} // namespace bolster
