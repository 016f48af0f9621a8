#include "SoftwareMarks.h"

#include <QPainter>
#include <QPainterPath>

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

class Hiding {
public:
    Hiding(const Camera& camera, const std::vector<float>& depth, const Eigen::Vector2i& size)
        : m_camera(camera)
        , m_depth(depth)
        , m_size(size)
        , m_known(depth.size() == static_cast<std::size_t>(size.x()) * static_cast<std::size_t>(size.y()))
    {}

    bool hides(const Vec3& point, const Vec2& pixel) const
    {
        if (!m_known)
            return false;
        const Eigen::Vector2i at =
            pixel.cwiseQuotient(m_camera.size).cwiseProduct(m_size.cast<double>()).cast<int>();
        if ((at.array() < 0).any() || (at.array() >= m_size.array()).any())
            return false;
        const float front = m_depth[static_cast<std::size_t>(at.y()) * static_cast<std::size_t>(m_size.x()) +
                                    static_cast<std::size_t>(at.x())];
        return front < m_camera.depth(point) - 3 - 4 * m_camera.pixelSize(point);
    }

private:
    const Camera& m_camera;
    const std::vector<float>& m_depth;
    Eigen::Vector2i m_size;
    bool m_known;
};

void stroke(QPainter& painter, const QPainterPath& path, const SceneLine& line, float opacity)
{
    painter.setBrush(Qt::NoBrush);
    painter.setOpacity(static_cast<double>(opacity));
    if (line.casing > 0) {
        const QColor casing = line.color.darker(400);
        painter.setPen(QPen(casing, static_cast<double>(line.width + 2 * line.casing), Qt::SolidLine, Qt::RoundCap,
                            Qt::RoundJoin));
        painter.drawPath(path);
    }
    painter.setPen(QPen(line.color, static_cast<double>(line.width), Qt::SolidLine, Qt::RoundCap, Qt::RoundJoin));
    painter.drawPath(path);
}

void paintLine(QPainter& painter, const SceneLine& line, const Camera& camera, const Hiding& hiding)
{
    QPainterPath shown, behind;
    std::optional<Vec2> last;
    bool lastHidden = false;
    for (const Eigen::Vector3f& p : line.points) {
        const Vec3 point = p.cast<double>();
        const std::optional<Vec2> at = camera.pixel(point);
        if (!at) {
            last.reset();
            continue;
        }
        const bool hidden = hiding.hides(point, *at);
        if (last) {
            QPainterPath& path = hidden && lastHidden ? behind : shown;
            const QPointF from(last->x(), last->y());
            if (path.currentPosition() != from || path.isEmpty())
                path.moveTo(from);
            path.lineTo(at->x(), at->y());
        }
        last = at;
        lastHidden = hidden;
    }
    if (line.hidden > 0)
        stroke(painter, behind, line, line.hidden);
    stroke(painter, shown, line, 1);
}

void paintDot(QPainter& painter, const SceneDot& dot, const Camera& camera, const Hiding& hiding)
{
    const Vec3 point = dot.at.cast<double>();
    const std::optional<Vec2> at = camera.pixel(point);
    if (!at)
        return;
    painter.setOpacity(hiding.hides(point, *at) ? static_cast<double>(dot.hidden) : 1.0);
    painter.setPen(QPen(dot.rim, 1.6));
    painter.setBrush(dot.fill);
    const double radius = static_cast<double>(dot.radius) - 0.8;
    painter.drawEllipse(QPointF(at->x(), at->y()), radius, radius);
}

void paintPoints(QPainter& painter, const ViewScene::PointsLook& look, const Camera& camera, const Hiding& hiding)
{
    const auto width = static_cast<double>(look.size);
    QPolygonF shown;
    painter.setOpacity(1);
    for (std::size_t i = 0; i < look.points->size(); ++i) {
        const Vec3 point = (*look.points)[i].cast<double>();
        const std::optional<Vec2> at = camera.pixel(point);
        if (!at || hiding.hides(point, *at))
            continue;
        if (!look.own) {
            shown.append({at->x(), at->y()});
            continue;
        }
        painter.setPen(QPen(look.colorOf(i), width));
        painter.drawPoint(QPointF(at->x(), at->y()));
    }
    painter.setPen(QPen(look.color, width));
    painter.drawPoints(shown);
}

} // namespace

void paintMarks(QPainter& painter, const ViewScene& scene, const Camera& camera, const std::vector<float>& depth,
                const Eigen::Vector2i& depthSize)
{
    const Hiding hiding(camera, depth, depthSize);
    painter.save();
    for (const ViewScene::PointsLook& look : scene.points) // many and small: smoothing would show little
        paintPoints(painter, look, camera, hiding);
    painter.setRenderHint(QPainter::Antialiasing);
    for (const SceneLine& line : scene.lines)
        paintLine(painter, line, camera, hiding);
    for (const SceneDot& dot : scene.dots)
        paintDot(painter, dot, camera, hiding);
    painter.restore();
}

} // namespace bolster
