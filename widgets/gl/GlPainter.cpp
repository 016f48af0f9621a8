#include "GlPainter.h"

#include <QElapsedTimer>
#include <QOffscreenSurface>

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace bolster {

namespace {

constexpr double timeForMoving = 0.03;  ///< seconds a frame should take while something moves
constexpr double timeForResting = 0.04; ///< seconds of refinement before the next picture is shown

double seconds(const QElapsedTimer& clock)
{
    return 1e-9 * static_cast<double>(clock.nsecsElapsed());
}

} // namespace

GlPainter::GlPainter(QOffscreenSurface& surface)
{
    m_context.setFormat(glFormat());
    if (!m_context.create() || !m_context.makeCurrent(&surface))
        throw std::runtime_error("no OpenGL context");
    m_renderer = std::make_unique<SceneRenderer>();
    m_picture = std::make_unique<GlPicture>(*glFunctions());
}

GlPainter::~GlPainter()
{
    m_renderer.reset();
    m_picture.reset();
    m_context.doneCurrent();
}

GlPainter::Picture GlPainter::paint(const Request& request, const std::stop_token& stop)
{
    if (std::exchange(m_version, request.version) != request.version)
        m_picture->restart();
    m_renderer->update(request.scene);
    if (request.moving && !request.finest)
        paintMoving(request);
    else
        refine(request, stop);
    if (stop.stop_requested())
        return {};
    return {m_picture->image(request.size), request.scene.surface, request.version,
            m_picture->count() >= GlPicture::finest, false};
}

void GlPainter::paintMoving(const Request& request)
{
    const bool quick = m_fineTime > timeForMoving;
    // The time goes with the number of pixels.
    const double wanted = std::sqrt(timeForMoving / std::max(m_frameTime, 1e-4));
    const double scale = std::clamp(std::floor(4 * wanted) / 4, 0.5, 1.0);
    const QSize reduced = (QSizeF(request.size) * scale).toSize().expandedTo({1, 1});
    QElapsedTimer clock;
    clock.start();
    m_picture->replace(reduced, [&](const Vec2& jitter) {
        m_renderer->draw(request.scene, request.camera, reduced, jitter, quick);
    });
    glFunctions()->glFinish();
    m_frameTime += 0.35 * (seconds(clock) / (scale * scale) - m_frameTime);
}

void GlPainter::refine(const Request& request, const std::stop_token& stop)
{
    QElapsedTimer clock;
    clock.start();
    while (m_picture->count() < GlPicture::finest && !stop.stop_requested()) {
        const double begin = seconds(clock);
        m_picture->add(request.size, [&](const Vec2& jitter) {
            m_renderer->draw(request.scene, request.camera, request.size, jitter, false);
        });
        glFunctions()->glFinish();
        m_fineTime = seconds(clock) - begin;
        if (!request.finest && seconds(clock) > timeForResting)
            break;
    }
}

} // namespace bolster
