#include "SoftwareCanvas.h"

#include "SoftwareMarks.h"

#include <QLinearGradient>
#include <QPainter>

#include <chrono>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr auto restAfter = 180ms;
constexpr double movingScale = 0.5;

} // namespace

SoftwareCanvas::SoftwareCanvas(const SurfaceScene& scene, const Camera& camera,
                               std::shared_ptr<SoftwareRenderer> renderer, QWidget* parent)
    : QWidget(parent)
    , SurfaceCanvas(scene, camera)
    , m_renderer(std::move(renderer))
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] { send(false); });
    if (m_renderer)
        m_job = std::make_unique<SurfaceJob<SoftwareRenderer::Request, Picture>>(
            [this](const SoftwareRenderer::Request& asked, std::stop_token stop) {
                const std::lock_guard lock(m_rendering);
                return Picture{asked, m_renderer->render(asked, stop)};
            },
            [this](Picture picture) { received(std::move(picture)); });
}

SoftwareCanvas::~SoftwareCanvas() = default;

SoftwareRenderer::Request SoftwareCanvas::request(bool moving) const
{
    SoftwareRenderer::Request request;
    request.surface = m_scene.surface;
    const QColor veil = mixed(m_scene.backgroundTop(), m_scene.backgroundBottom(), 0.5);
    for (const SurfaceScene::PatchLook& look : m_scene.patches) {
        QColor color = mixed(look.fabric, QColor(look.tint.rgb()), look.tint.alphaF());
        if (m_scene.dimmed)
            color = mixed(color, veil, 0.5);
        request.looks.push_back({look.patch, color});
    }
    request.frames = m_scene.frames;
    request.camera = m_camera;
    const double scale = devicePixelRatioF() * (moving ? movingScale : 1);
    request.camera.size = Vec2((width() * scale), (height() * scale)).array().round().max(1.0);
    request.backgroundTop = m_scene.backgroundTop();
    request.backgroundBottom = m_scene.backgroundBottom();
    request.checker = m_scene.checker;
    request.ground = m_scene.ground;
    request.moving = moving;
    return request;
}

void SoftwareCanvas::refresh(bool moving)
{
    m_fine = false;
    if (moving)
        m_rest.start(restAfter);
    send(moving);
    update();
}

void SoftwareCanvas::send(bool moving)
{
    if (!m_job || width() < 1 || height() < 1)
        return;
    // A running quick picture may end: stopping it again and again would show none.
    if (m_asked == Asked::Quick && moving) {
        m_again = true;
        return;
    }
    m_again = false;
    m_asked = moving ? Asked::Quick : Asked::Fine;
    m_job->request(request(moving), true);
}

void SoftwareCanvas::received(Picture picture)
{
    m_asked = Asked::Nothing;
    if (!picture.result.image.isNull()) {
        m_picture = std::move(picture);
        m_fine = !m_picture.request.moving && !m_again;
        update();
    }
    if (m_again)
        send(true);
}

void SoftwareCanvas::paintPicture(QPainter& painter, const Picture& picture, const Camera& camera) const
{
    if (picture.result.image.isNull()) {
        QLinearGradient gradient(0, 0, 0, height());
        gradient.setColorAt(0, m_scene.backgroundTop());
        gradient.setColorAt(1, m_scene.backgroundBottom());
        painter.fillRect(rect(), gradient);
    } else {
        painter.setRenderHint(QPainter::SmoothPixmapTransform);
        painter.drawImage(QRectF(rect()), picture.result.image);
    }
    paintMarks(painter, m_scene, camera, picture.result.depth, picture.request.camera.size.cast<int>());
}

void SoftwareCanvas::paintEvent(QPaintEvent*)
{
    // Lines are drawn for the picture that is shown: both move together.
    Camera camera = m_picture.result.image.isNull() ? m_camera : m_picture.request.camera;
    camera.size = {width(), height()};
    QPainter painter(this);
    paintPicture(painter, m_picture, camera);
}

void SoftwareCanvas::resizeEvent(QResizeEvent*)
{
    refresh(true);
}

QImage SoftwareCanvas::grab()
{
    if (m_renderer && !m_fine) {
        m_job->cancel();
        m_asked = Asked::Nothing;
        const SoftwareRenderer::Request asked = request(false);
        const std::lock_guard lock(m_rendering);
        m_picture = {asked, m_renderer->render(asked, {})};
        m_fine = true;
    }
    return QWidget::grab().toImage();
}

} // namespace bolster
