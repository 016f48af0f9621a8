#include "CutNotches.h"

#include "MatchedRange.h"
#include "OutlineSamples.h"
#include "SewnPair.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr double sameNotch = 1;     // mm
constexpr double alikeSeams = 0.03; // of the length: seams that could be taken for one another
constexpr double shortestTold = 40; // mm: on shorter ones nobody goes wrong
constexpr double atCorner = 0.5;    // mm

double lengthAlong(const BSpline2& outline, double a, double b)
{
    return (outline.at(outline.wrapped(a)) - outline.at(outline.wrapped(b))).norm();
}

bool isCorner(const BSpline2& outline, double t)
{
    return std::ranges::any_of(outline.corners(),
                               [&](double corner) { return lengthAlong(outline, corner, t) < atCorner; });
}

class Places {
public:
    Places(const Design& design, const AutomaticNotches& order)
        : m_design(design)
        , m_order(order)
    {
        design.each<Seam>([&](ElementId id, const Seam& seam) {
            if (SewnPair pair(design, seam); pair.usable())
                m_seams.emplace(id, std::move(pair));
        });
    }

    std::map<ElementId, std::vector<NotchPlace>> result()
    {
        m_design.each<Notch>([&](ElementId id, const Notch& notch) { placed(id, notch); });
        for (const auto& [id, pair] : m_seams) {
            if (m_order.ends)
                ends(id, pair);
            spaced(id, pair);
        }
        if (m_order.ends)
            m_design.each<FancySeam>([&](ElementId, const FancySeam& fancy) { fancyEnds(fancy); });
        if (m_order.telling)
            tell();
        for (auto& [patch, places] : m_places)
            std::ranges::stable_sort(places, {}, &NotchPlace::at);
        return std::move(m_places);
    }

private:
    void add(ElementId patch, NotchPlace place)
    {
        const BSpline2& outline = m_design.find<Patch>(patch)->outline;
        place.at = outline.wrapped(place.at);
        std::vector<NotchPlace>& there = m_places[patch];
        if (std::ranges::none_of(there, [&](const NotchPlace& other) {
                return lengthAlong(outline, other.at, place.at) < sameNotch;
            }))
            there.push_back(place);
    }

    /// On both sides of a seam, where they meet.
    void addPair(ElementId id, const SewnPair& pair, double fraction, NotchPlace place)
    {
        place.seam = id;
        place.fraction = fraction;
        place.at = pair.onA(fraction);
        add(pair.seam().a.patch, place);
        place.at = pair.onB(fraction);
        add(pair.seam().b.patch, place);
    }

    void placed(ElementId id, const Notch& notch)
    {
        const Patch* patch = m_design.find<Patch>(notch.place.patch);
        if (!patch || patch->outline.empty())
            return;
        const NotchPlace place{notch.place.at, notch.shape, notch.twice, id};
        if (!onSeam(notch.place, place))
            add(notch.place.patch, place);
    }

    /// Adds both sides if the place is on a seam.
    bool onSeam(const OutlinePlace& where, const NotchPlace& place)
    {
        for (const auto& [id, pair] : m_seams)
            if (const auto fraction = pair.fractionAt(where)) {
                addPair(id, pair, *fraction, place);
                return true;
            }
        return false;
    }

    NotchPlace usual() const { return {0, m_order.shape}; }

    /// Where a side ends inside an edge.
    void ends(ElementId id, const SewnPair& pair)
    {
        for (const double fraction : {0.0, 1.0}) {
            const bool a = isCorner(pair.outlineA(), pair.onA(fraction));
            const bool b = isCorner(pair.outlineB(), pair.onB(fraction));
            if (!a || !b)
                addPair(id, pair, fraction, usual());
        }
    }

    void spaced(ElementId id, const SewnPair& pair)
    {
        if (!(m_order.spacing > 0))
            return;
        const int parts = static_cast<int>(std::min(std::ceil(pair.length() / m_order.spacing), 1000.0));
        for (int k = 1; k < parts; ++k)
            addPair(id, pair, static_cast<double>(k) / parts, usual());
    }

    void fancyEnds(const FancySeam& fancy)
    {
        const Patch* patch = m_design.find<Patch>(fancy.patch);
        if (!patch || patch->outline.empty() || fancy.curve.empty() || fancy.curve.closed())
            return;
        for (const double t : {fancy.curve.domainStart(), fancy.curve.domainEnd()}) {
            const BSpline2::Closest closest = patch->outline.closest(fancy.curve.at(t));
            const OutlinePlace where{fancy.patch, closest.parameter};
            NotchPlace place = usual();
            place.at = where.at;
            if (closest.distance < atCorner && !onSeam(where, place))
                add(fancy.patch, place);
        }
    }

    /// Seams of a patch that are as long as another one's could be taken for one another, and a side that is its
    /// own mirror image be turned round: one notch off the middle, two for the next such seam, further out for
    /// more.
    void tell()
    {
        std::vector<ElementId> told;
        for (const auto& [id, pair] : m_seams) {
            if (pair.length() < shortestTold)
                continue;
            int before = 0;
            bool alike = false;
            for (const auto& [other, there] : m_seams)
                if (other != id && pair.couldBe(there, alikeSeams)) {
                    alike = true;
                    before += other < id;
                }
            if (!alike && !pair.couldBeTurned(alikeSeams))
                continue;
            NotchPlace place = usual();
            place.twice = before % 2 == 1;
            addPair(id, pair, std::max(0.4 - 0.08 * (before / 2), 0.05), place);
        }
    }

    const Design& m_design;
    const AutomaticNotches& m_order;
    std::map<ElementId, SewnPair> m_seams;
    std::map<ElementId, std::vector<NotchPlace>> m_places;
};

} // namespace

std::map<ElementId, std::vector<NotchPlace>> notchPlaces(const Design& design, const AutomaticNotches& notches)
{
    return Places(design, notches).result();
}

} // namespace bolster
