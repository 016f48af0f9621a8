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

/// Lines are exact to a few hundredths, and nobody asks for an allowance of 9.99 mm.
double rounded(double width)
{
    const double tenths = std::round(width * 10) / 10;
    return std::abs(width - tenths) < 0.03 ? tenths : std::round(width * 100) / 100;
}

/// The parts of an edge that have one width each. Near corners the cut line belongs to both edges.
class EdgeWidths {
public:
    EdgeWidths(const BSpline2& outline, const Contour& cut, double from, double to)
        : m_outline(outline)
        , m_cut(cut)
        , m_from(from)
        , m_to(to)
    {}

    std::vector<EdgeWidth> parts()
    {
        constexpr int steps = 48, leastRun = 4;
        std::vector<EdgeWidth> runs; // from the first to the last sample of one width
        int length = 0;
        for (int k = 1; k < steps; ++k) {
            const double t = m_from + (m_to - m_from) * k / steps;
            const auto width = at(t);
            if (!width) {
                length = 0;
            } else if (length > 0 && std::abs(*width - m_last) <= alike) {
                if (++length == leastRun)
                    begin(runs, t - (leastRun - 1) * (m_to - m_from) / steps, *width);
                if (length >= leastRun)
                    runs.back().to = t;
            } else {
                length = 1;
            }
            m_last = width.value_or(m_last);
        }
        if (runs.empty())
            runs.push_back({m_from, m_to, at((m_from + m_to) / 2).value_or(0)});
        for (std::size_t i = 0; i + 1 < runs.size(); ++i)
            runs[i].to = runs[i + 1].from = change(runs[i], runs[i + 1]);
        runs.front().from = m_from;
        runs.back().to = m_to;
        for (EdgeWidth& run : runs)
            run.width = rounded(run.width);
        return runs;
    }

private:
    std::optional<double> at(double parameter) const
    {
        const double t = m_outline.wrapped(parameter);
        const Vec2 along = m_outline.derivative(t);
        return wayTo(m_cut, m_outline.at(t), Vec2(along.y(), -along.x()).normalized());
    }

    static void begin(std::vector<EdgeWidth>& runs, double from, double width)
    {
        if (runs.empty() || std::abs(runs.back().width - width) > alike)
            runs.push_back({from, from, width});
    }

    /// Where the width leaves that of the first run.
    double change(const EdgeWidth& first, const EdgeWidth& second) const
    {
        double low = first.to, high = second.from;
        for (int k = 0; k < 30; ++k) {
            const double middle = (low + high) / 2;
            const double width = at(middle).value_or(second.width);
            (std::abs(width - first.width) < std::abs(width - second.width) ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    const BSpline2& m_outline;
    const Contour& m_cut;
    double m_from, m_to;
    double m_last = 0;
};

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
        const double to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + outline.period();
        for (EdgeWidth& part : EdgeWidths(outline, cut, corners[i], to).parts()) {
            lengths[std::llround(part.width / alike)] += length.between(part.from, part.to);
            part.from = outline.wrapped(part.from);
            part.to = outline.wrapped(part.to);
            edges.push_back(part);
        }
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
