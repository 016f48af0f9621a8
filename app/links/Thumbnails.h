// Small pictures of the versions in the history, made while nothing else is to do.
#pragma once

#include "Design.h"
#include "History.h"
#include "SurfaceMesh.h"

#include <QByteArray>
#include <QObject>
#include <QTimer>

#include <map>
#include <set>

namespace bolster {

class DesignSession;
class SolverLink;
class CoverView;

/// Drawn beside the GUI thread from the resting surface, looked at as in the view. They are kept in the project,
/// from where they may get lost: nothing depends on them.
class Thumbnails : public QObject {
    Q_OBJECT

public:
    Thumbnails(DesignSession& session, SolverLink& solver, CoverView& view);

    /// A PNG, or nothing when the version has none.
    QByteArray picture(NodeId node);

signals:
    void made(bolster::NodeId node);

private:
    struct Version {
        SurfaceMeshPtr surface;
        Design design;
    };

    void note();
    void make();
    void keep(NodeId node, const QByteArray& png);
    void store();

    DesignSession& m_session;
    SolverLink& m_solver;
    CoverView& m_view;
    QTimer m_pause;
    std::map<NodeId, QByteArray> m_pictures;
    std::map<NodeId, Version> m_waiting; ///< have come to rest, and are to be drawn
    std::set<NodeId> m_unstored;         ///< pictures that no journal has
    bool m_drawing = false;
    int m_generation = 0; ///< counts designs, so that late pictures of an earlier one are dropped
};

} // namespace bolster
