#include "SelectionEdits.h"

#include "CurveEdits.h"
#include "Document.h"
#include "ElementEdits.h"
#include "LengthEdits.h"
#include "PatchEdits.h"
#include "Selection.h"
#include "StretchToFix.h"
#include "TwinEdits.h"

#include <QCoreApplication>

#include <algorithm>
#include <map>

namespace bolster {

namespace {

using PointsByElement = std::map<ElementId, std::vector<int>>;

PointsByElement byElement(const Selection::Points& points)
{
    PointsByElement result;
    for (const auto& [id, point] : points)
        result[id].push_back(point);
    return result;
}

Edit removePoints(const Design& design, const Selection::Points& points)
{
    EditChain chain(design);
    for (const auto& [id, indices] : byElement(points))
        for (auto index = indices.rbegin(); index != indices.rend();
             ++index) { // the last first: the others stay valid
            const int inSpace = spacePoint(chain.design(), {id, *index});
            chain.add(inSpace < 0 ? edits::removePatchPoint(chain.design(), id, *index)
                                  : edits::removeCurvePoint(chain.design(), id, inSpace));
        }
    return chain.result({QT_TRANSLATE_NOOP("Message", "Remove %1 points"), {std::to_string(points.size())}});
}

/// The patch in whose coordinates the element's curve in the pattern is given.
const Patch* patchOf(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    const PatchCurve* drawn = element ? patchCurve(*element) : nullptr;
    return design.find<Patch>(drawn ? drawn->patch : id);
}

} // namespace

void EditChain::add(const Edit& edit)
{
    if (edit.empty())
        return;
    m_now = m_now.with(edit);
    m_verb = edit.verb;
    ++m_count;
}

Edit EditChain::result(Message verb) const
{
    return editBetween(m_start, m_now, m_count == 1 ? m_verb : std::move(verb));
}

int selectionPoint(const Element& element, int index)
{
    return planeCurve(element) ? firstSpacePoint + index : index;
}

int spacePoint(const Design& design, const Selection::Point& point)
{
    const ElementPtr element = design.element(point.first);
    const BSpline3* curve = element ? spaceCurve(*element) : nullptr;
    const int index = curve && planeCurve(*element) ? point.second - firstSpacePoint : point.second;
    return curve && index >= 0 && index < curve->pointCount() ? index : -1;
}

int planePoint(const Design& design, const Selection::Point& point)
{
    const ElementPtr element = design.element(point.first);
    const BSpline2* curve = element ? planeCurve(*element) : nullptr;
    return curve && point.second < curve->pointCount() ? point.second : -1;
}

Edit movePointsInLayout(const Design& design, const Selection::Points& points, const Vec2& delta)
{
    EditChain chain(design);
    for (const auto& [id, indices] : byElement(points))
        if (const Patch* patch = patchOf(design, id)) { // points in space lie beyond those of the curve
            const Vec2 moved = fromLayout(*patch, delta) - fromLayout(*patch, Vec2::Zero());
            chain.add(edits::movePatchPoints(chain.design(), id, indices, moved));
        }
    return chain.result({QT_TRANSLATE_NOOP("Message", "Move %1 points"), {std::to_string(points.size())}});
}

Selection::Points pointsOfEdges(const Design& design, const Selection& selection)
{
    Selection::Points points;
    for (const Selection::Edge& edge : selection.edges())
        for (const int point : edits::pointsOfEdge(design, edge.stretch))
            points.emplace(edge.stretch.patch, point);
    return points;
}

Edit nudge(const Design& design, const Selection& selection, const Vec2& delta)
{
    if (!selection.points().empty())
        return movePointsInLayout(design, selection.points(), delta);
    if (!selection.edges().empty())
        return movePointsInLayout(design, pointsOfEdges(design, selection), delta);
    const std::vector<ElementId> patches = selectedOf<Patch>(design, selection.elements());
    return patches.empty() ? Edit{} : edits::movePatches(design, patches, delta);
}

Edit removeSelected(const Design& design, const Selection& selection, QString* problem)
{
    const bool points = !selection.points().empty();
    const auto ofPatch = [&](const Selection::Edge& edge) { return edge.owner == edge.stretch.patch; };
    if (!points && std::ranges::any_of(selection.edges(), ofPatch)) {
        if (problem)
            *problem = QCoreApplication::translate(
                "SelectionEdits", "An edge cannot be removed: its points can, or with Esc the whole patch.");
        return {};
    }
    const std::vector<ElementId> ids(selection.elements().begin(), selection.elements().end());
    Edit edit = points ? removePoints(design, selection.points()) : edits::removeElements(design, ids);
    if (edit.empty() && !ids.empty() && problem)
        *problem =
            points ? QCoreApplication::translate("SelectionEdits", "Not removed: the curve needs these points.")
                   : QCoreApplication::translate("SelectionEdits", "Not removed: other elements need this fabric.");
    return edit;
}

void pruneSelection(Selection& selection, const Design& design)
{
    Selection::Elements elements = selection.elements();
    Selection::Points points = selection.points();
    Selection::Edges edges = selection.edges();
    std::erase_if(elements, [&](ElementId id) { return !design.element(id); });
    std::erase_if(edges, [&](const Selection::Edge& edge) {
        return !design.element(edge.owner) || !isOutlineEdge(design, edge.stretch);
    });
    std::erase_if(
        points, [&](const Selection::Point& p) { return planePoint(design, p) < 0 && spacePoint(design, p) < 0; });
    selection.set(std::move(elements), std::move(points), std::move(edges));
    if (selection.hovered() != noElement && !design.element(selection.hovered()))
        selection.hover(noElement);
}

void removeAndForget(Document& document, Selection& selection, const Edit& removal)
{
    selection.set(selection.elements());
    document.commit(removal);
}

std::set<ElementId> mirroredOfMarked(const Design& design, const Selection& selection)
{
    std::set<ElementId> marked = selection.elements();
    if (selection.hovered() != noElement)
        marked.insert(selection.hovered());
    return edits::mirroredElements(design, marked);
}

} // namespace bolster
