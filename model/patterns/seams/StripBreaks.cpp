#include "StripBreaks.h"

#include <algorithm>
#include <cmath>
#include <optional>

namespace bolster {

namespace {

constexpr double rowDifference = 0.01; // of the strip's length
constexpr double stripRounding = 1;    // mm
constexpr double shortestPart = 8;     // mm
constexpr int mostInRow = 12;
constexpr std::ptrdiff_t mostRows = 2'000; // that one strip is compared with
constexpr double narrow = 3;               // times as long as wide

/// A row of edges that a strip could be sewn to.
struct Row {
    ElementId patch{};
    std::vector<double> shares; ///< of the strip's length, counter-clockwise along it, where its corners come
    bool notched = false;       ///< the strip has a notch at each of them
    bool unused = true;         ///< no other strip runs past that piece
    bool opposite = false;      ///< they are those of the strip's other edge
    bool whole = false;         ///< once around the piece

    auto rank() const { return std::tuple(notched, unused, opposite, whole, -static_cast<int>(shares.size())); }
};

bool close(const std::vector<double>& a, const std::vector<double>& b, double within)
{
    return std::ranges::equal(a, b, [within](double x, double y) { return std::abs(x - y) < within; });
}

class StripSearch {
public:
    StripSearch(const Design& design, const std::vector<OutlineEdge>& edges)
        : m_design(design)
        , m_edges(edges)
    {
        for (int first = 0; first < static_cast<int>(edges.size()); ++first)
            addLengths(first);
        std::ranges::sort(m_lengths);
    }

    EdgeBreaks run(const std::stop_token& stop)
    {
        std::vector<const OutlineEdge*> strips;
        for (const OutlineEdge& edge : m_edges)
            if (!edge.taken && edge.length > 2 * shortestPart)
                strips.push_back(&edge);
        std::ranges::stable_sort(strips, std::greater(), &OutlineEdge::length);
        for (const OutlineEdge* strip : strips) {
            if (stop.stop_requested())
                break;
            if (const std::optional<Row> row = bestRow(*strip, isNarrow(*strip) && isLone(*strip)))
                divide(*strip, *row);
        }
        return std::move(m_breaks);
    }

private:
    static double tolerance(double length) { return rowDifference * length + stripRounding; }

    bool isLone(const OutlineEdge& strip) const
    {
        return std::ranges::none_of(m_edges, [&](const OutlineEdge& other) {
            return !other.taken && other.stretch.patch != strip.stretch.patch &&
                   std::abs(other.length - strip.length) <= 2 * tolerance(strip.length);
        });
    }

    bool isNarrow(const OutlineEdge& strip) const
    {
        return strip.length > narrow * std::max(at(strip.next).length, at(strip.before).length);
    }

    /// Of all rows that begin with this edge and have more than one.
    void addLengths(int first)
    {
        double length = 0;
        int edge = first, count = 0;
        while (count < mostInRow && !at(edge).taken && at(edge).length >= shortestPart) {
            length += at(edge).length;
            if (++count > 1)
                m_lengths.emplace_back(length, first);
            edge = afterDarts(at(edge).next);
            if (edge == first)
                break;
        }
    }

    /// Their first edges, each once, in the order of all edges; not too many, however many are alike.
    std::vector<int> rowsAsLongAs(const OutlineEdge& strip) const
    {
        constexpr double rounding = 1e-6; // mm
        const double within = tolerance(strip.length) + rounding;
        const auto from = std::ranges::lower_bound(m_lengths, strip.length - within, {}, &RowLength::first);
        const auto to = std::ranges::upper_bound(m_lengths, strip.length + within, {}, &RowLength::first);
        std::vector<int> found;
        for (auto row = from; row != to && row - from < mostRows; ++row)
            found.push_back(row->second);
        std::ranges::sort(found);
        found.erase(std::unique(found.begin(), found.end()), found.end());
        return found;
    }

    std::optional<Row> bestRow(const OutlineEdge& strip, bool lone) const
    {
        std::optional<Row> best;
        for (const int first : rowsAsLongAs(strip)) {
            std::optional<Row> row = rowFrom(first, strip);
            if (!row || !(row->notched || (lone && row->whole)))
                continue;
            if (!best || row->rank() > best->rank())
                best = std::move(row);
        }
        return best;
    }

    /// The edges that follow one another counter-clockwise from this one, if they are as long as the strip. It runs
    /// past them clockwise.
    std::optional<Row> rowFrom(int first, const OutlineEdge& strip) const
    {
        const ElementId patch = at(first).stretch.patch;
        if (patch == strip.stretch.patch || strip.length < at(first).length)
            return std::nullopt;
        std::vector<double> ends; // of the edges, mm from the start
        double length = 0;
        int edge = first;
        do {
            if (at(edge).taken || at(edge).length < shortestPart)
                return std::nullopt;
            length += at(edge).length;
            ends.push_back(length);
            edge = afterDarts(at(edge).next);
        } while (edge != first && length < strip.length - tolerance(strip.length) &&
                 static_cast<int>(ends.size()) < mostInRow);
        if (ends.size() < 2 || std::abs(length - strip.length) > tolerance(strip.length))
            return std::nullopt;
        Row row;
        row.patch = patch;
        row.whole = edge == first;
        for (std::size_t i = ends.size() - 1; i-- > 0;)
            row.shares.push_back(1 - ends[i] / length);
        judge(row, strip);
        return row;
    }

    /// A dart in an edge is folded where a strip runs past it.
    int afterDarts(int edge) const
    {
        for (int count = 0; count < mostInRow && at(edge).partner >= 0 && at(edge).partner == at(edge).next;
             ++count)
            edge = at(at(edge).next).next;
        return edge;
    }

    void judge(Row& row, const OutlineEdge& strip) const
    {
        const double near = 0.005 + 3 / strip.length;
        row.notched = std::ranges::all_of(row.shares, [&](double share) {
            return std::ranges::any_of(strip.notches, [&](double notch) { return std::abs(notch - share) < near; });
        });
        for (const auto& [patch, divided] : m_rows) {
            row.unused = row.unused && divided.patch != row.patch;
            if (patch != strip.stretch.patch)
                continue;
            std::vector<double> mirrored;
            for (auto share = divided.shares.rbegin(); share != divided.shares.rend(); ++share)
                mirrored.push_back(1 - *share);
            row.opposite = row.opposite || close(row.shares, mirrored, 2 * near);
        }
    }

    void divide(const OutlineEdge& strip, const Row& row)
    {
        for (const double share : row.shares)
            m_breaks[strip.stretch.patch].push_back(placeOn(m_design, strip, share));
        m_rows.emplace_back(strip.stretch.patch, row);
    }

    using RowLength = std::pair<double, int>; // mm, the row's first edge

    const OutlineEdge& at(int edge) const { return m_edges[static_cast<std::size_t>(edge)]; }

    const Design& m_design;
    const std::vector<OutlineEdge>& m_edges;
    std::vector<RowLength> m_lengths;              ///< sorted
    std::vector<std::pair<ElementId, Row>> m_rows; ///< of the strips that are divided already, by their patches
    EdgeBreaks m_breaks;
};

} // namespace

EdgeBreaks stripBreaks(const Design& design, const std::vector<OutlineEdge>& edges, const std::stop_token& stop)
{
    return StripSearch(design, edges).run(stop);
}

} // namespace bolster
