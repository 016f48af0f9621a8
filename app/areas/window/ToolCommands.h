// The tools: one at a time, in whichever view.
#pragma once

#include "CoverView.h"
#include "PatternTools.h"

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class Docks;
class PatternView;

class ToolCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(ToolCommands)

public:
    ToolCommands(Commands& commands, PatternView& pattern, CoverView& coverView, const Docks& docks);

private:
    void add(Commands& commands);
    void addInSurface(Commands& commands);
    void connectViews(Commands& commands);
    bool isOn(PatternToolKind kind) const;
    bool isOn(CoverToolKind kind) const { return m_coverView.tool() == kind; }
    void begin(PatternToolKind kind);
    void end();

    PatternView& m_pattern;
    CoverView& m_coverView;
};

} // namespace bolster
