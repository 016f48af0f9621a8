#include "DartCommands.h"

#include "Commands.h"
#include "CommitEdit.h"
#include "DartDrag.h"
#include "DartEdits.h"
#include "Document.h"
#include "PatternView.h"
#include "Selection.h"
#include "StatusLine.h"
#include "Translated.h"

namespace bolster {

DartCommands::DartCommands(Commands& commands, Document& document, Selection& selection, PatternView& pattern,
                           StatusLine& status)
    : m_document(document)
    , m_selection(selection)
    , m_pattern(pattern)
    , m_status(status)
{
    commands.add(
        {{.id = "dart.close",
          .text = tr("Remove da&rt"),
          .tip = tr("The edge goes on as if the selected dart had never been cut"),
          .places = {"pattern.points/2", "seam/2"},
          .enabled = [this] { return isSelected(); },
          .does = [this] { close(); }},
         {.id = "dart.rotate",
          .text = tr("R&otate dart to \u2026"),
          .tip = tr("Turns the selected dart shut and opens the pattern where you click, by the same angle"),
          .places = {"pattern.points/2", "seam/2"},
          .enabled = [this] { return isSelected(); },
          .does = [this] { m_pattern.setTool(PatternToolKind::DartRotation); }}});
}

bool DartCommands::isSelected() const
{
    return selectedDart(m_document.design(), m_selection) != noElement;
}

void DartCommands::close()
{
    m_document.cancelGesture();
    const ElementId seam = selectedDart(m_document.design(), m_selection);
    const auto dart = edits::dartOf(m_document.design(), seam);
    Message problem;
    const Edit edit = edits::removeDart(m_document.design(), seam, &problem);
    if (dart && !edit.empty())
        m_selection.set({dart->patch}); // the seam goes, and its points get other numbers
    commitOrTell(m_document, m_status, edit, translated(problem));
}

} // namespace bolster
