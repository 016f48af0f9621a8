#include "CoverAtRest.h"

#include "Document.h"
#include "SolverLink.h"
#include "StatusLine.h"
#include "Translated.h"

namespace bolster {

CoverAtRest::CoverAtRest(Document& document, SolverLink& solver, StatusLine& status)
    : m_document(document)
    , m_solver(solver)
    , m_status(status)
{}

void CoverAtRest::then(const std::function<void()>& act)
{
    m_document.cancelGesture();
    if (!m_solver.atRest())
        m_status.flash(tr("As soon as the cover has come to rest \u2026"));
    m_solver.whenAtRest(this, [this, act](const SurfaceMeshPtr& surface) {
        if (surface)
            act();
        else if (m_solver.paused())
            m_status.flash(tr("This needs the cover of the present design: let the solver go on first (Pause)."));
        else if (m_solver.status().state == SolverStatus::State::Failed)
            m_status.flash(translated(m_solver.status().reason));
    });
}

} // namespace bolster
