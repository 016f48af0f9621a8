#include "PatchDrawingTool.h"

#include "DesignCheck.h"
#include "Document.h"
#include "DrawingKeys.h"
#include "OutlineEdits.h"
#include "Selection.h"
#include "Translated.h"

#include <QKeyEvent>

#include <set>

namespace bolster {

Snapped snappedPointer(const PatternToolContext& context, const PatternPointer& pointer, SnapQuery query)
{
    query.at = pointer.layout;
    if (pointer.modifiers & (Qt::ControlModifier | Qt::AltModifier))
        return {query.at, {}};
    return Snapper(context.scene(), context.transform(), context.snapSettings()).snap(query);
}

bool PatchDrawingTool::keyPress(const QKeyEvent& event)
{
    if (begun() && m_typed.keyPress(event))
        pointerMoved();
    else if (event.key() == Qt::Key_Backspace && begun())
        takeBack();
    else if (event.key() == Qt::Key_Return || event.key() == Qt::Key_Enter)
        enter();
    else if (isDigitKey(event.key()) && !event.modifiers().testFlag(Qt::ControlModifier))
        m_context.report(prompt()); // of nothing that has been begun
    else
        return false;
    m_context.refresh();
    return true;
}

bool PatchDrawingTool::wants(int key) const
{
    return (begun() && (m_typed.wants(key) || key == Qt::Key_Backspace)) || isEnterKey(key) || isDigitKey(key);
}

ToolKeys PatchDrawingTool::keys() const
{
    return begun() ? DrawingKeys::ofLine(false) : ToolKeys();
}

bool PatchDrawingTool::escape()
{
    if (m_typed.open()) {
        m_typed.clear();
        pointerMoved();
    } else if (begun()) {
        giveUp();
    } else {
        m_context.endTool();
    }
    m_context.refresh();
    return true;
}

void PatchDrawingTool::leave()
{
    m_pointer.reset();
    pointerMoved();
    m_context.refresh();
}

std::string PatchDrawingTool::freeName() const
{
    std::set<std::string> taken;
    int number = 1;
    m_context.document().design().each<Patch>([&](ElementId, const Patch& patch) {
        taken.insert(patch.name);
        ++number;
    });
    while (taken.contains(tr("Patch %1").arg(number).toStdString()))
        ++number;
    return tr("Patch %1").arg(number).toStdString();
}

bool PatchDrawingTool::finish(const std::optional<BSpline2>& outline)
{
    if (!outline) {
        m_context.report(tr("An outline needs at least three points in different places."));
        return false;
    }
    if (const std::optional<Message> problem = outlineProblem(*outline)) {
        m_context.report(tr("This cannot be a patch: %1").arg(translated(*problem)));
        return false;
    }
    Document& document = m_context.document();
    const Edit added = edits::addPatch(document.design(), *outline, freeName());
    if (added.empty())
        return false;
    giveUp();
    document.commit(added);
    m_context.selection().set({added.changes.back().id});
    m_context.endTool();
    return true;
}

} // namespace bolster
