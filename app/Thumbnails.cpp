#include "Thumbnails.h"

#include "Background.h"
#include "DesignSession.h"
#include "FabricShown.h"
#include "RayRenderer.h"
#include "SolverLink.h"
#include "SurfaceView.h"

#include <QBuffer>

#include <chrono>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr auto pause = 700ms; // without a change
constexpr int pictureWidth = 192;
constexpr int pictureHeight = 144;
constexpr std::size_t mostInMemory = 500;

SoftwareRenderer::Request requestFor(const SurfaceMeshPtr& surface, const Design& design, const SurfaceView& view)
{
    SoftwareRenderer::Request request;
    request.surface = surface;
    design.each<Patch>([&](ElementId id, const Patch&) {
        const Fabric* fabric = design.find<Fabric>(fabricShown(design, id));
        request.looks.push_back({id, QColor(QString::fromStdString(fabric ? fabric->color : Fabric{}.color))});
    });
    request.camera = view.camera();
    request.camera.size = {pictureWidth, pictureHeight};
    request.camera.fit(surface->boundingBox());
    request.backgroundTop = QColor(0xd8, 0xdd, 0xe3);
    request.backgroundBottom = QColor(0xf4, 0xf5, 0xf7);
    return request;
}

QByteArray pngOf(const QImage& image)
{
    QByteArray bytes;
    QBuffer buffer(&bytes);
    buffer.open(QIODevice::WriteOnly);
    return image.save(&buffer, "PNG") ? bytes : QByteArray();
}

} // namespace

Thumbnails::Thumbnails(DesignSession& session, SolverLink& solver, SurfaceView& view)
    : m_session(session)
    , m_solver(solver)
    , m_view(view)
{
    m_pause.setSingleShot(true);
    m_pause.setInterval(pause);
    connect(&m_pause, &QTimer::timeout, this, &Thumbnails::make);
    connect(&solver, &SolverLink::statusChanged, this, [this] { m_pause.start(); });
    connect(&session, &DesignSession::opened, this, [this] {
        ++m_generation;
        m_pictures.clear();
    });
}

void Thumbnails::make()
{
    const Document& document = m_session.document();
    const NodeId node = document.history().current();
    if (!m_solver.atRest() || !picture(node).isEmpty())
        return;
    inBackground<QByteArray>([request = requestFor(m_solver.surface(), document.committed(), m_view)] {
        return pngOf(RayRenderer().render(request, {}).image);
    }).then(this, [this, node, generation = m_generation](const QByteArray& png) {
        if (generation == m_generation && !png.isEmpty())
            keep(node, png);
    });
}

void Thumbnails::keep(NodeId node, const QByteArray& png)
{
    if (m_pictures.size() >= mostInMemory)
        m_pictures.erase(m_pictures.begin());
    m_pictures[node] = png;
    if (const auto& journal = m_session.journal().journal())
        (void)journal->setThumbnail(node, png.toStdString()); // without it there is only a picture less
    emit made(node);
}

QByteArray Thumbnails::picture(NodeId node)
{
    if (const auto found = m_pictures.find(node); found != m_pictures.end())
        return found->second;
    const auto& journal = m_session.journal().journal();
    return journal ? QByteArray::fromStdString(journal->thumbnail(node)) : QByteArray();
}

} // namespace bolster
