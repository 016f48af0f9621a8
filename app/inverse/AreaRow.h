// "Only in a painted area": a brush for the 3D view, and what was painted, shown in colours on cover and pattern.
#pragma once

#include "AreaBrushTool.h"
#include "FitGoals.h"

#include <QWidget>

class QCheckBox;
class QPushButton;

namespace bolster {

class CoverView;
class MapLink;
class NumberBox;
class SolverLink;

class AreaRow : public QWidget {
    Q_OBJECT

public:
    struct Parts {
        SolverLink& solver;
        MapLink& maps;
        CoverView& cover;
    };
    explicit AreaRow(const Parts& parts, QWidget* parent = nullptr);
    ~AreaRow() override;

    /// Whether only a part of the cover is meant.
    bool wanted() const;
    /// Of the pattern as it is now; nothing as long as nothing is painted.
    const std::vector<AreaSpot>& spots() const { return m_spots; }
    void setSpots(std::vector<AreaSpot> spots);

private:
    void paint();
    void take(const AreaBrushTool::Stamp& stamp);
    void refresh();

    Parts m_parts;
    QCheckBox* m_only;
    QPushButton *m_paint, *m_clear;
    NumberBox* m_radius;
    std::vector<AreaSpot> m_spots;
    bool m_seen = false; ///< in colours
};

} // namespace bolster
