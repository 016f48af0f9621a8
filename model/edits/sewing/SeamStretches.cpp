#include "SeamStretches.h"

#include "ArcLength.h"
#include "EditHelpers.h"
#include "ElementRules.h"
#include "StretchLength.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster::edits {

namespace {

constexpr double cornerAngle = 10 * std::numbers::pi / 180;
constexpr double shortestStretch = 1e-3; // mm, as in the rules for designs

const BSpline2* outlineOf(const Design& design, ElementId id)
{
    const auto* patch = design.find<Patch>(id);
    return patch && !patch->outline.empty() ? &patch->outline : nullptr;
}

double endOf(const BSpline2& outline, const Stretch& stretch)
{
    return unwrappedEnd(stretch.from, stretch.to, outline.domainStart(), outline.domainEnd());
}

/// Calls visit(seam, stretch) for all that is sewn of an outline.
template <class Visit>
void eachSewn(const Design& design, ElementId patch, Visit visit)
{
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        for (const Stretch& stretch : {seam.a, seam.b})
            if (stretch.patch == patch)
                visit(id, stretch);
    });
}

/// From corner to corner around t, unwrapped.
struct EdgeRange {
    double from = 0;
    double to = 0;
};

EdgeRange edgeAround(const BSpline2& outline, double t)
{
    const std::vector<double> corners = outlineCorners(outline);
    if (corners.empty())
        return {outline.domainStart(), outline.domainEnd()};
    const auto next = std::upper_bound(corners.begin(), corners.end(), t);
    const double from = next == corners.begin() ? corners.back() - outline.period() : *std::prev(next);
    const double to = next == corners.end() ? corners.front() + outline.period() : *next;
    return {from, to};
}

/// In the order of the outline, beginning after the largest part that is left out.
void sortAlong(const BSpline2& outline, std::vector<Stretch>& row)
{
    std::ranges::sort(row, {}, &Stretch::from);
    std::size_t first = 0;
    double largest = -1;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const Stretch& before = row[(i + row.size() - 1) % row.size()];
        const double gap = outline.wrapped(outline.domainStart() + row[i].from - before.to) - outline.domainStart();
        if (gap > largest) {
            largest = gap;
            first = i;
        }
    }
    std::rotate(row.begin(), row.begin() + static_cast<std::ptrdiff_t>(first), row.end());
}

Vec2 middleInLayout(const Design& design, const Stretch& stretch)
{
    const Patch& patch = *design.find<Patch>(stretch.patch);
    const ArcLength2 length(patch.outline);
    const double middle = 0.5 * (length.at(stretch.from) + length.at(endOf(patch.outline, stretch)));
    return toLayout(patch, patch.outline.at(length.parameterAt(middle)));
}

/// The seams in this order, from the start of `whole`.
std::vector<Seam> seamsInOrder(const Design& design, const Stretch& whole, std::span<const Stretch> row,
                               bool flipped)
{
    const BSpline2& outline = *outlineOf(design, whole.patch);
    const ArcLength2 length(outline);
    std::vector<double> sums = {0};
    for (const Stretch& other : row)
        sums.push_back(sums.back() + stretchLength(design, other));
    const double start = length.at(whole.from);
    const double all = length.at(endOf(outline, whole)) - start;

    std::vector<Seam> seams;
    double from = whole.from;
    for (std::size_t i = 0; i < row.size(); ++i) {
        const double to = i + 1 == row.size() ? endOf(outline, whole)
                                              : length.parameterAt(start + all * sums[i + 1] / sums.back());
        const Stretch part = row.size() == 1 ? whole : stretchBetween(whole.patch, outline, from, to);
        seams.push_back({part, row[i], usuallyReversed(design, part, row[i]) != flipped});
        from = to;
    }
    return seams;
}

double distanceInLayout(const Design& design, const std::vector<Seam>& seams)
{
    double sum = 0;
    for (const Seam& seam : seams)
        sum += (middleInLayout(design, seam.a) - middleInLayout(design, seam.b)).norm();
    return sum;
}

/// Of the row when nothing is flipped.
std::vector<Stretch> usualOrder(const Design& design, const Stretch& whole, std::span<const Stretch> given)
{
    std::vector<Stretch> row(given.begin(), given.end());
    const ElementId patch = row.front().patch;
    if (std::ranges::all_of(row, [&](const Stretch& s) { return s.patch == patch; })) {
        sortAlong(*outlineOf(design, patch), row);
        if (usuallyReversed(design, whole, row.front()))
            std::ranges::reverse(row);
        return row;
    }
    std::vector<Stretch> turned(row.rbegin(), row.rend());
    const double asGiven = distanceInLayout(design, seamsInOrder(design, whole, row, false));
    return distanceInLayout(design, seamsInOrder(design, whole, turned, false)) < asGiven ? turned : row;
}

} // namespace

