#include "FancyLines.h"

#include "CurveDivision.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double narrowest = 1.0 / 6;     // of an edge length: a strip that triangles can still follow
constexpr double longestCell = 2.5;       // along a strip, as a multiple of the distance of its lines
constexpr double leastAdvance = 0.2;      // of an outer line's edge against the curve's: less nearly turns back
constexpr double leastBesideCorner = 0.4; // of a step: points nearer to a line's corner are left out
constexpr double leastAtOutline = 0.35;   // of a step: likewise at its end on the outline
constexpr double flattest = 1.75;         // extension per half width: outlines met at 30 degrees and more
constexpr double mostMitre = -0.5;        // cosine of the sharpest turn, 120 degrees

struct PathPoint {
    Vec2 point, before, after; // unit tangents on both sides
    double place = 0;          // arc length along the curve, mm
    bool corner = false;
};

Vec2 left(const Vec2& tangent)
{
    return {-tangent.y(), tangent.x()};
}

class FancyDrawer {
public:
    FancyDrawer(const FancySeam& seam, const PatchBorder& border, double edgeLength)
        : m_curve(seam.curve)
        , m_length(seam.curve)
        , m_border(border)
        , m_edge(edgeLength)
        , m_half(seam.width / 2)
    {
        // Three lines on each side show any profile; more where they would lie farther apart than an edge is long.
        const auto ideal = static_cast<int>(std::lround(6 * m_half / m_edge));
        m_perSide = std::max({1, std::min(3, ideal), static_cast<int>(std::ceil(m_half / m_edge))});
        m_step = std::min(m_edge, std::max(longestCell * m_half / m_perSide, narrowest * m_edge));
    }

    FancyLines run()
    {
        FancyLines result;
        if (2 * m_half < narrowest * m_edge)
            m_reason = {QT_TRANSLATE_NOOP("Message",
                                          "a width of %1 mm is too narrow for edges of %2 mm; make it at "
                                          "least %3 mm wide, or choose a smaller edge length"),
                        {numberText(2 * m_half), numberText(m_edge), numberText(narrowest * m_edge, 3)}};
        if (!m_reason)
            findInside();
        if (!m_reason)
            samplePath();
        for (int line = -m_perSide; line <= m_perSide && !m_reason; ++line)
            result.lines.push_back(drawLine(static_cast<double>(line) / m_perSide));
        if (m_reason)
            return {{}, m_reason};
        return result;
    }

private:
    Vec2 at(double s) const { return m_curve.at(m_length.parameterAt(s)); }

    /// The part of the curve that lies in the patch; what is beyond the outline is cut off.
    void findInside()
    {
        const double total = m_length.total();
        const int count = std::max(2, static_cast<int>(std::ceil(4 * total / m_edge)));
        int first = -1, last = -1, inside = 0;
        for (int k = 0; k <= count; ++k)
            if (m_border.contains(at(total * k / count))) {
                first = first < 0 ? k : first;
                last = k;
                ++inside;
            }
        if (inside == 0)
            m_reason = {
                QT_TRANSLATE_NOOP("Message", "it lies outside its patch; move its points inside the outline"), {}};
        else if (inside != last - first + 1 || (m_curve.closed() && inside <= count))
            m_reason = {QT_TRANSLATE_NOOP("Message",
                                          "it leaves the patch and comes back; keep it inside, or end it at "
                                          "the outline"),
                        {}};
        if (m_reason || m_curve.closed()) {
            m_s1 = total;
            return;
        }
        m_s0 = first == 0 ? 0 : crossing(total * first / count, total * (first - 1) / count);
        m_s1 = last == count ? total : crossing(total * last / count, total * (last + 1) / count);
        const auto reaches = [&](double s) {
            return m_border.outline().closest(at(s)).distance <= outlineReach(m_edge);
        };
        m_meets = {first > 0 || reaches(m_s0), last < count || reaches(m_s1)};
    }

