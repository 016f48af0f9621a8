#include "Selection.h"

#include <algorithm>

namespace bolster {

Selection::Selection(QObject* parent)
    : QObject(parent)
{}

bool Selection::contains(const Edge& edge) const
{
    return std::ranges::find(m_edges, edge) != m_edges.end();
}

void Selection::set(Elements elements, Points points, Edges edges)
{
    for (const Point& point : points)
        elements.insert(point.first);
    for (const Edge& edge : edges)
        elements.insert(edge.owner);
    if (elements == m_elements && points == m_points && edges == m_edges)
        return;
    m_elements = std::move(elements);
    m_points = std::move(points);
    m_edges = std::move(edges);
    emit changed();
}

void Selection::toggle(ElementId id)
{
    Elements elements = m_elements;
    Points points = m_points;
    Edges edges = m_edges;
    if (elements.erase(id) > 0) {
        std::erase_if(points, [id](const Point& point) { return point.first == id; });
        std::erase_if(edges, [id](const Edge& edge) { return edge.owner == id; });
    } else {
        elements.insert(id);
    }
    set(std::move(elements), std::move(points), std::move(edges));
}

void Selection::toggle(Point point)
{
    Points points = m_points;
    if (points.erase(point) == 0)
        points.insert(point);
    set(m_elements, std::move(points), m_edges);
}

void Selection::toggle(const Edge& edge)
{
    Elements elements = m_elements;
    Edges edges = m_edges;
    if (std::erase(edges, edge) == 0)
        edges.push_back(edge);
    else if (std::ranges::none_of(edges, [&](const Edge& other) { return other.owner == edge.owner; }))
        elements.erase(edge.owner);
    set(std::move(elements), m_points, std::move(edges));
}

bool Selection::narrow()
{
    if (m_elements.empty())
        return false;
    set(m_points.empty() && m_edges.empty() ? Elements() : m_elements);
    return true;
}

void Selection::hover(ElementId id)
{
    if (id == m_hovered)
        return;
    m_hovered = id;
    emit hoverChanged();
}

} // namespace bolster
