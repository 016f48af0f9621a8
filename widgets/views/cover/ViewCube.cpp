#include "ViewCube.h"

#include "ViewColors.h"

#include <QMouseEvent>
#include <QPainter>
#include <QPainterPath>

#include <cmath>
#include <numbers>

namespace bolster {

namespace {

constexpr double half = 26;         ///< of an edge of the cube, pixels
constexpr double border = 0.6;      ///< beyond this part of a face its edges and corners begin
constexpr double turnSpeed = 0.012; ///< radians per pixel

/// A face as it is seen from outside: its middle is its normal.
struct Face {
    Vec3 normal, right, up;
    const char* name;
};

const std::array<Face, 6>& faces()
{
    static const std::array<Face, 6> all{{
        {{0, -1, 0}, {1, 0, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("bolster::ViewCube", "FRONT")},
        {{0, 1, 0}, {-1, 0, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("bolster::ViewCube", "BACK")},
        {{-1, 0, 0}, {0, -1, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("bolster::ViewCube", "LEFT")},
        {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}, QT_TRANSLATE_NOOP("bolster::ViewCube", "RIGHT")},
        {{0, 0, 1}, {1, 0, 0}, {0, 1, 0}, QT_TRANSLATE_NOOP("bolster::ViewCube", "TOP")},
        {{0, 0, -1}, {1, 0, 0}, {0, -1, 0}, QT_TRANSLATE_NOOP("bolster::ViewCube", "BOTTOM")},
    }};
    return all;
}

double beyondBorder(double x)
{
    return x > border ? 1 : x < -border ? -1 : 0;
}

} // namespace

ViewCube::ViewCube(QWidget* parent)
    : QWidget(parent)
{
    setMouseTracking(true);
    setFixedSize(sizeHint());
    setToolTip(tr("Click a face, an edge or a corner to look from there; drag to turn"));
}

void ViewCube::setCamera(const Camera& camera)
{
    const bool turned_ = camera.azimuth != m_camera.azimuth || camera.elevation != m_camera.elevation;
    m_camera = camera;
    if (turned_)
        update();
}

QPointF ViewCube::projected(const Vec3& point) const
{
    // A little perspective: parallel cubes flip in the eye.
    const double scale = half * 6 / (6 - point.dot(m_camera.backward()));
    return QPointF(width() / 2.0, height() / 2.0) +
           QPointF(scale * point.dot(m_camera.rightward()), -scale * point.dot(m_camera.upward()));
}

QPolygonF ViewCube::quad(const Vec3& center, const Vec3& right, const Vec3& up) const
{
    return QPolygonF({projected(center - right + up), projected(center + right + up),
                      projected(center + right - up), projected(center - right - up)});
}

QPolygonF ViewCube::facePolygon(int face) const
{
    const Face& f = faces()[static_cast<std::size_t>(face)];
    return quad(f.normal, f.right, f.up);
}

std::optional<ViewCube::Zone> ViewCube::zoneAt(QPointF pixel) const
{
    const QPolygonF square({{-1, 1}, {1, 1}, {1, -1}, {-1, -1}});
    for (int i = 0; i < 6; ++i) {
        const Face& face = faces()[static_cast<std::size_t>(i)];
        const QPolygonF polygon = facePolygon(i);
        const Vec3 toEye = 6 * m_camera.backward() - face.normal;
        if (toEye.dot(face.normal) <= 0 || !polygon.containsPoint(pixel, Qt::OddEvenFill))
            continue;
        QTransform toFace;
        if (!QTransform::quadToQuad(polygon, square, toFace))
            continue;
        const QPointF at = toFace.map(pixel);
        return Zone{i, face.normal + beyondBorder(at.x()) * face.right + beyondBorder(at.y()) * face.up};
    }
    return std::nullopt;
}

void ViewCube::paintFace(QPainter& painter, int index) const
{
    const Face& face = faces()[static_cast<std::size_t>(index)];
    const Vec3 toEye = 6 * m_camera.backward() - face.normal;
    if (toEye.dot(face.normal) <= 0)
        return;
    const ViewColors colors = ViewColors::of(palette());
    const double facing = std::clamp(face.normal.dot(m_camera.backward()), 0.0, 1.0);
    const QColor base = colors.dark ? QColor(0x5b, 0x62, 0x6c) : QColor(0xff, 0xff, 0xff);
    const QColor shade = colors.dark ? QColor(0x3a, 0x3f, 0x46) : QColor(0xcf, 0xd5, 0xdc);
    const QColor edge = colors.dark ? QColor(0x22, 0x25, 0x2a) : QColor(0x9a, 0xa3, 0xad);
    const QPolygonF polygon = facePolygon(index);
    painter.setPen(QPen(edge, 1.1, Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.setBrush(mixed(shade, base, 0.35 + 0.65 * facing));
    painter.drawPolygon(polygon);
    if (m_hover) {
        // The part of this face that belongs to the zone under the pointer.
        const Vec3& d = m_hover->direction;
        if (d.dot(face.normal) > 0) {
            const auto span = [](double side) {
                return side == 0 ? std::pair(0.0, border) : std::pair(side * (1 + border) / 2, (1 - border) / 2);
            };
            const auto [x, halfWidth] = span(d.dot(face.right));
            const auto [y, halfHeight] = span(d.dot(face.up));
            QColor light = colors.accent;
            light.setAlphaF(0.45F);
            painter.setPen(Qt::NoPen);
            painter.setBrush(light);
            painter.drawPolygon(
                quad(face.normal + x * face.right + y * face.up, halfWidth * face.right, halfHeight * face.up));
        }
    }
    const QPolygonF square({{0, 0}, {100, 0}, {100, 100}, {0, 100}});
    QTransform onFace;
    if (facing < 0.15 || !QTransform::quadToQuad(square, polygon, onFace))
        return;
    QPainterPath text;
    QFont labelFont = font();
    labelFont.setPixelSize(21);
    labelFont.setWeight(QFont::DemiBold);
    text.addText(0, 0, labelFont, tr(face.name));
    const QRectF box = text.boundingRect();
    const double fit = std::min(1.0, 76 / std::max(box.width(), 1.0));
    painter.save();
    painter.setTransform(onFace, true);
    painter.translate(50, 50);
    painter.scale(fit, fit);
    painter.translate(-box.center());
    QColor ink = colors.label;
    ink.setAlphaF(static_cast<float>(std::clamp((facing - 0.15) * 3, 0.0, 0.85)));
    painter.fillPath(text, ink);
    painter.restore();
}

void ViewCube::paintAxes(QPainter& painter) const
{
    const Vec3 origin(-1.12, -1.12, -1.12);
    const std::array<std::pair<Vec3, QColor>, 3> axes{{{Vec3::UnitX(), QColor(0xd6, 0x45, 0x3d)},
                                                       {Vec3::UnitY(), QColor(0x3c, 0x9a, 0x4f)},
                                                       {Vec3::UnitZ(), QColor(0x3b, 0x77, 0xd8)}}};
    const std::array<QString, 3> names{QStringLiteral("x"), QStringLiteral("y"), QStringLiteral("z")};
    QFont axisFont = font();
    axisFont.setPixelSize(10);
    painter.setFont(axisFont);
    for (std::size_t i = 0; i < 3; ++i) {
        const QPointF tip = projected(origin + 2.5 * axes[i].first);
        painter.setPen(QPen(axes[i].second, 1.8, Qt::SolidLine, Qt::RoundCap));
        painter.drawLine(projected(origin), tip);
        painter.drawText(QRectF(tip - QPointF(7, 7), QSizeF(14, 14)).translated((tip - projected(origin)) * 0.09),
                         Qt::AlignCenter, names[i]);
    }
}

void ViewCube::paintEvent(QPaintEvent*)
{
    QPainter painter(this);
    painter.setRenderHint(QPainter::Antialiasing);
    const bool originBehind = m_camera.backward().dot(Vec3(1, 1, 1)) > 0;
    if (originBehind)
        paintAxes(painter);
    for (int i = 0; i < 6; ++i)
        paintFace(painter, i);
    if (!originBehind)
        paintAxes(painter);
}

void ViewCube::choose(const Zone& zone)
{
    const Vec3 d = zone.direction.normalized();
    double azimuth = std::atan2(d.x(), -d.y());
    if (std::hypot(d.x(), d.y()) < 1e-6) // straight from above or below: the nearest upright turn
        azimuth = std::round(m_camera.azimuth / (std::numbers::pi / 2)) * (std::numbers::pi / 2);
    emit viewChosen(azimuth, std::asin(std::clamp(d.z(), -1.0, 1.0)));
}

void ViewCube::mousePressEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton) {
        event->ignore();
        return;
    }
    m_pressed = m_last = event->position();
    m_dragged = false;
}

void ViewCube::mouseMoveEvent(QMouseEvent* event)
{
    const QPointF at = event->position();
    if (!m_pressed) {
        const std::optional<Zone> zone = zoneAt(at);
        setCursor(zone ? Qt::PointingHandCursor : Qt::ArrowCursor);
        if (zone != m_hover) {
            m_hover = zone;
            update();
        }
        return;
    }
    m_dragged = m_dragged || (at - *m_pressed).manhattanLength() > 4;
    if (m_dragged) {
        emit turned(-turnSpeed * (at.x() - m_last.x()), turnSpeed * (at.y() - m_last.y()));
        m_last = at;
    }
}

void ViewCube::mouseReleaseEvent(QMouseEvent* event)
{
    if (event->button() != Qt::LeftButton || !m_pressed)
        return;
    m_pressed.reset();
    if (m_dragged)
        return;
    if (const std::optional<Zone> zone = zoneAt(event->position()))
        choose(*zone);
}

void ViewCube::leaveEvent(QEvent*)
{
    m_hover.reset();
    update();
}

bool ViewCube::event(QEvent* event)
{
    if (event->type() == QEvent::Wheel) { // belongs to the view
        event->ignore();
        return false;
    }
    return QWidget::event(event);
}

} // namespace bolster
