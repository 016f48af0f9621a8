#include "StretchRemap.h"

#include "MatchedRange.h"
#include "PatchMark.h"

#include <algorithm>
#include <cmath>

namespace bolster::edits {

namespace {

constexpr double shortestRest = 0.01; // mm: what is shorter is no piece of its own

/// A range as the text form has it: inside the domain, exactly on knots that are almost met.
template <int Dim>
std::pair<double, double> normalised(const BSpline<Dim>& curve, double from, double to)
{
    const double start = curve.domainStart(), end = curve.domainEnd(), gap = 1e-9 * curve.period();
    const auto inside = [&](double t) {
        double wrapped = curve.wrapped(t);
        for (const double knot : curve.breaks())
            if (std::abs(knot - wrapped) < gap)
                wrapped = knot;
        return wrapped;
    };
    double first = inside(from), last = inside(to);
    if (curve.closed() && first >= end)
        first = start;
    if (curve.closed() && last <= start)
        last = end;
    return {first, last};
}

struct Placed {
    Stretch stretch;
    bool backwards = false;
};

/// One side of a seam on its way from the old outlines to the new ones.
class Side {
public:
    Side(const Design& before, const Design& after, const OutlineArcs& arcs, const Stretch& stretch, Match match)
        : m_outline(before.find<Patch>(stretch.patch)->outline)
        , m_after(after)
        , m_stretch(stretch)
        , m_range(m_outline, stretch.from, stretch.to, match)
    {
        if (const auto found = arcs.find(stretch.patch); found != arcs.end())
            m_arcs = &found->second;
        findCuts();
    }

    const std::map<double, double>& cuts() const { return m_cuts; } ///< fraction to parameter
    double parameter(double fraction) const
    {
        const auto own = m_cuts.find(fraction);
        return own != m_cuts.end() ? own->second : m_range.parameter(fraction);
    }
    double lengthFraction(double fraction) const { return m_range.lengthFraction(parameter(fraction)); }
    double length() const { return m_range.total(); }

    /// Where the part between two fractions lies now; nothing if it is gone.
    std::optional<Placed> placed(double f0, double f1) const
    {
        double from = parameter(f0), to = parameter(f1);
        if (!m_arcs) {
            if (f0 == 0 && f1 == 1)
                return Placed{m_stretch};
            const auto [first, last] = normalised(m_outline, from, to);
            return Placed{{m_stretch.patch, first, last}};
        }
        const OutlineArc* arc = nullptr;
        double turns = 0;
        for (const OutlineArc& one : *m_arcs)
            for (int k = -2; k <= 2; ++k)
                if (const double t = (from + to) / 2 + k * m_outline.period(); t > one.from && t < one.to) {
                    arc = &one;
                    turns = k * m_outline.period();
                }
        if (!arc)
            return std::nullopt;
        const auto target = [&](double t) {
            const double ahead = t + turns - arc->from;
            return arc->backwards ? arc->start - ahead : arc->start + ahead;
        };
        const Patch& patch = *m_after.find<Patch>(arc->patch);
        const double begin = arc->backwards ? target(to) : target(from);
        const double end = arc->backwards ? target(from) : target(to);
        const auto [first, last] = normalised(patch.outline, begin, end);
        return Placed{{arc->patch, first, last}, arc->backwards};
    }

private:
    void findCuts()
    {
        if (!m_arcs)
            return;
        const double whole = m_range.total();
        for (const OutlineArc& arc : *m_arcs)
            for (const double end : {arc.from, arc.to})
                for (int k = -2; k <= 2; ++k) {
                    const double t = end + k * m_outline.period();
                    if (t > m_range.from() && t < m_range.to() && m_range.lengthTo(t) > shortestRest &&
                        whole - m_range.lengthTo(t) > shortestRest)
                        m_cuts.emplace(m_range.fraction(t), t);
                }
    }

