#include "SelectedEdgesForm.h"

#include "CheckedNumber.h"
#include "ElementText.h"
#include "LengthEdits.h"
#include "PropertyForm.h"
#include "Selection.h"
#include "Units.h"

namespace bolster {

namespace {

std::vector<Stretch> chosenEdges(const Selection& selection)
{
    std::vector<Stretch> edges;
    for (const Selection::Edge& edge : selection.edges())
        edges.push_back(edge.stretch);
    return edges;
}

} // namespace

void SelectedEdgesForm::add(PropertyForm& form) const
{
    const std::vector<Stretch> edges = chosenEdges(m_selection);
    if (edges.empty())
        return;
    form.addNumber(
        edges.size() == 1 ? tr("Edge length") : tr("Edge lengths"), sizeRange,
        [this, edges] {
            return sharedNumber(edges.size(),
                                [&](std::size_t i) { return edits::edgeLength(m_document.design(), edges[i]); });
        },
        [this, edges](double length) {
            Message problem;
            commitChecked(m_document,
                          [&](const Design& now) { return edits::setEdgeLengths(now, edges, length, &problem); });
            if (!problem.empty())
                emit m_document.refused(problem);
        });
    if (edges.size() > 1)
        form.addNote([this, edges] {
            return tr("%1 edges. Of \"Make equally long\" the first one stays: %2 of %3.")
                .arg(edges.size())
                .arg(lengthText(edits::edgeLength(m_document.design(), edges.front())),
                     displayName(m_document.design(), edges.front().patch));
        });
    else if (m_selection.edges().front().owner != edges.front().patch)
        form.addInfo(tr("Edge of"),
                     [this, edges] { return displayName(m_document.design(), edges.front().patch); });
}

} // namespace bolster
