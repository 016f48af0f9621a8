#include "OutlineSampling.h"

#include "CurveDivision.h"
#include "FixationTargets.h"
#include "OutlineCuts.h"
#include "PatchLines.h"
#include "UnionFind.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

/// A polygon needs three edges.
int wantedEdges(const CutOutline& outline, int piece, double edgeLength)
{
    const auto [s0, s1] = outline.pieceLengths(piece);
    const int fewest = outline.pieceCount() == 1 ? 3 : outline.pieceCount() == 2 ? 2 : 1;
    return std::max(edgesOf(*outline.curve, outline.length, s0, s1, edgeLength), fewest);
}

/// Divides the pieces between cuts, those that belong together through seams alike.
class PieceDivider {
public:
    explicit PieceDivider(const OutlineCuts& cuts)
        : m_cuts(cuts)
    {
        m_firstPiece.push_back(0);
        for (const CutOutline& outline : cuts.outlines())
            m_firstPiece.push_back(m_firstPiece.back() + outline.pieceCount());
        m_links.resize(m_firstPiece.back());
        m_parameters.resize(m_firstPiece.back());
        for (const SeamSpans& seam : cuts.seams())
            linkPieces(seam);
    }

    void divide()
    {
        std::vector<char> seen(m_links.size(), 0);
        for (int piece = 0; piece < std::ssize(m_links); ++piece) {
            if (seen[piece])
                continue;
            const std::vector<int> group = linkedPieces(piece, seen);
            int edges = 1;
            for (int member : group) {
                const auto [outline, local] = ownerOf(member);
                edges = std::max(edges, wantedEdges(m_cuts.outlines()[outline], local, m_cuts.edgeLength()));
            }
            placeGroup(group, edges);
        }
    }

    /// The parameters of a piece's samples, both ends included.
    const std::vector<double>& parameters(int outline, int piece) const
    {
        return m_parameters[m_firstPiece[outline] + piece];
    }

private:
    struct Link {
        int piece = 0;
        bool reversed = false;
        Match match = Match::Length;
    };

    void linkPieces(const SeamSpans& seam)
    {
        const auto a = m_cuts.along(seam.a, seam.seam->match), b = m_cuts.along(seam.b, seam.seam->match);
        const std::size_t n = a.size() - 1;
        for (std::size_t k = 0; k < n; ++k) {
            const int first = m_firstPiece[seam.a.outline] + a[k].cut;
            const int second = m_firstPiece[seam.b.outline] + b[seam.seam->reversed ? n - 1 - k : k].cut;
            m_links[first].push_back({second, seam.seam->reversed, seam.seam->match});
            m_links[second].push_back({first, seam.seam->reversed, seam.seam->match});
        }
    }

    std::pair<int, int> ownerOf(int piece) const
    {
        const auto next = std::upper_bound(m_firstPiece.begin(), m_firstPiece.end(), piece);
        const int outline = static_cast<int>(next - m_firstPiece.begin()) - 1;
        return {outline, piece - m_firstPiece[outline]};
    }

    std::vector<int> linkedPieces(int first, std::vector<char>& seen) const
    {
        std::vector<int> group{first};
        seen[first] = 1;
        for (std::size_t k = 0; k < group.size(); ++k)
            for (const Link& link : m_links[group[k]])
                if (!seen[link.piece]) {
                    seen[link.piece] = 1;
                    group.push_back(link.piece);
                }
        return group;
    }

    /// The first piece evenly by arc length, the others through the seams.
    void placeGroup(const std::vector<int>& group, int edges)
    {
        const auto [index, local] = ownerOf(group.front());
        const CutOutline& outline = m_cuts.outlines()[index];
        const auto [s0, s1] = outline.pieceLengths(local);
        const auto [t0, t1] = outline.pieceParameters(local);
        std::vector<double>& even = m_parameters[group.front()];
        even.push_back(t0);
        for (int k = 1; k < edges; ++k)
            even.push_back(outline.length.parameterAt(s0 + (s1 - s0) * k / edges));
        even.push_back(t1);
        for (int piece : group)
            for (const Link& link : m_links[piece])
                if (m_parameters[link.piece].empty())
                    m_parameters[link.piece] = mapped(m_parameters[piece], piece, link);
    }

