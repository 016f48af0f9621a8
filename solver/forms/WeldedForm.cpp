#include "WeldedForm.h"

#include "HalfEdges.h"
#include "SortUnlessStopped.h"
#include "UnionFind.h"

#include <CGAL/AABB_segment_primitive.h>
#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/Simple_cartesian.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <map>

namespace bolster {

namespace {

constexpr double parted = 0.01; // mm: sheets that touch would count as going through each other

std::vector<int> partOfTriangles(const TriangleMesh& mesh)
{
    std::vector<int> part(mesh.triangles.size(), 0);
    for (std::size_t k = 0; k < mesh.parts.size(); ++k)
        for (std::uint32_t t = 0; t < mesh.parts[k].triangleCount; ++t)
            part[mesh.parts[k].firstTriangle + t] = static_cast<int>(k);
    return part;
}

/// How many faces of each sheet are turned round, so that neighbours agree; more where a sheet has one side only.
class Turning {
public:
    Turning(WeldedForm& form, const std::vector<HalfEdge>& halves)
        : m_form(form)
        , m_neighbours(form.triangles.size())
        , m_turn(form.triangles.size(), unknown)
    {
        eachEdge(halves, [&](const HalfEdge* first, const HalfEdge* last) {
            if (last - first > 2)
                ++crowdedEdges;
            if (last - first != 2)
                return;
            const bool differs = first[0].forward == first[1].forward;
            m_neighbours[first[0].triangle].emplace_back(first[1].triangle, differs);
            m_neighbours[first[1].triangle].emplace_back(first[0].triangle, differs);
        });
        for (std::size_t start = 0; start < m_turn.size(); ++start)
            if (m_turn[start] == unknown)
                turnSheetOf(start);
    }

    int turned = 0, crowdedEdges = 0;
    bool oneSided = false;

private:
    void turnSheetOf(std::size_t start)
    {
        std::vector<std::size_t> sheet{start};
        m_turn[start] = 0;
        for (std::size_t k = 0; k < sheet.size(); ++k)
            for (const auto& [other, differs] : m_neighbours[sheet[k]])
                if (const auto fits = static_cast<signed char>(m_turn[sheet[k]] ^ static_cast<int>(differs));
                    m_turn[other] == unknown) {
                    m_turn[other] = fits;
                    sheet.push_back(other);
                } else {
                    oneSided = oneSided || m_turn[other] != fits;
                }
        const auto wrong = std::ranges::count_if(sheet, [&](std::size_t t) { return m_turn[t] == 1; });
        const bool turnsOthers = isClosed(sheet) ? volumeOf(sheet) < 0 : 2 * wrong > std::ssize(sheet);
        const signed char less = turnsOthers ? 0 : 1;
        for (const std::size_t t : sheet)
            if (m_turn[t] == less) {
                std::swap(m_form.triangles[t][1], m_form.triangles[t][2]);
                ++turned;
            }
    }

    bool isClosed(const std::vector<std::size_t>& sheet) const
    {
        return std::ranges::all_of(sheet, [&](std::size_t t) { return m_neighbours[t].size() == 3; });
    }

    /// That it encloses, times 6, when what is to be turned is; negative where its inside is outside.
    double volumeOf(const std::vector<std::size_t>& sheet) const
    {
        double volume = 0;
        for (const std::size_t t : sheet) {
            const auto at = [&](std::size_t k) -> const Vec3& { return m_form.points[m_form.triangles[t][k]]; };
            volume += (m_turn[t] == 1 ? -1 : 1) * at(0).dot(at(1).cross(at(2)));
        }
        return volume;
    }

    static constexpr signed char unknown = -1;
    WeldedForm& m_form;
    std::vector<std::vector<std::pair<std::size_t, bool>>> m_neighbours; // and whether one must be turned
    std::vector<signed char> m_turn;
};

/// Which places of rows of points a place lies at.
class RowPlaces {
    using Kernel = CGAL::Simple_cartesian<double>;
    using Segments = std::vector<Kernel::Segment_3>;
    using Tree =
        CGAL::AABB_tree<CGAL::AABB_traits<Kernel, CGAL::AABB_segment_primitive<Kernel, Segments::iterator>>>;

public:
    struct Place {
        std::size_t row = 0;
        double along = 0; ///< mm
    };

