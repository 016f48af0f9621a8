// The pattern view: the patches in their layout, with seams and fixations.
#pragma once

#include "DrawingAids.h"
#include "PatternArrows.h"
#include "PatternCrosshair.h"
#include "PatternMargins.h"
#include "PatternNavigation.h"
#include "PatternPan.h"
#include "PatternToolHost.h"
#include "ShownPattern.h"

#include <QWidget>

#include <optional>

namespace bolster {

/// Which buttons pan and zoom says MouseStyle; Space with the left one pans, too; Home shows everything.
class PatternView : public QWidget {
    Q_OBJECT

public:
    PatternView(Document& document, Selection& selection, ProblemSet& problems, QWidget* parent = nullptr);
    ~PatternView() override;

    /// What is shown.
    ShownPattern& shown() { return m_shown; }
    /// Which part of the layout.
    PatternNavigation& navigation() { return m_navigation; }
    const PatternNavigation& navigation() const { return m_navigation; }
    /// What helps to draw: snapping, guides, a picture to trace.
    DrawingAids& aids() { return m_aids; }

    /// Colours on the patches; null for none.
    void setMap(const bolster::ShownMapPtr& map);
    /// What the map says under the pointer.
    void setMapReading(const QString& reading) { m_margins.setMapReading(reading); }
    /// Not beside another view that has one; shown at first.
    void setLegendShown(bool shown) { m_margins.setLegendShown(shown); }
    /// Rulers along the edges; off at first.
    void setRulersShown(bool shown) { m_margins.setRulersShown(shown); }
    /// Without rulers and the scale bar: here something may lie over the view. Pixels.
    QRect freeRoom() const { return m_margins.freeRoom(); }
    /// A cross-hair at a point of a patch; nothing takes it away.
    void showPlace(const std::optional<bolster::CoverPoint>& point) { m_crosshair.show(point); }
    /// Where outlines would go; none when there are none.
    void showArrows(bolster::PatternArrows arrows);
    /// Moves the picture if the point is not in it.
    void reveal(const bolster::CoverPoint& point);

    void setTool(bolster::PatternToolKind kind) { m_tools.setTool(kind); }
    PatternToolKind tool() const { return m_tools.kind(); }
    bool takeBack() { return m_tools.takeBack(); } ///< as ToolHost has it
    /// What can be done now, for the status bar.
    QString prompt() const { return m_tools.prompt(); }
    PatternHit hit(QPointF pixel) const { return m_tools.hit(pixel); }
    QSize sizeHint() const override { return {640, 640}; }

signals:
    void promptChanged(const QString& prompt);
    void toolChanged(bolster::PatternToolKind kind);
    /// There is more or less of it in a view of the same size.
    void freeRoomChanged();
    void pointerMoved(const std::optional<bolster::Vec2>& layout);
    /// The point of a patch under the pointer; nothing beside them.
    void patchPointed(const std::optional<bolster::CoverPoint>& point);
    /// Clicked with the tool that selects.
    void patchClicked(const bolster::CoverPoint& point);
    /// By the right button or the menu key; what lies there is selected then.
    void contextMenuWanted(const QPoint& global, bool onSomething);
    /// Instead, while a tool has begun something.
    void toolMenuWanted(const QPoint& global, const bolster::ToolKeys& keys);
    /// What a tool could not do, in the user's words.
    void failed(const QString& message);

protected:
    bool event(QEvent* event) override;
    void paintEvent(QPaintEvent* event) override;
    void resizeEvent(QResizeEvent* event) override;
    void changeEvent(QEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void mouseDoubleClickEvent(QMouseEvent* event) override;
    void wheelEvent(QWheelEvent* event) override;
    void keyPressEvent(QKeyEvent* event) override;
    void keyReleaseEvent(QKeyEvent* event) override;
    void leaveEvent(QEvent* event) override;
    void focusOutEvent(QFocusEvent* event) override;
    void contextMenuEvent(QContextMenuEvent* event) override;

private:
    void wire();
    void refreshed();
    bool handle(QEvent* event);
    std::optional<bool> tabPressed(const QKeyEvent& event);
    PatternPointer pointerOf(const QMouseEvent& event) const;

    bool m_whole = false; ///< else what is in it comes or goes, and there are no tools to handle events
    Document& m_document;
    Selection& m_selection;
    ShownPattern m_shown;
    PatternNavigation m_navigation;
    PatternPan m_pan;
    DrawingAids m_aids;
    PatternArrows m_arrows;
    PatternCrosshair m_crosshair;
    PatternMargins m_margins;
    PatternToolHost m_tools;
    QPointF m_pressedAt; ///< the left button
};

} // namespace bolster
