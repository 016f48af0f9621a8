// Pictures of versions, and comparing one with the present design.
#pragma once

#include "History.h"

#include <QObject>

#include <memory>

class QWidget;

namespace bolster {

class DesignSession;
class FabricLink;
class HistoryPanel;
class SolverLink;
class CoverView;
class Thumbnails;

class VersionCommands : public QObject {
public:
    VersionCommands(DesignSession& session, SolverLink& solver, FabricLink& fabrics, CoverView& coverView,
                    HistoryPanel& history, QWidget& window);
    ~VersionCommands() override;

private:
    void compareWith(NodeId node);

    DesignSession& m_session;
    SolverLink& m_solver;
    FabricLink& m_fabrics;
    QWidget& m_window;
    std::unique_ptr<Thumbnails> m_thumbnails;
};

} // namespace bolster
