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
    /// What the map says under the pointer, in words; "" when the pointer is elsewhere.
    void setReading(const QString& reading);
    /// To the lower right corner of the parent.
    void place();
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString number(double value) const;

    bool hasLimits() const { return m_map && !m_map->allowed.empty(); }

    SurfaceMapPtr m_map;
    QString m_reading;
};

} // namespace bolster