    const BSpline2& m_outline;
    const Design& m_after;
    Stretch m_stretch;
    MatchedRange<2> m_range;
    const std::vector<OutlineArc>* m_arcs = nullptr;
    std::map<double, double> m_cuts;
};

/// 0, the cuts, 1; cuts that are almost the same count once.
std::vector<double> pieces(std::vector<double> cuts, double length)
{
    cuts.insert(cuts.end(), {0.0, 1.0});
    std::sort(cuts.begin(), cuts.end());
    const double least = length > 0 ? shortestRest / length : 0;
    std::vector<double> result = {0};
    for (const double cut : cuts)
        if (cut - result.back() > least && (1 - cut > least || cut == 1))
            result.push_back(cut);
    if (result.back() != 1)
        result.push_back(1);
    return result;
}

std::vector<double> piecesOf(const Side& side)
{
    std::vector<double> cuts;
    for (const auto& cut : side.cuts())
        cuts.push_back(cut.first);
    return pieces(std::move(cuts), side.length());
}

class Remap {
public:
    Remap(const Design& before, const OutlineArcs& arcs, EditBuilder& builder, std::vector<ElementId>& dropped)
        : m_before(before)
        , m_after(builder.now())
        , m_arcs(arcs)
        , m_builder(builder)
        , m_dropped(dropped)
    {}

    void seam(ElementId id, const Seam& seam)
    {
        if (!concerns(seam.a) && !concerns(seam.b))
            return;
        std::vector<Seam> kept;
        if (usable(seam.a) && usable(seam.b)) {
            const Side a(m_before, m_after, m_arcs, seam.a, seam.match);
            const Side b(m_before, m_after, m_arcs, seam.b, seam.match);
            const auto across = [&](double f) { return seam.reversed ? 1 - f : f; };
            std::vector<double> cuts;
            for (const auto& cut : a.cuts())
                cuts.push_back(cut.first);
            for (const auto& cut : b.cuts())
                cuts.push_back(across(cut.first));
            const std::vector<double> ends = pieces(std::move(cuts), std::max(a.length(), b.length()));
            for (std::size_t k = 0; k + 1 < ends.size(); ++k) {
                const auto [b0, b1] = std::minmax({across(ends[k]), across(ends[k + 1])});
                const auto onA = a.placed(ends[k], ends[k + 1]);
                const auto onB = b.placed(b0, b1);
                if (onA && onB)
                    kept.push_back(partOfSeam(seam, *onA, *onB, ends[k + 1] - ends[k]));
            }
        }
        put(id, std::move(kept));
    }

    void fixation(ElementId id, const FixationSeam& held)
    {
        if (!concerns(held.stretch))
            return;
        std::vector<FixationSeam> kept;
        const auto* curve = m_before.find<FixationCurve>(held.curve);
        if (usable(held.stretch) && (curve || !held.hasCurve())) {
            const Side side(m_before, m_after, m_arcs, held.stretch, held.match);
            const std::vector<double> ends = piecesOf(side);
            for (std::size_t k = 0; k + 1 < ends.size(); ++k)
                if (const auto placed = side.placed(ends[k], ends[k + 1]))
                    kept.push_back(partOfFixation(held, curve, side, *placed, ends[k], ends[k + 1]));
        }
        put(id, std::move(kept));
    }

    /// Trims and allowances of edges, and whatever lies at one place of an outline.
    template <PatchMark T>
    void mark(ElementId id, const T& mark)
    {
        std::vector<T> kept;
        const auto keep = [&](const auto& where) {
            kept.push_back(mark);
            whereOf(kept.back()) = where;
        };
        if constexpr (requires { mark.stretch; }) {
            if (!concerns(mark.stretch))
                return;
            if (usable(mark.stretch)) {
                const Side side(m_before, m_after, m_arcs, mark.stretch, Match::Length);
                const std::vector<double> ends = piecesOf(side);
                for (std::size_t k = 0; k + 1 < ends.size(); ++k)
                    if (const auto placed = side.placed(ends[k], ends[k + 1]))
                        keep(placed->stretch);
            }
            put(id, std::move(kept));
        } else if constexpr (requires { mark.place.at; }) {
            if (!m_arcs.contains(mark.place.patch))
                return;
            if (const auto place = placed(mark.place))
                keep(*place);
            put(id, std::move(kept));
        }
    }

private:
    bool concerns(const Stretch& stretch) const { return m_arcs.contains(stretch.patch); }

    bool usable(const Stretch& stretch) const
    {
        const Patch* patch = m_before.find<Patch>(stretch.patch);
        return patch && !patch->outline.empty() && std::isfinite(stretch.from) && std::isfinite(stretch.to);
    }

