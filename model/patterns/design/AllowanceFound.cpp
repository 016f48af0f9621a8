#include "AllowanceFound.h"

#include "ArcLength.h"
#include "CutPattern.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

constexpr double alike = 0.06; // mm: widths that are one
constexpr double widest = 200; // mm

/// From the point to the line, along a direction; nothing where it meets none.
std::optional<double> wayTo(const Contour& line, const Vec2& from, const Vec2& way)
{
    double nearest = widest + 1;
    for (std::size_t i = 0; i < line.points.size(); ++i) {
        const Vec2 a = line.points[i].at - from, b = line.points[(i + 1) % line.points.size()].at - from;
        const double sideA = cross(way, a), sideB = cross(way, b);
        if ((sideA > 0) == (sideB > 0))
            continue;
        const double t = (a + (b - a) * (sideA / (sideA - sideB))).dot(way);
        if (t > -0.05)
            nearest = std::min(nearest, std::max(t, 0.0));
    }
    if (nearest > widest)
        return std::nullopt;
    return nearest;
}

/// In the middle half of an edge, where no corner is near.
double widthOfEdge(const BSpline2& outline, const Contour& cut, double from, double to)
{
    std::vector<double> widths;
    for (int k = 0; k <= 8; ++k) {
        const double t = outline.wrapped(from + (to - from) * (0.25 + 0.5 * k / 8));
        const Vec2 along = outline.derivative(t);
        const Vec2 right = Vec2(along.y(), -along.x()).normalized();
        if (const auto width = wayTo(cut, outline.at(t), right))
            widths.push_back(*width);
    }
    if (widths.empty())
        return 0;
    std::ranges::sort(widths);
    return std::round(widths[widths.size() / 2] * 100) / 100;
}

/// Corners of the cut line as the one of five ways to join them that has its area.
CornerJoin joinOf(const BSpline2& outline, const Contour& cut, const FoundAllowance& found)
{
    constexpr CornerJoin all[] = {CornerJoin::Mitred, CornerJoin::Square, CornerJoin::Rounded, CornerJoin::Folded,
                                  CornerJoin::Stepped};
    CornerJoin best = CornerJoin::Mitred;
    double least = std::numeric_limits<double>::infinity();
    for (const CornerJoin join : all) {
        Patch patch;
        patch.outline = outline;
        patch.allowance = CutAllowance{found.usual.width, join};
        std::vector<Change> changes{{ElementId(1), nullptr, makeElement(std::move(patch))}};
        int id = 2;
        for (const EdgeWidth& edge : found.edges)
            changes.push_back({ElementId(id++), nullptr,
                               makeElement(EdgeAllowance{{ElementId(1), edge.from, edge.to}, edge.width})});
        const CutPattern pattern = cutPattern(Design().with({{}, std::move(changes), {}}), {});
        if (pattern.pieces.empty())
            break;
        const double off = std::abs(areaOf(pattern.pieces.front().cut) - cut.signedArea());
        // Only what differs by more than the lines are exact.
        if (off < least - 1e-5 * std::abs(cut.signedArea())) {
            least = off;
            best = join;
        }
    }
    return best;
}

} // namespace

FoundAllowance foundAllowance(const BSpline2& outline, const Contour& cut)
{
    std::vector<double> corners = outline.corners();
    if (corners.empty())
        corners.push_back(outline.domainStart());
    std::vector<EdgeWidth> edges;
    const ArcLength2 length(outline);
    std::map<long long, double> lengths; // by width
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double from = corners[i],
                     to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + outline.period();
        edges.push_back({from, outline.wrapped(to), widthOfEdge(outline, cut, from, to)});
        lengths[std::llround(edges.back().width / alike)] += length.between(from, to);
    }
    FoundAllowance found;
    double longest = -1;
    for (const EdgeWidth& edge : edges)
        if (const double along = lengths[std::llround(edge.width / alike)]; along > longest) {
            longest = along;
            found.usual.width = edge.width;
        }
    for (const EdgeWidth& edge : edges)
        if (std::abs(edge.width - found.usual.width) > alike) {
            EdgeWidth other = edge;
            // Neighbours of one width are one edge.
            if (!found.edges.empty() && found.edges.back().to == other.from &&
                std::abs(found.edges.back().width - other.width) <= alike)
                found.edges.back().to = other.to;
            else
                found.edges.push_back(other);
        }
    found.usual.corner = joinOf(outline, cut, found);
    return found;
}

} // namespace bolster
