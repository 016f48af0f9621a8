// The File menu.
#pragma once

#include <QCoreApplication>
#include <QObject>

class QWidget;

namespace bolster {

class Commands;
class CoverAtRest;
class DesignSession;
class FabricLink;
class SolverLink;
class CoverView;
struct FileFlows;

class FileCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(FileCommands)

public:
    FileCommands(Commands& commands, FileFlows& files, DesignSession& session, SolverLink& solver,
                 CoverAtRest& cover, CoverView& coverView, FabricLink& fabrics, QWidget& window);

private:
    void addOpening(Commands& commands);
    void addSaving(Commands& commands);
    void addExchange(Commands& commands);
    void exportPicture();
    void printView();
    void renderPicture();

    FileFlows& m_files;
    DesignSession& m_session;
    SolverLink& m_solver;
    CoverAtRest& m_cover;
    CoverView& m_coverView;
    FabricLink& m_fabrics;
    QWidget& m_window;
};

} // namespace bolster
