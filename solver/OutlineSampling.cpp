#include "OutlineSampling.h"

#include "ArcLength.h"
#include "UnionFind.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

namespace bolster {

namespace {

// Two cuts nearer than this fraction of the edge length count as one: a shorter edge would spoil the triangles.
constexpr double snap = 0.25;
// An edge may be this much shorter than asked for where the outline bends sharply.
constexpr double shortestEdge = 0.4;
constexpr double largestTurnPerEdge = std::numbers::pi / 6;
// Cuts that seams carry round for ever without closing stop here.
constexpr int largestCutCount = 20000;
constexpr double conflictDistance = 0.01; // mm, from the issue of one vertex held in two places

struct Cut {
    double s = 0; // arc length from the domain's start, in [0, total)
    double t = 0;
};

/// An outline with its cuts, by increasing arc length.
struct CutOutline {
    ElementId patch{};
    const BSpline2* curve = nullptr;
    ArcLength2 length;
    std::vector<Cut> cuts;
    std::vector<int> firstSample; // per piece, filled at the end

    CutOutline(ElementId id, const BSpline2& outline)
        : patch(id)
        , curve(&outline)
        , length(outline)
    {}

    double total() const { return length.total(); }
    double wrap(double s) const
    {
        const double wrapped = s - std::floor(s / total()) * total();
        return wrapped < total() ? wrapped : 0;
    }
    double distance(double s, double other) const
    {
        const double d = std::abs(wrap(s) - wrap(other));
        return std::min(d, total() - d);
    }
    /// The nearest cut within the tolerance (mm), or -1.
    int near(double s, double tolerance) const
    {
        int best = -1;
        for (int i = 0; i < std::ssize(cuts); ++i) {
            const double d = distance(s, cuts[i].s);
            if (d <= tolerance) {
                tolerance = d;
                best = i;
            }
        }
        return best;
    }
    /// Adds a cut unless one lies there. Returns whether it did.
    bool add(double t, double tolerance)
    {
        t = curve->wrapped(t);
        const double s = wrap(length.at(t));
        if (near(s, tolerance) >= 0)
            return false;
        const auto at =
            std::lower_bound(cuts.begin(), cuts.end(), s, [](const Cut& c, double v) { return c.s < v; });
        cuts.insert(at, {s, t});
        return true;
    }
};

/// A stretch in unwrapped arc length and parameter.
struct Span {
    int outline = 0;
    double t0 = 0, t1 = 0;
    double s0 = 0, s1 = 0;
};

/// One cut of a stretch, with its place along it.
struct Along {
    int cut = 0;
    double fraction = 0; // by arc length or by parameter, from the start in walking direction
};

struct SeamSpans {
    ElementId id{};
    const Seam* seam = nullptr;
    Span a, b;
};

class Sampler {
public:
    explicit Sampler(const Design& design)
        : m_design(design)
        , m_edge(design.settings().edgeLength)
    {}

    OutlineSampling run()
    {
        collectOutlines();
        collectSpans();
        cutAtCornersAndEnds();
        if (carryCutsAcrossSeams() && pairPieces()) {
            placeSamples();
            chainSeams();
            chainFixations();
        }
        return std::move(m_result);
    }

private:
    void collectOutlines()
    {
        m_design.each<Patch>([&](ElementId id, const Patch& patch) {
            m_index[id] = static_cast<int>(m_outlines.size());
            m_outlines.emplace_back(id, patch.outline);
        });
    }

    Span span(const Stretch& stretch) const
    {
        Span span;
        span.outline = m_index.at(stretch.patch);
        const CutOutline& outline = m_outlines[span.outline];
        const double start = outline.curve->domainStart(), end = outline.curve->domainEnd();
        span.t0 = stretch.from;
        span.t1 = unwrappedEnd(stretch.from, stretch.to, start, end);
        span.s0 = outline.length.at(span.t0);
        span.s1 = outline.length.at(span.t1);
        return span;
    }