    std::optional<OutlinePlace> placed(const OutlinePlace& place) const
    {
        const Patch* patch = m_before.find<Patch>(place.patch);
        if (!patch || patch->outline.empty() || !std::isfinite(place.at))
            return std::nullopt;
        const double period = patch->outline.period(), slack = 1e-9 * period;
        for (const OutlineArc& arc : m_arcs.at(place.patch)) {
            const double ahead = place.at - arc.from - period * std::floor((place.at - arc.from + slack) / period);
            const BSpline2& outline = m_after.find<Patch>(arc.patch)->outline;
            if (ahead <= arc.to - arc.from + slack)
                return OutlinePlace{
                    arc.patch,
                    normalised(outline, arc.backwards ? arc.start - ahead : arc.start + ahead, outline.domainEnd())
                        .first};
        }
        return std::nullopt;
    }

    static Seam partOfSeam(const Seam& seam, const Placed& onA, const Placed& onB, double share)
    {
        Seam part = seam;
        part.a = onA.stretch;
        part.b = onB.stretch;
        part.reversed = (seam.reversed != onA.backwards) != onB.backwards;
        part.ease = seam.ease * share;
        return part;
    }

    static FixationSeam partOfFixation(const FixationSeam& held, const FixationCurve* curve, const Side& side,
                                       const Placed& placed, double f0, double f1)
    {
        FixationSeam part = held;
        part.stretch = placed.stretch;
        part.reversed = held.reversed != placed.backwards;
        const bool whole = f0 == 0 && f1 == 1;
        if (curve && !whole) {
            const BSpline3& c = curve->curve;
            const auto [from, to] = held.curveRange.value_or(std::pair(c.domainStart(), c.domainEnd()));
            const MatchedRange<3> range(c, from, to, held.match);
            const double g0 = held.reversed ? 1 - f1 : f0, g1 = held.reversed ? 1 - f0 : f1;
            part.curveRange = normalised(c, range.parameter(g0), range.parameter(g1));
        }
        if (!whole || placed.backwards)
            part.orientation = partOf(held.orientation, side.lengthFraction(placed.backwards ? f1 : f0),
                                      side.lengthFraction(placed.backwards ? f0 : f1));
        return part;
    }

    /// The first one takes the place of the old one.
    template <class T>
    void put(ElementId id, std::vector<T> kept)
    {
        if (kept.empty()) {
            m_builder.remove(id);
            m_dropped.push_back(id);
            return;
        }
        m_builder.replace(id, std::move(kept.front()));
        for (std::size_t k = 1; k < kept.size(); ++k)
            m_builder.add(std::move(kept[k]));
    }

    const Design& m_before;
    const Design m_after; // with the new outlines
    const OutlineArcs& m_arcs;
    EditBuilder& m_builder;
    std::vector<ElementId>& m_dropped;
};

} // namespace

void remapStretches(const Design& before, const OutlineArcs& arcs, const std::set<ElementId>& except,
                    EditBuilder& builder, std::vector<ElementId>& dropped)
{
    Remap remap(before, arcs, builder, dropped);
    before.each<Seam>([&](ElementId id, const Seam& seam) {
        if (!except.contains(id))
            remap.seam(id, seam);
    });
    before.each<FixationSeam>([&](ElementId id, const FixationSeam& held) {
        if (!except.contains(id))
            remap.fixation(id, held);
    });
    eachMarkKind([&]<class T>() {
        before.each<T>([&](ElementId id, const T& mark) {
            if (!except.contains(id))
                remap.mark(id, mark);
        });
    });
}

Orientation partOf(const Orientation& orientation, double from, double to)
{
    const std::size_t count = orientation.directions.size();
    if (count < 2)
        return orientation;
    Orientation part = orientation;
    for (std::size_t k = 0; k < count; ++k) {
        const double share = static_cast<double>(k) / static_cast<double>(count - 1);
        const double along = (1 - share) * from + share * to;
        const double once = to > 1.001 && along > 1 ? along - 1 : along;
        const Vec3 direction = orientation.at(std::clamp(once, 0.0, 1.0));
        if (direction.norm() > 0)
            part.directions[k] = direction;
    }
    return part;
}

} // namespace bolster::edits
