#include "FabricMenu.h"

#include "Background.h"
#include "ColourwayWindow.h"
#include "Commands.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "Docks.h"
#include "FabricCommands.h"
#include "FabricDrop.h"
#include "FabricLink.h"
#include "FabricPanel.h"
#include "FabricPresets.h"
#include "Inspector.h"
#include "PatternView.h"
#include "Selection.h"
#include "SelectionEdits.h"

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

FabricMenu::FabricMenu(Commands& commands, const Parts& parts)
    : m_commands(commands)
    , m_parts(parts)
{
    addMaking();
    addFabrics();
    addFiles();
    addPreviews();
    addColourways();
    connectPanel();
    takeDrops();
}

void FabricMenu::addMaking()
{
    m_commands.add({{.id = "fabric.new",
                     .formerly = "new-fabric",
                     .text = tr("&New fabric"),
                     .icon = "fabric",
                     .tip = tr("Adds leather, weave, velvet or another fabric to the library of the design"),
                     .places = {"fabric/1"}}, // its menu offers presets
                    {.id = "fabric.new-from-picture",
                     .formerly = "from-a-picture",
                     .text = tr("From a &picture \u2026"),
                     .tip = tr("A fabric that looks like a picture: PNG, JPEG, TIFF or OpenEXR"),
                     .places = {"fabric/1"},
                     .does = calm([this] { m_parts.fabrics.choosePicture(noElement); })}});
    fillNewFabric();
}

void FabricMenu::addFabrics()
{
    FabricCommands& fabrics = m_parts.fabrics;
    const auto any = [this] { return meant(); };
    const auto assignable = [this] {
        return meant() &&
               !selectedOf<Patch>(m_parts.session.document().design(), m_parts.selection.elements()).empty();
    };
    m_commands.add({{.id = "fabric.assign",
                     .formerly = "assign-to-selection",
                     .text = tr("&Assign to selection"),
                     .icon = "patch",
                     .tip = tr("Gives the selected patches the fabric that is chosen in the library"),
                     .places = {"fabric/2"},
                     .enabled = assignable,
                     .does = calm([&fabrics] { fabrics.assignToSelection(); })},
                    {.id = "fabric.edit",
                     .formerly = "fabric-properties",
                     .text = tr("Fabric p&roperties"),
                     .icon = "settings",
                     .tip = tr("Shows kind, colours, size and limits of the fabric"),
                     .places = {"fabric/2"},
                     .enabled = any,
                     .does = calm([this] { edit(m_parts.fabrics.fabric()); })},
                    {.id = "fabric.picture",
                     .formerly = "picture-on-the-fabric",
                     .text = tr("Picture on the &fabric \u2026"),
                     .icon = "picture",
                     .tip = tr("Lets the fabric look like a picture: PNG, JPEG, TIFF or OpenEXR"),
                     .places = {"fabric/2"},
                     .enabled = any,
                     .does = calm([&fabrics] { fabrics.choosePicture(fabrics.fabric()); })},
                    {.id = "fabric.duplicate",
                     .formerly = "duplicate-fabric",
                     .text = tr("D&uplicate fabric"),
                     .tip = tr("Adds a copy of the fabric, to be changed"),
                     .places = {"fabric/3"},
                     .enabled = any,
                     .does = calm([&fabrics] { fabrics.duplicate(); })},
                    {.id = "fabric.rename",
                     .formerly = "rename-fabric",
                     .text = tr("Rename fa&bric \u2026"),
                     .tip = tr("Gives the fabric another name"),
                     .places = {"fabric/3"},
                     .enabled = any,
                     .does = calm([&fabrics] { fabrics.rename(); })},
                    {.id = "fabric.delete",
                     .formerly = "delete-fabric",
                     .text = tr("&Delete fabric \u2026"),
                     .icon = "delete",
                     .tip = tr("Removes the fabric; asks what patches get instead"),
                     .places = {"fabric/3"},
                     .enabled = any,
                     .does = calm([&fabrics] { fabrics.remove(); })}});
}

