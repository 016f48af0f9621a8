// What the window does with seams.
#include "MainWindow.h"

#include "Actions.h"
#include "Docks.h"
#include "SeamEdits.h"
#include "SeamsView.h"
#include "SelectionEdits.h"

#include <QTreeView>

#include <algorithm>

namespace bolster {

void MainWindow::connectSewing()
{
    const auto on = [this](QAction* action, auto edit) {
        connect(action, &QAction::triggered, this, [this, action, edit] {
            document().cancelGesture();
            const Design& design = document().design();
            document().commit(
                edit(design, selectedOf<Seam>(design, m_selection.elements()), action->data().toInt()));
            updateSeamActions(); // an action that changed nothing stays as it was
        });
    };
    using Seams = std::vector<ElementId>;
    on(m_actions->flipSeams,
       [](const Design& design, const Seams& seams, int) { return edits::flipSeams(design, seams); });
    on(m_actions->swapSeamSides,
       [](const Design& design, const Seams& seams, int) { return edits::swapSeamSides(design, seams); });
    for (QAction* action : m_actions->seamContinuities)
        on(action, [](const Design& design, const Seams& seams, int value) {
            return edits::setContinuity(design, seams, static_cast<Continuity>(value));
        });
    for (QAction* action : m_actions->seamMatches)
        on(action, [](const Design& design, const Seams& seams, int value) {
            return edits::setMatch(design, seams, static_cast<Match>(value));
        });
    connect(m_actions->showSeamList, &QAction::triggered, this, [this] { Docks::reveal(m_docks->seams); });

    QTreeView& table = m_seams->table();
    const auto separator = [&table] {
        auto* line = new QAction(&table);
        line->setSeparator(true);
        return line;
    };
    table.addActions({m_actions->flipSeams, m_actions->swapSeamSides, separator()});
    table.addActions(m_actions->seamContinuities);
    table.addAction(separator());
    table.addActions(m_actions->seamMatches);
    table.addActions({separator(), m_actions->fitSelection, m_actions->remove});
    connect(m_seams, &SeamsView::shown, this, &MainWindow::fitSelection);
    connect(&m_selection, &Selection::changed, this, &MainWindow::updateSeamActions);
    connect(&document(), &Document::changed, this, &MainWindow::updateSeamActions);
    updateSeamActions();
}

void MainWindow::updateSeamActions()
{
    const Design& design = document().design();
    const std::vector<ElementId> seams = selectedOf<Seam>(design, m_selection.elements());
    const auto all = [&](auto has) {
        return !seams.empty() &&
               std::ranges::all_of(seams, [&](ElementId id) { return has(*design.find<Seam>(id)); });
    };
    for (QAction* action : m_actions->seamContinuities) {
        const auto value = static_cast<Continuity>(action->data().toInt());
        action->setEnabled(!seams.empty());
        action->setChecked(all([value](const Seam& seam) { return seam.continuity == value; }));
    }
    for (QAction* action : m_actions->seamMatches) {
        const auto value = static_cast<Match>(action->data().toInt());
        action->setEnabled(!seams.empty());
        action->setChecked(all([value](const Seam& seam) { return seam.match == value; }));
    }
    m_actions->flipSeams->setEnabled(!seams.empty());
    m_actions->swapSeamSides->setEnabled(!seams.empty());
}

} // namespace bolster
