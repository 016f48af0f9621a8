// What the window does with its panels and the keyboard.
#include "MainWindow.h"

#include "Actions.h"
#include "Background.h"
#include "CommandPalette.h"
#include "CompareWindow.h"
#include "Docks.h"
#include "ElementsView.h"
#include "HistoryModel.h"
#include "HistoryPanel.h"
#include "HistoryView.h"
#include "Inspector.h"
#include "PatternView.h"
#include "ProblemsView.h"
#include "Shortcuts.h"
#include "ShortcutsDialog.h"
#include "Thumbnails.h"

#include <QApplication>
#include <QMenuBar>

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace bolster {

namespace {

/// What large objects have left lies between smaller ones that stay: the system gets it only when it is asked to.
void giveMemoryBack()
{
#ifdef __GLIBC__
    backgroundPool().start([] { malloc_trim(0); });
#endif
}

} // namespace

void MainWindow::connectPanels()
{
    m_palette = new CommandPalette(*this);
    connect(m_actions->findCommand, &QAction::triggered, m_palette, &CommandPalette::open);

    for (QDockWidget* dock : m_docks->all())
        dock->toggleViewAction()->setObjectName(QStringLiteral("show-") + dock->objectName());
    QList<QAction*> all;
    for (const Command& command : commandsOf(*menuBar()))
        all.append(command.action);
    m_shortcuts = std::make_unique<Shortcuts>(all);
    connect(m_actions->editShortcuts, &QAction::triggered, this, [this] {
        auto* dialog = new ShortcutsDialog(*m_shortcuts, commandsOf(*menuBar()), this);
        dialog->setAttribute(Qt::WA_DeleteOnClose);
        dialog->show();
    });

    connect(&m_history->view(), &HistoryView::compareWanted, this, &MainWindow::compareWith);
    m_thumbnails = std::make_unique<Thumbnails>(*m_session, *m_solver, *m_surface);
    m_history->view().history().setPictures([this](NodeId node) { return m_thumbnails->picture(node); });
    connect(m_thumbnails.get(), &Thumbnails::made, &m_history->view().history(), &HistoryModel::pictureMade);
    connect(m_actions->nextPart, &QAction::triggered, this, [this] { focusNextPart(true); });
    connect(m_actions->previousPart, &QAction::triggered, this, [this] { focusNextPart(false); });
    connect(m_elements, &ElementsView::propertiesWanted, this, [this] {
        Docks::reveal(m_docks->inspector);
        m_inspector->focusFirst();
    });
    // Keys mean the view again in which one was before, not the next field.
    connect(qApp, &QApplication::focusChanged, this, [this](const QWidget*, QWidget* now) {
        if (now == m_pattern || now == m_surface)
            m_lastView = now;
    });
    connect(
        m_inspector, &Inspector::typed, this,
        [this] { (m_lastView ? m_lastView : m_pattern)->setFocus(Qt::OtherFocusReason); }, Qt::QueuedConnection);
    const QList<QDockWidget*> parts = m_docks->all();
    for (qsizetype i = 1; i < parts.size(); ++i)
        setTabOrder(parts[i - 1]->widget(), parts[i]->widget());
}

void MainWindow::compareWith(NodeId node)
{
    auto* window = findChild<CompareWindow*>();
    if (!window) {
        const auto filesOf = [session = m_session.get()](const Design& design) { return session->filesOf(design); };
        window = new CompareWindow(document(), filesOf, *m_fabricLink, *m_solver, this);
        connect(m_session.get(), &DesignSession::fileRead, window, &CompareWindow::updateFiles);
        connect(m_session.get(), &DesignSession::opened, window, &QWidget::close);
        connect(window, &QObject::destroyed, this, &giveMemoryBack);
    }
    if (window->compareWith(node)) {
        window->show();
        window->raise();
        window->activateWindow();
    }
}

/// Among the parts that can be seen; of docks on top of each other that is one.
void MainWindow::focusNextPart(bool forward)
{
    const QWidget* now = QApplication::focusWidget();
    QList<QDockWidget*> parts;
    qsizetype place = -1;
    for (QDockWidget* dock : m_docks->all()) {
        if (!dock->isVisible() || dock->visibleRegion().isEmpty())
            continue;
        if (now && dock->isAncestorOf(now))
            place = parts.size();
        parts.append(dock);
    }
    if (parts.isEmpty())
        return;
    const qsizetype count = parts.size();
    const qsizetype next = place < 0 ? (forward ? 0 : count - 1) : (place + (forward ? 1 : count - 1)) % count;
    QDockWidget* dock = parts[next];
    dock->activateWindow(); // it may float
    if (dock == m_docks->inspector)
        m_inspector->focusFirst();
    else
        dock->widget()->setFocus(Qt::ShortcutFocusReason);
}

} // namespace bolster
