#include "OutlineCuts.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

// Two cuts nearer than this fraction of the edge length count as one: a shorter edge would spoil the triangles.
constexpr double snap = 0.25;
// Two names for one place: differences of rounding, as a fraction of the edge length.
constexpr double rounding = 1e-5;
// Cuts that seams carry round for ever without closing stop here.
constexpr std::ptrdiff_t largestCutCount = 20000;

} // namespace

double CutOutline::wrap(double s) const
{
    const double wrapped = s - std::floor(s / total()) * total();
    return wrapped < total() ? wrapped : 0;
}

std::pair<double, double> CutOutline::pieceLengths(int piece) const
{
    const bool last = piece + 1 == pieceCount();
    return {cuts[piece].s, last ? cuts[0].s + total() : cuts[piece + 1].s};
}

std::pair<double, double> CutOutline::pieceParameters(int piece) const
{
    const bool last = piece + 1 == pieceCount();
    return {cuts[piece].t, last ? cuts[0].t + curve->period() : cuts[piece + 1].t};
}

int CutOutline::near(double s, double tolerance) const
{
    const double inside = wrap(s);
    const int last = pieceCount() - 1;
    const int above = static_cast<int>(std::ranges::lower_bound(cuts, inside, {}, &Cut::s) - cuts.begin());
    int best = -1;
    for (const int i : {0, above - 1, above, last}) { // the neighbours, also across the start
        if (i < 0 || i > last || i == best)
            continue;
        const double apart = std::abs(inside - cuts[i].s);
        const double distance = std::min(apart, total() - apart);
        if (distance <= tolerance) {
            tolerance = distance;
            best = i;
        }
    }
    return best;
}

bool CutOutline::add(double t, double tolerance)
{
    t = curve->wrapped(t);
    const double s = wrap(length.at(t));
    if (near(s, tolerance) >= 0)
        return false;
    const auto at = std::lower_bound(cuts.begin(), cuts.end(), s, [](const Cut& c, double v) { return c.s < v; });
    cuts.insert(at, {s, t});
    return true;
}

CurveSpan::CurveSpan(const BSpline3& whole)
    : curve(&whole)
    , length(std::make_shared<const ArcLength3>(whole))
    , t0(whole.domainStart())
    , t1(whole.domainEnd())
{}

CurveSpan::CurveSpan(const Design& design, const FixationSeam& fixation)
    : CurveSpan(design.find<FixationCurve>(fixation.curve)->curve)
{
    if (fixation.curveRange) {
        t0 = fixation.curveRange->first;
        t1 = curve->closed()
                 ? unwrappedEnd(t0, fixation.curveRange->second, curve->domainStart(), curve->domainEnd())
                 : fixation.curveRange->second;
    }
}

double CurveSpan::parameterAt(double fraction, Match match) const
{
    if (match == Match::Parameter)
        return t0 + fraction * (t1 - t0);
    return length->parameterAt(length->at(t0) + fraction * length->between(t0, t1));
}

double CurveSpan::fractionOf(double t, Match match) const
{
    if (match == Match::Parameter)
        return (t - t0) / (t1 - t0);
    const double whole = length->between(t0, t1);
    return whole > 0 ? length->between(t0, t) / whole : 0.5;
}

OutlineCuts::OutlineCuts(const Design& design)
    : m_design(design)
    , m_edge(design.settings().edgeLength)
{
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        m_index[id] = static_cast<int>(m_outlines.size());
        m_outlines.emplace_back(id, patch.outline);
    });
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        m_seams.push_back({id, &seam, span(seam.a), span(seam.b)});
    });
    design.each<FixationSeam>([&](ElementId id, const FixationSeam& fixation) {
        const FixationSpan held{id, &fixation, span(fixation.stretch)};
        if (fixation.hasCurve())
            m_fixations.push_back(held);
        if (!fixation.orientation.empty())
            m_orientations.push_back(held);
    });
}

OutlineSpan OutlineCuts::span(const Stretch& stretch) const
{
    OutlineSpan span;
    span.outline = m_index.at(stretch.patch);
    const CutOutline& outline = m_outlines[span.outline];
    span.t0 = stretch.from;
    span.t1 = unwrappedEnd(stretch.from, stretch.to, outline.curve->domainStart(), outline.curve->domainEnd());
    span.s0 = outline.length.at(span.t0);
    span.s1 = outline.length.at(span.t1);
    return span;
}

