#include "Selection.h"

namespace bolster {

Selection::Selection(QObject* parent)
    : QObject(parent)
{}

void Selection::set(Elements elements, Points points)
{
    for (const Point& point : points)
        elements.insert(point.first);
    if (elements == m_elements && points == m_points)
        return;
    m_elements = std::move(elements);
    m_points = std::move(points);
    emit changed();
}

void Selection::toggle(ElementId id)
{
    Elements elements = m_elements;
    Points points = m_points;
    if (elements.erase(id) > 0)
        std::erase_if(points, [id](const Point& point) { return point.first == id; });
    else
        elements.insert(id);
    set(std::move(elements), std::move(points));
}

void Selection::toggle(Point point)
{
    Points points = m_points;
    if (points.erase(point) == 0)
        points.insert(point);
    set(m_elements, std::move(points));
}

bool Selection::narrow()
{
    if (m_elements.empty())
        return false;
    set(m_points.empty() ? Elements() : m_elements);
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
