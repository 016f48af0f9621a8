#include "CuttingCommands.h"

#include "Commands.h"
#include "CuttingPanel.h"
#include "Docks.h"
#include "ExportFlow.h"
#include "PatternView.h"
#include "Selection.h"

namespace bolster {

CuttingCommands::CuttingCommands(Commands& commands, const Parts& parts)
    : m_commands(commands)
    , m_parts(parts)
{
    commands.add({{.id = "cutting.check",
                   .text = tr("Chec&k before cutting"),
                   .icon = "warning",
                   .places = {"pattern.cutting/2"},
                   .does = [this] { check(); }}});
    connect(&m_parts.panel, &CuttingPanel::chosen, this, [this](const CutFinding& finding) {
        showPlace(finding.problem.element, finding.patch, finding.place);
    });
    connect(&m_parts.exports, &ExportFlow::placeWanted, this,
            [this](ElementId element, ElementId patch, const Vec2& place) {
                check();
                showPlace(element, patch, place);
            });
}

void CuttingCommands::check()
{
    Docks::reveal(m_parts.docks.cutting);
    m_parts.panel.setFocus();
}

void CuttingCommands::showPlace(ElementId element, ElementId patch, const Vec2& place)
{
    m_commands["layer.cutting"]->setChecked(true); // what is wrong is to be seen
    m_parts.selection.set({element});
    m_parts.pattern.reveal({patch, place});
    m_parts.pattern.showPlace(CoverPoint{patch, place});
}

} // namespace bolster
