// What is selected and what lies under the pointer, shared by all views.
#pragma once

#include "Stretch.h"

#include <QObject>

#include <set>
#include <utility>
#include <vector>

namespace bolster {

class Selection : public QObject {
    Q_OBJECT

public:
    using Point = std::pair<ElementId, int>; ///< control point of a curve; see firstSpacePoint
    using Elements = std::set<ElementId>;
    using Points = std::set<Point>;
    /// Of an outline, from corner to corner. A click on it selects `owner`, too: the seam that runs there, or the
    /// patch.
    struct Edge {
        ElementId owner{};
        Stretch stretch;

        friend bool operator==(const Edge&, const Edge&) = default;
    };
    using Edges = std::vector<Edge>; ///< in the order in which they were selected

    explicit Selection(QObject* parent = nullptr);

    const Elements& elements() const { return m_elements; }
    const Points& points() const { return m_points; }
    const Edges& edges() const { return m_edges; }
    ElementId hovered() const { return m_hovered; } ///< noElement: nothing

    bool contains(ElementId id) const { return m_elements.contains(id); }
    bool contains(Point point) const { return m_points.contains(point); }
    bool contains(const Edge& edge) const;

    /// Selecting points and edges selects their elements too.
    void set(Elements elements, Points points = {}, Edges edges = {});
    void toggle(ElementId id);
    void toggle(Point point);
    /// Without its last edge an owner is selected no longer.
    void toggle(const Edge& edge);
    void clear() { set({}); }
    /// One step back: points and edges first, then elements. False when nothing was selected.
    bool narrow();
    void hover(ElementId id);

signals:
    void changed();
    void hoverChanged();

private:
    Elements m_elements;
    Points m_points;
    Edges m_edges;
    ElementId m_hovered = noElement;
};

} // namespace bolster