    void collectSpans()
    {
        m_design.each<Seam>([&](ElementId id, const Seam& seam) {
            m_seams.push_back({id, &seam, span(seam.a), span(seam.b)});
        });
        m_design.each<FixationSeam>([&](ElementId id, const FixationSeam& fixation) {
            m_fixations.push_back({id, &fixation, span(fixation.stretch)});
        });
    }

    void cutAtCornersAndEnds()
    {
        const double tiny = 1e-6 * m_edge;
        auto ends = [&](const Span& span) {
            m_outlines[span.outline].add(span.t0, tiny);
            m_outlines[span.outline].add(span.t1, tiny);
        };
        for (const SeamSpans& seam : m_seams) {
            ends(seam.a);
            ends(seam.b);
        }
        for (const auto& fixation : m_fixations)
            ends(fixation.span);
        for (CutOutline& outline : m_outlines) {
            for (double t : outline.curve->corners())
                outline.add(t, tiny);
            if (outline.cuts.empty())
                outline.add(outline.curve->domainStart(), tiny);
        }
        for (const auto& fixation : m_fixations)
            cutAtCurveCorners(fixation);
    }

    /// A corner of a fixation curve wants a vertex, or the cover would cut it off.
    template <class Fixation>
    void cutAtCurveCorners(const Fixation& fixation)
    {
        const CurveSpan curve = curveSpan(*fixation.fixation);
        const double period = curve.curve->closed() ? curve.curve->period() : 0;
        for (double corner : curve.curve->corners()) {
            while (period > 0 && corner < curve.t0)
                corner += period;
            if (corner <= curve.t0 || corner >= curve.t1)
                continue;
            double fraction = curve.fractionOf(corner, fixation.fixation->match);
            if (fixation.fixation->reversed)
                fraction = 1 - fraction;
            m_outlines[fixation.span.outline].add(parameterAt(fixation.span, fraction, fixation.fixation->match),
                                                  snap * m_edge);
        }
    }

    double parameterAt(const Span& span, double fraction, Match match) const
    {
        if (match == Match::Parameter)
            return span.t0 + fraction * (span.t1 - span.t0);
        return m_outlines[span.outline].length.parameterAt(span.s0 + fraction * (span.s1 - span.s0));
    }

    /// The cuts of a stretch in increasing parameter, both ends included.
    std::vector<Along> cutsAlong(const Span& span, Match match) const
    {
        const CutOutline& outline = m_outlines[span.outline];
        const double period = outline.curve->period();
        const int first = outline.near(span.s0, 1e-5 * m_edge);
        std::vector<Along> along{{first, 0.0}};
        const int n = static_cast<int>(outline.cuts.size());
        for (int k = 1; k <= n; ++k) {
            const Cut& cut = outline.cuts[(first + k) % n];
            double s = cut.s, t = cut.t;
            while (s <= span.s0 + 1e-5 * m_edge) {
                s += outline.total();
                t += period;
            }
            if (s >= span.s1 - 1e-5 * m_edge)
                break;
            const double fraction = match == Match::Parameter ? (t - span.t0) / (span.t1 - span.t0)
                                                              : (s - span.s0) / (span.s1 - span.s0);
            along.push_back({(first + k) % n, fraction});
        }
        along.push_back({outline.near(span.s1, 1e-5 * m_edge), 1.0});
        return along;
    }

    /// The same walked backwards.
    static void reverse(std::vector<Along>& along)
    {
        std::reverse(along.begin(), along.end());
        for (Along& a : along)
            a.fraction = 1 - a.fraction;
    }

    /// Adds to `to` the cuts that only `from` has. Cuts that lie close together are a pair already.
    bool carry(const std::vector<Along>& from, const std::vector<Along>& to, const Span& target, bool reversed,
               Match match)
    {
        const double length = target.s1 - target.s0;
        bool added = false;
        std::vector<double> missing;
        std::size_t next = 1; // each cut of `to` pairs with one of `from` only
        for (std::size_t k = 1; k + 1 < from.size(); ++k) {
            while (next + 1 < to.size() && to[next].fraction * length < from[k].fraction * length - snap * m_edge)
                ++next;
            const bool paired =
                next + 1 < to.size() && std::abs(to[next].fraction - from[k].fraction) * length <= snap * m_edge;
            if (paired)
                ++next;
            else
                missing.push_back(from[k].fraction);
        }
        for (double fraction : missing)
            added |= m_outlines[target.outline].add(parameterAt(target, reversed ? 1 - fraction : fraction, match),
                                                    1e-5 * m_edge);
        return added;
    }

