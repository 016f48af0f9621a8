// The Fabric menu, and where fabrics are chosen and dropped.
#pragma once

#include "ElementId.h"

#include <QCoreApplication>
#include <QObject>

#include <functional>

class QMenu;
class QWidget;

namespace bolster {

class Commands;
class DesignSession;
class Docks;
class FabricCommands;
class FabricLink;
class FabricPanel;
class Inspector;
class PatternView;
class Selection;
class SolverLink;
class CoverView;

class FabricMenu : public QObject {
    Q_DECLARE_TR_FUNCTIONS(FabricMenu)

public:
    struct Parts {
        DesignSession& session;
        Selection& selection;
        FabricCommands& fabrics;
        FabricLink& link;
        FabricPanel& panel;
        SolverLink& solver;
        PatternView& pattern;
        CoverView& coverView;
        Inspector& inspector;
        Docks& docks;
        QWidget& window;
    };
    FabricMenu(Commands& commands, const Parts& parts);

private:
    void addMaking();
    void addFabrics();
    void addFiles();
    void addPreviews();
    void addColourways();
    void fillNewFabric();
    void fillColourways(QMenu& menu);
    void connectPanel();
    void takeDrops();
    /// Whatever is dragged ends first.
    std::function<void()> calm(std::function<void()> act);
    /// There is a fabric that commands mean.
    bool meant() const;
    void choose(ElementId fabric);
    void edit(ElementId fabric);
    void compareColourways();

    Commands& m_commands;
    Parts m_parts;
};

} // namespace bolster