Problems OutlineCuts::cut(const std::vector<LineEnd>& lineEnds)
{
    cutAtCornersAndEnds();
    if (Problems problems = strayStretches(); !problems.empty())
        return problems;
    for (const LineEnd& end : lineEnds)
        m_outlines[end.outline].add(end.t, end.reach);
    for (bool changed = true; changed;) {
        changed = false;
        for (const SeamSpans& seam : m_seams) {
            changed |= carry(seam, true);
            changed |= carry(seam, false);
            if (std::ssize(m_outlines[seam.a.outline].cuts) > largestCutCount)
                return {problem(
                    seam.id, "a",
                    QT_TRANSLATE_NOOP("Message", "this seam and its neighbours carry their ends round in a circle "
                                                 "without ever meeting. Let the seams of this circle end at common "
                                                 "points."))};
        }
    }
    Problems problems;
    for (const SeamSpans& seam : m_seams)
        if (along(seam.a, seam.seam->match).size() != along(seam.b, seam.seam->match).size())
            problems.push_back(
                problem(seam.id, "b",
                        QT_TRANSLATE_NOOP("Message", "the corners of the two stretches lie too close together to "
                                                     "be matched. Move them apart or choose a smaller edge "
                                                     "length.")));
    return problems;
}

/// A stretch has a cut at each end, unless it lies elsewhere than its outline.
Problems OutlineCuts::strayStretches() const
{
    Problems problems;
    const auto look = [&](const OutlineSpan& span, ElementId id, const char* field) {
        const CutOutline& outline = m_outlines[span.outline];
        const double same = rounding * m_edge;
        const int from = outline.near(span.s0, same), to = outline.near(span.s1, same);
        if (from < 0 || to < 0 || (from == to && span.s1 - span.s0 < outline.total() / 2))
            problems.push_back(
                problem(id, field,
                        QT_TRANSLATE_NOOP("Message", "the stretch does not lie on its outline any more. "
                                                     "Sew or fix it anew.")));
    };
    for (const SeamSpans& seam : m_seams) {
        look(seam.a, seam.id, "a");
        look(seam.b, seam.id, "b");
    }
    for (const auto* held : {&m_fixations, &m_orientations})
        for (const FixationSpan& fixation : *held)
            look(fixation.span, fixation.id, "from");
    return problems;
}

void OutlineCuts::cutAtCornersAndEnds()
{
    const double tiny = rounding * m_edge;
    auto ends = [&](const OutlineSpan& span) {
        m_outlines[span.outline].add(span.t0, tiny);
        m_outlines[span.outline].add(span.t1, tiny);
    };
    for (const SeamSpans& seam : m_seams) {
        ends(seam.a);
        ends(seam.b);
    }
    for (const auto* held : {&m_fixations, &m_orientations})
        for (const FixationSpan& fixation : *held)
            ends(fixation.span);
    for (CutOutline& outline : m_outlines) {
        for (double t : outline.curve->corners())
            outline.add(t, tiny);
        if (outline.cuts.empty())
            outline.add(outline.curve->domainStart(), tiny);
    }
    for (const FixationSpan& fixation : m_fixations)
        cutAtCurveCorners(fixation);
}

/// A corner of a fixation curve wants a vertex, or the cover would cut it off.
void OutlineCuts::cutAtCurveCorners(const FixationSpan& fixation)
{
    const Match match = fixation.fixation->match;
    const CurveSpan curve(m_design, *fixation.fixation);
    for (double corner : curve.curve->corners()) {
        while (curve.curve->closed() && corner < curve.t0)
            corner += curve.curve->period();
        if (corner <= curve.t0 || corner >= curve.t1)
            continue;
        double fraction = curve.fractionOf(corner, match);
        if (fixation.fixation->reversed)
            fraction = 1 - fraction;
        m_outlines[fixation.span.outline].add(parameterAt(fixation.span, fraction, match), snap * m_edge);
    }
}

double OutlineCuts::parameterAt(const OutlineSpan& span, double fraction, Match match) const
{
    if (match == Match::Parameter)
        return span.t0 + fraction * (span.t1 - span.t0);
    return m_outlines[span.outline].length.parameterAt(span.s0 + fraction * (span.s1 - span.s0));
}