    bool carryCutsAcrossSeams()
    {
        for (bool changed = true; changed;) {
            changed = false;
            for (const SeamSpans& seam : m_seams) {
                const Match match = seam.seam->match;
                for (bool forward : {true, false}) {
                    std::vector<Along> a = cutsAlong(seam.a, match);
                    std::vector<Along> b = cutsAlong(seam.b, match);
                    if (seam.seam->reversed)
                        reverse(b);
                    changed |= forward ? carry(a, b, seam.b, seam.seam->reversed, match)
                                       : carry(b, a, seam.a, false, match);
                }
                const CutOutline& a = m_outlines[seam.a.outline];
                if (std::ssize(a.cuts) > largestCutCount) {
                    report(
                        seam.id, "a",
                        QT_TRANSLATE_NOOP(
                            "Message",
                            "this seam and its neighbours carry their ends round in a circle without ever meeting. "
                            "Let the seams of this circle end at common points."));
                    return false;
                }
            }
        }
        return true;
    }

    /// Each seam pairs its pieces; paired pieces get the same number of edges.
    bool pairPieces()
    {
        m_firstPiece.assign(1, 0);
        for (const CutOutline& outline : m_outlines)
            m_firstPiece.push_back(m_firstPiece.back() + static_cast<int>(outline.cuts.size()));
        m_links.resize(m_firstPiece.back());
        for (const SeamSpans& seam : m_seams) {
            std::vector<Along> a = cutsAlong(seam.a, seam.seam->match);
            std::vector<Along> b = cutsAlong(seam.b, seam.seam->match);
            if (a.size() != b.size()) {
                report(
                    seam.id, "b",
                    QT_TRANSLATE_NOOP(
                        "Message",
                        "the corners of the two stretches lie too close together to be matched. Move them apart or "
                        "choose a smaller edge length."));
                return false;
            }
            const int n = static_cast<int>(a.size()) - 1;
            for (int k = 0; k < n; ++k) {
                const int mate = seam.seam->reversed ? n - 1 - k : k;
                link(m_firstPiece[seam.a.outline] + a[k].cut, m_firstPiece[seam.b.outline] + b[mate].cut,
                     seam.seam->reversed, seam.seam->match);
            }
        }
        return true;
    }

    struct Link {
        int piece = 0;
        bool reversed = false;
        Match match = Match::Length;
    };

    void link(int a, int b, bool reversed, Match match)
    {
        m_links[a].push_back({b, reversed, match});
        m_links[b].push_back({a, reversed, match});
    }

    /// Length and turning of a piece decide how many edges it needs.
    int wantedEdges(const CutOutline& outline, int piece) const
    {
        const auto [s0, s1] = pieceLengths(outline, piece);
        const double length = s1 - s0;
        int edges = std::max(1, static_cast<int>(std::lround(length / m_edge)));
        const int probes = std::max(4, 2 * edges);
        double turn = 0;
        Vec2 previous = Vec2::Zero();
        for (int k = 0; k <= probes; ++k) {
            // A hair inside the ends, where a corner would turn as well.
            const double s = s0 + length * std::clamp(double(k) / probes, 1e-6, 1 - 1e-6);
            const Vec2 tangent = outline.curve->derivative(outline.length.parameterAt(s)).normalized();
            if (k > 0 && tangent.allFinite() && previous.allFinite())
                turn += std::acos(std::clamp(tangent.dot(previous), -1.0, 1.0));
            previous = tangent;
        }
        const int forTurn = static_cast<int>(std::ceil(turn / largestTurnPerEdge - 1e-6));
        const int most = std::max(1, static_cast<int>(length / (shortestEdge * m_edge)));
        edges = std::max(edges, std::min(forTurn, most));
        if (turn > 0.5)
            edges = std::max(edges, 2); // a single edge would flatten the bend altogether
        return outline.cuts.size() == 1   ? std::max(edges, 3)
               : outline.cuts.size() == 2 ? std::max(edges, 2)
                                          : edges;
    }

