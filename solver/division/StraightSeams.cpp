#include "StraightSeams.h"

#include "JoinedSheets.h"
#include "SheetCut.h"

#include <algorithm>
#include <optional>
#include <utility>

namespace bolster {

namespace {

constexpr double straightMore = 1.1;  // times the strain: what a straighter seam may cost,
constexpr double littleStrain = 0.85; // or up to so much of the limit
constexpr double shorter = 0.99;      // times as long: worth another line

/// Two neighbours, with a smooth line between them but for creases.
std::optional<std::array<FormSheet, 2>> partedStraight(const FormSheet& one, const FormSheet& other,
                                                       const SheetTrials& trials)
{
    const Form form = trials.formOf(together(one, other));
    if (form.pieces.size() != 1 || !slitsOf(form, 0).empty() ||
        form.pieces[0].triangles.size() != one.triangles.size() + other.triangles.size())
        return std::nullopt;
    FormSheet both = sheetOf(form.points, form.pieces[0]);
    Halves halves;
    halves.ofTriangles.assign(one.triangles.size(), -1);
    halves.ofTriangles.resize(both.triangles.size(), 1);
    halves.ofPoints.resize(both.points.size(), 0);
    std::vector<double> areas(both.points.size(), 0);
    for (std::size_t t = 0; t < both.triangles.size(); ++t)
        for (const int corner : both.triangles[t]) {
            halves.ofPoints[corner] += both.areaNormal(t).norm() * halves.ofTriangles[t];
            areas[corner] += both.areaNormal(t).norm();
        }
    for (std::size_t v = 0; v < areas.size(); ++v)
        halves.ofPoints[v] /= std::max(areas[v], 1e-300);
    auto parts = cutInTwo(std::move(both), halves, creaseBend);
    if (parts[0].triangles.empty() || parts[1].triangles.empty())
        return std::nullopt;
    return parts;
}

} // namespace

void straighten(std::vector<FormSheet>& sheets, const SheetTrials& trials)
{
    for (const auto& [pair, length] : commonLengths(sheets, trials)) {
        FormSheet &one = sheets[pair.first], &other = sheets[pair.second];
        std::optional<std::array<FormSheet, 2>> anew = partedStraight(one, other, trials);
        if (!anew || trials.isStopped())
            continue;
        const Form a = trials.formOf(one), b = trials.formOf(other), c = trials.formOf((*anew)[0]),
                   d = trials.formOf((*anew)[1]);
        const auto isPiece = [](const Form& form) { return form.pieces.size() == 1 && form.opened.empty(); };
        if (!isPiece(c) || !isPiece(d) || borderOf(c) + borderOf(d) > shorter * (borderOf(a) + borderOf(b)))
            continue;
        const double most = std::max(trials.strainOf(a), trials.strainOf(b)),
                     now = std::max(trials.strainOf(c), trials.strainOf(d));
        if (now > std::min(trials.limitAlone(), std::max(straightMore * most, littleStrain * trials.limit())))
            continue;
        one = std::move((*anew)[0]);
        other = std::move((*anew)[1]);
    }
}

} // namespace bolster
