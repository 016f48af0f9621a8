// Corners, straight stretches and merging.
#include "Commands.h"
#include "CornerEdits.h"
#include "Document.h"
#include "Gesture.h"
#include "LengthEdits.h"
#include "PatchMerge.h"
#include "PatternCommands.h"
#include "SeamTruing.h"
#include "Selection.h"
#include "SelectionEdits.h"
#include "Translated.h"

#include <algorithm>
#include <map>

namespace bolster {

namespace {

/// The selected control points in the pattern, by their element.
std::map<ElementId, std::vector<int>> planePoints(const Design& design, const Selection& selection)
{
    std::map<ElementId, std::vector<int>> points;
    for (const Selection::Point& point : selection.points())
        if (const int index = planePoint(design, point); index >= 0)
            points[point.first].push_back(index);
    return points;
}

} // namespace

void PatternCommands::addPoints(Commands& commands)
{
    commands.add(MenuPlace{"pattern.points", tr("Poin&ts and edges"), "pattern/2"});
    const auto stretch = [this] {
        const auto points = planePoints(m_document.design(), m_selection);
        return points.size() == 1 && points.begin()->second.size() == 2;
    };
    commands.add({{.id = "shape.make-corner",
                   .formerly = "make-corner",
                   .text = tr("Make &corner"),
                   .keys = {Qt::CTRL | Qt::Key_K},
                   .places = {"pattern.points/1"},
                   .enabled = [this] { return hasPoints(false); },
                   .does = [this] { makeCorners(true); }},
                  {.id = "shape.make-smooth",
                   .formerly = "make-smooth",
                   .text = tr("Make s&mooth"),
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_K},
                   .places = {"pattern.points/1"},
                   .enabled = [this] { return hasPoints(true); },
                   .does = [this] { makeCorners(false); }},
                  {.id = "shape.straighten",
                   .formerly = "straighten",
                   .text = tr("Strai&ghten"),
                   .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_G},
                   .places = {"pattern.points/1"},
                   .enabled = stretch,
                   .does = [this] { straighten(); }}});
}

void PatternCommands::addEdges(Commands& commands)
{
    const auto comparable = [this] {
        return m_selection.edges().size() >= 2 ||
               !selectedOf<Seam>(m_document.design(), m_selection.elements()).empty();
    };
    commands.add(
        {{.id = "shape.edge-length",
          .formerly = "edge-length",
          .text = tr("Edge &length \u2026"),
          .keys = {Qt::Key_L},
          .tip = tr("Type the length of the selected edge"),
          .places = {"pattern.points/1"},
          .enabled = [this] { return !m_selection.edges().empty(); },
          .does = [this] { emit edgeLengthWanted(); }},
         {.id = "shape.equal-lengths",
          .formerly = "make-equally-long",
          .text = tr("Make e&qually long"),
          .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_E},
          .tip = tr("Makes the selected edges as long as the first one, or the second side of a seam as "
                    "long as its first"),
          .places = {"pattern.points/1"},
          .enabled = comparable,
          .does = [this] { equalise(); }},
         {.id = "shape.common-tangents",
          .text = tr("Smooth &across seam ends"),
          .tip = tr("Outlines go on without a kink from one patch to the other where the selected seams end, "
                    "when both sides lie together"),
          .places = {"pattern.points/1"},
          .enabled = [this] { return !selectedOf<Seam>(m_document.design(), m_selection.elements()).empty(); },
          .does = [this] { smoothSeamEnds(); }}});
    commands.add(MenuPlace{"pattern.twins", tr("Mirror twi&ns"), "pattern/2"}); // filled by TwinCommands
    commands.add({.id = "shape.merge-patches",
                  .formerly = "merge-along-seam",
                  .text = tr("Merge a&long seam"),
                  .keys = {Qt::CTRL | Qt::Key_J},
                  .places = {"pattern/2"},
                  .enabled = [this] { return seamToMerge().has_value(); },
                  .does = [this] { merge(); }});
}

/// Selected ones that are corners (ends of open curves do not count), or that are none.
bool PatternCommands::hasPoints(bool corner) const
{
    const Design& design = m_document.design();
    for (const auto& [id, indices] : planePoints(design, m_selection))
        for (const int index : indices) {
            const BSpline2& curve = *planeCurve(*design.element(id));
            const bool end = !curve.closed() && (index == 0 || index == curve.pointCount() - 1);
            const bool isCorner = edits::isCornerPoint(design, id, index);
            if (corner ? isCorner && !end : !isCorner)
                return true;
        }
    return false;
}