    double crossing(double inside, double outside) const
    {
        for (int i = 0; i < 50; ++i) {
            const double middle = 0.5 * (inside + outside);
            (m_border.contains(at(middle)) ? inside : outside) = middle;
        }
        return inside;
    }

    PathPoint pathPoint(double s, bool corner) const
    {
        const double delta = 1e-5 * (m_s1 - m_s0);
        PathPoint point{at(s), Vec2::Zero(), Vec2::Zero(), s, corner};
        const bool open = !m_curve.closed();
        point.before = (point.point - at(s - delta)).normalized();
        point.after = (at(s + delta) - point.point).normalized();
        if (open && s - delta < m_s0)
            point.before = point.after;
        if (open && s + delta > m_s1)
            point.after = point.before;
        return point;
    }

    void samplePath()
    {
        std::vector<double> cuts;
        const bool closed = m_curve.closed();
        if (!closed)
            cuts.push_back(m_s0);
        for (double t : m_curve.corners())
            if (const double s = m_length.at(t); closed || (s > m_s0 + 1e-6 * m_edge && s < m_s1 - 1e-6 * m_edge))
                cuts.push_back(s);
        const bool cornered = closed && !cuts.empty();
        if (closed && cuts.empty())
            cuts.push_back(0);
        cuts.push_back(closed ? cuts.front() + m_length.total() : m_s1);
        for (std::size_t piece = 0; piece + 1 < cuts.size(); ++piece) {
            const double s0 = cuts[piece], s1 = cuts[piece + 1];
            const int edges =
                std::max(edgesOf(m_curve, m_length, s0, s1, m_step), closed && cuts.size() < 4 ? 3 : 1);
            for (int k = 0; k < edges; ++k)
                m_path.push_back(pathPoint(s0 + (s1 - s0) * k / edges, k == 0 && (piece > 0 || cornered)));
        }
        if (closed)
            return;
        m_path.push_back(pathPoint(m_s1, false));
        for (const int end : {0, 1})
            if (m_meets[end])
                extend(end);
    }

    /// Straight on, so that all lines cross the outline.
    void extend(int end)
    {
        const int count = static_cast<int>(std::ceil((flattest * m_half + outlineReach(m_edge)) / m_step)) + 1;
        const PathPoint last = end == 0 ? m_path.front() : m_path.back();
        for (int k = 1; k <= count; ++k) {
            PathPoint point = last;
            const double distance = (end == 0 ? -k : k) * m_step;
            point.point += distance * last.after;
            point.place += distance;
            m_path.insert(end == 0 ? m_path.begin() : m_path.end(), point);
        }
    }

    PatchLine drawLine(double across)
    {
        PatchLine line;
        line.across = across;
        line.closed = m_curve.closed();
        line.reach = std::min(outlineReach(m_edge), 0.3 * m_half / m_perSide);
        std::vector<Vec2> offset;
        for (const PathPoint& p : m_path) {
            const Vec2 a = left(p.before), b = left(p.after);
            if (a.dot(b) < mostMitre)
                bendsTooSharply(p);
            offset.push_back(p.point + across * m_half / (1 + std::max(a.dot(b), mostMitre)) * (a + b));
        }
        const std::vector<int> kept = keptPoints(offset);
        for (int k : kept) {
            line.points.push_back(offset[k]);
            line.places.push_back(m_path[k].place);
        }
        for (std::size_t k = 0; k + (line.closed ? 0 : 1) < kept.size(); ++k) {
            const std::size_t next = (k + 1) % kept.size();
            const Vec2 wanted = m_path[kept[next]].point - m_path[kept[k]].point;
            if ((line.points[next] - line.points[k]).dot(wanted) < leastAdvance * wanted.squaredNorm())
                bendsTooSharply(m_path[kept[k]]);
        }
        for (const int end : {1, 0})
            if (m_meets[end] && !m_reason)
                leadToOutline(line, end);
        return line;
    }

