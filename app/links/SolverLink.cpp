#include "SolverLink.h"

#include "Document.h"

#include <utility>

namespace bolster {

SolverLink::SolverLink(Document& document, QObject* parent, std::shared_ptr<RestingCache> kept)
    : QObject(parent)
    , m_document(document)
    , m_glide([this](const SurfaceMeshPtr& surface) { emit surfaceShown(surface); })
    , m_thread(std::make_unique<SolverThread>(
          [this] { QMetaObject::invokeMethod(this, &SolverLink::receive, Qt::QueuedConnection); }, std::move(kept)))
{
    connect(&document, &Document::changed, this, &SolverLink::send);
    connect(&document, &Document::gestureEnded, this, &SolverLink::sendAfterGesture);
}

SolverLink::~SolverLink() = default;

bool SolverLink::upToDate() const
{
    return m_answered == m_document.revision();
}

bool SolverLink::atRest() const
{
    return upToDate() && m_status.resting && !m_document.gestureRunning();
}

void SolverLink::whenAtRest(QObject* context, Then then)
{
    m_waiting.push_back({context, std::move(then)});
    answerWaiting();
}

void SolverLink::answerWaiting()
{
    using State = SolverStatus::State;
    const bool ended = upToDate() && (m_status.state == State::Failed || m_status.state == State::Idle);
    const bool stays = m_paused && (!upToDate() || m_sentInGesture);
    if (m_waiting.empty() || !(atRest() || ended || stays))
        return;
    m_glide.finish(); // pictures are made of what is seen
    const SurfaceMeshPtr surface = atRest() ? m_surface : nullptr;
    for (const Waiting& waiting : std::exchange(m_waiting, {}))
        if (waiting.context)
            waiting.then(surface);
}

void SolverLink::send()
{
    if (m_paused || m_document.breakage()) // the last good surface stays until the gesture is sound again
        return;
    m_sentInGesture = m_document.gestureRunning();
    m_thread->request({m_document.design(), m_files}, m_document.revision(), m_document.dragging());
    if (!m_sentInGesture && m_status.state == SolverStatus::State::Settled && !m_status.resting) {
        // The solver may be at this very design already, and says nothing until its triangles are there.
        m_status.state = SolverStatus::State::Preparing;
        m_status.stage = SolverStatus::Stage::Triangles;
        emit statusChanged(m_status);
    }
}

/// The end of a gesture changes nothing when the design is what the last preview was, and so says nothing; but now
/// the resting surface is wanted.
void SolverLink::sendAfterGesture()
{
    if (!m_sentInGesture || m_document.gestureRunning())
        return;
    send();
}

void SolverLink::setFiles(DesignFiles files)
{
    m_files = std::move(files);
    send();
}

void SolverLink::setPaused(bool paused)
{
    m_paused = paused;
    if (!paused && (!upToDate() || m_sentInGesture))
        send();
    answerWaiting();
}

void SolverLink::setFieldShown(bool shown)
{
    m_thread->drawField(shown);
    send();
}

void SolverLink::forget(DesignFiles files)
{
    m_files = std::move(files);
    m_thread->startAnew();
    m_status = {};
    if (m_document.design().count<Patch>() > 0)
        m_status.state = SolverStatus::State::Preparing; // it may be long until the solver says so
    m_report = {};
    takeSurface(nullptr, nullptr);
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
        takeSurface(std::move(surface), output->from);
        if (m_status.sprang)
            emit sprang(*m_status.sprang);
    }
    if (output->field != m_field) {
        m_field = std::move(output->field);
        emit fieldChanged(m_field);
    }
    emit statusChanged(m_status);
    answerWaiting();
}

void SolverLink::takeSurface(SurfaceMeshPtr surface, const SurfaceMeshPtr& from)
{
    m_glide.stop();
    m_surface = std::move(surface);
    if (from && m_surface)
        m_glide.start(from, m_surface);
    else
        emit surfaceShown(m_surface);
    emit surfaceChanged(m_surface);
}

} // namespace bolster
