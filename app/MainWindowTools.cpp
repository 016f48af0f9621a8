// What the window does with tools: one at a time, in whichever view.
#include "MainWindow.h"

#include "Actions.h"
#include "Docks.h"
#include "PatternView.h"

#include <QShortcut>

namespace bolster {

void MainWindow::connectTools()
{
    for (QAction* action : m_actions->patternTools) {
        const auto kind = static_cast<PatternToolKind>(action->data().toInt());
        connect(action, &QAction::triggered, this, [this, kind](bool begin) {
            m_surface->setTool(SurfaceToolKind::Select);
            m_pattern->setTool(begin ? kind : PatternToolKind::Select);
            updateToolActions(); // who asks for what is there has not ended it
        });
    }
    for (QAction* action : m_actions->surfaceTools) {
        const auto kind = static_cast<SurfaceToolKind>(action->data().toInt());
        connect(action, &QAction::triggered, this, [this, kind](bool begin) {
            m_surface->setTool(begin ? kind : SurfaceToolKind::Select);
            updateToolActions();
        });
    }
    // Whoever begins a tool in one view has ended the one in the other.
    connect(m_pattern, &PatternView::toolChanged, this, [this](PatternToolKind now) {
        if (now != PatternToolKind::Select)
            m_surface->setTool(SurfaceToolKind::Select);
        updateToolActions();
    });
    connect(m_surface, &SurfaceView::toolChanged, this, [this](SurfaceToolKind now) {
        if (now != SurfaceToolKind::Select)
            m_pattern->setTool(PatternToolKind::Select);
        updateToolActions();
    });
    // Escape ends it from a list, too: what has the keyboard is easily overlooked.
    for (QDockWidget* list :
         {m_docks->elements, m_docks->history, m_docks->seams, m_docks->fabrics, m_docks->spots})
        connect(new QShortcut(QKeySequence(Qt::Key_Escape), list, nullptr, nullptr, Qt::WidgetWithChildrenShortcut),
                &QShortcut::activated, this, [this] {
                    m_pattern->setTool(PatternToolKind::Select);
                    m_surface->setTool(SurfaceToolKind::Select);
                });
}

void MainWindow::updateToolActions()
{
    const bool inCover = m_surface->tool() != SurfaceToolKind::Select;
    for (QAction* action : m_actions->patternTools)
        action->setChecked(!inCover && static_cast<int>(m_pattern->tool()) == action->data().toInt());
    for (QAction* action : m_actions->surfaceTools)
        action->setChecked(static_cast<int>(m_surface->tool()) == action->data().toInt());
}

} // namespace bolster
