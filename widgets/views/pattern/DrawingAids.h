// What helps to draw in the pattern view and is no part of the design: snapping, guides, a picture to trace.
#pragma once

#include "BackgroundPicture.h"
#include "Snapper.h"

#include <QObject>

namespace bolster {

class DrawingAids : public QObject {
    Q_OBJECT

public:
    using QObject::QObject;

    /// Whether drawing and dragging snap to what is near; off at first.
    bool snapping() const { return m_snap.on; }
    void setSnapping(bool on) { m_snap.on = on; }
    /// Snapping finds the lines of the grid, too; off at first.
    void setGrid(bool on) { m_snap.grid = on; }
    /// With the guides that are shown.
    const SnapSettings& snapSettings() const { return m_snap; }

    /// Those that are hidden do not snap.
    const PatternGuides& guides() const { return m_guides; }
    void setGuides(const PatternGuides& guides);
    void setGuidesShown(bool shown);

    /// A drag from nothing selects in a loop; with Alt it is the other way round.
    bool lasso() const { return m_lasso; }
    void setLasso(bool on) { m_lasso = on; }

    const BackgroundPicture& background() const { return m_background; }
    void setBackground(const BackgroundPicture& picture);

signals:
    /// To be painted anew.
    void changed();

private:
    SnapSettings m_snap;
    PatternGuides m_guides;
    bool m_guidesShown = true;
    bool m_lasso = false;
    BackgroundPicture m_background;
};

} // namespace bolster
