#include "FitChange.h"

#include "Edit.h"
#include "FitRows.h"

#include <algorithm>
#include <cmath>
#include <map>
#include <tuple>
#include <utility>

namespace bolster {

namespace {

constexpr double leastWantedEase = 0.05, mostWantedEase = 1000; // mm

Design withEases(const Design& before, const Design& changed)
{
    Edit edit;
    changed.each<Seam>([&](ElementId id, const Seam& seam) {
        const auto* old = before.find<Seam>(id);
        if (!old)
            return;
        const double more = seamDifference(changed, seam) - seamDifference(before, *old);
        if (std::abs(more) < leastWantedEase)
            return;
        Seam eased = seam;
        eased.ease = std::clamp(old->ease + more, -mostWantedEase, mostWantedEase);
        edit.changes.push_back({id, changed.element(id), makeElement(std::move(eased))});
    });
    return edit.empty() ? changed : changed.with(edit);
}

} // namespace

double largestChange(std::span<const Freedom> freedoms, const Eigen::VectorXd& values)
{
    std::map<std::tuple<ElementId, Freedom::Kind, int>, double> squares;
    for (std::size_t k = 0; k < freedoms.size(); ++k)
        if (freedoms[k].kind != Freedom::Kind::Number && freedoms[k].kind != Freedom::Kind::Size)
            squares[{freedoms[k].element, freedoms[k].kind, freedoms[k].index}] +=
                std::pow(values[static_cast<Eigen::Index>(k)], 2);
    double most = 0;
    for (const auto& [place, square] : squares)
        most = std::max(most, std::sqrt(square));
    return most;
}

Design withChange(const Design& design, std::span<const Freedom> freedoms, const Eigen::VectorXd& values,
                  bool easeIsFree)
{
    const Design changed = withFreedoms(design, freedoms, values);
    return easeIsFree ? withEases(design, changed) : changed;
}

} // namespace bolster