    std::vector<double> mapped(const std::vector<double>& from, int piece, const Link& link) const
    {
        const auto [fromOutline, fromLocal] = ownerOf(piece);
        const auto [toOutline, toLocal] = ownerOf(link.piece);
        const CutOutline &source = m_cuts.outlines()[fromOutline], &target = m_cuts.outlines()[toOutline];
        const auto [fs0, fs1] = source.pieceLengths(fromLocal);
        const auto [ts0, ts1] = target.pieceLengths(toLocal);
        const auto [tt0, tt1] = target.pieceParameters(toLocal);
        const bool byParameter = link.match == Match::Parameter;
        std::vector<double> result(from.size());
        for (std::size_t k = 0; k < from.size(); ++k) {
            double fraction = byParameter ? (from[k] - from.front()) / (from.back() - from.front())
                                          : (source.length.at(from[k]) - fs0) / (fs1 - fs0);
            if (link.reversed)
                fraction = 1 - fraction;
            result[link.reversed ? from.size() - 1 - k : k] =
                byParameter ? tt0 + fraction * (tt1 - tt0)
                            : target.length.parameterAt(ts0 + fraction * (ts1 - ts0));
        }
        result.front() = tt0;
        result.back() = tt1;
        return result;
    }

    const OutlineCuts& m_cuts;
    std::vector<int> m_firstPiece; // per outline, and one more
    std::vector<std::vector<Link>> m_links;
    std::vector<std::vector<double>> m_parameters;
};

/// Lines that end at an outline end at its samples.
void tieEnds(InnerLine& line, const std::vector<Vec2>& samples)
{
    if (line.startSample >= 0)
        line.points.front() = samples[line.startSample];
    if (line.endSample >= 0)
        line.points.back() = samples[line.endSample];
}

/// Turns divided pieces into samples, and stretches into chains of them.
class Chainer {
public:
    Chainer(const OutlineCuts& cuts, const PieceDivider& divider, OutlineSampling& result)
        : m_cuts(cuts)
        , m_result(result)
    {
        for (int o = 0; o < std::ssize(cuts.outlines()); ++o) {
            const CutOutline& outline = cuts.outlines()[o];
            OutlineSampling::Outline samples;
            samples.patch = outline.patch;
            m_firstSample.emplace_back();
            for (int piece = 0; piece < outline.pieceCount(); ++piece) {
                m_firstSample.back().push_back(static_cast<int>(samples.parameters.size()));
                const std::vector<double>& t = divider.parameters(o, piece);
                samples.parameters.insert(samples.parameters.end(), t.begin(), t.end() - 1);
            }
            for (double t : samples.parameters)
                samples.points.push_back(outline.curve->at(t));
            m_result.outlines.push_back(std::move(samples));
        }
    }

    void chainSeams()
    {
        std::vector<int> offset{0};
        for (const auto& outline : m_result.outlines)
            offset.push_back(offset.back() + static_cast<int>(outline.points.size()));
        UnionFind sewn(offset.back());
        for (const SeamSpans& seam : m_cuts.seams()) {
            OutlineSampling::SewnChain chain{seam.id, seam.a.outline, seam.b.outline, samplesAlong(seam.a),
                                             samplesAlong(seam.b)};
            if (seam.seam->reversed)
                std::reverse(chain.b.begin(), chain.b.end());
            for (std::size_t k = 0; k < chain.a.size(); ++k)
                sewn.join(offset[chain.outlineA] + chain.a[k], offset[chain.outlineB] + chain.b[k]);
            m_result.seams.push_back(std::move(chain));
        }
        const std::vector<int> cluster = sewn.labels(&m_result.clusterCount);
        for (int o = 0; o < std::ssize(m_result.outlines); ++o)
            m_result.outlines[o].cluster.assign(cluster.begin() + offset[o], cluster.begin() + offset[o + 1]);
    }

    void chainFixations()
    {
        for (const FixationSpan& fixation : m_cuts.fixations())
            m_result.fixations.push_back({fixation.id,
                                          fixation.fixation->curve,
                                          fixation.span.outline,
                                          -1,
                                          samplesAlong(fixation.span),
                                          {},
                                          {}});
        for (const FixationSpan& held : m_cuts.orientations())
            m_result.orientations.push_back({held.id, held.span.outline, -1, samplesAlong(held.span), {}});
    }

