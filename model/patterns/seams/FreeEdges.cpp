#include "FreeEdges.h"

#include "ArcLength.h"
#include "CornerWay.h"
#include "DesignCheck.h"
#include "DrawnWords.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double samePlaceOnEdge = 0.5; // mm

/// Words of which a piece has one or the other.
constexpr std::pair<const char*, const char*> opposites[] = {{"left", "right"},    {"links", "rechts"},
                                                             {"linke", "rechte"},  {"linker", "rechter"},
                                                             {"gauche", "droite"}, {"l", "r"}};

std::set<std::string> wordsOf(const std::string& name)
{
    std::set<std::string> words;
    std::string word;
    for (const char c : lowered(name) + " ") {
        if (c != ' ' && c != '-' && c != '_' && c != ',' && c != '.') {
            word += c;
        } else if (!word.empty()) {
            words.insert(word);
            word.clear();
        }
    }
    return words;
}

/// What lies on an outline already.
struct UsedStretch {
    Stretch stretch;
    ElementId seam{}; ///< none: it is fixed
    bool isA = false;
};

class PatchEdges {
public:
    /// `start` is where the edge of an outline without any corner begins.
    PatchEdges(ElementId id, const Patch& patch, const std::vector<UsedStretch>& used, std::vector<double> more,
               double start)
        : m_id(id)
        , m_outline(patch.outline)
        , m_length(patch.outline)
        , m_used(used)
        , m_more(std::move(more))
        , m_start(start)
        , m_grain(patch.grain)
        , m_rotation(patch.rotation)
        , m_position(patch.position)
        , m_backwards((patch.outline.signedArea() < 0) != patch.wrongSideOut)
    {}

    std::vector<OutlineEdge> make(int first, std::map<std::pair<ElementId, bool>, int>& sides) const
    {
        std::vector<double> breaks = breaksOf();
        std::vector<OutlineEdge> edges;
        const int count = static_cast<int>(breaks.size());
        for (int i = 0; i < count; ++i) {
            OutlineEdge edge;
            const double from = breaks[static_cast<std::size_t>(i)];
            const double to =
                i + 1 < count ? breaks[static_cast<std::size_t>(i) + 1] : breaks.front() + m_outline.period();
            edge.stretch = {m_id, from, m_outline.wrapped(to)};
            edge.length = m_length.between(from, to);
            edge.backwards = m_backwards;
            edge.way = wayOf(m_backwards ? to : from, m_backwards ? from : to);
            edge.middle = middleOf(from, to);
            edge.alongGrain = edge.way.dot(directionOf(m_rotation + m_grain));
            edge.corner = angleAt(m_backwards ? to : from);
            const int after = first + (i + 1) % count, prior = first + (i + count - 1) % count;
            edge.next = m_backwards ? prior : after;
            edge.before = m_backwards ? after : prior;
            take(edge, from, to, first + i, sides);
            edges.push_back(std::move(edge));
        }
        return edges;
    }

private:
    std::vector<double> breaksOf() const
    {
        std::vector<double> breaks = m_outline.corners();
        for (const UsedStretch& used : m_used)
            for (const double t : {used.stretch.from, used.stretch.to})
                breaks.push_back(m_outline.wrapped(t));
        breaks.insert(breaks.end(), m_more.begin(), m_more.end());
        std::ranges::sort(breaks);
        std::vector<double> kept;
        for (const double t : breaks)
            if (kept.empty() || m_length.between(kept.back(), t) > samePlaceOnEdge)
                kept.push_back(t);
        while (kept.size() > 1 &&
               m_length.between(kept.back(), kept.front() + m_outline.period()) < samePlaceOnEdge)
            kept.pop_back();
        if (kept.empty())
            kept.push_back(m_start);
        return kept;
    }

    static Vec2 directionOf(double degrees)
    {
        const double angle = degrees * std::numbers::pi / 180;
        return {std::cos(angle), std::sin(angle)};
    }

    Vec2 wayOf(double from, double to) const
    {
        const Vec2 way = m_outline.at(m_outline.wrapped(to)) - m_outline.at(m_outline.wrapped(from));
        return Eigen::Rotation2Dd(m_rotation * std::numbers::pi / 180) * way.normalized();
    }

    Vec2 middleOf(double from, double to) const
    {
        const Vec2 between = (m_outline.at(m_outline.wrapped(from)) + m_outline.at(m_outline.wrapped(to))) / 2;
        return m_position + Eigen::Rotation2Dd(m_rotation * std::numbers::pi / 180) * between;
    }

    /// Inside the piece.
    double angleAt(double parameter) const
    {
        const double turn = turnAt(m_outline, parameter);
        return 180 - (m_outline.signedArea() < 0 ? -turn : turn) * 180 / std::numbers::pi;
    }

