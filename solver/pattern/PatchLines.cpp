#include "PatchLines.h"

#include "CurveDivision.h"
#include "FancyLines.h"
#include "SegmentGrid.h"
#include "SpokenName.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

/// The arc lengths at which a handle is cut: its own corners, and those of its target, which want a vertex too.
std::vector<double> cutsOf(const HandleCurve& handle, const ArcLength2& length, double apart)
{
    const BSpline2& curve = handle.curve;
    std::vector<double> cuts{0};
    for (double t : curve.corners())
        if (const double s = length.at(t); s > 0)
            cuts.push_back(s);
    if (curve.closed() && !curve.corners().empty() && curve.corners().front() > curve.domainStart())
        cuts.erase(cuts.begin()); // a smooth start needs no cut when there is a corner
    const ArcLength3 targetLength(handle.target);
    const std::vector<double> corners = handle.hasTarget() ? handle.target.corners() : std::vector<double>();
    for (double t : corners) {
        const double fraction = handle.match == Match::Length
                                    ? targetLength.at(t) / targetLength.total()
                                    : (t - handle.target.domainStart()) / handle.target.period();
        const double s = handle.match == Match::Length ? fraction * length.total()
                                                       : length.at(curve.domainStart() + fraction * curve.period());
        const bool isNew = std::all_of(cuts.begin(), cuts.end(), [&](double cut) {
            const double distance = std::abs(cut - s);
            return std::min(distance, length.total() - distance) > apart;
        });
        if (isNew)
            cuts.push_back(s);
    }
    std::sort(cuts.begin(), cuts.end());
    cuts.push_back(curve.closed() ? cuts.front() + length.total() : length.total());
    return cuts;
}

PatchLine sampledHandle(const HandleCurve& handle, const ArcLength2& length, double edge)
{
    const BSpline2& curve = handle.curve;
    PatchLine line;
    line.closed = curve.closed();
    const std::vector<double> cuts = cutsOf(handle, length, outlineReach(edge));
    const auto add = [&](double s) {
        const double t = length.parameterAt(s);
        line.points.push_back(curve.at(t));
        line.places.push_back(s);
        const double fraction =
            handle.match == Match::Length ? s / length.total() : (t - curve.domainStart()) / curve.period();
        line.fractions.push_back(line.closed ? fraction - std::floor(fraction) : fraction);
    };
    for (std::size_t piece = 0; piece + 1 < cuts.size(); ++piece) {
        const double s0 = cuts[piece], s1 = cuts[piece + 1];
        const int fewest = line.closed ? 4 - std::min<int>(3, static_cast<int>(cuts.size()) - 1) : 1;
        const int edges = std::max(edgesOf(curve, length, s0, s1, edge), fewest);
        for (int k = 0; k < edges; ++k)
            add(s0 + (s1 - s0) * k / edges);
    }
    if (!line.closed)
        add(length.total());
    return line;
}

/// The lines of one patch, and what lies too close to what.
class PatchDrawer {
public:
    PatchDrawer(const Design& design, const Patch& patch, PatchLines& result)
        : m_design(design)
        , m_edge(design.settings().edgeLength)
        , m_border(patch.outline, m_edge / 4)
        , m_grid(m_border.box(), m_edge)
        , m_result(result)
    {
        m_grid.addPolyline(m_border.points(), true);
        m_tags.assign(m_border.points().size(), {});
    }

    void draw(ElementId id, const Element& element)
    {
        m_id = id;
        std::optional<Message> reason;
        std::vector<PatchLine> lines;
        double room = 0.75 * m_edge; // along the curve: nearer points may be near
        if (const auto* seam = std::get_if<FancySeam>(&element)) {
            FancyLines drawn = drawFancyLines(*seam, m_border, m_edge);
            lines = std::move(drawn.lines);
            reason = std::move(drawn.reason);
            room += 1.5 * seam->width;
        } else {
            lines.push_back(drawHandle(std::get<HandleCurve>(element), reason));
        }
        const double total = ArcLength2(patchCurve(element)->curve).total();
        if (!reason)
            reason = addChecked(lines, room, total);
        if (reason) {
            m_refused.insert(id);
            m_result.problems.push_back({id, elementLabel(id, element), "curve", *reason, Severity::Error});
            return;
        }
        for (PatchLine& line : lines) {
            line.element = id;
            line.patch = patchCurve(element)->patch;
            m_result.lines.push_back(std::move(line));
        }
    }

private:
    /// What a segment of the grid belongs to; the outline's have no element.
    struct Tag {
        ElementId element = noElement;
        double from = 0, to = 0; ///< along the drawn curve, mm
    };

    PatchLine drawHandle(const HandleCurve& handle, std::optional<Message>& reason) const
    {
        const ArcLength2 length(handle.curve);
        const double shortest = (handle.curve.closed() ? 3 : 1) * m_edge;
        if (length.total() < shortest) {
            reason = {QT_TRANSLATE_NOOP("Message",
                                        "it is only %1 mm long; draw it at least %2 mm long, or choose a "
                                        "smaller edge length"),
                      {numberText(length.total(), 3), numberText(shortest)}};
            return {};
        }
        PatchLine line = sampledHandle(handle, length, m_edge);
        line.reach = outlineReach(m_edge);
        for (const int end : {0, 1}) {
            Vec2& point = end == 0 ? line.points.front() : line.points.back();
            const auto closest = m_border.outline().closest(point);
            if (line.closed || closest.distance > line.reach)
                continue;
            line.onOutline[end] = closest.parameter;
            point = closest.point;
        }
        return line;
    }