    RowPlaces(const std::vector<std::vector<Vec3>>& rows, double within)
        : m_within(within)
    {
        for (std::size_t r = 0; r < rows.size(); ++r) {
            double along = 0;
            for (std::size_t k = 1; k < rows[r].size(); ++k) {
                const Vec3 &a = rows[r][k - 1], &b = rows[r][k];
                m_segments.emplace_back(Kernel::Point_3(a.x(), a.y(), a.z()), Kernel::Point_3(b.x(), b.y(), b.z()));
                m_begins.push_back({r, along});
                along += (b - a).norm();
            }
        }
        m_tree.rebuild(m_segments.begin(), m_segments.end());
    }

    std::vector<Place> of(const Vec3& point) const
    {
        std::vector<Segments::iterator> near;
        m_tree.all_intersected_primitives(CGAL::Bbox_3(point.x() - m_within, point.y() - m_within,
                                                       point.z() - m_within, point.x() + m_within,
                                                       point.y() + m_within, point.z() + m_within),
                                          std::back_inserter(near));
        std::vector<Place> places;
        for (const Segments::iterator& segment : near) {
            const Vec3 from(segment->source().x(), segment->source().y(), segment->source().z());
            const Vec3 to(segment->target().x(), segment->target().y(), segment->target().z());
            const double length = (to - from).norm();
            const double along = length > 0 ? std::clamp((point - from).dot(to - from) / length, 0.0, length) : 0;
            const Place& begin = m_begins[static_cast<std::size_t>(&*segment - m_segments.data())];
            if ((from + along / std::max(length, 1e-9) * (to - from) - point).norm() <= m_within)
                places.push_back({begin.row, begin.along + along});
        }
        return places;
    }

private:
    double m_within; // mm
    Segments m_segments;
    std::vector<Place> m_begins; // of each segment
    Tree m_tree;
};

/// Of triangles with the same corners the first one stays.
void takeOnce(WeldedForm& form, const std::stop_token& stop)
{
    std::vector<std::pair<WeldedForm::Corners, std::size_t>> sorted;
    sorted.reserve(form.triangles.size());
    for (std::size_t t = 0; t < form.triangles.size(); ++t) {
        sorted.emplace_back(form.triangles[t], t);
        std::ranges::sort(sorted.back().first);
    }
    sortUnlessStopped(sorted, std::less(), stop);
    if (stop.stop_requested())
        return;
    std::vector<bool> again(form.triangles.size(), false);
    for (std::size_t k = 1; k < sorted.size(); ++k)
        again[sorted[k].second] = sorted[k].first == sorted[k - 1].first;
    form.twice = static_cast<int>(std::ranges::count(again, true));
    if (form.twice == 0)
        return;
    std::size_t kept = 0;
    for (std::size_t t = 0; t < again.size(); ++t)
        if (!again[t]) {
            form.triangles[kept] = form.triangles[t];
            form.part[kept++] = form.part[t];
        }
    form.triangles.resize(kept);
    form.part.resize(kept);
}

/// Points at one place are one point.
class PointNumbers {
public:
    /// The number of the point that is there already, or the next one; and whether it is new.
    std::pair<int, bool> numberOf(const Vec3& point)
    {
        const Vec3 beside = Vec3::Constant(cellSize * bySide);
        const Cell low = cellOf(point - beside), high = cellOf(point + beside);
        for (const long long x : {low[0], high[0]})
            for (const long long y : {low[1], high[1]})
                for (const long long z : {low[2], high[2]})
                    if (const auto found = m_numbers.find({x, y, z}); found != m_numbers.end())
                        return {found->second, false};
        const int number = static_cast<int>(m_numbers.size());
        m_numbers.emplace(cellOf(point), number);
        return {number, true};
    }

private:
    using Cell = std::array<long long, 3>;

    static Cell cellOf(const Vec3& point)
    {
        Cell cell{};
        for (int axis = 0; axis < 3; ++axis)
            cell[axis] = std::llround(point[axis] / cellSize);
        return cell;
    }

    static constexpr double cellSize = 1e-4; // mm: texts have rounded them alike
    static constexpr double bySide = 0.15;   // cells: a point may belong to another one that is as near as that