    /// On the inner side of a corner the neighbours' offsets fall behind that of the corner itself.
    std::vector<int> keptPoints(const std::vector<Vec2>& offset)
    {
        const int count = static_cast<int>(offset.size());
        std::vector<char> dropped(offset.size(), 0);
        for (int corner = 0; corner < count; ++corner)
            for (const int direction : {-1, 1}) {
                if (!m_path[corner].corner)
                    continue;
                const Vec2 along = direction < 0 ? Vec2(-m_path[corner].before) : m_path[corner].after;
                for (int k = corner + direction;; k += direction) {
                    const bool beyond = !m_curve.closed() && (k < 0 || k >= count);
                    const int index = (k + count) % count;
                    if (!beyond && (offset[index] - offset[corner]).dot(along) >= leastBesideCorner * m_step)
                        break;
                    if (beyond || m_path[index].corner) {
                        bendsTooSharply(m_path[corner]);
                        break;
                    }
                    dropped[index] = 1;
                }
            }
        std::vector<int> kept;
        for (int k = 0; k < count; ++k)
            if (!dropped[k])
                kept.push_back(k);
        return kept;
    }

    void leadToOutline(PatchLine& line, int end)
    {
        if (end == 0)
            reverse(line);
        std::size_t k = line.points.size() / 2;
        const bool begins = m_border.contains(line.points[k]);
        std::optional<PatchBorder::Meeting> meeting;
        for (; begins && !meeting && k + 1 < line.points.size(); ++k)
            meeting = m_border.firstMeeting(line.points[k], line.points[k + 1]);
        if (!meeting) {
            m_reason = {QT_TRANSLATE_NOOP("Message", "it runs too flat into the outline near %1; let it meet the "
                                                     "outline more steeply, or end it before"),
                        {pointText(line.points.back())}};
            return;
        }
        const Vec2 point = m_border.outline().at(meeting->parameter);
        const double place = line.places[k - 1] + meeting->fraction * (line.places[k] - line.places[k - 1]);
        line.points.resize(k);
        line.places.resize(k);
        while (line.points.size() > 1 && (line.points.back() - point).norm() < leastAtOutline * m_step) {
            line.points.pop_back();
            line.places.pop_back();
        }
        line.points.push_back(point);
        line.places.push_back(place);
        line.onOutline[end] = meeting->parameter;
        if (end == 0)
            reverse(line);
    }

    static void reverse(PatchLine& line)
    {
        std::reverse(line.points.begin(), line.points.end());
        std::reverse(line.places.begin(), line.places.end());
    }

    void bendsTooSharply(const PathPoint& where)
    {
        if (!m_reason)
            m_reason = {QT_TRANSLATE_NOOP("Message", "it bends too sharply for a width of %1 mm near %2; make it "
                                                     "narrower, or bend it less there"),
                        {numberText(2 * m_half), pointText(where.point)}};
    }

    const BSpline2& m_curve;
    ArcLength2 m_length;
    const PatchBorder& m_border;
    double m_edge;
    double m_half;
    int m_perSide = 1;
    double m_step = 0;                            // along the path, mm
    double m_s0 = 0, m_s1 = 0;                    // what lies in the patch
    std::array<bool, 2> m_meets = {false, false}; // the outline, at start and end
    std::vector<PathPoint> m_path;
    std::optional<Message> m_reason;
};

} // namespace

FancyLines drawFancyLines(const FancySeam& seam, const PatchBorder& border, double edgeLength)
{
    return FancyDrawer(seam, border, edgeLength).run();
}

double outlineReach(double edgeLength)
{
    return 0.25 * edgeLength; // a shorter edge would spoil the triangles
}

std::string pointText(const Vec2& point)
{
    return std::string("(").append(numberText(point.x())).append(", ").append(numberText(point.y())).append(")");
}

} // namespace bolster
