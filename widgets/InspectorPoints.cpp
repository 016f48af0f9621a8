// What the inspector shows of selected control points.
#include "InspectorForms.h"
#include "PlacementFields.h"
#include "PointPlaces.h"

#include <cmath>

namespace bolster {

namespace {

constexpr double same = 1e-6; // mm: turning a patch leaves less

/// The coordinate that all places have, or nothing.
template <class Place>
std::optional<double> sharedCoordinate(const std::vector<Place>& places, int axis)
{
    if (places.empty())
        return 0;
    for (const Place& place : places)
        if (std::abs(place[axis] - places.front()[axis]) > same)
            return std::nullopt;
    return places.front()[axis];
}

} // namespace

void InspectorForms::addSelectedPoints(PropertyForm& form) const
{
    const Selection::Points& points = m_selection.points();
    Selection::Points inPattern, inSpace;
    for (const Selection::Point& point : points)
        (spacePoint(m_document.design(), point) < 0 ? inPattern : inSpace).insert(point);
    if (points.size() > 1)
        form.addInfo(tr("Points"), [n = points.size()] { return QString::number(n); });
    if (!inPattern.empty())
        addPatternPoints(form, inPattern);
    if (!inSpace.empty())
        addSpacePoints(form, inSpace);
}

void InspectorForms::addPatternPoints(PropertyForm& form, const Selection::Points& points) const
{
    form.addNumbers(
        tr("Layout x, y"), lengthRange, 2,
        [this, points](int axis) { return sharedCoordinate(placesInLayout(m_document.design(), points), axis); },
        [this, points](int axis, double value) {
            m_document.commit(placeInLayout(m_document.design(), points, axis, value));
        });
}

void InspectorForms::addSpacePoints(PropertyForm& form, const Selection::Points& points) const
{
    form.addNumbers(
        tr("Space x, y, z"), lengthRange, 3,
        [this, points](int axis) { return sharedCoordinate(placesInSpace(m_document.design(), points), axis); },
        [this, points](int axis, double value) {
            m_document.commit(placeInSpace(m_document.design(), points, axis, value));
        });
}

} // namespace bolster