    std::pair<double, double> pieceLengths(const CutOutline& outline, int piece) const
    {
        const double s0 = outline.cuts[piece].s;
        const bool last = piece + 1 == std::ssize(outline.cuts);
        return {s0, last ? outline.cuts[0].s + outline.total() : outline.cuts[piece + 1].s};
    }

    std::pair<double, double> pieceParameters(const CutOutline& outline, int piece) const
    {
        const double t0 = outline.cuts[piece].t;
        const bool last = piece + 1 == std::ssize(outline.cuts);
        return {t0, last ? outline.cuts[0].t + outline.curve->period() : outline.cuts[piece + 1].t};
    }

    std::pair<int, int> ownerOf(int piece) const
    {
        const auto next = std::upper_bound(m_firstPiece.begin(), m_firstPiece.end(), piece);
        const int outline = static_cast<int>(next - m_firstPiece.begin()) - 1;
        return {outline, piece - m_firstPiece[outline]};
    }

    /// The pieces that belong together through seams, the first being the one that is divided evenly.
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

    /// Inner sample parameters of every piece, each end cut left out, even by arc length in the group's first piece
    /// and mapped along the seams to the others.
    void placeSamples()
    {
        std::vector<std::vector<double>> parameters(m_links.size());
        std::vector<char> seen(m_links.size(), 0);
        for (int piece = 0; piece < std::ssize(m_links); ++piece) {
            if (seen[piece])
                continue;
            const std::vector<int> group = linkedPieces(piece, seen);
            int edges = 1;
            for (int member : group) {
                const auto [outline, local] = ownerOf(member);
                edges = std::max(edges, wantedEdges(m_outlines[outline], local));
            }
            placeGroup(group, edges, parameters);
        }
        collectSamples(parameters);
    }

    void placeGroup(const std::vector<int>& group, int edges, std::vector<std::vector<double>>& parameters) const
    {
        const auto [outline, local] = ownerOf(group.front());
        const CutOutline& first = m_outlines[outline];
        const auto [s0, s1] = pieceLengths(first, local);
        const auto [t0, t1] = pieceParameters(first, local);
        std::vector<double>& even = parameters[group.front()];
        even.push_back(t0);
        for (int k = 1; k < edges; ++k)
            even.push_back(first.length.parameterAt(s0 + (s1 - s0) * k / edges));
        even.push_back(t1);
        for (int piece : group)
            for (const Link& link : m_links[piece])
                if (parameters[link.piece].empty())
                    parameters[link.piece] = mapped(parameters[piece], piece, link);
    }

    std::vector<double> mapped(const std::vector<double>& from, int piece, const Link& link) const
    {
        const auto [fromOutline, fromLocal] = ownerOf(piece);
        const auto [toOutline, toLocal] = ownerOf(link.piece);
        const CutOutline& source = m_outlines[fromOutline];
        const CutOutline& target = m_outlines[toOutline];
        const auto [fs0, fs1] = pieceLengths(source, fromLocal);
        const auto [ts0, ts1] = pieceLengths(target, toLocal);
        const auto [tt0, tt1] = pieceParameters(target, toLocal);
        std::vector<double> result(from.size());
        for (std::size_t k = 0; k < from.size(); ++k) {
            double fraction = link.match == Match::Parameter
                                  ? (from[k] - from.front()) / (from.back() - from.front())
                                  : (source.length.at(from[k]) - fs0) / (fs1 - fs0);
            const std::size_t slot = link.reversed ? from.size() - 1 - k : k;
            if (link.reversed)
                fraction = 1 - fraction;
            result[slot] = link.match == Match::Parameter ? tt0 + fraction * (tt1 - tt0)
                                                          : target.length.parameterAt(ts0 + fraction * (ts1 - ts0));
        }
        result.front() = tt0;
        result.back() = tt1;
        return result;
    }