std::vector<OutlineCuts::Along> OutlineCuts::along(const OutlineSpan& span, Match match, bool backwards) const
{
    const CutOutline& outline = m_outlines[span.outline];
    const double same = rounding * m_edge;
    const int first = outline.near(span.s0, same), last = outline.near(span.s1, same), n = outline.pieceCount();
    // By the order of the cuts, not by how far they are: one may lie as near to an end as the one that stands for
    // it.
    const bool isTiny = span.s1 - span.s0 < outline.total() / 2;
    const int pieces = first == last ? (isTiny ? 0 : n) : (last - first + n) % n;
    const double turns = std::round((span.s0 - outline.cuts[first].s) / outline.total());
    std::vector<Along> result{{first, 0.0}};
    for (int k = 1; k < pieces; ++k) {
        const int index = (first + k) % n;
        const double around = turns + (index <= first ? 1 : 0);
        const double s = outline.cuts[index].s + around * outline.total(),
                     t = outline.cuts[index].t + around * outline.curve->period();
        const double fraction =
            match == Match::Parameter ? (t - span.t0) / (span.t1 - span.t0) : (s - span.s0) / (span.s1 - span.s0);
        result.push_back({index, std::clamp(fraction, 0.0, 1.0)});
    }
    result.push_back({last, 1.0});
    if (backwards) {
        std::reverse(result.begin(), result.end());
        for (Along& a : result)
            a.fraction = 1 - a.fraction;
    }
    return result;
}

/// Of each cut within `from`: the one within `to` that it makes a pair with; 0: none. Pairs are not farther apart
/// than `near`, as fractions. Those that are each other's nearest come first, or a corner could take its
/// neighbour's partner; then, between them, what is left in order.
std::vector<std::size_t> OutlineCuts::partners(const std::vector<Along>& from, const std::vector<Along>& to,
                                               double near)
{
    const auto nearest = [](const std::vector<Along>& all, double fraction) -> std::size_t {
        std::size_t best = 0;
        const auto above = std::lower_bound(all.begin() + 1, all.end() - 1, fraction,
                                            [](const Along& one, double value) { return one.fraction < value; });
        for (const std::ptrdiff_t k : {above - all.begin() - 1, above - all.begin()})
            if (const auto index = static_cast<std::size_t>(k);
                k > 0 && index + 1 < all.size() &&
                (best == 0 || all[index].fraction - fraction < fraction - all[best].fraction))
                best = index;
        return best;
    };
    const auto close = [&](std::size_t k, std::size_t j) {
        return std::abs(from[k].fraction - to[j].fraction) <= near;
    };
    std::vector<std::size_t> partner(from.size(), 0);
    for (std::size_t k = 1; k + 1 < from.size(); ++k)
        if (const std::size_t j = nearest(to, from[k].fraction);
            j > 0 && close(k, j) && nearest(from, to[j].fraction) == k)
            partner[k] = j;
    std::size_t free = 1; // of `to`, behind all that have partners so far
    for (std::size_t k = 1; k + 1 < from.size(); ++k) {
        if (partner[k] > 0) {
            free = partner[k] + 1;
            continue;
        }
        const auto taken = std::find_if(partner.begin() + static_cast<std::ptrdiff_t>(k), partner.end(),
                                        [](std::size_t j) { return j > 0; });
        const std::size_t end = taken == partner.end() ? to.size() - 1 : *taken;
        while (free < end && to[free].fraction < from[k].fraction - near)
            ++free;
        if (free < end && close(k, free))
            partner[k] = free++;
    }
    return partner;
}

/// Adds to the other side the cuts that only this side has. Cuts that lie close together are a pair already.
bool OutlineCuts::carry(const SeamSpans& seam, bool forward)
{
    const Match match = seam.seam->match;
    const bool reversed = seam.seam->reversed;
    const std::vector<Along> a = along(seam.a, match), b = along(seam.b, match, reversed);
    const std::vector<Along>&from = forward ? a : b, &to = forward ? b : a;
    const OutlineSpan& target = forward ? seam.b : seam.a;
    const double near = snap * m_edge / (target.s1 - target.s0); // as a fraction
    const std::vector<std::size_t> partner = partners(from, to, near);
    std::vector<double> missing;
    for (std::size_t k = 1; k + 1 < from.size(); ++k)
        if (partner[k] == 0)
            missing.push_back(from[k].fraction);
    bool added = false;
    for (double fraction : missing) {
        const double onTarget = forward && reversed ? 1 - fraction : fraction;
        added |= m_outlines[target.outline].add(parameterAt(target, onTarget, match), rounding * m_edge);
    }
    return added;
}

Problem OutlineCuts::problem(ElementId id, const char* field, const char* sentence) const
{
    return {id, elementLabel(id, *m_design.element(id)), field, {sentence, {}}, Severity::Error};
}

} // namespace bolster