    void placeLines(const std::vector<PatchLine>& lines, const Design& design)
    {
        for (const PatchLine& line : lines) {
            const int o = m_cuts.outlineOf(line.patch);
            OutlineSampling::Outline& outline = m_result.outlines[o];
            InnerLine shape{line.points, line.closed, sampleAt(o, line.onOutline[0], line.reach),
                            sampleAt(o, line.onOutline[1], line.reach)};
            tieEnds(shape, outline.points);
            const int index = static_cast<int>(outline.lines.size());
            const auto* handle = design.find<HandleCurve>(line.element);
            if (handle && handle->hasTarget())
                m_result.handles.push_back({line.element, line.element, o, index, {}, {}, {}});
            if (handle && !handle->orientation.empty())
                m_result.orientations.push_back({line.element, o, index, {}, {}});
            outline.lines.push_back({line.element, std::move(shape), line.fractions, line.across});
        }
    }

private:
    int sampleAt(int outline, std::optional<double> t, double reach) const
    {
        if (!t)
            return -1;
        const CutOutline& cuts = m_cuts.outlines()[outline];
        return m_firstSample[outline][cuts.near(cuts.length.at(*t), reach)];
    }

    /// The samples of a stretch in increasing parameter, both ends included.
    std::vector<int> samplesAlong(const OutlineSpan& span) const
    {
        const auto along = m_cuts.along(span, Match::Length);
        const int count = static_cast<int>(m_result.outlines[span.outline].points.size());
        const int first = m_firstSample[span.outline][along.front().cut];
        int last = m_firstSample[span.outline][along.back().cut];
        if (last <= first)
            last += count;
        std::vector<int> samples;
        for (int k = first; k <= last; ++k)
            samples.push_back(k % count);
        return samples;
    }

    const OutlineCuts& m_cuts;
    OutlineSampling& m_result;
    std::vector<std::vector<int>> m_firstSample; // per outline and piece
};

std::vector<OutlineCuts::LineEnd> endsOf(const std::vector<PatchLine>& lines, const OutlineCuts& cuts)
{
    std::vector<OutlineCuts::LineEnd> ends;
    for (const PatchLine& line : lines)
        for (const std::optional<double>& t : line.onOutline)
            if (t)
                ends.push_back({cuts.outlineOf(line.patch), *t, line.reach});
    return ends;
}

/// Puts the points of lines drawn anew into their samplings. False when there are more or fewer of them.
bool redrawLines(OutlineSampling& sampling, const std::vector<PatchLine>& drawn)
{
    std::map<ElementId, std::size_t> known; // by patch: lines that have been met
    for (const PatchLine& line : drawn) {
        const auto outline =
            std::ranges::lower_bound(sampling.outlines, line.patch, {}, &OutlineSampling::Outline::patch);
        const std::size_t index = known[line.patch]++;
        if (index >= outline->lines.size())
            return false;
        OutlineSampling::Line& old = outline->lines[index];
        if (old.element != line.element || old.across != line.across || old.shape.closed != line.closed ||
            old.shape.points.size() != line.points.size() ||
            (old.shape.startSample >= 0) != line.onOutline[0].has_value() ||
            (old.shape.endSample >= 0) != line.onOutline[1].has_value())
            return false;
        old.shape.points = line.points;
        old.fractions = line.fractions;
        tieEnds(old.shape, outline->points);
    }
    return std::ranges::all_of(sampling.outlines,
                               [&](const auto& outline) { return known[outline.patch] == outline.lines.size(); });
}

} // namespace

bool resample(OutlineSampling& sampling, const Design& design)
{
    for (OutlineSampling::Outline& outline : sampling.outlines) {
        const BSpline2& curve = design.find<Patch>(outline.patch)->outline;
        std::ranges::transform(outline.parameters, outline.points.begin(), [&](double t) { return curve.at(t); });
    }
    const PatchLines lines = drawPatchLines(design);
    if (!lines.problems.empty() || !redrawLines(sampling, lines.lines))
        return false;
    retarget(sampling, design);
    return sampling.problems.empty();
}

OutlineSampling sampleOutlines(const Design& design)
{
    OutlineSampling sampling;
    PatchLines lines = drawPatchLines(design);
    if (!lines.problems.empty()) {
        sampling.problems = std::move(lines.problems);
        return sampling;
    }
    OutlineCuts cuts(design);
    sampling.problems = cuts.cut(endsOf(lines.lines, cuts));
    if (!sampling.problems.empty())
        return sampling;
    PieceDivider divider(cuts);
    divider.divide();
    Chainer chainer(cuts, divider, sampling);
    chainer.chainSeams();
    chainer.chainFixations();
    chainer.placeLines(lines.lines, design);
    aimFixations(sampling, cuts, design);
    return sampling;
}

} // namespace bolster
