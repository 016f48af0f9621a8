#include "LineEnds.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <utility>

namespace bolster {

namespace {

constexpr double reach =
    11; // mm: a line that ends so near to a border or another line goes on to it (10, and 1 over)
constexpr double leastLoop = 50; // mm
constexpr double overshoot = 1;  // mm, so that they surely cross
constexpr double overEnd = 3;    // mm
constexpr double overEdge = 5;   // mm: nobody cuts in so little behind an edge
constexpr double there = 0.05;   // mm

/// Whether it would go on from its end to its own beginning.
bool comesBack(const FormLine& line)
{
    return !line.closed && line.points.size() > 3 && lengthOf(line.points) > leastLoop &&
           (line.points.front() - line.points.back()).norm() < reach;
}

FormLine closed(FormLine line)
{
    line.closed = true;
    if ((line.points.front() - line.points.back()).norm() < shortestLine)
        line.points.pop_back();
    return line;
}

} // namespace

std::vector<FormLine> LineEnds::parts(const FormLine& line) const
{
    std::vector<FormLine> parts;
    for (const FormLine& part : onForm(comesBack(line) ? closed(line) : line))
        std::ranges::move(awayFromBorder(endedOnEdges(part)), std::back_inserter(parts));
    return parts;
}

/// The parts of a line that leaves the form over an edge and comes back to it elsewhere, as over the inner corner
/// of an L: it would run along the edges on the way.
std::vector<FormLine> LineEnds::onForm(const FormLine& line) const
{
    constexpr double apart = 2, off = 2; // mm
    if (line.closed)
        return {line};
    const std::vector<Vec3> places = evenly(line, apart);
    std::vector<bool> outside;
    for (const Vec3& place : places)
        outside.push_back(m_form.isOutside(place));
    std::vector<FormLine> parts;
    FormLine part{line.name, {}, false};
    for (std::size_t k = 0; k < places.size();) {
        std::size_t end = k;
        while (end < places.size() && outside[end])
            ++end;
        const bool between = k > 0 && end > k && end < places.size();
        const Vec3 middle =
            between ? Vec3(0.5 * (m_form.nearest(places[k]) + m_form.nearest(places[end - 1]))) : Vec3();
        if (between && (m_form.nearest(middle) - middle).norm() > off) {
            part.points.push_back(places[k]);
            parts.push_back(std::exchange(part, {line.name, {places[end - 1]}, false}));
        } else {
            end = std::max(end, k + 1);
            part.points.insert(part.points.end(), places.begin() + static_cast<std::ptrdiff_t>(k),
                               places.begin() + static_cast<std::ptrdiff_t>(end));
        }
        k = end;
    }
    parts.push_back(std::move(part));
    if (parts.size() == 1)
        return {line};
    std::erase_if(parts, [](const FormLine& each) { return !(lengthOf(each.points) > shortestLine); });
    return parts;
}

/// Without what was drawn over a border, or an edge that is sharp or cut anyway, by a few mm at its ends.
FormLine LineEnds::endedOnEdges(FormLine line) const
{
    for (int end = 0; end < 2 && !line.closed; ++end) {
        endOnEdge(line.points);
        std::ranges::reverse(line.points);
    }
    return line;
}

void LineEnds::endOnEdge(std::vector<Vec3>& points) const
{
    constexpr double step = 0.25, on = 0.3; // mm
    constexpr double mostAlong = 0.4;       // sine of the angle at which it leaves the edge at least
    const Vec3 end = points.back();
    const bool isOver = m_form.isOutside(end); // beside the form
    if (!isOver && m_form.edgeNear(end, on))
        return;
    double length = 0; // back to where the segment begins
    for (std::size_t k = points.size() - 1; k > 0; --k) {
        const Vec3 from = points[k], way = points[k - 1] - from;
        const double segment = way.norm();
        for (double along = step; along < segment; along += step) {
            const double over = length + along;
            const Vec3 at = from + along / segment * way;
            if (over > (isOver ? farthestLine : overEdge))
                return;
            const std::optional<Vec3> edge =
                isOver && m_form.isOutside(at) ? std::nullopt : m_form.edgeNear(at, on);
            if (!edge)
                continue;
            if (const std::optional<Vec3> beside = m_form.edgeNear(end, over);
                beside && (*beside - end).norm() < mostAlong * over)
                return; // it runs along it
            points.resize(k);
            points.push_back(*edge);
            return;
        }
        length += segment;
    }
}

/// Where a line that comes from along the border leaves it: straight across, a little outside.
Vec3 LineEnds::acrossBorder(const Vec3& at) const
{
    const Vec3 border = m_form.borderNear(at).value_or(at), way = border - at;
    return way.norm() > 0 ? Vec3(border + overshoot * way.normalized()) : border;
}

/// The parts of a line between those that run along a border, which cut nothing; the line itself where it only
/// ends there.
std::vector<FormLine> LineEnds::awayFromBorder(const FormLine& line) const
{
    constexpr double on = 1, away = 3; // mm
    std::vector<Vec3> places = evenly(line, m_spacing);
    std::vector<double> distances;
    for (const Vec3& place : places)
        distances.push_back(m_form.distanceFromBorder(place));
    const auto isOn = [&](double distance) { return distance < on; };
    if (line.closed) {
        const auto first = std::ranges::find_if(distances, isOn);
        if (first == distances.end())
            return {line};
        places.pop_back(); // the first one again
        distances.pop_back();
        const auto turn = first - distances.begin();
        std::rotate(places.begin(), places.begin() + turn, places.end());
        std::rotate(distances.begin(), distances.begin() + turn, distances.end());
        places.push_back(places.front());
        distances.push_back(distances.front());
    }
    std::vector<FormLine> parts;
    for (auto begin = distances.begin(); begin != distances.end();) {
        begin = std::find_if_not(begin, distances.end(), isOn);
        const auto end = std::find_if(begin, distances.end(), isOn);
        const auto from = begin - distances.begin(), to = end - distances.begin();
        bool cuts = false;
        for (auto k = from; k < to; ++k)
            cuts = cuts || (distances[k] > away && !m_form.isBeyond(places[k]));
        if (cuts) {
            const bool comes = from > 0, goes = to < std::ssize(places);
            if (from <= 1 && to + 1 >= std::ssize(places) && !line.closed)
                return {line};
            FormLine part = line;
            part.closed = false;
            part.points.assign(places.begin() + from, places.begin() + to);
            if (comes)
                part.points.insert(part.points.begin(), acrossBorder(places[from]));
            if (goes)
                part.points.push_back(acrossBorder(places[to - 1]));
            parts.push_back(std::move(part));
        }
        begin = end;
    }
    return parts;
}

void LineEnds::leadOn(std::vector<LineRun>& runs, const FormLine& line) const
{
    const auto isOver = [&](const LineRun& run) {
        const double length = lengthOf(run.places);
        return !run.onEdges &&
               (length < overEnd || (length < 2 * reach && std::ranges::any_of(run.places, [&](const Vec3& at) {
                                         return m_form.isOutside(at);
                                     })));
    };
    if (line.closed)
        return;
    if (isOver(runs.back()))
        runs.pop_back();
    if (isOver(runs.front()))
        runs.erase(runs.begin());
    if (runs.back().onEdges)
        leadOn(runs.back().places);
    if (runs.front().onEdges) {
        std::ranges::reverse(runs.front().places);
        leadOn(runs.front().places);
        std::ranges::reverse(runs.front().places);
    }
}

void LineEnds::leadOn(std::vector<Vec3>& places) const
{
    const Vec3& end = places.back();
    const Vec3 direction = (end - places[places.size() - 2]).normalized();
    if (const std::optional<Vec3> ahead = placeAhead(end, direction))
        if (const std::optional<Vec3> on = m_form.sharpEdges().nearest(*ahead + overshoot * direction))
            places.push_back(*on);
}

/// What runs on outside would be pulled back to the border, and cut along it. One place stays outside at each
/// end that goes there; whether they do.
std::pair<bool, bool> LineEnds::trim(std::vector<Vec3>& places, const FormLine& line) const
{
    if (line.closed)
        return {false, false};
    const auto isInside = [&](const Vec3& at) { return !m_form.isOutside(at); };
    const auto first = std::ranges::find_if(places, isInside);
    if (first == places.end())
        return {false, false};
    const auto last = std::find_if(places.rbegin(), places.rend(), isInside).base(); // behind the last one
    const bool starts = first != places.begin(), ends = last != places.end();
    places = std::vector<Vec3>(first - static_cast<int>(starts), last + static_cast<int>(ends));
    return {starts, ends};
}

/// What a line that ends on the form may go on to: the nearest place of a border, of where it is cut anyway, or
/// of another line, within reach, and neither beside nor behind.
std::optional<Vec3> LineEnds::placeAhead(const Vec3& end, const Vec3& direction) const
{
    constexpr double mostAside = 0.25; // cosine of the angle by which it turns at most
    std::optional<Vec3> found;
    double nearest = reach;
    const auto look = [&](const Vec3& place) {
        const double distance = (place - end).norm();
        const bool isThere = distance < there; // in which direction is chance
        if (distance < nearest && (isThere || (place - end).dot(direction) > mostAside * distance)) {
            nearest = distance;
            found = place;
        }
    };
    m_form.eachBorderNear(end, reach, look);
    for (std::size_t k = 0; k < m_lines.size(); ++k)
        if (k != m_own)
            for (const Vec3& place : m_lines[k].places)
                if ((place - end).norm() < reach + farthestLine) // both as they lie on the form
                    look(m_form.nearest(place));
    return found;
}

/// One place more behind the end of a line: a little beyond what is near, or else straight on.
Vec3 LineEnds::goneOn(const Vec3& end, const Vec3& before) const
{
    const Vec3 straight = (end - before).normalized(), on = m_form.nearest(end);
    const std::optional<Vec3> ahead = placeAhead(on, straight);
    const double missing = ahead ? (*ahead - on).norm() : 0;
    return missing > overshoot ? Vec3(*ahead + overshoot / missing * (*ahead - on))
                               : Vec3(end + (missing + overshoot) * straight);
}

void LineEnds::prolong(std::vector<Vec3>& places, const FormLine& line, const Joined& joined) const
{
    const auto [starts, ends] = trim(places, line);
    if (line.closed || places.size() < 2)
        return;
    const auto over = [&](const Vec3& end, const Vec3& before) {
        return Vec3(end + overshoot * (end - before).normalized());
    };
    const Vec3 &second = places[1], &last = places.back(), &lastBut = places[places.size() - 2];
    const Vec3 before = joined.first ? over(places.front(), second) : goneOn(places.front(), second);
    const Vec3 behind = joined.second ? over(last, lastBut) : goneOn(last, lastBut);
    if (!starts)
        places.insert(places.begin(), before);
    if (!ends)
        places.push_back(behind);
}

} // namespace bolster
