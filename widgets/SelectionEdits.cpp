#include "SelectionEdits.h"

#include "CurveEdits.h"
#include "Document.h"
#include "ElementEdits.h"
#include "PatchEdits.h"
#include "Selection.h"

#include <QCoreApplication>

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

int pointCount(const Design& design, ElementId id)
{
    if (const Patch* patch = design.find<Patch>(id))
        return patch->outline.pointCount();
    if (const FixationCurve* curve = design.find<FixationCurve>(id))
        return curve->curve.pointCount();
    return 0;
}

Edit removePoints(const Design& design, const Selection::Points& points)
{
    EditChain chain(design);
    for (const auto& [id, indices] : byElement(points))
        for (auto index = indices.rbegin(); index != indices.rend();
             ++index) // the last first: the others stay valid
            chain.add(design.find<Patch>(id) ? edits::removePatchPoint(chain.design(), id, *index)
                                             : edits::removeCurvePoint(chain.design(), id, *index));
    return chain.result({QT_TRANSLATE_NOOP("Message", "Remove %1 points"), {std::to_string(points.size())}});
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

Edit movePointsInLayout(const Design& design, const Selection::Points& points, const Vec2& delta)
{
    EditChain chain(design);
    for (const auto& [id, indices] : byElement(points))
        if (const Patch* patch = design.find<Patch>(id)) {
            const Vec2 moved = fromLayout(*patch, delta) - fromLayout(*patch, Vec2::Zero());
            chain.add(edits::movePatchPoints(chain.design(), id, indices, moved));
        }
    return chain.result({QT_TRANSLATE_NOOP("Message", "Move %1 points"), {std::to_string(points.size())}});
}

Edit nudge(const Design& design, const Selection& selection, const Vec2& delta)
{
    if (!selection.points().empty())
        return movePointsInLayout(design, selection.points(), delta);
    const std::vector<ElementId> patches = selectedOf<Patch>(design, selection.elements());
    return patches.empty() ? Edit{} : edits::movePatches(design, patches, delta);
}

Edit removeSelected(const Design& design, const Selection& selection, QString* problem)
{
    const bool points = !selection.points().empty();
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
    std::erase_if(elements, [&](ElementId id) { return !design.element(id); });
    std::erase_if(points, [&](const Selection::Point& p) { return p.second >= pointCount(design, p.first); });
    selection.set(std::move(elements), std::move(points));
    if (selection.hovered() != settingsId && !design.element(selection.hovered()))
        selection.hover(settingsId);
}

void removeAndForget(Document& document, Selection& selection, const Edit& removal)
{
    selection.set(selection.elements());
    document.commit(removal);
}

} // namespace bolster
