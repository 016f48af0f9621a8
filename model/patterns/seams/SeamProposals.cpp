#include "SeamProposals.h"

#include "DartLegs.h"
#include "FreeEdges.h"
#include "NotchBreaks.h"
#include "SeamEdits.h"
#include "StripBreaks.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>

namespace bolster {

namespace {

constexpr double mostDifference = 0.06; // of the longer edge's length
constexpr double usualDifference = 0.018;
constexpr double roundedLength = 1;        // mm
constexpr double shortestEdge = 8;         // mm
constexpr std::size_t mostCandidates = 16; // of an edge
constexpr std::size_t mostCompared = 600;  // that an edge is compared with, of those that are as long or longer
constexpr double leastFit = 0.05;
constexpr std::uint64_t searches = 12;
constexpr double leastCertain = 0.2;
constexpr double surelySewn = 0.5;
constexpr double certainDart = 0.97;

/// By the names alone: pieces of different sides are seldom sewn to each other.
double byWords(const OutlineEdge& a, const OutlineEdge& b)
{
    if (onOppositeSides(a, b))
        return 0.35;
    int common = 0;
    for (const std::string& word : a.words)
        common += b.words.contains(word);
    return common > 0 ? 1.0 : 0.88;
}

/// Notches meet when the edges are sewn, or tell that they don't.
double byNotches(const OutlineEdge& a, const OutlineEdge& b)
{
    if (a.notches.empty() && b.notches.empty())
        return 0.9;
    if (a.notches.size() != b.notches.size())
        return a.notches.empty() || b.notches.empty() ? 0.8 : 0.55;
    const double reach = 0.01 + 3 / std::max(a.length, b.length);
    for (std::size_t i = 0; i < a.notches.size(); ++i)
        if (std::abs(a.notches[i] - (1 - b.notches[b.notches.size() - 1 - i])) > reach)
            return 0.6;
    return 1;
}

/// What is up on one piece is up on the next: designers lay patterns out so, and cut seats, backs, borders so.
double byDirection(const OutlineEdge& a, const OutlineEdge& b)
{
    // b is walked backwards
    const double inLayout = std::min(0.0, -a.way.y() * b.way.y()),
                 along = std::min(0.0, -a.alongGrain * b.alongGrain);
    return (1 + 0.5 * inLayout) * (1 + 0.08 * along);
}

/// Pieces lie beside those that they are sewn to, in many a layout.
double byPlace(const OutlineEdge& a, const OutlineEdge& b)
{
    const bool facing = a.way.dot(b.way) < -0.8;
    return facing && (a.middle - b.middle).norm() < 0.35 * a.length + 80 ? 1.0 : 0.92;
}

/// A simple stream of numbers that is the same everywhere.
class Dice {
public:
    explicit Dice(std::uint64_t seed)
        : m_state(seed * 0x9E3779B97F4A7C15ull + 1)
    {}
    /// 0 to count - 1.
    std::size_t below(std::size_t count) { return static_cast<std::size_t>(next() >> 16) % count; }
    /// 0 to 1.
    double share() { return static_cast<double>(next() >> 11) / 9007199254740992.0; }

private:
    std::uint64_t next()
    {
        m_state ^= m_state << 13;
        m_state ^= m_state >> 7;
        m_state ^= m_state << 17;
        return m_state;
    }

    std::uint64_t m_state;
};

/// Which edges could be sewn to each other by what they are alone.
class Candidates {
public:
    struct Candidate {
        int other = 0;
        double fit = 0; ///< 0 to 1
    };

    Candidates(const std::vector<OutlineEdge>& edges, const std::stop_token& stop)
        : m_lists(edges.size())
    {
        std::vector<std::pair<double, int>> byLength;
        for (std::size_t i = 0; i < edges.size(); ++i)
            if (!edges[i].taken && edges[i].length >= shortestEdge)
                byLength.emplace_back(edges[i].length, static_cast<int>(i));
        std::ranges::sort(byLength);
        for (std::size_t k = 0; k < byLength.size() && !stop.stop_requested(); ++k)
            for (std::size_t l = k + 1; l < byLength.size() && l - k <= mostCompared; ++l) {
                const auto [length, i] = byLength[k];
                const auto [longer, j] = byLength[l];
                if (longer - length > mostDifference * longer + roundedLength)
                    break;
                if (const double value =
                        fit(edges[static_cast<std::size_t>(i)], edges[static_cast<std::size_t>(j)]);
                    value > leastFit) {
                    add(i, {j, value});
                    add(j, {i, value});
                }
            }
        for (std::vector<Candidate>& list : m_lists)
            shorten(list);
    }

