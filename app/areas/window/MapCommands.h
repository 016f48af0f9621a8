// Maps of the cover: which one is shown, what it says at the pointer, and where it is worst.
#pragma once

#include "MapLink.h"

#include <QCoreApplication>
#include <QObject>

class QMenu;

namespace bolster {

class Commands;
class Docks;
class Inspector;
class PatternView;
class ScanLink;
class SpotsPanel;
class CoverView;

class MapCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(MapCommands)

public:
    MapCommands(Commands& commands, MapLink& maps, ScanLink& scans, PatternView& pattern, CoverView& coverView,
                Inspector& inspector, Docks& docks, SpotsPanel& spots);

    /// In both views.
    void showSpot(const CoverPoint& place);
    void hideSpot();

private:
    void addKinds();
    void addSpots();
    void connectViews();
    void choose();
    const ShownMapPtr& shown();
    void showMeasured();
    void read(const std::optional<CoverPoint>& place);
    void fillSpots(QMenu& menu);
    void showSpotList();

    Commands& m_commands;
    MapLink& m_maps;
    ScanLink& m_scans;
    PatternView& m_pattern;
    CoverView& m_coverView;
    Inspector& m_inspector;
    Docks& m_docks;
    SpotsPanel& m_spots;
    std::optional<CoverPoint> m_place; ///< under the pointer
};

} // namespace bolster