    void take(OutlineEdge& edge, double from, double to, int index,
              std::map<std::pair<ElementId, bool>, int>& sides) const
    {
        const double middle = (from + to) / 2, period = m_outline.period();
        for (const UsedStretch& used : m_used) {
            const double end =
                unwrappedEnd(used.stretch.from, used.stretch.to, m_outline.domainStart(), m_outline.domainEnd());
            const double t = middle - period * std::floor((middle - used.stretch.from) / period);
            if (t >= end)
                continue;
            (used.seam == noElement ? edge.fixed : edge.taken) = true;
            if (used.seam != noElement &&
                std::abs(m_length.between(used.stretch.from, end) - edge.length) < samePlaceOnEdge)
                sides[{used.seam, used.isA}] = index;
        }
    }

    ElementId m_id;
    const BSpline2& m_outline;
    ArcLength2 m_length;
    const std::vector<UsedStretch>& m_used;
    std::vector<double> m_more;
    double m_start;
    double m_grain, m_rotation; // degrees
    Vec2 m_position;
    bool m_backwards;
};

bool isSound(const Stretch& stretch)
{
    return std::isfinite(stretch.from) && std::isfinite(stretch.to);
}

void addNotches(const Design& design, std::vector<OutlineEdge>& edges)
{
    std::map<ElementId, std::pair<std::size_t, std::size_t>> ofPatch; // they follow one another
    for (std::size_t i = 0; i < edges.size(); ++i)
        ofPatch.try_emplace(edges[i].stretch.patch, i, i).first->second.second = i + 1;
    design.each<Notch>([&](ElementId, const Notch& notch) {
        const auto range = ofPatch.find(notch.place.patch);
        if (range == ofPatch.end() || !std::isfinite(notch.place.at))
            return;
        for (std::size_t i = range->second.first; i < range->second.second; ++i) {
            OutlineEdge& edge = edges[i];
            const BSpline2& outline = design.find<Patch>(edge.stretch.patch)->outline;
            const double period = outline.period();
            const double end =
                unwrappedEnd(edge.stretch.from, edge.stretch.to, outline.domainStart(), outline.domainEnd());
            const double t = notch.place.at - period * std::floor((notch.place.at - edge.stretch.from) / period);
            const bool round = end - edge.stretch.from < 1e-9 * period; // an outline without any corner
            if ((t >= end && !round) || edge.length < 1)
                continue;
            const double share = ArcLength2(outline).between(edge.stretch.from, t) / edge.length;
            if (share > 0.01 && share < 0.99)
                edge.notches.push_back(edge.backwards ? 1 - share : share);
        }
    });
    for (OutlineEdge& edge : edges)
        std::ranges::sort(edge.notches);
}

} // namespace

bool onOppositeSides(const OutlineEdge& a, const OutlineEdge& b)
{
    return std::ranges::any_of(opposites, [&](const auto& words) {
        const auto& [one, other] = words;
        return (a.words.contains(one) && b.words.contains(other)) ||
               (a.words.contains(other) && b.words.contains(one));
    });
}

double placeOn(const Design& design, const OutlineEdge& edge, double share)
{
    const BSpline2& outline = design.find<Patch>(edge.stretch.patch)->outline;
    const ArcLength2 length(outline);
    const double along = length.at(edge.stretch.from) + edge.length * (edge.backwards ? 1 - share : share);
    return outline.wrapped(length.parameterAt(along > length.total() ? along - length.total() : along));
}

std::vector<OutlineEdge> outlineEdges(const Design& design, const EdgeBreaks& more)
{
    std::map<ElementId, std::vector<UsedStretch>> used;
    const auto use = [&](const Stretch& stretch, ElementId seam, bool isA) {
        if (isSound(stretch))
            used[stretch.patch].push_back({stretch, seam, isA});
    };
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        use(seam.a, id, true);
        use(seam.b, id, false);
    });
    design.each<FixationSeam>([&](ElementId, const FixationSeam& fixed) { use(fixed.stretch, noElement, false); });
    std::map<ElementId, double> notches; // the first one of each patch
    design.each<Notch>([&](ElementId, const Notch& notch) {
        if (const Patch* patch = design.find<Patch>(notch.place.patch);
            patch && !patch->outline.empty() && std::isfinite(notch.place.at))
            notches.emplace(notch.place.patch, patch->outline.wrapped(notch.place.at));
    });
    std::vector<OutlineEdge> edges;
    std::map<std::pair<ElementId, bool>, int> sides;
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (outlineProblem(patch.outline))
            return;
        const std::set<std::string> words = wordsOf(patch.name);
        const auto extra = more.find(id);
        const auto notch = notches.find(id);
        const PatchEdges cut(id, patch, used[id], extra == more.end() ? std::vector<double>() : extra->second,
                             notch == notches.end() ? patch.outline.domainStart() : notch->second);
        for (OutlineEdge& edge : cut.make(static_cast<int>(edges.size()), sides)) {
            edge.words = words;
            edges.push_back(std::move(edge));
        }
    });
    for (const auto& [side, edge] : sides)
        if (const auto other = sides.find({side.first, !side.second}); other != sides.end())
            edges[static_cast<std::size_t>(edge)].partner = other->second;
    addNotches(design, edges);
    return edges;
}

} // namespace bolster
