#include "MapCommands.h"

#include "Commands.h"
#include "CoverView.h"
#include "Docks.h"
#include "Inspector.h"
#include "PatternView.h"
#include "ScanLink.h"
#include "SpotsPanel.h"

#include <QMainWindow>
#include <QMenu>

namespace bolster {

namespace {

const std::pair<CoverMap::Kind, const char*> kinds[] = {
    {CoverMap::Kind::Strain, "map.strain"},       {CoverMap::Kind::Along, "map.along"},
    {CoverMap::Kind::Across, "map.across"},       {CoverMap::Kind::Shear, "map.shear"},
    {CoverMap::Kind::Curvature, "map.curvature"}, {CoverMap::Kind::Thickness, "map.thickness"},
};

} // namespace

MapCommands::MapCommands(Commands& commands, MapLink& maps, ScanLink& scans, PatternView& pattern,
                         CoverView& coverView, Inspector& inspector, Docks& docks, SpotsPanel& spots)
    : m_commands(commands)
    , m_maps(maps)
    , m_scans(scans)
    , m_pattern(pattern)
    , m_coverView(coverView)
    , m_inspector(inspector)
    , m_docks(docks)
    , m_spots(spots)
{
    addKinds();
    addSpots();
    connectViews();
}

void MapCommands::addKinds()
{
    m_commands.add(MenuPlace{"view.map", tr("&Map"), "view/2"});
    const auto add = [this](const char* id, const char* formerly, const QString& text) {
        m_commands.add({.id = id,
                        .formerly = formerly,
                        .text = text,
                        .places = {"view.map/1"},
                        .on = false,
                        .group = "map",
                        .orNone = true,
                        .toggled = [this](bool) { choose(); }});
    };
    add("map.strain", "largest-strain", tr("&Largest strain"));
    add("map.along", "strain-along-the-grain", tr("Strain al&ong the grain"));
    add("map.across", "strain-across-the-grain", tr("Strain a&cross the grain"));
    add("map.shear", "shear", tr("&Shear"));
    add("map.curvature", "mean-curvature", tr("&Mean curvature"));
    add("map.thickness", "distance-to-the-frame", tr("Distance to the &frame"));
    m_commands.add({.id = "map.deviation",
                    .formerly = "deviation-from-the-scan",
                    .text = tr("&Deviation from the scan"),
                    .icon = "deviation",
                    .keys = {Qt::Key_D},
                    .places = {"view.map/1"},
                    .bar = 508,
                    .on = false,
                    .group = "map",
                    .orNone = true,
                    .toggled = [this](bool) {
                        m_maps.setGuest(nullptr);
                        showMeasured();
                        hideSpot();
                    }});
}

void MapCommands::addSpots()
{
    m_commands.add(
        MenuPlace{"map.worst", tr("&Worst spots"), "view.map/2", [this](QMenu& menu) { fillSpots(menu); }});
    m_commands.add({.id = "map.spot-list",
                    .formerly = "show-worst-spots-as-a-list",
                    .text = tr("Show worst spots as a l&ist"),
                    .places = {"view.map/2"},
                    .does = [this] { showSpotList(); }});
    connect(&m_spots, &SpotsPanel::chosen, this, &MapCommands::showSpot);
}

void MapCommands::connectViews()
{
    connect(&m_maps, &MapLink::measured, this, &MapCommands::showMeasured);
    connect(&m_scans, &ScanLink::measured, this, &MapCommands::showMeasured);
    connect(m_docks.spots, &QDockWidget::visibilityChanged, this, [this](bool visible) {
        if (!visible)
            hideSpot();
    });
    connect(&m_coverView, &CoverView::coverPointed, this, &MapCommands::read);
    connect(&m_pattern, &PatternView::patchPointed, this, &MapCommands::read);
    connect(m_docks.cover, &QDockWidget::visibilityChanged, this,
            [this](bool visible) { m_pattern.setLegendShown(!visible); });
}

void MapCommands::choose()
{
    std::optional<CoverMap::Kind> chosen;
    for (const auto& [kind, id] : kinds)
        if (m_commands[id]->isChecked())
            chosen = kind;
    m_maps.setKind(chosen);
    showMeasured();
    hideSpot();
}

const ShownMapPtr& MapCommands::shown()
{
    return m_commands["map.deviation"]->isChecked() && !m_maps.hasGuest() ? m_scans.map() : m_maps.map();
}

void MapCommands::showMeasured()
{
    m_coverView.setMap(shown());
    m_pattern.setMap(shown());
    m_coverView.shown().setScanPairs(m_scans.pairs());
    m_inspector.setScanFigures(m_scans.figures());
    read(m_place); // it says something else there now
}

void MapCommands::read(const std::optional<CoverPoint>& place)
{
    m_place = place;
    const ShownMapPtr& map = shown();
    const QString reading = place && map ? MapLink::reading(*map, *place) : QString();
    m_coverView.setMapReading(reading);
    m_pattern.setMapReading(reading);
}

/// It was one of another map.
void MapCommands::hideSpot()
{
    m_coverView.showPlace({});
    m_pattern.showPlace({});
    read({});
}

void MapCommands::fillSpots(QMenu& menu)
{
    menu.clear();
    for (const MapLink::Spot& spot : m_maps.spots()) {
        QAction* action = menu.addAction(QString(spot.text).replace(u'&', QStringLiteral("&&")));
        action->setToolTip(tr("Show this place in both windows"));
        connect(action, &QAction::triggered, this, [this, place = spot.place] { showSpot(place); });
    }
    if (menu.isEmpty())
        menu.addAction(tr("Choose a map of strain first"))->setEnabled(false);
}

void MapCommands::showSpotList()
{
    const bool hidden = m_docks.spots->isHidden();
    Docks::reveal(m_docks.spots);
    if (hidden) // else it is as large as somebody made it
        if (auto* window = qobject_cast<QMainWindow*>(m_docks.spots->parentWidget()))
            window->resizeDocks({m_docks.spots}, {m_docks.spots->sizeHint().height()}, Qt::Vertical);
    m_spots.setFocus();
}

void MapCommands::showSpot(const CoverPoint& place)
{
    m_coverView.face(place);
    m_pattern.reveal(place);
    m_coverView.showPlace(place);
    m_pattern.showPlace(place);
}

} // namespace bolster
