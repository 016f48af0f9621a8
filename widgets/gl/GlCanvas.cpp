#include "GlCanvas.h"

#include <QPainter>

#include <chrono>
#include <exception>

namespace bolster {

namespace {

/// Makes its painter, and with it the context, on the thread where it is called first.
class PaintingWork {
public:
    explicit PaintingWork(QOffscreenSurface& surface)
        : m_surface(&surface)
    {}

    GlPainter::Picture operator()(const GlPainter::Request& request, const std::stop_token& stop)
    {
        GlPainter::Picture picture;
        picture.failed = true;
        try {
            if (!m_painter)
                m_painter = std::make_shared<GlPainter>(*m_surface);
            picture = m_painter->paint(request, stop);
        } catch (const std::exception& problem) {
            qWarning("OpenGL: %s", problem.what());
        }
        if (request.finest)
            request.finest->set_value(picture.image);
        return picture;
    }

private:
    QOffscreenSurface* m_surface;
    std::shared_ptr<GlPainter> m_painter;
};

} // namespace

GlCanvas::GlCanvas(const ViewScene& scene, const Camera& camera, QWidget* parent)
    : QWidget(parent)
    , SceneCanvas(scene, camera)
{
    setAttribute(Qt::WA_TransparentForMouseEvents);
    setAttribute(Qt::WA_OpaquePaintEvent);
    m_surface.setFormat(glFormat());
    m_surface.create();
    m_rest.setSingleShot(true);
    connect(&m_rest, &QTimer::timeout, this, [this] {
        m_moving = false;
        schedule();
    });
    m_job = std::make_unique<Job>(PaintingWork(m_surface),
                                  [this](GlPainter::Picture picture) { received(std::move(picture)); });
}

GlCanvas::~GlCanvas() = default;

void GlCanvas::refresh(bool moving)
{
    ++m_version;
    m_moving = moving;
    if (moving)
        m_rest.start(restAfter);
    schedule();
}

/// Once, after all that is being changed.
void GlCanvas::schedule()
{
    if (!std::exchange(m_scheduled, true))
        QMetaObject::invokeMethod(this, &GlCanvas::send, Qt::QueuedConnection);
}

/// A cover that is not on the screen yet comes quickly, and finely after that: a fine picture can take seconds, in
/// which the old cover would stand there as if it were the answer.
GlPainter::Request GlCanvas::request() const
{
    const bool quickly = m_moving || reduced() || m_picture.surface != m_scene.surface;
    return {m_scene, m_camera, pixelSize(), m_version, quickly, nullptr};
}

void GlCanvas::send()
{
    m_scheduled = false;
    if (!isVisible() || (m_asked && m_askedMoving))
        return; // a quick one is let end: stopping it again and again would show none
    GlPainter::Request asked = request();
    m_asked = m_version;
    m_askedMoving = asked.moving;
    m_job->request(std::move(asked), true);
}

void GlCanvas::received(GlPainter::Picture picture)
{
    if (picture.failed) {
        emit failed(tr("No OpenGL: drawn in software"));
        return;
    }
    if (picture.version == m_asked)
        m_asked.reset();
    const bool other = picture.surface != m_picture.surface;
    m_picture = std::move(picture);
    update();
    if (other)
        tellShown();
    if (m_picture.version != m_version || (!m_moving && !reduced() && !m_picture.finest))
        schedule();
}

QSize GlCanvas::pixelSize() const
{
    return (QSizeF(size()) * devicePixelRatioF()).toSize().expandedTo({1, 1});
}

void GlCanvas::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    if (m_picture.image.isNull())
        painter.fillRect(rect(), m_scene.veil());
    else // of another size only while the view is being resized
        painter.drawImage(QRectF(rect()), m_picture.image);
}

void GlCanvas::showEvent(QShowEvent*)
{
    schedule();
}

QImage GlCanvas::grab()
{
    GlPainter::Request asked = request();
    asked.finest = std::make_shared<std::promise<QImage>>();
    std::future<QImage> image = asked.finest->get_future();
    m_asked = m_version;
    m_askedMoving = false;
    m_job->request(std::move(asked), true);
    return image.get();
}

} // namespace bolster