    std::map<Cell, int> m_numbers; // a cell has one point at most
};

} // namespace

WeldedForm weld(const TriangleMesh& mesh, const std::stop_token& stop)
{
    WeldedForm welded;
    PointNumbers numbers;
    std::vector<int> place(mesh.points.size());
    for (std::size_t i = 0; i < mesh.points.size(); ++i) {
        if (stop.stop_requested())
            return {};
        const auto [number, isNew] = numbers.numberOf(mesh.points[i]);
        if (isNew)
            welded.points.push_back(mesh.points[i]);
        place[i] = number;
    }
    const std::vector<int> part = partOfTriangles(mesh);
    for (std::size_t t = 0; t < mesh.triangles.size(); ++t) {
        WeldedForm::Corners corners{};
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = place[mesh.triangles[t][k]];
        const Vec3 &a = welded.points[corners[0]], &b = welded.points[corners[1]], &c = welded.points[corners[2]];
        if (!((b - a).cross(c - a).norm() > 1e-9 * (b - a).squaredNorm()))
            continue;
        welded.triangles.push_back(corners);
        welded.part.push_back(part[t]);
    }
    for (const TriangleMesh::Part& there : mesh.parts)
        welded.names.push_back(there.name);
    if (welded.names.empty())
        welded.names.emplace_back();
    takeOnce(welded, stop);
    return welded;
}

void turnAlike(WeldedForm& form, std::vector<Message>& notes, const std::stop_token& stop)
{
    const std::vector<HalfEdge> halves = halfEdges(form.triangles, stop);
    if (stop.stop_requested())
        return;
    const Turning turning(form, halves);
    if (form.twice > 0)
        notes.push_back({QT_TRANSLATE_NOOP(
                             "Message", "Faces of the form that lie where another one lies, and are left out: %1"),
                         {std::to_string(form.twice)}});
    if (turning.oneSided)
        notes.push_back({QT_TRANSLATE_NOOP("Message", "The form has one side only, as a twisted band: it is "
                                                      "left open where its outside meets its inside"),
                         {}});
    if (turning.turned > 0)
        notes.push_back({QT_TRANSLATE_NOOP("Message", "Faces of the form that were turned round: %1"),
                         {std::to_string(turning.turned)}});
    if (turning.crowdedEdges > 0)
        notes.push_back({QT_TRANSLATE_NOOP("Message", "Edges of the form that belong to more than two faces, so "
                                                      "that they are borders and nothing is sewn there: %1"),
                         {std::to_string(turning.crowdedEdges)}});
}

void partSheets(WeldedForm& form, const std::stop_token& stop)
{
    const std::vector<HalfEdge> halves = halfEdges(form.triangles, stop);
    if (stop.stop_requested())
        return;
    UnionFind corners(static_cast<int>(3 * form.triangles.size()));
    const auto cornerAt = [&](const HalfEdge& half, int point) {
        const auto& there = form.triangles[half.triangle];
        return static_cast<int>(3 * half.triangle + (std::ranges::find(there, point) - there.begin()));
    };
    eachEdge(halves, [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first == 2 && first[0].forward != first[1].forward)
            for (const int point : {first->low, first->high})
                corners.join(cornerAt(first[0], point), cornerAt(first[1], point));
    });
    // The first of those that meet in a point keeps it; each of the others goes a little into its own sheet.
    const WeldedForm before = form;
    std::vector<int> keeps(form.points.size(), -1);
    std::map<int, int> points; // of those that part, by their root
    for (std::size_t t = 0; t < form.triangles.size(); ++t)
        for (std::size_t k = 0; k < 3; ++k) {
            const int point = before.triangles[t][k], root = corners.root(static_cast<int>(3 * t + k));
            if (keeps[point] < 0)
                keeps[point] = root;
            if (keeps[point] == root)
                continue;
            const auto [part, isNew] = points.emplace(root, static_cast<int>(form.points.size()));
            if (isNew) {
                Vec3 way = -before.points[point];
                for (const int corner : before.triangles[t])
                    way += before.points[corner] / 3;
                form.points.push_back(before.points[point] + std::min(parted, way.norm()) * way.normalized());
            }
            form.triangles[t][k] = part->second;
        }
}

std::set<std::pair<int, int>> edgesAlong(const WeldedForm& form, const std::vector<std::vector<Vec3>>& rows,
                                         double within)
{
    const RowPlaces places(rows, within);
    std::vector<std::vector<std::pair<double, int>>> along(rows.size()); // points of each row
    for (std::size_t p = 0; p < form.points.size(); ++p)
        for (const RowPlaces::Place& place : places.of(form.points[p]))
            along[place.row].emplace_back(place.along, static_cast<int>(p));
    std::set<std::pair<int, int>> there, found;
    for (const WeldedForm::Corners& corners : form.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            there.insert(std::minmax({corners[k], corners[(k + 1) % 3]}));
    for (auto& row : along) {
        std::ranges::sort(row);
        for (std::size_t k = 1; k < row.size(); ++k)
            if (const std::pair<int, int> edge = std::minmax({row[k - 1].second, row[k].second});
                there.contains(edge))
                found.insert(edge);
    }
    return found;
}

} // namespace bolster
