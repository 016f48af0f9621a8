#include "AllowanceFound.h"

#include "ArcLength.h"
#include "CutPattern.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

constexpr double alike = 0.06;      // mm: widths that are one
constexpr double widest = 200.01;   // mm: as the rules have it, rounded
constexpr double farthestCut = 1e4; // mm: what is told of wider ones
constexpr double exactness = 0.05;  // mm: of the lines
constexpr double exactShare = 1e-5; // of an area

/// From the point to the closed line, along a direction; nothing where it meets none within reach.
std::optional<double> wayTo(const std::vector<Vec2>& line, const Vec2& from, const Vec2& way, double reach)
{
    double nearest = reach + 1;
    for (std::size_t i = 0; i < line.size(); ++i) {
        const Vec2 a = line[i] - from, b = line[(i + 1) % line.size()] - from;
        const double sideA = cross(way, a), sideB = cross(way, b);
        if ((sideA > 0) == (sideB > 0))
            continue;
        const double t = (a + (b - a) * (sideA / (sideA - sideB))).dot(way);
        if (t > -exactness)
            nearest = std::min(nearest, std::max(t, 0.0));
    }
    if (nearest > reach)
        return std::nullopt;
    return nearest;
}

/// A piece's two lines, as polygons.
struct BothLines {
    const BSpline2& outline;
    Contour sew;
    std::vector<Vec2> cut;
    std::vector<std::vector<Vec2>> others;

    BothLines(const BSpline2& sewn, const Contour& cutLine, const std::vector<Contour>& otherSewn)
        : outline(sewn)
        , cut(cutLine.places())
    {
        for (const Contour& other : otherSewn)
            others.push_back(other.places());
        sew.closed = true;
        for (const OutlineSample& sample : sampled(outline, {0.02, 0, {}})) {
            sew.points.emplace_back();
            sew.points.back().at = sample.at;
        }
    }

    /// From a place of the outline straight out to the cut line. Beside an inner corner the way leads along another
    /// edge, or back into the piece: then its middle is nearer to something else, and nothing can be said.
    std::optional<double> widthAt(double parameter, double reach = widest) const
    {
        const double t = outline.wrapped(parameter);
        const Vec2 at = outline.at(t), along = outline.derivative(t);
        const Vec2 out = Vec2(along.y(), -along.x()).normalized();
        const auto width = wayTo(cut, at, out, reach);
        if (!width || sew.distance(at + *width / 2 * out) < *width / 2 - exactness)
            return std::nullopt;
        const auto between = [&](const std::vector<Vec2>& other) {
            return wayTo(other, at, out, *width).has_value();
        };
        return std::ranges::any_of(others, between) ? std::nullopt : width;
    }
};

/// Lines are exact to a few hundredths, and nobody asks for an allowance of 9.99 mm.
double rounded(double width)
{
    const double tenths = std::round(width * 10) / 10;
    return std::abs(width - tenths) < 0.03 ? tenths : std::round(width * 100) / 100;
}

/// The parts of an edge that have one width each. Near corners the cut line belongs to both edges.
class EdgeWidths {
public:
    EdgeWidths(const BothLines& lines, double from, double to)
        : m_lines(lines)
        , m_from(from)
        , m_to(to)
    {}

    /// None where nothing can be said.
    std::vector<EdgeWidth> parts()
    {
        constexpr int steps = 48, leastRun = 4;
        std::vector<EdgeWidth> runs; // from the first to the last sample of one width
        int length = 0;
        for (int k = 1; k < steps; ++k) {
            const double t = m_from + (m_to - m_from) * k / steps;
            const auto width = m_lines.widthAt(t);
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
        if (runs.empty()) {
            const auto middle = m_lines.widthAt((m_from + m_to) / 2);
            if (!middle)
                return {};
            runs.push_back({m_from, m_to, *middle, false});
        }
        for (std::size_t i = 0; i + 1 < runs.size(); ++i)
            runs[i].to = runs[i + 1].from = change(runs[i], runs[i + 1]);
        runs.front().from = m_from;
        runs.back().to = m_to;
        for (EdgeWidth& run : runs)
            run.width = rounded(run.width);
        return runs;
    }

private:
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
            const double width = m_lines.widthAt(middle).value_or(second.width);
            (std::abs(width - first.width) < std::abs(width - second.width) ? low : high) = middle;
        }
        return (low + high) / 2;
    }

    const BothLines& m_lines;
    double m_from, m_to;
    double m_last = 0;
};