    const std::vector<Candidate>& of(int edge) const { return m_lists[static_cast<std::size_t>(edge)]; }

private:
    static double fit(const OutlineEdge& a, const OutlineEdge& b)
    {
        const double longer = std::max(a.length, b.length), difference = std::abs(a.length - b.length);
        const double off = difference / (usualDifference * longer + roundedLength);
        const double value =
            std::exp(-off * off) * byWords(a, b) * byNotches(a, b) * byDirection(a, b) * byPlace(a, b);
        const double held = (a.fixed ? 0.85 : 1) * (b.fixed ? 0.85 : 1); // what is fixed to the frame needs no seam
        return held * (a.stretch.patch == b.stretch.patch ? 0.3 * value : value);
    }

    /// Only the best of each edge, so that large patterns are no matter of hours.
    void add(int i, const Candidate& candidate)
    {
        std::vector<Candidate>& list = m_lists[static_cast<std::size_t>(i)];
        list.push_back(candidate);
        if (list.size() > 2 * mostCandidates)
            shorten(list);
    }
    static void shorten(std::vector<Candidate>& list)
    {
        std::ranges::stable_sort(list, std::greater(), &Candidate::fit);
        if (list.size() > mostCandidates)
            list.resize(mostCandidates);
    }

    std::vector<std::vector<Candidate>> m_lists;
};

/// A choice of partners for all edges, and how good a cover it would make: many edges sewn to what fits them, and
/// corners at which three or four pieces come together.
class Sewing {
public:
    explicit Sewing(const std::vector<OutlineEdge>& edges)
        : m_edges(edges)
    {
        for (const OutlineEdge& edge : edges) {
            m_partner.push_back(edge.partner);
            m_fit.push_back(edge.partner >= 0 ? 1 : 0);
        }
    }

    int partner(int edge) const { return m_partner[static_cast<std::size_t>(edge)]; }
    double fit(int edge) const { return m_fit[static_cast<std::size_t>(edge)]; }
    void join(int a, int b, double fit)
    {
        set(a, b, fit);
        set(b, a, fit);
    }
    void part(int edge)
    {
        if (const int other = partner(edge); other >= 0)
            set(other, -1, 0);
        set(edge, -1, 0);
    }

    struct Ring {
        double value = 0; ///< the more the better; 0 of an open one: a hem, or not sewn yet
        int corner = 0;   ///< the first of its corners, which are called by the edges that begin there
        int count = 1;
    };
    /// All pieces that come together where an edge begins.
    Ring ring(int edge) const
    {
        constexpr int largestRing = 7;
        constexpr double byCount[largestRing + 1] = {0, -0.6, 0.9, 1.8, 1.5, 0.3, -1.8, -4};
        Ring found{0, edge, 0};
        int at = edge;
        double angles = 0;
        bool straight = false; // an edge is divided there
        do {
            const double angle = m_edges[static_cast<std::size_t>(at)].corner;
            angles += angle;
            straight = straight || std::abs(angle - 180) < straightWithin;
            found.corner = std::min(found.corner, at);
            const int across = partner(at);
            if (across < 0)
                return {0, edge, 1};
            at = m_edges[static_cast<std::size_t>(across)].next;
        } while (++found.count < largestRing && at != edge);
        if (at != edge)
            found.value = byCount[largestRing];
        else if (found.count == 2 && straight && angles < mostPastCorner)
            found.value = byCount[3]; // a strip that runs past a corner, as three pieces that meet
        else
            found.value = byCount[found.count] - (angles > mostAngle ? 1.5 : 0);
        return found;
    }

    /// What these edges and the corners at their ends add.
    double around(std::span<const int> edges) const
    {
        double sum = 0;
        std::array<int, 16> seen{};
        std::size_t rings = 0;
        for (const int edge : edges) {
            if (edge < 0)
                continue;
            sum += partner(edge) < 0 ? 0 : forSewing + forFit * fit(edge);
            for (const int corner : {edge, m_edges[static_cast<std::size_t>(edge)].next}) {
                const Ring found = ring(corner);
                if (std::find(seen.begin(), seen.begin() + static_cast<std::ptrdiff_t>(rings), found.corner) !=
                    seen.begin() + static_cast<std::ptrdiff_t>(rings))
                    continue;
                seen[rings++] = found.corner;
                sum += found.value;
            }
        }
        return sum;
    }

