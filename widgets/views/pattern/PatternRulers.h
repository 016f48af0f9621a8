// Rulers along the edges of the pattern view. Guides are dragged out of them.
#pragma once

#include "Snapper.h"
#include "ViewColors.h"

#include <QWidget>

namespace bolster {

class DrawingAids;
class PatternNavigation;

/// Along the top (Qt::Horizontal) or the left edge of the view, in mm. A drag out of the top ruler makes a level
/// guide, out of the left one an upright guide. A guide is grabbed by its mark on the ruler that it crosses, and
/// goes away when it is dragged back out of the view.
class PatternRuler : public QWidget {
    Q_OBJECT

public:
    static constexpr int thickness = 22; ///< pixels

    /// All must outlive it.
    PatternRuler(const PatternNavigation& navigation, DrawingAids& aids, Qt::Orientation orientation,
                 QWidget& view);
    /// Marks where the pointer is, layout mm.
    void showPointer(const std::optional<Vec2>& layout);
    /// Along the edge of the view, as it is now.
    void place();
    QSize sizeHint() const override { return {thickness, thickness}; }

signals:
    /// On the ruler.
    void pointerMoved(const std::optional<bolster::Vec2>& layout);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;

private:
    bool level() const { return m_orientation == Qt::Horizontal; }
    double along(const Vec2& layout) const; ///< pixels along the ruler
    std::vector<double>& dragged(PatternGuides& guides) const;
    void paintScale(QPainter& painter) const;
    void paintMarks(QPainter& painter) const;

    const PatternNavigation& m_navigation;
    DrawingAids& m_aids;
    QWidget& m_view;
    Qt::Orientation m_orientation;
    std::optional<Vec2> m_pointer; ///< layout mm

    bool m_dragging = false;
    bool m_ownAxis = false; ///< a guide that crosses this ruler was grabbed; else a new one, parallel to it
    PatternGuides m_others; ///< all guides but the dragged one
};

/// Lines across the view.
void paintGuides(QPainter& painter, const PatternGuides& guides, const PatternTransform& transform, QSize size,
                 const ViewColors& colors);

} // namespace bolster
