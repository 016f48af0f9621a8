#include "SolverLink.h"

#include "Document.h"

namespace bolster {

SolverLink::SolverLink(Document& document, QObject* parent)
    : QObject(parent)
    , m_document(document)
    , m_thread(std::make_unique<SolverThread>(
          [this] { QMetaObject::invokeMethod(this, &SolverLink::receive, Qt::QueuedConnection); }))
{
    connect(&document, &Document::changed, this, &SolverLink::send);
}

SolverLink::~SolverLink() = default;

bool SolverLink::upToDate() const
{
    return m_answered == m_document.revision();
}

void SolverLink::send()
{
    if (!m_paused && !m_document.breakage()) // the last good surface stays until the gesture is sound again
        m_thread->request({m_document.design(), m_files}, m_document.revision(), m_document.gestureRunning());
}

void SolverLink::setFiles(DesignFiles files)
{
    m_files = std::move(files);
    send();
}

void SolverLink::setPaused(bool paused)
{
    m_paused = paused;
    if (!paused && !upToDate())
        send();
}

void SolverLink::setFieldShown(bool shown)
{
    m_thread->drawField(shown);
    send();
}

void SolverLink::settle()
{
    m_thread->settle();
}

void SolverLink::forget(DesignFiles files)
{
    m_files = std::move(files);
    m_thread->startAnew();
    m_surface = nullptr;
    m_status = {};
    m_report = {};
    emit surfaceChanged(m_surface);
    emit statusChanged(m_status);
    send(); // even if the design is the same as before
}

void SolverLink::receive()
{
    std::optional<SolverOutput> output = m_thread->take();
    if (!output)
        return;
    m_answered = output->designRevision;
    m_status = std::move(output->status);
    if (m_status.state == SolverStatus::State::Settled)
        m_report = output->report;
    const bool keep = !output->surface && m_status.state != SolverStatus::State::Idle;
    SurfaceMeshPtr surface = m_status.state == SolverStatus::State::Idle ? nullptr : std::move(output->surface);
    if (!keep && surface != m_surface) {
        m_surface = std::move(surface);
        emit surfaceChanged(m_surface);
    }
    if (output->field != m_field) {
        m_field = std::move(output->field);
        emit fieldChanged(m_field);
    }
    emit statusChanged(m_status);
}

} // namespace bolster
