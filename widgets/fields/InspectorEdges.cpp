// What the inspector shows of selected edges, and the size of patches.
#include "Document.h"
#include "Gesture.h"
#include "InspectorForms.h"
#include "LengthEdits.h"
#include "PatchShapeEdits.h"
#include "Units.h"

#include <cmath>

namespace bolster {

namespace {

const NumberBox::Range sizeRange{QStringLiteral(" mm"), 3, 0.001, 1e6, 1};

std::vector<Stretch> chosenEdges(const Selection& selection)
{
    std::vector<Stretch> edges;
    for (const Selection::Edge& edge : selection.edges())
        edges.push_back(edge.stretch);
    return edges;
}

/// What all of them are, or nothing where they differ by more than rounding.
template <class Read>
std::optional<double> sharedNumber(std::size_t count, const Read& read)
{
    if (count == 0)
        return std::nullopt;
    const double first = read(0);
    for (std::size_t i = 1; i < count; ++i)
        if (std::abs(read(i) - first) > 1e-6)
            return std::nullopt;
    return first;
}

/// As one edit; what would break something is taken back with a reason.
void commitChecked(Document& document, const std::function<Edit(const Design&)>& edit)
{
    Gesture gesture(document);
    gesture.update(edit(gesture.start()));
    gesture.commit();
}

} // namespace

void InspectorForms::addSelectedEdges(PropertyForm& form) const
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

void InspectorForms::addPatchSize(PropertyForm& form, const Ids& ids) const
{
    form.addNumbers(
        tr("Size"), sizeRange, 2,
        [this, ids](int axis) {
            return sharedNumber(ids.size(), [&](std::size_t i) {
                const Patch* patch = m_document.design().find<Patch>(ids[i]);
                return patch && !patch->outline.empty() ? patch->outline.boundingBox().sizes()[axis] : 0.0;
            });
        },
        [this, ids](int axis, double size) {
            commitChecked(m_document,
                          [&](const Design& now) { return edits::resizePatches(now, ids, axis, size); });
        });
}

} // namespace bolster
