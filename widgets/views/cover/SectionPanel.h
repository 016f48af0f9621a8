// Where the 3D view is cut open: a small panel in its corner.
#pragma once

#include "Camera.h"
#include "SectionPlane.h"

#include <QFrame>

#include <array>
#include <functional>
#include <optional>

class QLabel;
class QSlider;
class QToolButton;

namespace bolster {

/// Along x, y, z or the view direction, moved by a slider, turned round by a button.
class SectionPanel : public QFrame {
    Q_OBJECT

public:
    explicit SectionPanel(QWidget* parent);

    /// What it cuts and who looks at it: asked when a direction is chosen.
    void setScene(std::function<Box3()> box, std::function<Camera()> camera);
    /// Shows it and begins in the middle of the scene, or hides it.
    void setOn(bool on);
    bool on() const { return !isHidden(); }
    /// Moves the plane, from elsewhere than the panel; announced as changes of its own are.
    void setPlane(const SectionPlane& plane);
    /// To the lower left corner of the parent.
    void place();

signals:
    /// Nothing: not cut open.
    void changed(const std::optional<bolster::SectionPlane>& section);
    void closed();

private:
    void choose(int direction);
    void flip();
    void announce();
    void showOffset();

    std::function<Box3()> m_box;
    std::function<Camera()> m_camera;
    std::array<QToolButton*, 4> m_directions{}; ///< x, y, z, view
    QSlider* m_slider;
    QLabel* m_value;
    Vec3 m_normal = Vec3::UnitX();
    std::pair<double, double> m_range{-1, 1}; ///< mm
    double m_offset = 0;                      ///< mm, along m_normal
    bool m_flipped = false;
};

} // namespace bolster
