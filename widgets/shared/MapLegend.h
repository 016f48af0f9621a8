// What the colours of a map mean.
#pragma once

#include "ShownMap.h"

#include <QWidget>

#include <vector>

class QPainter;

namespace bolster {

/// A bar with numbers, in the corner of a view; hidden without a map.
class MapLegend : public QWidget {
    Q_OBJECT

public:
    explicit MapLegend(QWidget* parent);

    void setMap(ShownMapPtr map);
    const ShownMapPtr& map() const { return m_map; }
    /// What the map says under the pointer, in words; "" when the pointer is elsewhere.
    void setReading(const QString& reading);
    const QString& reading() const { return m_reading; }
    /// To a corner of the parent, the lower right one if it can be: that where it covers least of these places.
    /// Whether it covers nothing.
    bool place(const std::vector<QRectF>& busy = {});
    QSize sizeHint() const override;

protected:
    void paintEvent(QPaintEvent* event) override;

private:
    QString number(double value) const;
    int barWidth() const;
    void markValue(QPainter& painter, const QRect& bar, const QRect& text) const;
    bool hasLimits() const { return m_map && !m_map->allowed.empty(); }

    ShownMapPtr m_map;
    QString m_reading;
};

} // namespace bolster