    void collectSamples(const std::vector<std::vector<double>>& parameters)
    {
        for (int o = 0; o < std::ssize(m_outlines); ++o) {
            CutOutline& outline = m_outlines[o];
            OutlineSampling::Outline samples;
            samples.patch = outline.patch;
            for (int piece = 0; piece < std::ssize(outline.cuts); ++piece) {
                outline.firstSample.push_back(static_cast<int>(samples.parameters.size()));
                const std::vector<double>& t = parameters[m_firstPiece[o] + piece];
                samples.parameters.insert(samples.parameters.end(), t.begin(), t.end() - 1);
            }
            for (double t : samples.parameters)
                samples.points.push_back(outline.curve->at(t));
            m_result.outlines.push_back(std::move(samples));
        }
    }

    /// The samples of a stretch in walking direction, both ends included.
    std::vector<int> samplesAlong(const Span& span) const
    {
        const CutOutline& outline = m_outlines[span.outline];
        const std::vector<Along> along = cutsAlong(span, Match::Length);
        const int count = static_cast<int>(m_result.outlines[span.outline].points.size());
        const int first = outline.firstSample[along.front().cut];
        int last = outline.firstSample[along.back().cut];
        if (last <= first)
            last += count;
        std::vector<int> samples;
        for (int k = first; k <= last; ++k)
            samples.push_back(k % count);
        return samples;
    }