bool FabricMenu::meant() const
{
    return m_parts.session.document().design().find<Fabric>(m_parts.fabrics.fabric()) != nullptr;
}

void FabricMenu::addFiles()
{
    m_commands.add({.id = "fabric.import",
                    .formerly = "import-fabrics",
                    .text = tr("&Import fabrics \u2026"),
                    .tip = tr("Takes over the fabrics of a file, a design or a project"),
                    .places = {"fabric/4"},
                    .does = calm([this] { m_parts.fabrics.importFabrics(); })});
    m_commands.add({.id = "fabric.export",
                    .formerly = "export-fabric",
                    .text = tr("&Export fabric \u2026"),
                    .tip = tr("Writes the fabric to a file, its picture beside it"),
                    .places = {"fabric/4"},
                    .enabled = [this] { return meant(); },
                    .does = calm([this] { m_parts.fabrics.exportFabric(); })});
}

void FabricMenu::addPreviews()
{
    m_commands.add(MenuPlace{"fabric.previews", tr("Pre&views"), "fabric/5"});
    const bool balls = QSettings().value(ballsKey, false).toBool();
    m_commands.add({{.id = "fabric.on-cushions",
                     .formerly = "on-cushions",
                     .text = tr("On &cushions"),
                     .icon = "pillow",
                     .tip = tr("Shows the fabrics of the library on cushions"),
                     .places = {"fabric.previews/1"},
                     .on = !balls,
                     .group = "fabric.previews"},
                    {.id = "fabric.on-balls",
                     .formerly = "on-balls",
                     .text = tr("On &balls"),
                     .icon = "ball",
                     .tip = tr("Shows the fabrics of the library on balls"),
                     .places = {"fabric.previews/1"},
                     .on = balls,
                     .group = "fabric.previews",
                     .toggled = [](bool on) { QSettings().setValue(ballsKey, on); }}});
}

void FabricMenu::addColourways()
{
    FabricCommands& fabrics = m_parts.fabrics;
    const auto shown = [this] {
        const Design& design = m_parts.session.document().design();
        return design.find<Colourway>(design.settings().colourway) != nullptr;
    };
    const auto any = [this] {
        bool found = false;
        m_parts.session.document().design().each<Colourway>([&](ElementId, const Colourway&) { found = true; });
        return found;
    };
    m_commands.add({{.id = "colourway.show",
                     .formerly = "show-colourway",
                     .text = tr("&Show colourway"),
                     .tip = tr("Chooses which fabrics are seen; the shape stays"),
                     .places = {"fabric/6"}}, // its menu has them all
                    {.id = "colourway.new",
                     .formerly = "new-colourway",
                     .text = tr("New &colourway \u2026"),
                     .icon = "colourway",
                     .tip = tr("Adds a set of fabrics for the patches; it begins as what is shown now"),
                     .places = {"fabric/6"},
                     .does = calm([&fabrics] { fabrics.newColourway(); })},
                    {.id = "colourway.rename",
                     .formerly = "rename-colourway",
                     .text = tr("Rena&me colourway \u2026"),
                     .tip = tr("Gives the colourway that is shown another name"),
                     .places = {"fabric/6"},
                     .enabled = shown,
                     .does = calm([&fabrics] { fabrics.renameColourway(); })},
                    {.id = "colourway.delete",
                     .formerly = "delete-colourway",
                     .text = tr("De&lete colourway"),
                     .tip = tr("Removes the colourway that is shown"),
                     .places = {"fabric/6"},
                     .enabled = shown,
                     .does = calm([&fabrics] { fabrics.removeColourway(); })},
                    {.id = "colourway.compare",
                     .formerly = "compare-colourways",
                     .text = tr("Compare c&olourways \u2026"),
                     .tip = tr("Shows two colourways side by side"),
                     .places = {"fabric/6"},
                     .enabled = any,
                     .does = calm([this] { compareColourways(); })}});
    auto* menu = new QMenu(&m_parts.window);
    connect(menu, &QMenu::aboutToShow, this, [this, menu] { fillColourways(*menu); });
    m_commands["colourway.show"]->setMenu(menu);
}

