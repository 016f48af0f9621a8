#include "NotchBreaks.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

constexpr std::size_t mostMarks = 24;       // of an edge: one with more is a ruler
constexpr std::size_t mostSections = 8'000; // of all edges
constexpr std::size_t mostMatches = 200'000;
constexpr double shortestSection = 30;      // mm
constexpr double sectionDifference = 0.008; // of its length
constexpr double sectionRounding = 1;       // mm
constexpr double sameMark = 2;              // mm

/// The part of an edge between two of its marks: its ends and its notches.
struct Section {
    int edge = 0;
    std::size_t from = 0, to = 0; ///< marks
    double length = 0;            ///< mm
    bool whole = false;
};

struct SectionPair {
    const Section* a = nullptr;
    const Section* b = nullptr;

    auto rank() const
    {
        // Edges that fit as they are, are not divided.
        return std::tuple(a->whole && b->whole, a->to - a->from, a->whole || b->whole,
                          -std::abs(a->length - b->length) / a->length);
    }
};

class NotchSearch {
public:
    NotchSearch(const Design& design, const std::vector<OutlineEdge>& edges, const std::vector<int>& chosen)
        : m_design(design)
        , m_edges(edges)
        , m_marks(edges.size())
        , m_broken(edges.size())
        , m_taken(edges.size())
    {
        for (const int edge : chosen)
            addSections(edge);
        std::ranges::stable_sort(m_sections, {}, &Section::length);
    }

    EdgeBreaks run(const std::stop_token& stop)
    {
        std::vector<SectionPair> matches = allMatches(stop);
        std::ranges::stable_sort(matches,
                                 [](const SectionPair& a, const SectionPair& b) { return a.rank() > b.rank(); });
        for (const SectionPair& match : matches)
            if (isFree(*match.a) && isFree(*match.b)) {
                take(*match.a);
                take(*match.b);
            }
        return std::move(m_breaks);
    }

private:
    void addSections(int edge)
    {
        const OutlineEdge& of = m_edges[index(edge)];
        std::vector<double>& marks = m_marks[index(edge)];
        if (of.notches.size() > mostMarks)
            return;
        marks.push_back(0);
        for (const double share : of.notches)
            if (share * of.length - marks.back() > sameMark)
                marks.push_back(share * of.length);
        marks.push_back(of.length);
        for (std::size_t from = 0; from < marks.size(); ++from)
            for (std::size_t to = from + 1; to < marks.size() && m_sections.size() < mostSections; ++to)
                if (const double length = marks[to] - marks[from]; length >= shortestSection)
                    m_sections.push_back({edge, from, to, length, from == 0 && to + 1 == marks.size()});
    }

    std::vector<SectionPair> allMatches(const std::stop_token& stop) const
    {
        std::vector<SectionPair> matches;
        for (std::size_t i = 0; i < m_sections.size() && !stop.stop_requested(); ++i)
            for (std::size_t k = i + 1; k < m_sections.size() && matches.size() < mostMatches; ++k) {
                const Section &a = m_sections[i], &b = m_sections[k];
                if (b.length - a.length > sectionDifference * b.length + sectionRounding)
                    break;
                if (fit(a, b))
                    matches.push_back({&a, &b});
            }
        return matches;
    }

    /// Sewn to each other, one of them is walked backwards.
    bool fit(const Section& a, const Section& b) const
    {
        const OutlineEdge &edgeA = m_edges[index(a.edge)], &edgeB = m_edges[index(b.edge)];
        if (edgeA.stretch.patch == edgeB.stretch.patch || a.to - a.from != b.to - b.from ||
            onOppositeSides(edgeA, edgeB))
            return false;
        const std::vector<double>&marksA = m_marks[index(a.edge)], &marksB = m_marks[index(b.edge)];
        for (std::size_t k = 1; k < a.to - a.from; ++k)
            if (std::abs((marksA[a.from + k] - marksA[a.from]) - (marksB[b.to] - marksB[b.to - k])) >
                sameMark + sectionDifference * b.length)
                return false;
        return true;
    }

    /// No other one reaches into it, nor does it end within another one.
    bool isFree(const Section& section) const
    {
        const auto overlaps = [&](const Section* other) {
            return other->from < section.to && section.from < other->to;
        };
        return std::ranges::none_of(m_taken[index(section.edge)], overlaps);
    }

    void take(const Section& section)
    {
        const OutlineEdge& edge = m_edges[index(section.edge)];
        const std::vector<double>& marks = m_marks[index(section.edge)];
        m_taken[index(section.edge)].push_back(&section);
        const bool round = edge.next == section.edge; // it ends where it begins, at no corner
        for (const std::size_t mark : {section.from, section.to})
            if ((round || (mark > 0 && mark + 1 < marks.size())) &&
                m_broken[index(section.edge)].insert(mark).second)
                m_breaks[edge.stretch.patch].push_back(placeOn(m_design, edge, marks[mark] / edge.length));
    }

    static std::size_t index(int edge) { return static_cast<std::size_t>(edge); }

    const Design& m_design;
    const std::vector<OutlineEdge>& m_edges;
    std::vector<Section> m_sections;
    // by edge:
    std::vector<std::vector<double>> m_marks;    ///< mm from its start, counter-clockwise
    std::vector<std::set<std::size_t>> m_broken; ///< marks that divide it
    std::vector<std::vector<const Section*>> m_taken;
    EdgeBreaks m_breaks;
};

} // namespace

EdgeBreaks notchBreaks(const Design& design, const std::vector<OutlineEdge>& edges, const std::vector<int>& chosen,
                       const std::stop_token& stop)
{
    return NotchSearch(design, edges, chosen).run(stop);
}

} // namespace bolster
