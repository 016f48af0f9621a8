#include "CutNotches.h"

#include "CornerWay.h"
#include "MatchedRange.h"
#include "OutlineSamples.h"
#include "SewnPair.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

namespace bolster {

namespace {

constexpr double sameNotch = 1;     // mm
constexpr double alikeSeams = 0.03; // of the length: seams that could be taken for one another
constexpr double shortestTold = 40; // mm: on shorter ones nobody goes wrong
constexpr double atCorner = 0.5;    // mm
/// Of the distance between two: a seam that is a multiple of it but for a little is meant as the multiple.
constexpr double spacingSlack = 0.01;
/// That the outline turns by: of less nobody sees where the seam begins.
constexpr double seenCorner = 25 * std::numbers::pi / 180;

double lengthAlong(const BSpline2& outline, double a, double b)
{
    return (outline.at(outline.wrapped(a)) - outline.at(outline.wrapped(b))).norm();
}

bool isCorner(const BSpline2& outline, double t)
{
    return std::ranges::any_of(outline.corners(), [&](double corner) {
        return lengthAlong(outline, corner, t) < atCorner && std::abs(turnAt(outline, corner)) > seenCorner;
    });
}

/// Places in squares as large as they must be apart: those that are too near lie in one or beside it.
class NearPlaces {
public:
    /// False when there is one nearer than sameNotch, and for what is no place.
    bool add(const Vec2& at)
    {
        constexpr double farthest = 1e12; // mm
        if (!(at.cwiseAbs().maxCoeff() < farthest))
            return false;
        const auto [x, y] = square(at);
        for (long long i = x - 1; i <= x + 1; ++i)
            for (long long k = y - 1; k <= y + 1; ++k)
                if (const auto there = m_squares.find({i, k}); there != m_squares.end())
                    for (const Vec2& other : there->second)
                        if ((other - at).norm() < sameNotch)
                            return false;
        m_squares[{x, y}].push_back(at);
        return true;
    }

private:
    static std::pair<long long, long long> square(const Vec2& at)
    {
        return {static_cast<long long>(std::floor(at.x() / sameNotch)),
                static_cast<long long>(std::floor(at.y() / sameNotch))};
    }

    std::map<std::pair<long long, long long>, std::vector<Vec2>> m_squares;
};

class Places {
public:
    Places(const Design& design, const AutomaticNotches& order, const std::stop_token& stop)
        : m_design(design)
        , m_order(order)
        , m_stop(stop)
    {
        design.each<Seam>([&](ElementId id, const Seam& seam) {
            SewnPair pair(design, seam);
            if (!pair.usable() || m_stop.stop_requested())
                return;
            m_seams.emplace(id, std::move(pair));
            m_seamsOf[seam.a.patch].push_back(id);
            if (seam.b.patch != seam.a.patch)
                m_seamsOf[seam.b.patch].push_back(id);
        });
    }

    std::map<ElementId, std::vector<NotchPlace>> result()
    {
        m_design.each<Notch>([&](ElementId id, const Notch& notch) { placed(id, notch); });
        for (const auto& [id, pair] : m_seams) {
            if (m_stop.stop_requested())
                return {};
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
        if (m_near[patch].add(outline.at(place.at)))
            m_places[patch].push_back(place);
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
        for (const ElementId id : m_seamsOf[where.patch])
            if (const auto fraction = m_seams.at(id).fractionAt(where)) {
                addPair(id, m_seams.at(id), *fraction, place);
                return true;
            }
        return false;
    }

    NotchPlace usual() const { return {0, m_order.shape}; }

    /// Where a side ends inside an edge, or at a corner that nobody sees.
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
        const double widest = (1 + spacingSlack) * m_order.spacing;
        const int parts = static_cast<int>(std::min(std::ceil(pair.length() / widest), 1000.0));
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
        for (const auto& [id, pair] : m_seams) {
            if (m_stop.stop_requested())
                return;
            if (pair.length() < shortestTold)
                continue;
            int before = 0;
            bool alike = false;
            std::set<ElementId> beside(m_seamsOf[pair.seam().a.patch].begin(),
                                       m_seamsOf[pair.seam().a.patch].end());
            beside.insert(m_seamsOf[pair.seam().b.patch].begin(), m_seamsOf[pair.seam().b.patch].end());
            for (const ElementId other : beside)
                if (other != id && pair.couldBe(m_seams.at(other), alikeSeams)) {
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
    const std::stop_token& m_stop;
    std::map<ElementId, SewnPair> m_seams;
    std::map<ElementId, std::vector<ElementId>> m_seamsOf; // by patch
    std::map<ElementId, NearPlaces> m_near;
    std::map<ElementId, std::vector<NotchPlace>> m_places;
};

} // namespace

std::map<ElementId, std::vector<NotchPlace>> notchPlaces(const Design& design, const AutomaticNotches& notches,
                                                         const std::stop_token& stop)
{
    return Places(design, notches, stop).result();
}

} // namespace bolster
