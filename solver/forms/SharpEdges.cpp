#include "SharpEdges.h"

#include "HalfEdges.h"
#include "SegmentDistance.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>
#include <queue>
#include <set>
#include <utility>

namespace bolster {

namespace {

constexpr double sharpFrom = 30;   // degrees
constexpr double beside = 4;       // mm: a line so near runs along an edge,
constexpr double mostTurned = 30;  // degrees: if it has about its direction,
constexpr double leastRun = 10;    // mm: for so long
constexpr double mostAlong = 0.7;  // of its places: it turns at corners, where it is by two edges
constexpr double onSegment = 0.02; // mm

/// The edges of triangles that lie on some segments.
class EdgeGraph {
public:
    /// `eachOn` calls a visitor with the numbers of the segments that a place lies on.
    template <class EachOn>
    EdgeGraph(TriangleSoup& form, const EachOn& eachOn)
        : m_form(form)
    {
        std::vector<std::vector<std::size_t>> on(form.points.size()); // segments of each point
        for (std::size_t p = 0; p < form.points.size(); ++p)
            eachOn(form.points[p], [&](std::size_t segment) { on[p].push_back(segment); });
        const auto share = [&](int a, int b) {
            return std::ranges::any_of(on[a], [&](std::size_t s) { return std::ranges::count(on[b], s) > 0; });
        };
        for (const auto& corners : form.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                if (const int a = corners[k], b = corners[(k + 1) % 3]; share(a, b))
                    link(a, b);
    }

    /// The point by a place on one of the edges, which is divided there unless it has one; none where none is.
    int pointAt(const Vec3& place)
    {
        int nearest = -1;
        double least = beside;
        for (const auto& [point, others] : m_beside)
            if (const double distance = (m_form.points[point] - place).norm(); distance < least) {
                least = distance;
                nearest = point;
            }
        if (nearest >= 0)
            return nearest;
        for (const auto& [a, others] : m_beside)
            for (const int b : others)
                if (a < b && segmentDistance<3>(place, m_form.points[a], m_form.points[b]) < onSegment)
                    return divide(a, b, nearestOnSegment<3>(place, m_form.points[a], m_form.points[b]));
        return -1;
    }

    /// The points on the shortest way between two of them, from its end; none where there is no way.
    std::vector<int> way(int from, int to) const
    {
        std::map<int, std::pair<double, int>> reached{{from, {0, -1}}}; // how far it is, and from where
        std::priority_queue<std::pair<double, int>, std::vector<std::pair<double, int>>, std::greater<>> waiting;
        for (waiting.push({0, from}); !waiting.empty();) {
            const auto [far, at] = waiting.top();
            waiting.pop();
            if (at == to)
                break;
            if (far > reached[at].first)
                continue;
            for (const int next : m_beside.at(at)) {
                const double through = far + (m_form.points[next] - m_form.points[at]).norm();
                const auto known = reached.find(next);
                if (known == reached.end() || through < known->second.first) {
                    reached[next] = {through, at};
                    waiting.push({through, next});
                }
            }
        }
        std::vector<int> points;
        for (int at = reached.contains(to) ? to : -1; at >= 0; at = reached[at].second)
            points.push_back(at);
        return points;
    }

private:
    void link(int a, int b)
    {
        m_beside[a].insert(b);
        m_beside[b].insert(a);
    }

    int divide(int a, int b, const Vec3& place)
    {
        const int middle = static_cast<int>(m_form.points.size());
        m_form.points.push_back(place);
        const std::size_t count = m_form.triangles.size();
        for (std::size_t t = 0; t < count; ++t)
            for (std::size_t k = 0; k < 3; ++k) {
                const std::array<int, 3> corners = m_form.triangles[t];
                if (std::minmax(corners[k], corners[(k + 1) % 3]) != std::minmax(a, b))
                    continue;
                m_form.triangles[t][(k + 1) % 3] = middle;
                m_form.triangles.push_back({middle, corners[(k + 1) % 3], corners[(k + 2) % 3]});
                m_form.part.push_back(m_form.part[t]);
                break;
            }
        if (m_form.cuts.erase(std::minmax(a, b)) > 0) {
            m_form.cuts.insert(std::minmax(a, middle));
            m_form.cuts.insert(std::minmax(b, middle));
        }
        m_beside[a].erase(b);
        m_beside[b].erase(a);
        link(a, middle);
        link(b, middle);
        return middle;
    }

    TriangleSoup& m_form;
    std::map<int, std::set<int>> m_beside;
};

} // namespace

SharpEdges::SharpEdges(const TriangleSoup& form)
{
    const auto normal = [&](int triangle) {
        const auto at = [&](std::size_t k) -> const Vec3& { return form.points[form.triangles[triangle][k]]; };
        return Vec3((at(1) - at(0)).cross(at(2) - at(0)).normalized());
    };
    const double bend = std::cos(sharpFrom * std::numbers::pi / 180);
    eachEdge(halfEdges(form.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first == 2 && normal(first[0].triangle).dot(normal(first[1].triangle)) < bend)
            m_segments.push_back({form.points[first->low], form.points[first->high]});
    });
    std::vector<std::uint32_t> all(m_segments.size());
    std::iota(all.begin(), all.end(), 0U);
    m_boxes.build(all, [&](std::uint32_t s) {
        const auto& [from, to] = m_segments[s];
        return BoxTree<double>::Triangle{from, to, to};
    });
}

/// Calls visit(number of a segment, mm) for those that a line at this place may run along.
template <class Visit>
void SharpEdges::eachBeside(const Vec3& at, const Visit& visit) const
{
    const auto gap = [&](const Box3& box) { return box.exteriorDistance(at); };
    m_boxes.walk(gap, beside, [&](std::uint32_t place) {
        const std::size_t number = m_boxes.order()[place];
        const auto& [from, to] = m_segments[number];
        if (const double distance = segmentDistance<3>(at, from, to); distance < beside)
            visit(number, distance);
        return false;
    });
}

std::optional<Vec3> SharpEdges::nearest(const Vec3& at) const
{
    std::optional<Vec3> found;
    double least = beside;
    eachBeside(at, [&](std::size_t number, double distance) {
        if (distance < least)
            found = nearestOnSegment<3>(at, m_segments[number].first, m_segments[number].second);
        least = std::min(least, distance);
    });
    return found;
}

bool SharpEdges::runsAlong(const Vec3& at, const Vec3& direction) const
{
    const double least = std::cos(mostTurned * std::numbers::pi / 180);
    bool any = false;
    eachBeside(at, [&](std::size_t number, double) {
        const Vec3 way = m_segments[number].second - m_segments[number].first;
        any = any || std::abs(way.normalized().dot(direction)) > least;
    });
    return any;
}

std::vector<LineRun> SharpEdges::runsOf(std::vector<Place> places, bool closed) const
{
    const auto isNear = [&](const Place& place) { return nearest(place.onForm).has_value(); };
    if (closed) { // it begins where it runs along none
        const auto off = std::find_if_not(places.begin(), places.end(), isNear);
        if (off != places.end()) {
            places.pop_back();
            std::rotate(places.begin(), off, places.end());
            places.push_back(places.front());
        }
    }
    std::vector<LineRun> runs;
    LineRun between;
    for (std::size_t begin = 0; begin < places.size();) {
        std::size_t end = begin;
        while (end < places.size() && isNear(places[end]))
            ++end;
        LineRun run = runOf(places, begin, end);
        if (run.onEdges) {
            if (!between.places.empty()) {
                between.places.push_back(run.places.front());
                runs.push_back(std::exchange(between, {}));
            }
            between.places.push_back(run.places.back());
            runs.push_back(std::move(run));
        } else {
            end = std::max(end, begin + 1);
            for (std::size_t k = begin; k < end; ++k)
                between.places.push_back(places[k].at);
        }
        begin = end;
    }
    if (between.places.size() < 2)
        return runs;
    if (closed && runs.size() > 1 && !runs.front().onEdges) { // what it begins with goes on from what it ends with
        std::vector<Vec3>& first = runs.front().places;
        between.places.insert(between.places.end(), first.begin() + 1, first.end());
        first = std::move(between.places);
    } else {
        runs.push_back(std::move(between));
    }
    return runs;
}

/// Of places near sharp edges: whether most of them are on the way along one.
LineRun SharpEdges::runOf(const std::vector<Place>& places, std::size_t begin, std::size_t end) const
{
    LineRun run;
    std::size_t along = 0;
    for (std::size_t k = begin; k < end; ++k) {
        const Vec3 way = places[std::min(k + 1, places.size() - 1)].at - places[k > 0 ? k - 1 : 0].at;
        along += runsAlong(places[k].onForm, way.normalized()) ? 1 : 0;
        run.places.push_back(nearest(places[k].onForm).value_or(places[k].onForm));
    }
    run.onEdges = lengthOf(run.places) >= leastRun &&
                  static_cast<double>(along) >= mostAlong * static_cast<double>(end - begin);
    return run;
}

std::set<std::size_t> SharpEdges::segmentsBeside(const LineRun& run) const
{
    std::set<std::size_t> found;
    for (std::size_t k = 1; k < run.places.size(); ++k) {
        const Vec3 from = run.places[k - 1], way = run.places[k] - from;
        const int steps = static_cast<int>(std::ceil(way.norm() / beside));
        for (int i = 0; i <= steps; ++i)
            eachBeside(from + way * i / std::max(steps, 1),
                       [&](std::size_t number, double) { found.insert(number); });
    }
    return found;
}

bool SharpEdges::cut(TriangleSoup& form, LineRun& run) const
{
    const std::set<std::size_t> chosen = segmentsBeside(run);
    EdgeGraph graph(form, [&](const Vec3& at, const auto& visit) {
        eachBeside(at, [&](std::size_t number, double distance) {
            if (distance < onSegment && chosen.contains(number))
                visit(number);
        });
    });
    std::vector<int> stations; // one after the other, also of a run that comes back to where it began
    constexpr std::size_t stages = 3;
    for (std::size_t k = 0; k <= stages; ++k)
        stations.push_back(graph.pointAt(run.places[k * (run.places.size() - 1) / stages]));
    if (std::ranges::count(stations, -1) > 0)
        return false;
    std::vector<int> way{stations.back()};
    for (std::size_t k = stages; k > 0; --k) {
        const std::vector<int> stage = graph.way(stations[k - 1], stations[k]);
        if (stage.empty())
            return false;
        way.insert(way.end(), stage.begin() + 1, stage.end());
    }
    for (std::size_t k = 1; k < way.size(); ++k)
        form.cuts.insert(std::minmax(way[k - 1], way[k]));
    run.places.front() = form.points[stations.front()];
    run.places.back() = form.points[stations.back()];
    return true;
}

} // namespace bolster
