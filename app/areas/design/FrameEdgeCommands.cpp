#include "FrameEdgeCommands.h"

#include "Ask.h"
#include "AssemblyImport.h"
#include "Background.h"
#include "Commands.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "FileFormats.h"
#include "StatusLine.h"

#include <QPointer>
#include <QProgressDialog>

#include <set>

namespace bolster {

FrameEdgeCommands::FrameEdgeCommands(Commands& commands, DesignSession& session, CoverView& coverView,
                                     StatusLine& status, QWidget& window)
    : m_session(session)
    , m_coverView(coverView)
    , m_status(status)
    , m_window(window)
{
    commands.add({.id = "frame.fix-edge",
                  .text = tr("Fixation curve along an &edge"),
                  .keys = {Qt::CTRL | Qt::ALT | Qt::Key_F},
                  .tip = tr("Click an edge of a frame: of STEP and IGES the edges of its faces, exactly; of others "
                            "where their triangles bend"),
                  .places = {"frame/1"},
                  .enabled = [this] { return hasFrame(); },
                  .checked = [this] { return isOn(); },
                  .does = [this] { begin(); }});
    connect(&session, &DesignSession::opened, this, [this] { m_known.clear(); });
}

bool FrameEdgeCommands::hasFrame() const
{
    bool found = false;
    m_session.document().design().each<Frame>([&](ElementId, const Frame&) { found = true; });
    return found;
}

bool FrameEdgeCommands::isOn() const
{
    return m_coverView.tool() == CoverToolKind::FixEdge;
}

/// CAD files are read once more for them: that takes as long as it took to import them.
void FrameEdgeCommands::begin()
{
    if (isOn()) {
        m_coverView.setTool(CoverToolKind::Select);
        return;
    }
    m_session.document().cancelGesture();
    auto* const progress = openProgress(&m_window, tr("Looking for the edges of the frames \u2026")).dialog;
    std::stop_source stop;
    connect(progress, &QProgressDialog::canceled, this, [stop]() mutable { stop.request_stop(); });
    connect(progress, &QObject::destroyed, [stop]() mutable { stop.request_stop(); }); // with its window
    inBackground<Subjects>([subjects = subjects(), watch = ImportWatch{stop.get_token(), {}, {}}] {
        return withEdges(subjects, watch);
    }).then(this, [this, shown = QPointer(progress)](const Subjects& read) {
        const bool cancelled = !shown || shown->wasCanceled();
        closeProgress(shown);
        if (!cancelled)
            offer(read);
    });
}

void FrameEdgeCommands::offer(const Subjects& subjects)
{
    m_known = subjects;
    auto edges = std::make_shared<const OfferedEdges>(offered(subjects));
    if (edges->joined.empty())
        m_status.flash(tr("The frames have no edges: they are smooth everywhere, or are not read yet."));
    else
        m_coverView.startFrameEdges(std::move(edges));
}

FrameEdgeCommands::Subjects FrameEdgeCommands::subjects() const
{
    Subjects subjects;
    const DesignFiles& files = m_session.files();
    m_session.document().design().each<Frame>([&](ElementId id, const Frame& frame) {
        const auto mesh = files.meshes.find(id);
        if (mesh == files.meshes.end())
            return;
        Subject subject{m_session.findFile(QString::fromStdString(frame.file)), mesh->second, frame, {}};
        for (const Subject& known : m_known)
            if (known.mesh == subject.mesh && known.path == subject.path)
                subject.edges = known.edges;
        subjects.push_back(std::move(subject));
    });
    return subjects;
}

FrameEdgeCommands::Subjects FrameEdgeCommands::withEdges(Subjects subjects, const ImportWatch& watch)
{
    for (Subject& subject : subjects) {
        if (subject.edges || watch.stop.stop_requested())
            continue;
        std::vector<FrameEdge> edges;
        if (isCadEnding(endingOf(subject.path)))
            edges = importFrameEdges(subject.path, watch).edges;
        if (edges.empty())
            edges = bentEdges(*subject.mesh, watch.stop);
        subject.edges = std::make_shared<const std::vector<FrameEdge>>(std::move(edges));
    }
    return subjects;
}

/// Of parts that are there, where they stand.
OfferedEdges FrameEdgeCommands::offered(const Subjects& subjects)
{
    OfferedEdges offered;
    for (const Subject& subject : subjects) {
        std::vector<FrameEdge> placed;
        const std::set<std::string> hidden(subject.frame.hiddenParts.begin(), subject.frame.hiddenParts.end());
        for (const FrameEdge& edge : *subject.edges)
            if (!hidden.contains(edge.part)) {
                placed.push_back(edge);
                for (Vec3& point : placed.back().points)
                    point = subject.frame.placed(point);
            }
        placed = distinctEdges(placed);
        const std::vector<FrameEdge> joined = joinedSmoothly(placed);
        offered.single.insert(offered.single.end(), placed.begin(), placed.end());
        offered.joined.insert(offered.joined.end(), joined.begin(), joined.end());
    }
    return offered;
}

} // namespace bolster