std::vector<LinePoint> cutWith(const BSpline2& outline, const FoundAllowance& found)
{
    Patch patch;
    patch.outline = outline;
    patch.allowance = found.usual;
    std::vector<Change> changes{{ElementId(1), nullptr, makeElement(std::move(patch))}};
    int id = 2;
    for (const EdgeWidth& edge : found.edges)
        changes.push_back(
            {ElementId(id++), nullptr, makeElement(EdgeAllowance{{ElementId(1), edge.from, edge.to}, edge.width})});
    const CutPattern pattern = cutPattern(Design().with({{}, std::move(changes), {}}), {});
    return pattern.pieces.empty() ? std::vector<LinePoint>() : pattern.pieces.front().cut;
}

double areaCut(const BSpline2& outline, const FoundAllowance& found)
{
    return areaOf(cutWith(outline, found));
}

/// How far points of one line are from the other one at most, mm. Of very fine lines some points tell enough.
double farthestFrom(const Contour& line, const Contour& other)
{
    constexpr std::size_t most = 1000;
    const std::size_t step = 1 + line.points.size() / most;
    double farthest = 0;
    for (std::size_t i = 0; i < line.points.size(); i += step)
        farthest = std::max(farthest, other.distance(line.points[i].at));
    return farthest;
}

double farthestOff(const BSpline2& outline, const Contour& cut, const FoundAllowance& found)
{
    Contour drawn;
    drawn.closed = true;
    for (const LinePoint& point : cutWith(outline, found)) {
        drawn.points.emplace_back();
        drawn.points.back().at = point.at;
    }
    return drawn.points.empty() ? 0 : std::max(farthestFrom(drawn, cut), farthestFrom(cut, drawn));
}

/// Takes for the corners the one of five ways to join them that has the area of the cut line. Returns how far off
/// it is, mm2.
double chooseCorners(const BSpline2& outline, double area, FoundAllowance& found)
{
    constexpr CornerJoin all[] = {CornerJoin::Mitred, CornerJoin::Square, CornerJoin::Rounded, CornerJoin::Folded,
                                  CornerJoin::Stepped};
    FoundAllowance tried = found;
    double least = std::numeric_limits<double>::infinity();
    for (const CornerJoin join : all) {
        tried.usual.corner = join;
        const double off = std::abs(areaCut(outline, tried) - area);
        // Only what differs by more than the lines are exact.
        if (off < least - exactShare * std::abs(area)) {
            least = off;
            found.usual.corner = join;
        }
    }
    return least;
}

/// Edges whose width could be measured nowhere but in their middle have the usual one if that explains the cut line
/// as well.
void dropGuesses(const BSpline2& outline, double area, FoundAllowance& found, double off)
{
    constexpr int most = 40; // each one costs a few cut lines
    int looked = 0;
    for (std::size_t i = 0; i < found.edges.size();) {
        if (found.edges[i].sure || ++looked > most) {
            ++i;
            continue;
        }
        FoundAllowance without = found;
        without.edges.erase(without.edges.begin() + static_cast<std::ptrdiff_t>(i));
        const double offWithout = chooseCorners(outline, area, without);
        if (offWithout <= off + exactShare * std::abs(area)) {
            found = std::move(without);
            off = offWithout;
        } else {
            ++i;
        }
    }
}

} // namespace

FoundAllowance foundAllowance(const BSpline2& outline, const Contour& cut, const std::vector<Contour>& others)
{
    std::vector<double> corners = outline.corners();
    if (corners.empty())
        corners.push_back(outline.domainStart());
    std::vector<EdgeWidth> edges;
    const BothLines lines(outline, cut, others);
    const ArcLength2 length(outline);
    std::map<long long, double> lengths; // by width
    FoundAllowance found;
    for (std::size_t i = 0; i < corners.size(); ++i) {
        const double to = i + 1 < corners.size() ? corners[i + 1] : corners.front() + outline.period();
        std::vector<EdgeWidth> parts = EdgeWidths(lines, corners[i], to).parts();
        if (parts.empty())
            found.tooWide = std::max(found.tooWide, lines.widthAt((corners[i] + to) / 2, farthestCut).value_or(0));
        for (EdgeWidth& part : parts) {
            lengths[std::llround(part.width / alike)] += length.between(part.from, part.to);
            part.from = outline.wrapped(part.from);
            part.to = outline.wrapped(part.to);
            edges.push_back(part);
        }
    }
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
                found.edges.back().to = other.to, found.edges.back().sure |= other.sure;
            else
                found.edges.push_back(other);
        }
    const double off = chooseCorners(outline, cut.signedArea(), found);
    dropGuesses(outline, cut.signedArea(), found, off);
    found.off = farthestOff(outline, cut, found);
    return found;
}

} // namespace bolster
