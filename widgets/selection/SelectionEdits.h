// What the keys and menus of every view do with the selection. Pure where it can be.
#pragma once

#include "Design.h"

#include <QString>

#include <span>

namespace bolster {

class Document;
class Selection;

/// Several edits as one: each is made for `design()`, the result leads from the start to the end.
class EditChain {
public:
    explicit EditChain(const Design& start)
        : m_start(start)
        , m_now(start)
    {}

    const Design& design() const { return m_now; }
    void add(const Edit& edit);
    /// With the verb of the only edit, or `verb` when there were several.
    Edit result(Message verb) const;

private:
    Design m_start;
    Design m_now;
    Message m_verb;
    int m_count = 0;
};

/// The selected elements of kind T.
template <class T>
std::vector<ElementId> selectedOf(const Design& design, const std::set<ElementId>& elements)
{
    std::vector<ElementId> result;
    for (const ElementId id : elements)
        if (design.find<T>(id))
            result.push_back(id);
    return result;
}

/// A handle curve has control points in the pattern and in space: in a selection the latter are numbered from here.
inline constexpr int firstSpacePoint = mostCurvePoints;
/// The number in the selection of control point `index` of an element's curve in space.
int selectionPoint(const Element& element, int index);
/// The control point of the element's curve in space that is meant, or -1.
int spacePoint(const Design& design, const std::pair<ElementId, int>& point);
/// Likewise of its curve in the pattern.
int planePoint(const Design& design, const std::pair<ElementId, int>& point);

/// Moves the selected control points of outlines, handle curves and fancy seams (given as in Selection) by `delta`
/// in the layout, mm.
Edit movePointsInLayout(const Design& design, const std::set<std::pair<ElementId, int>>& points, const Vec2& delta);
/// The control points of the selected edges, their corners included.
std::set<std::pair<ElementId, int>> pointsOfEdges(const Design& design, const Selection& selection);
/// Moves the selected points or edges or, without any, the selected patches in the layout.
Edit nudge(const Design& design, const Selection& selection, const Vec2& delta);
/// Removes the selected points or, without any, the selected elements with everything that needs them.
/// Empty when nothing can be removed; `problem` then says why.
Edit removeSelected(const Design& design, const Selection& selection, QString* problem);

/// Forgets selected elements and points that are gone.
void pruneSelection(Selection& selection, const Design& design);

/// Commits a removal; no other point takes the place of a removed one in the selection.
void removeAndForget(Document& document, Selection& selection, const Edit& removal);

/// What follows the selected elements and the one under the pointer as their mirror image.
std::set<ElementId> mirroredOfMarked(const Design& design, const Selection& selection);

} // namespace bolster
