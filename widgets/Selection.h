// What is selected and what lies under the pointer, shared by all views.
#pragma once

#include "ElementId.h"

#include <QObject>

#include <set>
#include <utility>

namespace bolster {

class Selection : public QObject {
    Q_OBJECT

public:
    using Point = std::pair<ElementId, int>; ///< control point of a curve; see firstSpacePoint
    using Elements = std::set<ElementId>;
    using Points = std::set<Point>;

    explicit Selection(QObject* parent = nullptr);

    const Elements& elements() const { return m_elements; }
    const Points& points() const { return m_points; }
    ElementId hovered() const { return m_hovered; } ///< settingsId: nothing

    bool contains(ElementId id) const { return m_elements.contains(id); }
    bool contains(Point point) const { return m_points.contains(point); }

    /// Selecting points selects their elements too.
    void set(Elements elements, Points points = {});
    void toggle(ElementId id);
    void toggle(Point point);
    void clear() { set({}); }
    /// One step back: points first, then elements. False when nothing was selected.
    bool narrow();
    void hover(ElementId id);

signals:
    void changed();
    void hoverChanged();

private:
    Elements m_elements;
    Points m_points;
    ElementId m_hovered = settingsId;
};

} // namespace bolster
