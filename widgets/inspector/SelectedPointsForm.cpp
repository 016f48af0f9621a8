#include "SelectedPointsForm.h"

#include "Gesture.h"
#include "LengthEdits.h"
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

void SelectedPointsForm::add(PropertyForm& form) const
{
    const Selection::Points& points = m_selection.points();
    Selection::Points inPattern, inSpace;
    for (const Selection::Point& point : points)
        (spacePoint(m_document.design(), point) < 0 ? inPattern : inSpace).insert(point);
    if (points.size() > 1)
        form.addInfo(tr("Points"), [n = points.size()] { return QString::number(n); });
    if (!inPattern.empty())
        addInPattern(form, inPattern);
    if (!inSpace.empty())
        addInSpace(form, inSpace);
}

void SelectedPointsForm::addInPattern(PropertyForm& form, const Selection::Points& points) const
{
    form.addNumbers(
        tr("Layout x, y"), lengthRange, 2,
        [this, points](int axis) { return sharedCoordinate(placesInLayout(m_document.design(), points), axis); },
        [this, points](int axis, double value) {
            m_document.commit(placeInLayout(m_document.design(), points, axis, value));
        });
    const auto& [first, last] = std::pair(*points.begin(), *points.rbegin());
    if (points.size() != 2 || first.first != last.first)
        return;
    NumberBox::Range range = lengthRange;
    range.least = 0;
    form.addNumber(
        tr("Length between"), range,
        [this, id = first.first, a = first.second, b = last.second] {
            return edits::lengthBetween(m_document.design(), id, a, b);
        },
        [this, id = first.first, a = first.second, b = last.second](double value) {
            Gesture gesture(m_document); // what would break something is taken back with a reason
            gesture.update(edits::setLengthBetween(gesture.start(), id, a, b, value));
            gesture.commit();
        });
}

void SelectedPointsForm::addInSpace(PropertyForm& form, const Selection::Points& points) const
{
    form.addNumbers(
        tr("Space x, y, z"), lengthRange, 3,
        [this, points](int axis) { return sharedCoordinate(placesInSpace(m_document.design(), points), axis); },
        [this, points](int axis, double value) {
            m_document.commit(placeInSpace(m_document.design(), points, axis, value));
        });
}

} // namespace bolster
