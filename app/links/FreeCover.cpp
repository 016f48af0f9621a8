#include "FreeCover.h"

#include "CoverView.h"
#include "Document.h"
#include "SolverLink.h"

#include <QEvent>

namespace bolster {

namespace {

bool isHeld(const Design& design)
{
    bool held = false;
    design.each<FixationSeam>([&](ElementId, const FixationSeam& seam) { held = held || seam.hasCurve(); });
    design.each<HandleCurve>([&](ElementId, const HandleCurve& handle) { held = held || handle.hasTarget(); });
    return held;
}

} // namespace

FreeCover::FreeCover(Document& document, SolverLink& solver, CoverView& view, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_solver(solver)
    , m_view(view)
{
    view.installEventFilter(this);
    connect(&solver, &SolverLink::statusChanged, this, &FreeCover::look);
    connect(&solver, &SolverLink::surfaceShown, this, &FreeCover::look);
}

void FreeCover::begin(bool placed)
{
    m_moved = placed;
    m_shown = 0;
}

void FreeCover::look()
{
    if (m_document.gestureRunning() || m_solver.paused() || !m_solver.upToDate() || isHeld(m_document.design()))
        return;
    const bool there = m_view.shown().surface() == m_solver.surface(); // not on its way
    if (m_solver.status().resting && there && !m_moved && m_shown != m_document.revision()) {
        m_shown = m_document.revision();
        if (!m_view.navigation().inPicture(m_solver.surface()->boundingBox()))
            m_view.navigation().fitAll();
    }
}

bool FreeCover::eventFilter(QObject* watched, QEvent* event)
{
    if (event->type() == QEvent::MouseButtonPress || event->type() == QEvent::Wheel)
        m_moved = true;
    return QObject::eventFilter(watched, event);
}

} // namespace bolster