    /// Adds the lines to the grid. The reason if one of them is too close to something.
    std::optional<Message> addChecked(const std::vector<PatchLine>& lines, double room, double total)
    {
        for (const PatchLine& line : lines)
            if (std::abs(line.across) == 1 || lines.size() == 1)
                addToGrid(line, total);
        for (const PatchLine& line : lines)
            if (std::abs(line.across) == 1 || lines.size() == 1)
                if (auto reason = check(line, room, total))
                    return reason;
        return std::nullopt;
    }

    /// Where segment k ends along the drawn curve.
    static double endPlace(const PatchLine& line, std::size_t k, double total)
    {
        return k + 1 < line.places.size() ? line.places[k + 1] : line.places.front() + total;
    }

    void addToGrid(const PatchLine& line, double total)
    {
        m_grid.addPolyline(line.points, line.closed);
        const std::size_t segments = line.points.size() - (line.closed ? 0 : 1);
        for (std::size_t k = 0; k < segments; ++k)
            m_tags.push_back({m_id, line.places[k], endPlace(line, k, total)});
    }

    std::optional<Message> check(const PatchLine& line, double room, double total) const
    {
        const double margin = outlineReach(m_edge);
        const std::size_t count = line.points.size();
        for (std::size_t k = 0; k < count; ++k) {
            const bool onOutline = (k == 0 && line.onOutline[0]) || (k + 1 == count && line.onOutline[1]);
            if (!onOutline && !m_border.contains(line.points[k]))
                return Message{QT_TRANSLATE_NOOP("Message", "it reaches beyond its patch near %1; move its points "
                                                            "inside the outline"),
                               {pointText(line.points[k])}};
        }
        for (std::size_t k = 0; k + (line.closed ? 0 : 1) < count; ++k) {
            const Vec2 &a = line.points[k], &b = line.points[(k + 1) % count];
            const int parts = std::max(1, static_cast<int>(std::ceil((b - a).norm() / margin)));
            for (int part = 0; part <= parts; ++part) {
                const Vec2 p = a + (b - a) * part / parts;
                const double place = line.places[k] + (endPlace(line, k, total) - line.places[k]) * part / parts;
                std::optional<Message> reason;
                m_grid.anyNear(p, margin, [&](int segment) {
                    return (reason = objection(line, p, place, m_tags[segment], room, total)).has_value();
                });
                if (reason)
                    return reason;
            }
        }
        return std::nullopt;
    }

    /// To a segment that is too near to p.
    std::optional<Message> objection(const PatchLine& line, const Vec2& p, double place, const Tag& other,
                                     double room, double total) const
    {
        const std::string where = pointText(p), margin = numberText(outlineReach(m_edge), 3);
        if (m_refused.contains(other.element))
            return std::nullopt;
        if (other.element == noElement) {
            for (const int end : {0, 1}) {
                const Vec2& point = end == 0 ? line.points.front() : line.points.back();
                if (line.onOutline[end] && (p - point).norm() < 2.2 * outlineReach(m_edge))
                    return std::nullopt; // it ends there
            }
            return Message{QT_TRANSLATE_NOOP("Message",
                                             "it comes closer than %1 mm to the outline near %2; keep away "
                                             "from it, or choose a smaller edge length"),
                           {margin, where}};
        }
        if (other.element != m_id)
            return Message{QT_TRANSLATE_NOOP("Message",
                                             "it crosses %1, or comes closer to it than %2 mm, near %3; move them "
                                             "apart, or choose a smaller edge length"),
                           {spokenName(m_design, other.element), margin, where}};
        for (const double turn : {0.0, -total, total})
            if (const double at = place + turn;
                (turn == 0 || line.closed) && at > other.from - room && at < other.to + room)
                return std::nullopt; // it is near along the line, too
        return Message{QT_TRANSLATE_NOOP("Message",
                                         "it crosses itself, or comes closer to itself than %1 mm, near %2; "
                                         "move its points apart, or choose a smaller edge length"),
                       {margin, where}};
    }

    const Design& m_design;
    double m_edge;
    PatchBorder m_border;
    SegmentGrid m_grid;
    std::vector<Tag> m_tags; // of the grid's segments
    std::set<ElementId> m_refused;
    PatchLines& m_result;
    ElementId m_id{};
};

} // namespace

PatchLines drawPatchLines(const Design& design)
{
    PatchLines result;
    std::map<ElementId, PatchDrawer> drawers;
    for (const auto& [id, element] : design.elements())
        if (const PatchCurve* drawn = shapingCurve(*element))
            drawers.try_emplace(drawn->patch, design, *design.find<Patch>(drawn->patch), result)
                .first->second.draw(id, *element);
    return result;
}

} // namespace bolster
