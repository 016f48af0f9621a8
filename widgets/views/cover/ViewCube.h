// The cube in the corner that shows how the view is turned, and turns it.
#pragma once

#include "Camera.h"

#include <QPolygonF>
#include <QWidget>

#include <array>
#include <optional>

namespace bolster {

/// A click on a face, an edge or a corner looks from there; dragging turns.
class ViewCube : public QWidget {
    Q_OBJECT

public:
    explicit ViewCube(QWidget* parent);

    void setCamera(const Camera& camera);
    QSize sizeHint() const override { return {104, 104}; }

signals:
    void viewChosen(double azimuth, double elevation);
    void turned(double azimuthBy, double elevationBy);

protected:
    void paintEvent(QPaintEvent* event) override;
    void mousePressEvent(QMouseEvent* event) override;
    void mouseMoveEvent(QMouseEvent* event) override;
    void mouseReleaseEvent(QMouseEvent* event) override;
    void leaveEvent(QEvent* event) override;
    bool event(QEvent* event) override;

private:
    struct Zone {
        int face = 0;
        Vec3 direction = Vec3::Zero(); ///< from where this zone is seen best: a face, an edge or a corner

        friend bool operator==(const Zone&, const Zone&) = default;
    };

    QPointF projected(const Vec3& point) const;
    QPolygonF quad(const Vec3& center, const Vec3& right, const Vec3& up) const;
    QPolygonF facePolygon(int face) const;
    std::optional<Zone> zoneAt(QPointF pixel) const;
    void paintFace(QPainter& painter, int face) const;
    void paintAxes(QPainter& painter) const;
    void choose(const Zone& zone);

    Camera m_camera;
    std::optional<Zone> m_hover;
    std::optional<QPointF> m_pressed;
    QPointF m_last;
    bool m_dragged = false;
};

} // namespace bolster
