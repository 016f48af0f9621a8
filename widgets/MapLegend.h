// What the colours of a map mean.
#pragma once

#include "SurfaceMap.h"

#include <QWidget>

namespace bolster {

/// A bar with numbers, in the corner of a view; hidden without a map.
class MapLegend : public QWidget {
    Q_OBJECT

public:
    explicit MapLegend(QWidget* parent);

    void setMap(SurfaceMapPtr map);
    /// To the lower right corner of the parent.
    void place();
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString number(double value) const;

    SurfaceMapPtr m_map;
};

} // namespace bolster
