#include "FixingCommands.h"

#include "Commands.h"
#include "CommitEdit.h"
#include "Document.h"
#include "FixationEdits.h"
#include "Selection.h"
#include "SolverLink.h"
#include "StatusLine.h"
#include "StretchToFix.h"
#include "Translated.h"

namespace bolster {

FixingCommands::FixingCommands(Commands& commands, Document& document, Selection& selection, SolverLink& solver,
                               StatusLine& status)
    : m_document(document)
    , m_selection(selection)
    , m_solver(solver)
    , m_status(status)
{
    commands.add({.id = "fixation.create",
                  .formerly = "create-fixation-curve",
                  .text = tr("&Create fixation curve"),
                  .icon = "create-fixation",
                  .keys = {Qt::CTRL | Qt::SHIFT | Qt::Key_F},
                  .places = {"frame/1"},
                  .bar = 321,
                  .enabled = [this] { return stretchToFix(m_document.design(), m_selection).has_value(); },
                  .does = [this] { create(); }});
}

void FixingCommands::create()
{
    m_document.cancelGesture();
    const Design& design = m_document.design();
    const std::optional<Stretch> stretch = stretchToFix(design, m_selection);
    if (!stretch) {
        m_status.flash(tr("Select two points of an outline first: what lies between them is fixed."));
        return;
    }
    if (const auto problem = edits::fixationProblem(design, *stretch)) {
        m_status.flash(translated(*problem));
        return;
    }
    int count = 1;
    design.each<FixationCurve>([&](ElementId, const FixationCurve&) { ++count; });
    const SurfaceMeshPtr surface = m_solver.surface();
    const std::string name = tr("Fixation %1").arg(count).toStdString();
    insertOrTell(m_document, m_selection, m_status,
                 surface ? edits::addFixationFromSurface(design, *surface, *stretch, name) : Edit{},
                 tr("There is no surface of this patch yet on which the curve could lie."));
}

} // namespace bolster
