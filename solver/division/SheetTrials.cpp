#include "SheetTrials.h"

#include "Division.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

namespace bolster {

namespace {

constexpr double sewnMore = 0.95; // of the limit
constexpr double leastEdges = 5;  // across a piece

} // namespace

SheetTrials::SheetTrials(FormCuts formCuts, const FormPatternOrder& order, const std::stop_token& stop)
    : cuts(std::move(formCuts))
    , m_order(order)
    , m_limit(bearableStrain(order.fabric))
    , m_least(std::pow(leastEdges * order.edgeLength, 2))
    , m_stop(stop)
{
    m_order.twins = false;
}

double SheetTrials::limitAlone() const
{
    return sewnMore * m_limit;
}

Form SheetTrials::formOf(const FormSheet& sheet, const FormCuts& along) const
{
    TriangleMesh mesh;
    append(mesh, sheet, "");
    return cutForm(mesh, along, m_stop);
}

Form SheetTrials::withoutSlits(const FormSheet& sheet) const
{
    FormCuts others = cuts;
    others.edges.clear();
    return formOf(sheet, others);
}

std::vector<bool> SheetTrials::badOnes(const Form& form, FlattenOrder flattening, double limit) const
{
    flattening.poisson = m_order.fabric.poisson;
    std::vector<bool> bad(form.pieces.size(), false);
    const std::vector<FlatPiece> flat = flatten(form, flattening, m_stop);
    if (isStopped() || flat.empty())
        return bad;
    const std::vector<bool> become = becomePatches(form, flat, m_order, m_stop);
    for (std::size_t p = 0; p < bad.size() && !isStopped(); ++p)
        bad[p] = !become[p] || flat[p].strainP99 > limit;
    return bad;
}

bool SheetTrials::liesFlat(const Form& form) const
{
    const std::vector<bool> bad = badOnes(form, trialFlattening, limitAlone());
    return !bad.empty() && !isStopped() && std::ranges::count(bad, true) == 0;
}

bool SheetTrials::liesFlat(const FormSheet& sheet, const Form& form) const
{
    if (liesFlat(form))
        return true;
    const bool hasSlits = !cuts.edges.empty() && form.pieces.size() == 1 && !slitsOf(form, 0).empty();
    return hasSlits && liesFlat(withoutSlits(sheet));
}

double SheetTrials::strainOf(const Form& form) const
{
    FlattenOrder flattening = trialFlattening;
    flattening.poisson = m_order.fabric.poisson;
    const std::vector<FlatPiece> flat = flatten(form, flattening, m_stop);
    const bool lies = !flat.empty() && becomePatches(form, flat, m_order, m_stop).front();
    return lies ? flat.front().strainP99 : std::numeric_limits<double>::infinity();
}

} // namespace bolster
