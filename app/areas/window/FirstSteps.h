// What the window does for those who begin a design.
#pragma once

#include "PatternTools.h"

#include <QObject>

namespace bolster {

class Commands;
class DesignSession;
class FileFlow;
class PatternView;
class Selection;
class SolverLink;
class CoverView;
class StartPage;

class FirstSteps : public QObject {
public:
    FirstSteps(Commands& commands, DesignSession& session, Selection& selection, SolverLink& solver,
               PatternView& pattern, CoverView& surface, FileFlow& files, StartPage& page);

private:
    void hintAtStart(Commands& commands, FileFlow& files, StartPage& page);
    void showFreeCover(SolverLink& solver);
    void hintAtNext(Commands& commands);
    void showDrawn();

    DesignSession& m_session;
    Selection& m_selection;
    PatternView& m_pattern;
    CoverView& m_surface;
    PatternToolKind m_tool = PatternToolKind::Select;
};

} // namespace bolster
