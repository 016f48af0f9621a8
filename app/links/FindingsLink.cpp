#include "FindingsLink.h"

#include "DesignSession.h"
#include "SolverLink.h"

namespace bolster {

FindingsLink::FindingsLink(DesignSession& session, SolverLink& solver, QObject* parent)
    : QObject(parent)
    , m_session(session)
    , m_solver(solver)
    , m_job(
          [frames = std::make_shared<FrameDistance>()](const Request& asked, const std::stop_token&) {
              return Result{asked.surface, coverFindings(*asked.surface, asked.design, asked.files, *frames)};
          },
          [this](Result result) { receive(std::move(result)); })
{
    connect(&solver, &SolverLink::statusChanged, this, &FindingsLink::look);
    connect(&session.document(), &Document::changed, this, &FindingsLink::look); // nothing is known of it any more
}

FindingsLink::~FindingsLink() = default;

void FindingsLink::look()
{
    const std::uint64_t revision = m_session.document().revision();
    if (!m_solver.atRest() || !m_solver.surface()) {
        m_job.cancel();
        m_asked.reset();
        if (std::exchange(m_known, false))
            emit changed();
        return;
    }
    if (m_solver.surface() == m_asked && revision == m_askedRevision)
        return;
    m_asked = m_solver.surface();
    m_askedRevision = revision;
    m_job.request({m_asked, m_session.document().design(), m_session.files()}, true);
}

void FindingsLink::receive(Result result)
{
    if (result.surface != m_asked)
        return; // another one is being looked over
    m_findings = std::move(result.findings);
    m_known = true;
    emit changed();
}

} // namespace bolster
