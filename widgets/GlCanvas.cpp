#include "GlCanvas.h"

#include <QElapsedTimer>
#include <QOpenGLContext>

#include <algorithm>
#include <chrono>
#include <cmath>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr auto restAfter = 180ms;
constexpr double timeForMoving = 0.03;  ///< seconds a frame should take while something moves
constexpr double timeForResting = 0.04; ///< seconds of refinement before the window gets its turn

} // namespace

GlCanvas::GlCanvas(const SurfaceScene& scene, const Camera& camera, QWidget* parent)
    : QOpenGLWidget(parent)
    , SurfaceCanvas(scene, camera)
{
    setFormat(glFormat());
    setUpdateBehavior(QOpenGLWidget::NoPartialUpdate);
    setAttribute(Qt::WA_TransparentForMouseEvents);
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        m_moving = false;
        update();
    });
}

GlCanvas::~GlCanvas()
{
    release();
}

void GlCanvas::release()
{
    if (!m_renderer || !context())
        return;
    makeCurrent();
    m_renderer.reset();
    m_picture.reset();
    doneCurrent();
}

void GlCanvas::initializeGL()
{
    // The context goes when the view moves into another window: what lives in it must go before.
    connect(context(), &QOpenGLContext::aboutToBeDestroyed, this, &GlCanvas::release, Qt::UniqueConnection);
    try {
        m_renderer = std::make_unique<SurfaceRenderer>();
        m_picture = std::make_unique<GlPicture>(*glFunctions());
    } catch (const std::exception& problem) {
        m_renderer.reset();
        m_picture.reset();
        qWarning("OpenGL: %s", problem.what());
        QMetaObject::invokeMethod(
            this, [this] { emit failed(tr("No OpenGL: drawn in software")); }, Qt::QueuedConnection);
    }
}

void GlCanvas::refresh(bool moving)
{
    if (m_picture)
        m_picture->restart();
    m_moving = moving;
    if (moving)
        m_rest.start(restAfter);
    update();
}

QSize GlCanvas::pixelSize() const
{
    return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void GlCanvas::paintGL()
{
    if (!m_renderer)
        return;
    const QSize size = pixelSize();
    m_renderer->update(m_scene);
    if (m_moving && !m_fineAtOnce)
        paintMoving(size);
    else
        paintResting(size);
    m_picture->present(defaultFramebufferObject(), size);
    if (!m_moving && m_picture->count() < GlPicture::finest)
        QMetaObject::invokeMethod(
            this, [this] { update(); }, Qt::QueuedConnection);
}

void GlCanvas::paintMoving(const QSize& size)
{
    // The time goes with the number of pixels.
    const double wanted = std::sqrt(timeForMoving / std::max(m_frameTime, 1e-4));
    const double scale = std::clamp(std::floor(4 * wanted) / 4, 0.5, 1.0);
    const QSize reduced = (QSizeF(size) * scale).toSize().expandedTo({1, 1});
    QElapsedTimer clock;
    clock.start();
    m_picture->replace(reduced, [&](const Vec2& jitter) { m_renderer->draw(m_scene, m_camera, reduced, jitter); });
    glFunctions()->glFinish();
    const double time = 1e-9 * static_cast<double>(clock.nsecsElapsed()) / (scale * scale);
    m_frameTime += 0.35 * (time - m_frameTime);
}

void GlCanvas::paintResting(const QSize& size)
{
    QElapsedTimer clock;
    clock.start();
    do {
        m_picture->add(size, [&](const Vec2& jitter) { m_renderer->draw(m_scene, m_camera, size, jitter); });
        glFunctions()->glFinish();
    } while (m_picture->count() < GlPicture::finest &&
             (m_fineAtOnce || 1e-9 * static_cast<double>(clock.nsecsElapsed()) < timeForResting));
}

QImage GlCanvas::grab()
{
    m_fineAtOnce = true;
    if (m_picture)
        m_picture->restart();
    QImage image = grabFramebuffer();
    m_fineAtOnce = false;
    return image;
}

} // namespace bolster