void PatternCommands::makeCorners(bool corner)
{
    m_document.cancelGesture();
    EditChain chain(m_document.design());
    const auto points = planePoints(chain.design(), m_selection);
    for (const auto& [id, indices] : points)
        chain.add(corner ? edits::makeCorners(chain.design(), id, indices)
                         : edits::makeSmooth(chain.design(), id, indices));
    // Points come and go: what was selected is found again at its parameter.
    Selection::Points found;
    for (const auto& [id, indices] : points)
        for (const int index : indices) {
            const BSpline2& before = *planeCurve(*m_document.design().element(id));
            found.insert({id, planeCurve(*chain.design().element(id))->pointAt(before.parameterOfPoint(index))});
        }
    const Edit edit = chain.result(corner ? Message{QT_TRANSLATE_NOOP("Message", "Make corners"), {}}
                                          : Message{QT_TRANSLATE_NOOP("Message", "Make curves smooth"), {}});
    m_selection.set(m_selection.elements());
    if (commit(edit))
        m_selection.set(m_selection.elements(), std::move(found));
}

void PatternCommands::straighten()
{
    m_document.cancelGesture();
    const auto points = planePoints(m_document.design(), m_selection);
    if (points.size() != 1 || points.begin()->second.size() != 2)
        return;
    const auto& [id, ends] = *points.begin();
    const Edit edit = edits::straighten(m_document.design(), id, ends[0], ends[1]);
    if (edit.empty()) {
        emit said(tr("This stretch is straight already."));
        return;
    }
    m_selection.set(m_selection.elements()); // the points have other numbers now
    commit(edit);
}

/// Two or more edges; else the sides of the selected seams.
void PatternCommands::equalise()
{
    std::vector<Stretch> edges;
    for (const Selection::Edge& edge : m_selection.edges())
        edges.push_back(edge.stretch);
    const std::vector<ElementId> seams = selectedOf<Seam>(m_document.design(), m_selection.elements());
    Message problem;
    Gesture gesture(m_document); // what would break something is taken back with a reason
    const Edit edit = edges.size() >= 2 ? edits::makeEdgesEqual(gesture.start(), edges, &problem)
                                        : edits::makeSeamSidesEqual(gesture.start(), seams, &problem);
    if (edit.empty()) {
        emit said(problem.empty() ? tr("They are equally long already.") : translated(problem));
        return;
    }
    gesture.update(edit);
    gesture.commit();
}

void PatternCommands::smoothSeamEnds()
{
    const std::vector<ElementId> seams = selectedOf<Seam>(m_document.design(), m_selection.elements());
    Message problem;
    Gesture gesture(m_document); // what would break something is taken back with a reason
    const Edit edit = edits::smoothAcrossSeamEnds(gesture.start(), seams, &problem);
    if (edit.empty()) {
        emit said(problem.empty() ? tr("They go on without a kink already.") : translated(problem));
        return;
    }
    m_selection.set(m_selection.elements()); // points of polygons have other numbers then
    gesture.update(edit);
    gesture.commit();
}

/// The selected seam, the first one of several between the same patches, or the one between two selected patches.
std::optional<ElementId> PatternCommands::seamToMerge() const
{
    const Design& design = m_document.design();
    const std::vector<ElementId> seams = selectedOf<Seam>(design, m_selection.elements());
    const auto joined = [&](ElementId id) {
        const Seam& seam = *design.find<Seam>(id);
        return std::minmax(seam.a.patch, seam.b.patch);
    };
    if (!seams.empty() && m_selection.elements().size() == seams.size()) {
        const std::pair<ElementId, ElementId> both = joined(seams.front());
        const bool same = std::ranges::all_of(
            seams, [&](ElementId id) { return std::pair<ElementId, ElementId>(joined(id)) == both; });
        return same ? std::optional(seams.front()) : std::nullopt;
    }
    const std::vector<ElementId> chosen = patches();
    if (chosen.size() != 2 || m_selection.elements().size() != 2)
        return std::nullopt;
    std::optional<ElementId> found;
    design.each<Seam>([&](ElementId id, const Seam& seam) {
        const bool joins = (seam.a.patch == chosen[0] && seam.b.patch == chosen[1]) ||
                           (seam.a.patch == chosen[1] && seam.b.patch == chosen[0]);
        if (joins && !found)
            found = id;
    });
    return found;
}

void PatternCommands::merge()
{
    m_document.cancelGesture();
    const std::optional<ElementId> seam = seamToMerge();
    if (!seam)
        return;
    const ElementId stays = m_document.design().find<Seam>(*seam)->a.patch;
    if (commit(edits::mergePatches(m_document.design(), *seam)))
        m_selection.set({stays});
}

} // namespace bolster