    void chainSeams()
    {
        std::vector<int> offset{0};
        for (const auto& outline : m_result.outlines)
            offset.push_back(offset.back() + static_cast<int>(outline.points.size()));
        UnionFind sewn(offset.back());
        for (const SeamSpans& seam : m_seams) {
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

    /// The walked part of a fixation curve.
    struct CurveSpan {
        const BSpline3* curve = nullptr;
        std::shared_ptr<ArcLength3> length;
        double t0 = 0, t1 = 0;

        double parameterAt(double fraction, Match match) const
        {
            if (match == Match::Parameter)
                return t0 + fraction * (t1 - t0);
            const double s0 = length->at(t0), s1 = length->at(t1);
            return length->parameterAt(s0 + fraction * (s1 - s0));
        }
        double fractionOf(double t, Match match) const
        {
            if (match == Match::Parameter)
                return (t - t0) / (t1 - t0);
            const double s0 = length->at(t0), s1 = length->at(t1);
            return s1 > s0 ? (length->at(t) - s0) / (s1 - s0) : 0.5;
        }
    };

    CurveSpan curveSpan(const FixationSeam& fixation) const
    {
        CurveSpan span;
        span.curve = &m_design.find<FixationCurve>(fixation.curve)->curve;
        span.length = std::make_shared<ArcLength3>(*span.curve);
        span.t0 = span.curve->domainStart();
        span.t1 = span.curve->domainEnd();
        if (fixation.curveRange) {
            span.t0 = fixation.curveRange->first;
            span.t1 = fixation.curveRange->second;
            if (span.curve->closed())
                span.t1 = unwrappedEnd(span.t0, span.t1, span.curve->domainStart(), span.curve->domainEnd());
        }
        return span;
    }

    void chainFixations()
    {
        for (const FixationSpan& fixation : m_fixations) {
            OutlineSampling::FixedChain chain;
            chain.fixation = fixation.id;
            chain.curve = fixation.fixation->curve;
            chain.outline = fixation.span.outline;
            chain.samples = samplesAlong(fixation.span);
            aim(chain, fixation);
            m_result.fixations.push_back(std::move(chain));
        }
        findConflicts(m_result, m_design);
    }

    struct FixationSpan {
        ElementId id{};
        const FixationSeam* fixation = nullptr;
        Span span;
    };

    /// Where each sample of the chain belongs on its curve.
    void aim(OutlineSampling::FixedChain& chain, const FixationSpan& fixation) const
    {
        const Match match = fixation.fixation->match;
        const CurveSpan curve = curveSpan(*fixation.fixation);
        const CutOutline& outline = m_outlines[chain.outline];
        const std::vector<double>& parameters = m_result.outlines[chain.outline].parameters;
        const Span& span = fixation.span;
        chain.targets.clear();
        chain.curveParameters.clear();
        for (std::size_t k = 0; k < chain.samples.size(); ++k) {
            double fraction = k == 0 ? 0 : 1;
            if (k > 0 && k + 1 < chain.samples.size()) {
                double t = parameters[chain.samples[k]];
                while (t < span.t0)
                    t += outline.curve->period();
                while (t > span.t1)
                    t -= outline.curve->period();
                fraction = match == Match::Parameter ? (t - span.t0) / (span.t1 - span.t0)
                                                     : (outline.length.at(t) - span.s0) / (span.s1 - span.s0);
            }
            if (fixation.fixation->reversed)
                fraction = 1 - fraction;
            const double t = curve.parameterAt(fraction, match);
            chain.curveParameters.push_back(t);
            chain.targets.push_back(curve.curve->at(t));
        }
    }

    void report(ElementId id, const char* field, const char* sentence, std::vector<std::string> args = {})
    {
        m_result.problems.push_back(
            {id, elementLabel(id, *m_design.element(id)), field, {sentence, std::move(args)}, Severity::Error});
    }

    static void findConflicts(OutlineSampling& sampling, const Design& design);

    friend void bolster::retarget(OutlineSampling& sampling, const Design& design);

    const Design& m_design;
    const double m_edge;
    std::map<ElementId, int> m_index;
    std::vector<CutOutline> m_outlines;
    std::vector<SeamSpans> m_seams;
    std::vector<FixationSpan> m_fixations;
    std::vector<int> m_firstPiece;
    std::vector<std::vector<Link>> m_links; // per piece
    OutlineSampling m_result;
};

/// Two fixations may hold one vertex only in the same place.
void Sampler::findConflicts(OutlineSampling& sampling, const Design& design)
{
    struct Held {
        Vec3 target = Vec3::Zero();
        const OutlineSampling::FixedChain* chain = nullptr;
    };
    std::vector<Held> held(sampling.clusterCount);
    for (const OutlineSampling::FixedChain& chain : sampling.fixations) {
        for (std::size_t k = 0; k < chain.samples.size(); ++k) {
            Held& other = held[sampling.outlines[chain.outline].cluster[chain.samples[k]]];
            if (!other.chain) {
                other = {chain.targets[k], &chain};
                continue;
            }
            const double apart = (other.target - chain.targets[k]).norm();
            if (apart <= conflictDistance)
                continue;
            auto name = [&](ElementId id) { return elementLabel(id, *design.element(id)); };
            sampling.problems.push_back(
                {chain.fixation,
                 name(chain.fixation),
                 "curve",
                 {QT_TRANSLATE_NOOP("Message",
                                    "%1 and %2 hold the same point of the cover in two places, %3 mm apart. "
                                    "Let both curves meet there, or end one stretch earlier."),
                  {name(other.chain->curve), name(chain.curve), numberText(apart)}},
                 Severity::Error});
            break;
        }
    }
}

} // namespace

OutlineSampling sampleOutlines(const Design& design)
{
    return Sampler(design).run();
}

void retarget(OutlineSampling& sampling, const Design& design)
{
    Sampler sampler(design);
    sampler.collectOutlines();
    sampler.collectSpans();
    std::swap(sampler.m_result, sampling);
    sampler.m_result.problems.clear();
    for (std::size_t k = 0; k < sampler.m_fixations.size(); ++k)
        sampler.aim(sampler.m_result.fixations[k], sampler.m_fixations[k]);
    Sampler::findConflicts(sampler.m_result, design);
    sampling = std::move(sampler.m_result);
}

} // namespace bolster
