// How the 3D view looks at its scene, and how it comes to look elsewhere.
#pragma once

#include "Camera.h"

#include <QObject>
#include <QPointF>
#include <QVariantAnimation>

class QWidget;

namespace bolster {

class ShownScene;

class CoverNavigation : public QObject {
    Q_OBJECT

public:
    using StandardView = Camera::StandardView;

    /// Both must outlive it. Of the view the size counts, and whether it is seen: if not, nothing flies.
    CoverNavigation(const ShownScene& shown, const QWidget& view);

    const Camera& camera() const { return m_camera; }
    void setCamera(const Camera& camera);
    /// Turns smoothly; the size of the picture stays.
    void flyTo(const Camera& camera);
    /// The view of a design that is opened again: what appears in it by and by does not move it.
    void returnTo(const Viewpoint& view);
    bool hasReturned() const { return m_returned; }

    void fitAll();
    void fit(const Box3& box); ///< mm
    void fitSelection();       ///< everything when nothing that is shown is selected
    /// Turns smoothly and fits the whole scene, and this box (mm) with it.
    void setStandardView(bolster::CoverNavigation::StandardView view, const bolster::Box3& with = {});
    void lookFrom(double azimuth, double elevation); ///< likewise; radians
    void setPerspective(bool perspective);
    bool perspective() const { return m_camera.perspective; }
    /// All of the box can be seen, but for what stands in front of it.
    bool inPicture(const Box3& box) const;
    /// Moves the picture if the place (mm) is not in it.
    void reveal(const Vec3& place);
    /// Also turns it, from the side or from above, if the place is behind something or seen from inside.
    /// `outwards`: of the cover there.
    void face(const Vec3& place, const Vec3& outwards);

    /// About the middle of the scene; radians.
    void turn(double azimuthBy, double elevationBy);
    /// Stays where it is, whatever was on its way or appears.
    void stop();
    void pan(QPointF by, QPointF pixel); ///< pixels; what lies under the pixel stays below it
    /// The factor of so many notches of the wheel.
    static double closer(double notches);
    /// Flights take no time.
    void setAnimated(bool animated) { m_animated = animated; }
    /// `factor` < 1 comes closer to what lies under the pixel.
    void zoom(double factor, QPointF pixel);
    /// What lies under the pixel, or the place at the depth of the scene's middle: movements are about it.
    Vec3 anchorAt(QPointF pixel) const;
    Vec3 middle() const; ///< of the scene, mm

    /// The view has another size.
    void resize();
    /// There is something to see, or a size: what was not possible before is done now.
    void catchUp();

signals:
    /// Turned, moved or zoomed.
    void moved(const bolster::Camera& camera);
    void perspectiveChanged(bool perspective);

private:
    void apply(const Camera& camera);
    void goTo(const Camera& camera);
    Camera destination() const;
    double frontSide() const;
    bool isInView(const Camera& camera, const Vec3& place) const;
    bool sees(const Camera& camera, const Vec3& place) const;
    bool comesBack(const Box3& box) const;

    const ShownScene& m_shown;
    const QWidget& m_view;
    Camera m_camera;
    bool m_fitPending = true; ///< until there is something to see and a size
    bool m_animated = true;
    bool m_returned = false; ///< the view was given, and no other was asked for since
    Box3 m_seen;             ///< where there has been something since the design was opened, mm
    QVariantAnimation m_flight;
    Camera m_from, m_to; ///< of the flight
};

} // namespace bolster