    double total() const
    {
        double sum = 0;
        for (int i = 0; i < static_cast<int>(m_edges.size()); ++i) {
            const Ring found = ring(i);
            sum += found.value / found.count + (partner(i) < 0 ? 0 : forSewing + forFit * fit(i));
        }
        return sum;
    }

    /// How well a sewn edge sits between its neighbours, 0 to 1.
    double settled(int edge) const
    {
        const auto closed = [&](int at) { return std::clamp(0.4 + 0.35 * ring(at).value, 0.1, 1.0); };
        return fit(edge) * closed(edge) * closed(m_edges[static_cast<std::size_t>(edge)].next);
    }

private:
    static constexpr double forSewing = 0.1;
    static constexpr double forFit = 1;
    static constexpr double mostAngle = 410; // degrees, of all pieces that meet at a corner
    static constexpr double straightWithin = 10;
    static constexpr double mostPastCorner = 320;

    void set(int edge, int other, double fit)
    {
        m_partner[static_cast<std::size_t>(edge)] = other;
        m_fit[static_cast<std::size_t>(edge)] = fit;
    }

    const std::vector<OutlineEdge>& m_edges;
    std::vector<int> m_partner;
    std::vector<double> m_fit;
};

/// Simulated annealing: partners are changed at random, and what makes the cover worse is kept less and less often.
class SewingSearch {
public:
    SewingSearch(const std::vector<OutlineEdge>& edges, const Candidates& candidates, std::uint64_t seed)
        : m_edges(edges)
        , m_candidates(candidates)
        , m_dice(seed)
        , m_sewing(edges)
    {
        for (int i = 0; i < static_cast<int>(edges.size()); ++i)
            if (!candidates.of(i).empty())
                m_free.push_back(i);
    }

    Sewing run(const std::stop_token& stop)
    {
        const std::size_t steps = std::min<std::size_t>(m_free.size() * stepsPerEdge, mostSteps);
        for (std::size_t k = 0; k < steps; ++k) {
            if (k % 1024 == 0 && stop.stop_requested())
                break;
            step(hottest * std::pow(coldest / hottest, static_cast<double>(k) / static_cast<double>(steps)));
        }
        return m_sewing;
    }

private:
    static constexpr std::size_t stepsPerEdge = 2000;
    static constexpr std::size_t mostSteps = 400'000;
    static constexpr double hottest = 1.2;
    static constexpr double coldest = 0.03;

    void step(double heat)
    {
        const int a = m_free[m_dice.below(m_free.size())];
        const auto& list = m_candidates.of(a);
        const Candidates::Candidate& candidate = list[m_dice.below(list.size())];
        const int b = candidate.other, formerA = m_sewing.partner(a), formerB = m_sewing.partner(b);
        const double fitA = m_sewing.fit(a), fitB = m_sewing.fit(b);
        const std::array touched{a, b, formerA, formerB};
        const double before = m_sewing.around(touched);
        const bool apart = formerA == b; // else they are sewn
        m_sewing.part(a);
        m_sewing.part(b);
        if (!apart) {
            m_sewing.join(a, b, candidate.fit);
            if (formerA >= 0 && formerB >= 0)
                joinIfTheyFit(formerA, formerB);
        }
        const double change = m_sewing.around(touched) - before;
        if (change >= 0 || m_dice.share() < std::exp(change / heat))
            return;
        m_sewing.part(a);
        m_sewing.part(b);
        for (const int edge : {formerA, formerB})
            if (edge >= 0)
                m_sewing.part(edge);
        if (formerA >= 0)
            m_sewing.join(a, formerA, fitA);
        if (formerB >= 0)
            m_sewing.join(b, formerB, fitB);
    }

    void joinIfTheyFit(int a, int b)
    {
        for (const Candidates::Candidate& candidate : m_candidates.of(a))
            if (candidate.other == b)
                m_sewing.join(a, b, candidate.fit);
    }