std::vector<double> outlineCorners(const BSpline2& outline)
{
    std::vector<double> corners;
    if (outline.empty())
        return corners;
    const std::vector<BezierPiece<2>> pieces = bezierPieces(outline);
    const auto along = [](const BezierPiece<2>& piece, double u) {
        const Vec2 direction = piece.derivative(u);
        return direction.norm() > 1e-9 ? direction : Vec2(piece.back() - piece.front());
    };
    for (std::size_t i = 0; i < pieces.size(); ++i) {
        const Vec2 before = along(pieces[(i + pieces.size() - 1) % pieces.size()], 1);
        const Vec2 after = along(pieces[i], 0);
        const double turn = std::atan2(before.x() * after.y() - before.y() * after.x(), before.dot(after));
        if (std::abs(turn) > cornerAngle)
            corners.push_back(pieces[i].start);
    }
    return corners;
}

Stretch stretchBetween(ElementId patch, const BSpline2& outline, double t0, double t1)
{
    const double to = outline.wrapped(t1);
    return {patch, outline.wrapped(t0), to == outline.domainStart() ? outline.domainEnd() : to};
}

std::optional<Stretch> freeStretchAt(const Design& design, ElementId patch, double parameter)
{
    const BSpline2* outline = outlineOf(design, patch);
    if (!outline || !std::isfinite(parameter) || sewnAt(design, patch, parameter))
        return std::nullopt;
    const double t = outline->wrapped(parameter);
    const double period = outline->period();
    const double slack = 1e-9 * period;
    EdgeRange edge = edgeAround(*outline, t);
    eachSewn(design, patch, [&](ElementId, const Stretch& sewn) {
        for (const double turn : {-period, 0.0, period}) {
            const double from = sewn.from + turn;
            const double to = endOf(*outline, sewn) + turn;
            if (to <= t + slack)
                edge.from = std::max(edge.from, to);
            else if (from > t - slack)
                edge.to = std::min(edge.to, from);
        }
    });
    return stretchBetween(patch, *outline, edge.from, edge.to);
}

std::optional<std::pair<ElementId, Stretch>> sewnAt(const Design& design, ElementId patch, double parameter)
{
    std::optional<std::pair<ElementId, Stretch>> found;
    const BSpline2* outline = outlineOf(design, patch);
    if (!outline || !std::isfinite(parameter))
        return found;
    const double t = outline->wrapped(parameter);
    const double slack = 1e-9 * outline->period();
    eachSewn(design, patch, [&](ElementId id, const Stretch& sewn) {
        const double to = endOf(*outline, sewn);
        for (const double at : {t - outline->period(), t, t + outline->period()})
            if (at > sewn.from - slack && at < to - slack)
                found = std::pair(id, sewn);
    });
    return found;
}

int edgeNumber(const BSpline2& outline, double parameter)
{
    const std::vector<double> corners = outlineCorners(outline);
    if (corners.empty())
        return 0;
    const double slack = 1e-9 * outline.period();
    const auto after = std::ranges::upper_bound(corners, outline.wrapped(parameter) + slack);
    return after == corners.begin() ? static_cast<int>(corners.size()) : static_cast<int>(after - corners.begin());
}

std::optional<Message> stretchProblem(const Design& design, const Stretch& stretch, ElementId except)
{
    if (!(stretchLength(design, stretch) >= shortestStretch))
        return Message{QT_TRANSLATE_NOOP("Message", "This stretch has no length: choose two different points.")};
    const BSpline2& outline = *outlineOf(design, stretch.patch);
    std::optional<Message> problem;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        if (problem || id == except)
            return;
        for (const auto& [side, other] : {std::pair(seam.a, seam.b), std::pair(seam.b, seam.a)})
            if (side.patch == stretch.patch && stretchesOverlap(outline, side, stretch))
                problem = Message{QT_TRANSLATE_NOOP("Message", "%1 is already sewn to %2 here: remove that seam "
                                                               "first, or take a free stretch."),
                                  {displayName(design, side.patch), displayName(design, other.patch)}};
    });
    return problem;
}

std::optional<Message> sewingProblem(const Design& design, const Stretch& whole, std::span<const Stretch> row)
{
    std::vector<Stretch> all(row.begin(), row.end());
    all.push_back(whole);
    for (const Stretch& stretch : all)
        if (std::optional<Message> problem = stretchProblem(design, stretch))
            return problem;
    for (std::size_t i = 0; i < all.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (all[i].patch == all[j].patch && stretchesOverlap(*outlineOf(design, all[i].patch), all[i], all[j]))
                return Message{QT_TRANSLATE_NOOP("Message", "A stretch cannot be sewn to itself: choose two that "
                                                            "have no part in common.")};
    return std::nullopt;
}

bool usuallyReversed(const Design& design, const Stretch& a, const Stretch& b)
{
    const auto* first = design.find<Patch>(a.patch);
    const auto* second = design.find<Patch>(b.patch);
    return !first || !second || rightSidesMeetReversed(*first, *second);
}

std::vector<Seam> seamsInRow(const Design& design, const Stretch& whole, std::span<const Stretch> row, bool flipped)
{
    const auto lies = [&](const Stretch& stretch) { return stretchLength(design, stretch) >= shortestStretch; };
    if (row.empty() || !lies(whole) || !std::ranges::all_of(row, lies))
        return {};
    std::vector<Stretch> order =
        row.size() == 1 ? std::vector(row.begin(), row.end()) : usualOrder(design, whole, row);
    if (flipped)
        std::ranges::reverse(order);
    return seamsInOrder(design, whole, order, flipped);
}

} // namespace bolster::edits
