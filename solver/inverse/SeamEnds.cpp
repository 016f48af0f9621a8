#include "SeamEnds.h"

#include "ArcLength.h"
#include "ElementStretches.h"

#include <algorithm>
#include <cmath>
#include <variant>

namespace bolster {

namespace {

constexpr double samePlace = 1e-6; // of the period

/// Of what is sewn or fixed.
std::vector<Stretch> sewnStretches(const Element& element)
{
    const bool sewn = std::holds_alternative<Seam>(element) || std::holds_alternative<FixationSeam>(element);
    return sewn ? stretchesOf(element) : std::vector<Stretch>();
}

/// Calls change(stretch) for all stretches of a design.
template <class Change>
Design withChanged(const Design& design, const Change& change)
{
    Edit edit;
    for (const auto& [id, element] : design.elements()) {
        const std::vector<Stretch> before = sewnStretches(*element);
        std::vector<Stretch> stretches = before;
        for (std::size_t k = 0; k < stretches.size(); ++k)
            change(id, k, stretches[k]);
        if (stretches != before)
            edit.changes.push_back({id, element, withStretches(*element, stretches)});
    }
    return edit.changes.empty() ? design : design.with(edit);
}

double distanceAround(const BSpline2& outline, double a, double b)
{
    const double off = std::abs(outline.wrapped(a) - outline.wrapped(b));
    return std::min(off, outline.period() - off);
}

bool isSame(const BSpline2& outline, double a, double b)
{
    return distanceAround(outline, a, b) < samePlace * outline.period();
}

/// From where to where a place that must keep its samples goes; parameters within the domain.
struct Place {
    double from = 0, to = 0;
};

std::vector<Place> placesOf(const Design& before, const Design& after, ElementId patch)
{
    const BSpline2& outline = before.find<Patch>(patch)->outline;
    std::vector<Place> places;
    for (const double corner : outline.corners())
        places.push_back({outline.wrapped(corner), outline.wrapped(corner)});
    for (const auto& [id, element] : before.elements()) {
        const ElementPtr other = after.element(id);
        if (!other)
            continue;
        const std::vector<Stretch> from = sewnStretches(*element), to = sewnStretches(*other);
        for (std::size_t k = 0; k < std::min(from.size(), to.size()); ++k)
            if (from[k].patch == patch && to[k].patch == patch) {
                places.push_back({outline.wrapped(from[k].from), outline.wrapped(to[k].from)});
                places.push_back({outline.wrapped(from[k].to), outline.wrapped(to[k].to)});
            }
    }
    std::ranges::sort(places, {}, &Place::from);
    return places;
}

} // namespace

std::vector<double> seamEnds(const Design& design, ElementId patch)
{
    const BSpline2& outline = design.find<Patch>(patch)->outline;
    std::vector<double> ends;
    for (const auto& [id, element] : design.elements())
        for (const Stretch& stretch : sewnStretches(*element))
            if (stretch.patch == patch && !isSame(outline, stretch.from, stretch.to))
                for (const double end : {stretch.from, stretch.to})
                    if (std::ranges::none_of(ends, [&](double known) { return isSame(outline, known, end); }))
                        ends.push_back(outline.wrapped(end));
    std::ranges::sort(ends);
    return ends;
}

Design withSeamEnds(const Design& design, std::span<const MovedSeamEnd> moved)
{
    if (moved.empty())
        return design;
    const auto slide = [&](ElementId patch, double& parameter) {
        const auto* found = design.find<Patch>(patch);
        for (const MovedSeamEnd& end : moved)
            if (found && end.patch == patch && isSame(found->outline, end.at, parameter)) {
                const ArcLength2 length(found->outline);
                const double all = length.total();
                double at = std::fmod(length.at(found->outline.wrapped(parameter)) + end.by, all);
                if (at < 0)
                    at += all;
                parameter = length.parameterAt(at);
                return;
            }
    };
    return withChanged(design, [&](ElementId, std::size_t, Stretch& stretch) {
        slide(stretch.patch, stretch.from);
        slide(stretch.patch, stretch.to);
    });
}

Design withStretchesOf(const Design& design, const Design& other)
{
    return withChanged(design, [&](ElementId id, std::size_t which, Stretch& stretch) {
        const ElementPtr element = other.element(id);
        if (!element)
            return;
        const std::vector<Stretch> stretches = sewnStretches(*element);
        if (which < stretches.size() && stretches[which].patch == stretch.patch)
            stretch = stretches[which];
    });
}

std::optional<std::vector<double>> slidSamples(const std::vector<double>& parameters, const Design& before,
                                               const Design& after, ElementId patch)
{
    const BSpline2& outline = before.find<Patch>(patch)->outline;
    const std::vector<Place> places = placesOf(before, after, patch);
    const double period = outline.period();
    std::vector<Place> kept; // each once, `to` unwrapped so that it lies beside `from`
    for (Place place : places) {
        place.to += period * std::round((place.from - place.to) / period);
        if (!kept.empty() && place.from - kept.back().from < samePlace * period) {
            if (std::abs(place.to - kept.back().to) > samePlace * period)
                return std::nullopt; // what lay in one place does no longer
            continue;
        }
        if (!kept.empty() && place.to <= kept.back().to)
            return std::nullopt;
        kept.push_back(place);
    }
    if (kept.empty())
        return parameters;
    if (kept.back().to - period >= kept.front().to)
        return std::nullopt;
    std::vector<double> slid;
    slid.reserve(parameters.size());
    for (const double t : parameters) {
        const auto next = std::ranges::upper_bound(kept, t + samePlace * period, {}, &Place::from);
        Place low = next == kept.begin() ? kept.back() : *std::prev(next);
        Place high = next == kept.end() ? kept.front() : *next;
        if (next == kept.begin())
            low = {low.from - period, low.to - period};
        if (next == kept.end())
            high = {high.from + period, high.to + period};
        const double share = std::clamp((t - low.from) / (high.from - low.from), 0.0, 1.0);
        slid.push_back(outline.wrapped(low.to + share * (high.to - low.to)));
    }
    return slid;
}

} // namespace bolster