    const std::vector<OutlineEdge>& m_edges;
    const Candidates& m_candidates;
    Dice m_dice;
    Sewing m_sewing;
    std::vector<int> m_free;
};

SeamProposal proposalOf(const OutlineEdge& a, const OutlineEdge& b, double certainty, bool dart = false)
{
    return {a.stretch, b.stretch, a.backwards == b.backwards, a.length, b.length, certainty, dart};
}

/// Legs of darts are as good as sewn: the rest is looked at as if they were. Gives their seams.
std::vector<SeamProposal> sewDarts(const Design& design, std::vector<OutlineEdge>& edges)
{
    std::vector<SeamProposal> found;
    for (const DartLegs& dart : dartLegs(design, edges)) {
        OutlineEdge &a = edges[static_cast<std::size_t>(dart.first)],
                    &b = edges[static_cast<std::size_t>(dart.second)];
        if (a.taken || b.taken)
            continue;
        found.push_back(proposalOf(a, b, certainDart * dart.fit, true));
        a.taken = b.taken = true;
        a.partner = dart.second;
        b.partner = dart.first;
    }
    return found;
}

/// What the edges are sewn to, and how certain that is, 0 to 1.
struct Search {
    std::vector<int> partner; ///< -1: none
    std::vector<double> certainty;
};

std::optional<Search> search(const std::vector<OutlineEdge>& edges, const std::stop_token& stop)
{
    const Candidates candidates(edges, stop);
    std::vector<Sewing> tries;
    for (std::uint64_t seed = 1; seed <= searches && !stop.stop_requested(); ++seed)
        tries.push_back(SewingSearch(edges, candidates, seed).run(stop));
    if (stop.stop_requested())
        return std::nullopt;
    const Sewing& best = *std::ranges::max_element(tries, {}, &Sewing::total);
    Search found{{}, std::vector<double>(edges.size())};
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
        const int k = best.partner(i);
        found.partner.push_back(k);
        if (k < 0)
            continue;
        const auto agree = std::ranges::count_if(tries, [&](const Sewing& other) { return other.partner(i) == k; });
        found.certainty[static_cast<std::size_t>(i)] =
            best.settled(i) * (0.2 + 0.8 * static_cast<double>(agree) / searches);
    }
    return found;
}

/// Where edges that found nothing are divided by their notches.
EdgeBreaks leftBreaks(const Design& design, const std::vector<OutlineEdge>& edges, const Search& found,
                      const std::stop_token& stop)
{
    std::vector<int> left;
    for (std::size_t i = 0; i < edges.size(); ++i)
        if (!edges[i].taken && found.certainty[i] < surelySewn)
            left.push_back(static_cast<int>(i));
    return notchBreaks(design, edges, left, stop);
}

} // namespace

std::vector<SeamProposal> proposeSeams(const Design& design, const std::stop_token& stop)
{
    std::vector<OutlineEdge> edges = outlineEdges(design);
    std::vector<SeamProposal> proposals = sewDarts(design, edges);
    const auto divide = [&](const EdgeBreaks& breaks) {
        edges = outlineEdges(design, breaks);
        proposals = sewDarts(design, edges);
    };
    EdgeBreaks breaks = stripBreaks(design, edges, stop);
    if (!breaks.empty())
        divide(breaks);
    std::optional<Search> found = search(edges, stop);
    if (!found)
        return {};
    if (const EdgeBreaks more = leftBreaks(design, edges, *found, stop); !more.empty()) {
        for (const auto& [patch, places] : more)
            breaks[patch].insert(breaks[patch].end(), places.begin(), places.end());
        divide(breaks);
        found = search(edges, stop);
    }
    if (!found)
        return {};
    for (int i = 0; i < static_cast<int>(edges.size()); ++i) {
        const int k = found->partner[static_cast<std::size_t>(i)];
        if (const OutlineEdge& edge = edges[static_cast<std::size_t>(i)];
            k > i && !edge.taken && found->certainty[static_cast<std::size_t>(i)] >= leastCertain)
            proposals.push_back(proposalOf(edge, edges[static_cast<std::size_t>(k)],
                                           found->certainty[static_cast<std::size_t>(i)]));
    }
    std::ranges::stable_sort(proposals, std::greater(), &SeamProposal::certainty);
    return proposals;
}

namespace {

Design withSmoothSeam(const Design& design, ElementId id)
{
    Seam seam = *design.find<Seam>(id);
    seam.continuity = Continuity::C1;
    return design.with({{}, {{id, nullptr, makeElement(std::move(seam))}}});
}

} // namespace

Edit sewProposals(const Design& design, const std::vector<SeamProposal>& proposals)
{
    Design sewn = design;
    int count = 0;
    for (const SeamProposal& proposal : proposals) {
        const Edit seam = edits::addSeam(sewn, proposal.a, proposal.b, proposal.reversed);
        if (seam.empty())
            continue;
        sewn = sewn.with(seam);
        if (proposal.dart)
            sewn = withSmoothSeam(sewn, seam.changes.front().id);
        ++count;
    }
    if (count == 1)
        return editBetween(design, sewn, {QT_TRANSLATE_NOOP("Message", "Sew a proposed seam"), {}});
    return editBetween(design, sewn,
                       {QT_TRANSLATE_NOOP("Message", "Sew %1 proposed seams"), {std::to_string(count)}});
}

} // namespace bolster
