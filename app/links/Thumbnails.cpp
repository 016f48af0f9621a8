#include "Thumbnails.h"

#include "Background.h"
#include "CoverPicture.h"
#include "CoverView.h"
#include "DesignSession.h"
#include "SolverLink.h"

#include <QBuffer>

#include <chrono>
#include <utility>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr auto pause = 700ms; // without a change
constexpr int pictureWidth = 192;
constexpr int pictureHeight = 144;
constexpr std::size_t mostInMemory = 500;
constexpr std::size_t mostWaiting = 50;

/// Without a background: the list in which it is shown is light or dark.
QByteArray pngOf(const Scene& scene, const Camera& camera)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return coverPicture(scene, camera, {pictureWidth, pictureHeight}).save(&buffer, "PNG") ? bytes : QByteArray();
}

} // namespace

Thumbnails::Thumbnails(DesignSession& session, SolverLink& solver, CoverView& view)
    : m_session(session)
    , m_solver(solver)
    , m_view(view)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(pause);
    connect(&m_pause, &QTimer::timeout, this, &Thumbnails::make);
    connect(&solver, &SolverLink::statusChanged, this, [this] {
        note();
        store();
        m_pause.start();
    });
    connect(&session, &DesignSession::opened, this, [this] {
        ++m_generation;
        m_pictures.clear();
        m_waiting.clear();
        m_unstored.clear();
    });
}

/// Drawn later: by then the next version may be there.
void Thumbnails::note()
{
    const Document& document = m_session.document();
    const NodeId node = document.history().current();
    if (!m_solver.atRest() || !picture(node).isEmpty())
        return;
    if (m_waiting.size() >= mostWaiting)
        m_waiting.erase(m_waiting.begin());
    m_waiting[node] = {m_solver.surface(), document.committed()};
}

/// The newest first.
void Thumbnails::make()
{
    if (m_drawing || m_waiting.empty())
        return;
    const auto [node, version] = *m_waiting.rbegin();
    m_waiting.erase(node);
    m_drawing = true;
    inBackground<QByteArray>([scene = coverScene(version.surface, version.design),
                              camera = m_view.navigation().camera()] {
        return pngOf(scene, camera);
    }).then(this, [this, node = node, generation = m_generation](const QByteArray& png) {
        m_drawing = false;
        if (generation == m_generation && !png.isEmpty())
            keep(node, png);
        if (!m_pause.isActive())
            make();
    });
}

void Thumbnails::keep(NodeId node, const QByteArray& png)
{
    if (m_pictures.size() >= mostInMemory)
        m_pictures.erase(m_pictures.begin());
    m_pictures[node] = png;
    m_unstored.insert(node);
    store();
    emit made(node);
}

/// There is no journal before the first edit.
void Thumbnails::store()
{
    const auto& journal = m_session.journal().journal();
    if (!journal)
        return;
    for (const NodeId node : std::exchange(m_unstored, {}))
        (void)journal->setThumbnail(node,
                                    m_pictures[node].toStdString()); // without it there is only a picture less
}

QByteArray Thumbnails::picture(NodeId node)
{
    if (const auto found = m_pictures.find(node); found != m_pictures.end())
        return found->second;
    const auto& journal = m_session.journal().journal();
    return journal ? QByteArray::fromStdString(journal->thumbnail(node)) : QByteArray();
}

} // namespace bolster
