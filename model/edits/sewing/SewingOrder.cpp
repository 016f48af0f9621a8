#include "SewingOrder.h"

#include "EditHelpers.h"
#include "StretchLength.h"

#include <algorithm>
#include <limits>
#include <map>
#include <tuple>

namespace bolster {

namespace {

constexpr double afterNumbered = std::numeric_limits<double>::infinity();

struct OrderedSeam {
    ElementId id{};
    double step = 0;
    std::size_t a = 0, b = 0; // patches
    double length = 0;        // of the first side, mm
};

/// Parts of the cover that hang together.
class SewnParts {
public:
    explicit SewnParts(std::size_t patches)
        : m_part(patches)
        , m_patches(patches)
    {
        for (std::size_t i = 0; i < patches; ++i)
            m_patches[m_part[i] = i] = {i};
    }
    bool together(const OrderedSeam& seam) const { return m_part[seam.a] == m_part[seam.b]; }
    std::size_t part(std::size_t patch) const { return m_part[patch]; }
    std::size_t patches(std::size_t patch) const { return m_patches[m_part[patch]].size(); }
    void join(const OrderedSeam& seam)
    {
        const std::size_t into = m_part[seam.a], from = m_part[seam.b];
        if (into == from)
            return;
        for (const std::size_t patch : m_patches[from]) {
            m_part[patch] = into;
            m_patches[into].push_back(patch);
        }
    }

private:
    std::vector<std::size_t> m_part;                 // of each patch
    std::vector<std::vector<std::size_t>> m_patches; // of each part
};

/// What comes next; smaller is sooner.
std::tuple<double, std::size_t, int, std::size_t, double> rank(const OrderedSeam& seam, const SewnParts& now,
                                                               const SewnParts& whole)
{
    if (seam.step > 0)
        return {seam.step, 0, 0, 0, 0};
    const std::size_t cover = whole.part(seam.a);
    if (seam.a == seam.b)
        return {afterNumbered, cover, 1, 0, seam.length};
    if (!now.together(seam))
        return {afterNumbered, cover, 3, now.patches(seam.a) + now.patches(seam.b), seam.length};
    return {afterNumbered, cover, now.patches(seam.a) < whole.patches(seam.a) ? 2 : 4, 0, seam.length};
}

} // namespace

std::vector<SewingStep> sewingOrder(const Design& design)
{
    std::map<ElementId, std::size_t> patches;
    design.each<Patch>([&](ElementId id, const Patch&) { patches.emplace(id, patches.size()); });
    std::vector<OrderedSeam> seams; // still to be sewn, by id
    SewnParts now(patches.size()), whole = now;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const auto a = patches.find(seam.a.patch), b = patches.find(seam.b.patch);
        if (a == patches.end() || b == patches.end())
            return;
        seams.push_back({id, seam.step, a->second, b->second, stretchLength(design, seam.a)});
        whole.join(seams.back());
    });
    std::vector<SewingStep> order;
    while (!seams.empty()) {
        const auto next =
            std::ranges::min_element(seams, {}, [&](const OrderedSeam& seam) { return rank(seam, now, whole); });
        order.push_back({next->id, next->a != next->b && now.together(*next)});
        now.join(*next);
        seams.erase(next);
    }
    return order;
}

namespace edits {

namespace {

/// Gives each seam the number that steps has for it.
Edit withSteps(const Design& design, const std::map<ElementId, double>& steps, const char* verb)
{
    Edit edit{{verb}, {}};
    for (const auto& [id, step] : steps) {
        Seam seam = *design.find<Seam>(id);
        if (std::exchange(seam.step, step) != step)
            edit.changes.push_back({id, design.element(id), makeElement(seam)});
    }
    return edit.changes.empty() ? Edit{} : edit;
}

} // namespace

Edit moveInSewingOrder(const Design& design, std::span<const ElementId> seams, SewingMove move)
{
    std::vector<SewingStep> order = sewingOrder(design);
    const auto chosen = [&](const SewingStep& step) { return std::ranges::find(seams, step.seam) != seams.end(); };
    if (move == SewingMove::Later)
        std::ranges::reverse(order);
    bool moved = false;
    for (std::size_t i = 1; i < order.size(); ++i)
        if (chosen(order[i]) && !chosen(order[i - 1])) {
            std::swap(order[i], order[i - 1]);
            moved = true;
        }
    if (!moved)
        return {};
    if (move == SewingMove::Later)
        std::ranges::reverse(order);
    std::map<ElementId, double> steps;
    for (const SewingStep& step : order)
        steps.emplace(step.seam, static_cast<double>(steps.size()) + 1);
    return withSteps(design, steps,
                     move == SewingMove::Earlier ? QT_TRANSLATE_NOOP("Message", "Sew earlier")
                                                 : QT_TRANSLATE_NOOP("Message", "Sew later"));
}

Edit proposeSewingOrder(const Design& design)
{
    std::map<ElementId, double> steps;
    design.each<Seam>([&](ElementId id, const Seam&) { steps.emplace(id, 0); });
    return withSteps(design, steps, QT_TRANSLATE_NOOP("Message", "Sew in the proposed order"));
}

} // namespace edits

} // namespace bolster
