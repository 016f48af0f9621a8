#include "DesignCheck.h"

#include "ElementRules.h"
#include "PatternSize.h"
#include "StretchLength.h"

#include <algorithm>
#include <cmath>
#include <map>

namespace bolster {

namespace {

// Patches that hang together through seams.
class Components {
public:
    void join(ElementId a, ElementId b) { m_parent.at(root(a)) = root(b); }

    ElementId root(ElementId id)
    {
        for (;;) {
            ElementId& parent = m_parent.try_emplace(id, id).first->second;
            if (parent == id)
                return id;
            parent = m_parent.at(parent); // halves the way for the next one
            id = parent;
        }
    }

private:
    std::map<ElementId, ElementId> m_parent;
};

void warnOfFreePatches(const Design& design, Problems& problems)
{
    Components components;
    design.each<Seam>([&](ElementId, const Seam& seam) { components.join(seam.a.patch, seam.b.patch); });
    std::set<ElementId> fixed;
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) {
        if (seam.hasCurve())
            fixed.insert(components.root(seam.stretch.patch));
    });
    design.each<HandleCurve>([&](ElementId, const HandleCurve& handle) {
        if (handle.hasTarget())
            fixed.insert(components.root(handle.patch));
    });

    // What is filled is a cushion or a pillow: it lies wherever somebody puts it.
    design.each<Patch>([&](ElementId id, const Patch& patch) {
        if (patch.pressure > 0)
            fixed.insert(components.root(id));
    });

    std::map<ElementId, std::vector<ElementId>> free;
    design.each<Patch>([&](ElementId id, const Patch&) {
        if (const ElementId root = components.root(id); !fixed.contains(root))
            free[root].push_back(id);
    });
    for (const auto& [root, patches] : free) {
        const ElementId id = patches.front();
        Message message{QT_TRANSLATE_NOOP("Message",
                                          "the patch is free in space: nothing fixes it to the frame; add a "
                                          "fixation")};
        if (patches.size() > 1)
            message = {QT_TRANSLATE_NOOP("Message",
                                         "this patch and the %1 sewn to it are free in space: nothing fixes "
                                         "them to the frame; add a fixation"),
                       {std::to_string(patches.size() - 1)}};
        problems.push_back({id, elementLabel(id, *design.element(id)), "", std::move(message), Severity::Warning});
    }
}

void sortByPlace(Problems& problems)
{
    std::stable_sort(problems.begin(), problems.end(), [](const Problem& a, const Problem& b) {
        return std::tie(a.element, a.field) < std::tie(b.element, b.field);
    });
}

} // namespace

Problems checkDesign(const Design& design)
{
    Problems problems;
    ElementRules rules(design, problems);
    rules.check(settingsId, *design.element(settingsId));
    for (const auto& [id, element] : design.elements())
        rules.check(id, *element);
    warnOfFreePatches(design, problems);
    sortByPlace(problems);
    return problems;
}

Problems allProblems(const ReadDesign& read)
{
    Problems problems = checkDesign(read.design); // repeats those of the elements
    std::copy_if(read.problems.begin(), read.problems.end(), std::back_inserter(problems),
                 [](const Problem& problem) { return problem.element == settingsId; });
    sortByPlace(problems);
    return problems;
}

double smallestEdgeLength(const Design& design)
{
    constexpr double mostTriangles = 5e6;
    return edgeLengthFor(patternArea(design), mostTriangles / 2);
}

double seamEase(const Design& design, const Seam& seam)
{
    return ease(stretchLength(design, seam.a), stretchLength(design, seam.b));
}

bool puckers(double lengthA, double lengthB, double wanted)
{
    return std::abs(lengthB - lengthA - wanted) > mostEase * std::min(lengthA, lengthB);
}

bool puckers(const Design& design, const Seam& seam)
{
    return puckers(stretchLength(design, seam.a), stretchLength(design, seam.b), seam.ease);
}

} // namespace bolster
