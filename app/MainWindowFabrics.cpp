// What the window does with fabrics and colourways.
#include "MainWindow.h"

#include "Actions.h"
#include "Background.h"
#include "ColourwayWindow.h"
#include "Docks.h"
#include "FabricCommands.h"
#include "FabricDrop.h"
#include "FabricLink.h"
#include "FabricPanel.h"
#include "FabricPresets.h"
#include "Inspector.h"
#include "PatternView.h"
#include "SelectionEdits.h"
#include "StatusLine.h"

#include <QActionGroup>
#include <QListWidget>
#include <QMenu>
#include <QSettings>
#include <QTimer>

namespace bolster {

namespace {

constexpr int presetPixels = 64;
const QString ballsKey = QStringLiteral("fabrics/balls");

void drawPreset(QAction* action, const Fabric& preset)
{
    inBackground<QImage>([preset] {
        return FabricLink::previewOf(preset, presetPixels);
    }).then(action, [action](const QImage& picture) { action->setIcon(QPixmap::fromImage(picture)); });
}

void addPresets(QMenu& menu, FabricCommands& commands)
{
    QList<QAction*> actions;
    for (const Fabric& preset : fabricPresets()) {
        QAction* action = menu.addAction(QString::fromStdString(preset.name), &commands,
                                         [&commands, preset] { commands.add(preset); });
        action->setToolTip(FabricPanel::tr("Adds this fabric to the library of the design"));
        actions.append(action);
    }
    // Their pictures take seconds of work, so they are drawn when the menu is first seen: lists of commands ask
    // menus to be filled without showing them.
    QObject::connect(&menu, &QMenu::aboutToShow, &menu, [&menu, actions] {
        QTimer::singleShot(0, &menu, [&menu, actions] {
            if (!menu.isVisible() || menu.property("drawn").toBool())
                return;
            menu.setProperty("drawn", true);
            const std::vector<Fabric> presets = fabricPresets();
            for (qsizetype i = 0; i < actions.size(); ++i)
                drawPreset(actions[i], presets[static_cast<std::size_t>(i)]);
        });
    });
}

} // namespace

void MainWindow::connectFabrics()
{
    const auto on = [this](QAction* action, auto function) {
        connect(action, &QAction::triggered, this, [this, function] {
            document().cancelGesture();
            function();
        });
    };
    FabricCommands& commands = *m_fabricCommands;
    on(m_actions->duplicateFabric, [&commands] { commands.duplicate(); });
    on(m_actions->renameFabric, [&commands] { commands.rename(); });
    on(m_actions->removeFabric, [&commands] { commands.remove(); });
    on(m_actions->editFabric, [this] { editFabric(m_fabricCommands->fabric()); });
    on(m_actions->assignFabric, [&commands] { commands.assignToSelection(); });
    on(m_actions->fabricPicture, [&commands] { commands.choosePicture(commands.fabric()); });
    on(m_actions->newPictureFabric, [&commands] { commands.choosePicture(settingsId); });
    on(m_actions->importFabrics, [&commands] { commands.importFabrics(); });
    on(m_actions->exportFabric, [&commands] { commands.exportFabric(); });
    on(m_actions->newColourway, [&commands] { commands.newColourway(); });
    on(m_actions->renameColourway, [&commands] { commands.renameColourway(); });
    on(m_actions->removeColourway, [&commands] { commands.removeColourway(); });
    on(m_actions->compareColourways, [this] { compareColourways(); });
    fillFabricMenus();
    QAction* balls = m_actions->fabricsOnBalls;
    balls->setChecked(QSettings().value(ballsKey, false).toBool());
    connect(balls, &QAction::toggled, this, [](bool checked) { QSettings().setValue(ballsKey, checked); });

    connect(&commands, &FabricCommands::done, m_status, &StatusLine::flash);
    connect(&commands, &FabricCommands::added, this, [this](ElementId id) { m_fabricPanel->setFabric(id); });
    connect(m_fabricPanel, &FabricPanel::fabricChosen, this, &MainWindow::chooseFabric);
    connect(m_fabricPanel, &FabricPanel::editWanted, this, &MainWindow::editFabric);
    connect(m_fabricPanel, &FabricPanel::colourwayChosen, &commands, &FabricCommands::showColourway);
    connect(m_fabricLink.get(), &FabricLink::changed, this, [this] {
        m_pattern->shown().setFabricColors(m_fabricLink->colors());
        m_surface->shown().setFabricMaps(m_fabricLink->maps());
        m_inspector->setFabricPictures(m_fabricLink->pictures());
        updateProblems();
    });
    const auto takeDrops = [&](QWidget& view, std::function<ElementId(QPointF)> patchAt) {
        auto* drop =
            new FabricDrop(view, std::move(patchAt), [this](ElementId patch) { m_selection.hover(patch); });
        connect(drop, &FabricDrop::dropped, &commands,
                [&commands](ElementId patch, ElementId fabric) { commands.assign({patch}, fabric); });
    };
    takeDrops(*m_pattern, [this](QPointF at) {
        const PatternHit hit = m_pattern->hit(at);
        return document().design().find<Patch>(hit.patch) ? hit.patch : settingsId;
    });
    takeDrops(*m_surface, [this](QPointF at) {
        const SurfaceHit hit = m_surface->hit(at);
        return document().design().find<Patch>(hit.element) ? hit.element : settingsId;
    });
    connect(&m_selection, &Selection::changed, this, &MainWindow::updateFabricActions);
    connect(&document(), &Document::historyChanged, this, &MainWindow::updateFabricActions);
    updateFabricActions();
}

void MainWindow::fillFabricMenus()
{
    auto* presets = new QMenu(this);
    presets->setToolTipsVisible(true);
    addPresets(*presets, *m_fabricCommands);
    presets->addSeparator();
    presets->addActions({m_actions->newPictureFabric, m_actions->importFabrics});
    m_actions->newFabric->setMenu(presets);
    connect(m_actions->newFabric, &QAction::triggered, presets, [presets] { presets->popup(QCursor::pos()); });

    auto* shown = new QMenu(this);
    connect(shown, &QMenu::aboutToShow, shown, [this, shown] {
        shown->clear();
        delete shown->findChild<QActionGroup*>();
        const Design& design = document().design();
        auto* group = new QActionGroup(shown);
        const auto offer = [&](ElementId id, const QString& name) {
            QAction* action = shown->addAction(name, this, [this, id] { m_fabricCommands->showColourway(id); });
            action->setCheckable(true);
            action->setChecked(design.settings().colourway == id);
            group->addAction(action);
        };
        offer(settingsId, tr("As made"));
        design.each<Colourway>(
            [&](ElementId id, const Colourway& colourway) { offer(id, QString::fromStdString(colourway.name)); });
    });
    m_actions->showColourway->setMenu(shown);
}

void MainWindow::updateFabricActions()
{
    const Design& design = document().design();
    const bool fabric = design.find<Fabric>(m_fabricCommands->fabric());
    for (QAction* action : {m_actions->duplicateFabric, m_actions->renameFabric, m_actions->removeFabric,
                            m_actions->editFabric, m_actions->fabricPicture, m_actions->exportFabric})
        action->setEnabled(fabric);
    m_actions->assignFabric->setEnabled(fabric && !selectedOf<Patch>(design, m_selection.elements()).empty());
    const bool shown = design.find<Colourway>(design.settings().colourway);
    m_actions->renameColourway->setEnabled(shown);
    m_actions->removeColourway->setEnabled(shown);
    bool any = false;
    design.each<Colourway>([&](ElementId, const Colourway&) { any = true; });
    m_actions->compareColourways->setEnabled(any);
}

/// Patches stay selected, so that they can get it; else its properties are shown.
void MainWindow::chooseFabric(ElementId fabric)
{
    m_fabricCommands->setChosen(fabric);
    const Design& design = document().design();
    if (design.find<Fabric>(fabric) && selectedOf<Patch>(design, m_selection.elements()).empty() &&
        m_fabricPanel->fabrics().hasFocus())
        m_selection.set({fabric});
    updateFabricActions();
}

void MainWindow::editFabric(ElementId fabric)
{
    if (!document().design().find<Fabric>(fabric))
        return;
    m_selection.set({fabric});
    Docks::reveal(m_docks->inspector);
    m_inspector->focusFirst();
}

void MainWindow::compareColourways()
{
    auto* window = findChild<ColourwayWindow*>();
    if (!window) {
        window = new ColourwayWindow(document(), m_session->files(), *m_fabricLink, *m_solver, this);
        connect(m_session.get(), &DesignSession::opened, window, &QWidget::close);
    }
    window->compare();
    window->show();
    window->raise();
    window->activateWindow();
}

} // namespace bolster
