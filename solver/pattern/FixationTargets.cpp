#include "FixationTargets.h"

#include "SpokenName.h"

#include <algorithm>

namespace bolster {

namespace {

constexpr double conflictDistance = 1; // mm between two targets of one vertex: nobody sews more exactly

/// How far along a stretch its k-th sample of `samples` lies.
double fractionAlong(const OutlineSpan& span, const CutOutline& outline, const std::vector<double>& parameters,
                     const std::vector<int>& samples, std::size_t k, Match match)
{
    if (k == 0 || k + 1 == samples.size())
        return k == 0 ? 0 : 1;
    double t = parameters[samples[k]];
    while (t < span.t0)
        t += outline.curve->period();
    while (t > span.t1)
        t -= outline.curve->period();
    return match == Match::Parameter ? (t - span.t0) / (span.t1 - span.t0)
                                     : (outline.length.at(t) - span.s0) / (span.s1 - span.s0);
}

/// Where each sample of the chain belongs on its curve.
void aim(OutlineSampling::FixedChain& chain, const FixationSpan& fixation, const OutlineCuts& cuts,
         const std::vector<double>& parameters, const Design& design)
{
    const Match match = fixation.fixation->match;
    const CurveSpan curve(design, *fixation.fixation);
    chain.targets.clear();
    chain.curveParameters.clear();
    for (std::size_t k = 0; k < chain.samples.size(); ++k) {
        double fraction =
            fractionAlong(fixation.span, cuts.outlines()[chain.outline], parameters, chain.samples, k, match);
        if (fixation.fixation->reversed)
            fraction = 1 - fraction;
        const double t = curve.parameterAt(fraction, match);
        chain.curveParameters.push_back(t);
        chain.targets.push_back(curve.curve->at(t));
    }
}

/// What is held at each point of a chain.
void direct(OutlineSampling::OrientedChain& chain, const Orientation& orientation,
            const std::vector<double>& fractions)
{
    chain.kind = orientation.kind;
    chain.weight = orientation.weight;
    chain.directions.clear();
    for (double fraction : fractions)
        chain.directions.push_back(orientation.at(fraction));
}

std::vector<double> fractionsAlong(const FixationSpan& held, const CutOutline& outline,
                                   const OutlineSampling::Outline& samples, const std::vector<int>& chain)
{
    std::vector<double> fractions;
    for (std::size_t k = 0; k < chain.size(); ++k)
        fractions.push_back(fractionAlong(held.span, outline, samples.parameters, chain, k, Match::Length));
    return fractions;
}

/// Likewise of a handle.
void aimHandle(OutlineSampling::FixedChain& chain, const std::vector<double>& fractions, const Design& design)
{
    const auto& handle = *design.find<HandleCurve>(chain.curve);
    const CurveSpan target(handle.target);
    chain.targets.clear();
    chain.curveParameters.clear();
    for (double fraction : fractions) {
        chain.curveParameters.push_back(target.parameterAt(fraction, handle.match));
        chain.targets.push_back(handle.target.at(chain.curveParameters.back()));
    }
}

/// The samples that a chain holds, in the order of its targets; -1 inside the patch.
std::vector<int> heldSamples(const OutlineSampling& sampling, const OutlineSampling::FixedChain& chain)
{
    if (chain.line < 0)
        return chain.samples;
    const InnerLine& shape = sampling.outlines[chain.outline].lines[chain.line].shape;
    std::vector<int> samples(shape.points.size(), -1);
    samples.front() = shape.startSample;
    samples.back() = shape.endSample;
    return samples;
}

/// Two fixations may hold one vertex only in the same place, or nearly: what an outline that changed a little does
/// to stretches that meet is no mistake. The last one counts.
void findConflicts(OutlineSampling& sampling, const Design& design)
{
    struct Held {
        Vec3 target = Vec3::Zero();
        const OutlineSampling::FixedChain* chain = nullptr;
    };
    std::vector<Held> held(sampling.clusterCount);
    const auto check = [&](const OutlineSampling::FixedChain& chain) {
        const std::vector<int> samples = heldSamples(sampling, chain);
        for (std::size_t k = 0; k < samples.size(); ++k) {
            if (samples[k] < 0)
                continue;
            Held& other = held[sampling.outlines[chain.outline].cluster[samples[k]]];
            if (!other.chain) {
                other = {chain.targets[k], &chain};
                continue;
            }
            const double apart = (other.target - chain.targets[k]).norm();
            if (apart <= conflictDistance)
                continue;
            sampling.problems.push_back(
                {chain.fixation,
                 elementLabel(chain.fixation, *design.element(chain.fixation)),
                 chain.line < 0 ? "curve" : "target",
                 {QT_TRANSLATE_NOOP("Message",
                                    "%1 and %2 hold the same point of the cover in two places, %3 mm apart. "
                                    "Let both curves meet there, or end one stretch earlier."),
                  {spokenName(design, other.chain->curve), spokenName(design, chain.curve), numberText(apart)}},
                 Severity::Error});
            return;
        }
    };
    std::for_each(sampling.fixations.begin(), sampling.fixations.end(), check);
    std::for_each(sampling.handles.begin(), sampling.handles.end(), check);
}

} // namespace

void aimFixations(OutlineSampling& sampling, const OutlineCuts& cuts, const Design& design)
{
    for (std::size_t k = 0; k < sampling.fixations.size(); ++k) {
        OutlineSampling::FixedChain& chain = sampling.fixations[k];
        aim(chain, cuts.fixations()[k], cuts, sampling.outlines[chain.outline].parameters, design);
    }
    auto held = cuts.orientations().begin();
    for (OutlineSampling::OrientedChain& chain : sampling.orientations) {
        const OutlineSampling::Outline& outline = sampling.outlines[chain.outline];
        if (chain.line >= 0) {
            direct(chain, design.find<HandleCurve>(chain.owner)->orientation, outline.lines[chain.line].fractions);
            continue;
        }
        direct(chain, held->fixation->orientation,
               fractionsAlong(*held, cuts.outlines()[chain.outline], outline, chain.samples));
        ++held;
    }
    for (OutlineSampling::FixedChain& chain : sampling.handles)
        aimHandle(chain, sampling.outlines[chain.outline].lines[chain.line].fractions, design);
    findConflicts(sampling, design);
}

void retarget(OutlineSampling& sampling, const Design& design)
{
    sampling.problems.clear();
    aimFixations(sampling, OutlineCuts(design), design);
}

} // namespace bolster
