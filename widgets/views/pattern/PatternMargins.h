// What lies over the edges of the pattern view: rulers, the scale bar, the legend of a map.
#pragma once

#include "ShownMap.h"

#include <QObject>
#include <QRectF>

#include <array>
#include <optional>
#include <vector>

class QWidget;

namespace bolster {

class DrawingAids;
class MapLegend;
class PatternNavigation;
class PatternRuler;
class PatternScene;

class PatternMargins : public QObject {
    Q_OBJECT

public:
    /// All must outlive it.
    PatternMargins(const PatternScene& scene, PatternNavigation& navigation, DrawingAids& aids, QWidget& view);

    /// Off at first.
    void setRulersShown(bool shown);
    /// What its legend explains; null for none.
    void setMap(const ShownMapPtr& map);
    void setMapReading(const QString& reading);
    /// Not beside another view that has one; shown at first.
    void setLegendShown(bool shown);
    /// Without rulers and the scale bar: here something may lie over the view. Pixels.
    QRect freeRoom() const;

    /// The view has another size, or shows something else.
    void place();
    void update();
    /// Where the pointer is, layout mm.
    void showPointer(const std::optional<bolster::Vec2>& layout);

signals:
    void freeRoomChanged();
    /// On a ruler.
    void pointerMoved(const std::optional<bolster::Vec2>& layout);

private:
    void showLegend();
    void makeRoom();
    bool placeLegend();
    std::vector<QRectF> busyPlaces() const;

    const PatternScene& m_scene;
    PatternNavigation& m_navigation;
    QWidget& m_view;
    std::array<PatternRuler*, 2> m_rulers; ///< the view's, as the legend is
    MapLegend* m_legend;
    ShownMapPtr m_map;
    bool m_legendShown = true;
};

} // namespace bolster
