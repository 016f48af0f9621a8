// What is looked at before a pattern is cut.
#pragma once

#include "CutCheck.h"

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class CuttingPanel;
class Docks;
class ExportFlow;
class PatternView;
class Selection;

class CuttingCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(CuttingCommands)

public:
    struct Parts {
        CuttingPanel& panel;
        ExportFlow& exports;
        Selection& selection;
        PatternView& pattern;
        const Docks& docks;
    };

    CuttingCommands(Commands& commands, const Parts& parts);

private:
    void check();
    void showPlace(ElementId element, ElementId patch, const Vec2& place);

    Commands& m_commands;
    Parts m_parts;
};

} // namespace bolster
