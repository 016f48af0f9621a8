// Fixation curves from the edges of frames.
#pragma once

#include "Frame.h"
#include "FrameEdgeTool.h"

#include <QCoreApplication>
#include <QObject>

namespace bolster {

class Commands;
class CoverView;
class DesignSession;
class StatusLine;

class FrameEdgeCommands : public QObject {
    Q_DECLARE_TR_FUNCTIONS(FrameEdgeCommands)

public:
    FrameEdgeCommands(Commands& commands, DesignSession& session, CoverView& coverView, StatusLine& status,
                      QWidget& window);

private:
    /// A frame, and what is known of its edges.
    struct Subject {
        QString path;
        std::shared_ptr<const TriangleMesh> mesh;
        Frame frame;
        std::shared_ptr<const std::vector<FrameEdge>> edges; ///< file units; null: not yet
    };
    using Subjects = std::vector<Subject>;

    bool hasFrame() const;
    bool isOn() const;
    void begin();
    void offer(const Subjects& subjects);
    Subjects subjects() const;
    static Subjects withEdges(Subjects subjects, const ImportWatch& watch);
    static OfferedEdges offered(const Subjects& subjects);

    DesignSession& m_session;
    CoverView& m_coverView;
    StatusLine& m_status;
    QWidget& m_window;
    Subjects m_known; ///< what was read last
};

} // namespace bolster