void FabricMenu::fillNewFabric()
{
    auto* presets = new QMenu(&m_parts.window);
    presets->setToolTipsVisible(true);
    addPresets(*presets, m_parts.fabrics);
    presets->addSeparator();
    presets->addActions(m_commands.list({"fabric.new-from-picture", "fabric.import"}));
    QAction* action = m_commands["fabric.new"];
    action->setMenu(presets);
    connect(action, &QAction::triggered, presets, [presets] { presets->popup(QCursor::pos()); });
}

void FabricMenu::fillColourways(QMenu& menu)
{
    menu.clear();
    delete menu.findChild<QActionGroup*>();
    const Design& design = m_parts.session.document().design();
    auto* group = new QActionGroup(&menu);
    const auto offer = [&](ElementId id, const QString& name) {
        QAction* action = menu.addAction(name, this, [this, id] { m_parts.fabrics.showColourway(id); });
        action->setCheckable(true);
        action->setChecked(design.settings().colourway == id);
        group->addAction(action);
    };
    offer(noElement, tr("As made"));
    design.each<Colourway>(
        [&](ElementId id, const Colourway& colourway) { offer(id, QString::fromStdString(colourway.name)); });
}

void FabricMenu::connectPanel()
{
    FabricPanel& panel = m_parts.panel;
    connect(&m_parts.fabrics, &FabricCommands::added, &panel, &FabricPanel::setFabric);
    connect(&panel, &FabricPanel::fabricChosen, this, &FabricMenu::choose);
    connect(&panel, &FabricPanel::editWanted, this, &FabricMenu::edit);
    connect(&panel, &FabricPanel::colourwayChosen, &m_parts.fabrics, &FabricCommands::showColourway);
}

void FabricMenu::takeDrops()
{
    const auto onto = [this](QWidget& view, std::function<ElementId(QPointF)> patchAt) {
        auto* drop =
            new FabricDrop(view, std::move(patchAt), [this](ElementId patch) { m_parts.selection.hover(patch); });
        connect(drop, &FabricDrop::dropped, this,
                [this](ElementId patch, ElementId fabric) { m_parts.fabrics.assign({patch}, fabric); });
    };
    const auto patch = [this](ElementId id) {
        return m_parts.session.document().design().find<Patch>(id) ? id : noElement;
    };
    onto(m_parts.pattern, [this, patch](QPointF at) { return patch(m_parts.pattern.hit(at).patch); });
    onto(m_parts.coverView, [this, patch](QPointF at) { return patch(m_parts.coverView.hit(at).element); });
}

std::function<void()> FabricMenu::calm(std::function<void()> act)
{
    return [this, act = std::move(act)] {
        m_parts.session.document().cancelGesture();
        act();
    };
}

/// Patches stay selected, so that they can get it; else its properties are shown.
void FabricMenu::choose(ElementId fabric)
{
    m_parts.fabrics.setChosen(fabric);
    const Design& design = m_parts.session.document().design();
    if (design.find<Fabric>(fabric) && selectedOf<Patch>(design, m_parts.selection.elements()).empty() &&
        m_parts.panel.fabrics().hasFocus())
        m_parts.selection.set({fabric});
    m_commands.update();
}

void FabricMenu::edit(ElementId fabric)
{
    if (!m_parts.session.document().design().find<Fabric>(fabric))
        return;
    m_parts.selection.set({fabric});
    Docks::reveal(m_parts.docks.inspector);
    m_parts.inspector.focusFirst();
}

void FabricMenu::compareColourways()
{
    auto* window = m_parts.window.findChild<ColourwayWindow*>();
    if (!window) {
        window = new ColourwayWindow(m_parts.session.document(), m_parts.session.files(), m_parts.link,
                                     m_parts.solver, &m_parts.window);
        connect(&m_parts.session, &DesignSession::opened, window, &QWidget::close);
    }
    window->compare();
    window->show();
    window->raise();
    window->activateWindow();
}

} // namespace bolster
