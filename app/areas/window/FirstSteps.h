// What the window does for those who begin a design.
#pragma once

#include "PatternTools.h"

#include <QObject>

namespace bolster {

class Commands;
class DesignSession;
class OpenFlow;
class PatternView;
class Selection;
class SolverLink;
class CoverView;
class StartPage;

class FirstSteps : public QObject {
public:
    FirstSteps(Commands& commands, DesignSession& session, Selection& selection, SolverLink& solver,
               PatternView& pattern, CoverView& coverView, OpenFlow& opening, StartPage& page);

private:
    void hintAtStart(Commands& commands, OpenFlow& opening, StartPage& page);
    void showFreeCover(SolverLink& solver);
    void hintAtNext(Commands& commands);
    void showDrawn();

    DesignSession& m_session;
    Selection& m_selection;
    PatternView& m_pattern;
    CoverView& m_coverView;
    PatternToolKind m_tool = PatternToolKind::Select;
};

} // namespace bolster
