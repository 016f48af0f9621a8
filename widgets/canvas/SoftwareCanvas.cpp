#include "SoftwareCanvas.h"

#include "SoftwareMarks.h"

#include <QLinearGradient>
#include <QPainter>

#include <algorithm>
#include <chrono>

namespace bolster {

namespace {

using namespace std::chrono_literals;

constexpr double movingScale = 0.5;

} // namespace

SoftwareCanvas::SoftwareCanvas(const ViewScene& scene, const Camera& camera,
                               std::shared_ptr<SoftwareRenderer> renderer, QWidget* parent)
    : QWidget(parent)
    , SceneCanvas(scene, camera)
    , m_renderer(std::move(renderer))
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] { send(false); });
    if (m_renderer)
        m_job = std::make_unique<LatestJob<SoftwareRenderer::Request, Picture>>(
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
    request.scene = m_scene; // without its marks
    if (m_scene.dimmed)
        for (Scene::PatchLook& look : request.scene.patches)
            look = {look.patch, mixed(colorOf(look.color), m_scene.veil(), 0.5).name().toStdString()};
    request.camera = m_camera;
    const double scale = devicePixelRatioF() * (moving ? movingScale : 1);
    request.camera.size = Vec2((width() * scale), (height() * scale)).array().round().max(1.0);
    request.moving = moving;
    return request;
}

bool SoftwareCanvas::fine() const
{
    return !m_picture.result.image.isNull() && m_picture.request == request(false);
}

void SoftwareCanvas::refresh(bool moving)
{
    update(); // lines may have changed
    if (fine() || m_asked == request(false))
        return;
    if (!reduced())
        m_rest.start(moving ? restAfter : 0ms);
    send(true);
}

void SoftwareCanvas::send(bool moving)
{
    if (!m_job || !isVisible() || width() < 1 || height() < 1)
        return;
    if (m_asked && m_asked->moving) {
        // Let it end: stopping it again and again would show none.
        m_again = m_again || moving;
        if (!moving)
            m_rest.start(20ms);
        return;
    }
    m_again = false;
    m_asked = request(moving);
    m_job->request(*m_asked, true);
}

void SoftwareCanvas::received(Picture picture)
{
    if (!m_asked)
        return; // a picture was grabbed meanwhile
    m_asked.reset();
    if (!picture.result.image.isNull()) {
        const bool other = picture.request.scene.surface != m_picture.request.scene.surface;
        m_picture = std::move(picture);
        update();
        if (other)
            tellShown();
    }
    if (m_again)
        send(true);
}

void SoftwareCanvas::paintPicture(QPainter& painter, const Picture& picture, const Camera& camera) const
{
    if (picture.result.image.isNull()) {
        QLinearGradient gradient(0, 0, 0, height());
        gradient.setColorAt(0, colorOf(m_scene.backgroundTop));
        gradient.setColorAt(1, colorOf(m_scene.backgroundBottom));
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
    if (m_renderer && !fine()) {
        m_job->cancel();
        m_asked.reset();
        const SoftwareRenderer::Request asked = request(false);
        const std::lock_guard lock(m_rendering);
        m_picture = {asked, m_renderer->render(asked, {})};
        tellShown();
    }
    return QWidget::grab().toImage();
}

} // namespace bolster
