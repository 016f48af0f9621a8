#include "SheetCut.h"

#include "HalfEdges.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <numbers>
#include <set>

namespace bolster {

namespace {

using Triangle = std::array<int, 3>;

constexpr int mostRefinements = 6;
constexpr double leastHalf = 0.02; // of the area: smoothing may leave next to nothing of a half, again and again
constexpr std::size_t fewTriangles = 200; // lines follow the edges of so few
constexpr double nearCorner = 0.15;       // of an edge: a line that crosses it nearer goes through the corner
constexpr std::array roundsOfSmoothing{30, 8, 0}; // as many as leave something of both halves

/// Points between others, each once.
class Between {
public:
    explicit Between(std::vector<Vec3>& points)
        : m_points(points)
    {}

    /// With so much of a and of b; the same to the last bit for (b, a).
    int operator()(int a, int b, double ofA, double ofB)
    {
        const auto [number, isNew] = m_numbers.emplace(std::minmax(a, b), static_cast<int>(m_points.size()));
        if (isNew)
            m_points.emplace_back(ofA * m_points[a] + ofB * m_points[b]);
        return number->second;
    }

private:
    std::vector<Vec3>& m_points;
    std::map<std::pair<int, int>, int> m_numbers;
};

/// Triangles become four, but for those at the border, whose edges stay as the neighbours have them.
FormSheet refined(const FormSheet& sheet)
{
    std::set<std::pair<int, int>> inside;
    eachEdge(halfEdges(sheet.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first == 2)
            inside.emplace(first->low, first->high);
    });
    FormSheet fine{sheet.points, {}};
    Between between(fine.points);
    for (const Triangle& corners : sheet.triangles) {
        std::vector<int> around;  // the triangle with the middles of its edges, once around,
        std::vector<int> middles; // and the places of these in it
        for (std::size_t k = 0; k < 3; ++k) {
            const int a = corners[k], b = corners[(k + 1) % 3];
            around.push_back(a);
            if (inside.contains(std::minmax(a, b))) {
                middles.push_back(static_cast<int>(around.size()));
                around.push_back(between(a, b, 0.5, 0.5));
            }
        }
        const auto at = [&](int place) { return around[static_cast<std::size_t>(place) % around.size()]; };
        if (middles.size() < 2) { // a fan of what one middle sees, or the triangle
            const int from = middles.empty() ? 0 : middles.front();
            for (int k = 1; k + 1 < std::ssize(around); ++k)
                fine.triangles.push_back({at(from), at(from + k), at(from + k + 1)});
            continue;
        }
        for (std::size_t m = 0; m < middles.size(); ++m) { // the corners between neighbouring middles
            const int from = middles[m];
            int to = middles[(m + 1) % middles.size()];
            to += to <= from ? static_cast<int>(around.size()) : 0;
            for (int k = from + 1; k < to; ++k)
                fine.triangles.push_back({at(from), at(k), at(k + 1)});
        }
        if (middles.size() == 3)
            fine.triangles.push_back({at(middles[0]), at(middles[1]), at(middles[2])});
    }
    return fine;
}

/// Points of edges that bend, and part the halves: the line goes along there. How much they bend is said by all
/// triangles around them, on either side: single ones of a rough form lean anywhere.
std::vector<bool> onBends(const FormSheet& sheet, const std::vector<double>& ofTriangles, double degrees)
{
    std::array<std::vector<Vec3>, 2> normals; // mm^2, of the triangles at each point in either half
    normals.fill(std::vector<Vec3>(sheet.points.size(), Vec3::Zero()));
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
        for (const int corner : sheet.triangles[t])
            normals[ofTriangles[t] < 0 ? 0 : 1][corner] += sheet.areaNormal(t);
    std::vector<bool> on(sheet.points.size(), false);
    const double bend = std::cos(degrees * std::numbers::pi / 180);
    eachEdge(halfEdges(sheet.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        if (last - first != 2 || ofTriangles[first[0].triangle] * ofTriangles[first[1].triangle] >= 0)
            return;
        const Vec3 one = normals[0][first->low] + normals[0][first->high],
                   other = normals[1][first->low] + normals[1][first->high];
        if (one.dot(other) < bend * one.norm() * other.norm())
            on[first->low] = on[first->high] = true;
    });
    return on;
}

/// A line with a little of each point's neighbours is not as jagged.
std::vector<double> smoothed(const FormSheet& sheet, const Halves& halves, double bend, int rounds)
{
    std::vector<double> values = halves.ofPoints;
    const std::vector<bool> stays = onBends(sheet, halves.ofTriangles, bend);
    for (std::size_t v = 0; v < values.size(); ++v)
        if (stays[v])
            values[v] = 0;
    for (int round = 0; round < rounds; ++round) {
        std::vector<double> sums(values.size(), 0), counts(values.size(), 0);
        for (const Triangle& corners : sheet.triangles)
            for (const int a : corners)
                for (const int b : corners) {
                    sums[a] += values[b];
                    counts[a] += 1;
                }
        for (std::size_t v = 0; v < values.size(); ++v)
            if (!stays[v] && counts[v] > 0)
                values[v] = sums[v] / counts[v];
    }
    return values;
}

/// No part of a triangle shall be a splinter; and borders get no new points, which their neighbours would not have.
void goThroughCorners(const FormSheet& sheet, std::vector<double>& values)
{
    eachEdge(halfEdges(sheet.triangles), [&](const HalfEdge* first, const HalfEdge* last) {
        double &a = values[first->low], &b = values[first->high];
        if (a * b >= 0)
            return;
        const double share = a / (a - b), near = last - first == 2 ? nearCorner : 0.5;
        if (share <= near)
            a = 0;
        else if (share >= 1 - near)
            b = 0;
    });
}

using TwoParts = std::array<std::vector<Triangle>, 2>;

TwoParts alongEdges(const FormSheet& sheet, const std::vector<double>& values)
{
    TwoParts halves;
    for (std::size_t t = 0; t < sheet.triangles.size(); ++t)
        halves[values[t] < 0 ? 0 : 1].push_back(sheet.triangles[t]);
    return halves;
}

/// New points are added to the sheet.
TwoParts acrossTriangles(FormSheet& sheet, std::vector<double> values)
{
    goThroughCorners(sheet, values);
    TwoParts halves;
    Between between(sheet.points);
    for (const Triangle& corners : sheet.triangles) {
        std::array<std::vector<int>, 2> parts; // of the triangle, below and above: once around
        for (std::size_t k = 0; k < 3; ++k) {
            const int at = corners[k], next = corners[(k + 1) % 3];
            const double a = values[at], b = values[next];
            if (a <= 0)
                parts[0].push_back(at);
            if (a >= 0)
                parts[1].push_back(at);
            if (a * b < 0) {
                const int place = between(at, next, b / (b - a), a / (a - b));
                parts[0].push_back(place);
                parts[1].push_back(place);
            }
        }
        if (std::ranges::all_of(corners, [&](int v) { return values[v] == 0; }))
            parts[0].clear(); // it would be in both
        for (std::size_t half = 0; half < 2; ++half)
            for (std::size_t k = 2; k < parts[half].size(); ++k)
                halves[half].push_back({parts[half][0], parts[half][k - 1], parts[half][k]});
    }
    return halves;
}

} // namespace

FormSheet fine(FormSheet sheet, std::size_t triangles)
{
    for (int k = 0; k < mostRefinements && sheet.triangles.size() < triangles; ++k)
        sheet = refined(sheet);
    return sheet;
}

std::array<FormSheet, 2> cutInTwo(FormSheet sheet, const Halves& halves, double bend)
{
    if (sheet.triangles.size() >= fewTriangles)
        for (const int rounds : roundsOfSmoothing) {
            FormSheet cut = sheet;
            const auto [below, above] = acrossTriangles(cut, smoothed(sheet, halves, bend, rounds));
            std::array<FormSheet, 2> parts{FormSheet{cut.points, below}, FormSheet{cut.points, above}};
            if (std::min(parts[0].area(), parts[1].area()) > leastHalf * sheet.area())
                return parts;
        }
    const auto [below, above] = alongEdges(sheet, halves.ofTriangles);
    return {FormSheet{sheet.points, below}, FormSheet{sheet.points, above}};
}

} // namespace bolster
