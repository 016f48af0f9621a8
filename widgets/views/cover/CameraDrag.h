// Turns and pans the 3D view with the pointer.
#pragma once

#include "CoverNavigation.h"

#include <QCursor>

class QMouseEvent;

namespace bolster {

/// From the press of a button to its release.
class CameraDrag {
public:
    /// Both must outlive it.
    CameraDrag(CoverNavigation& navigation, const ShownScene& shown)
        : m_navigation(navigation)
        , m_shown(shown)
    {}

    /// With Shift it pans.
    void start(const QMouseEvent& event, Qt::MouseButton button);
    bool running() const { return m_button != Qt::NoButton; }
    QCursor cursor() const { return m_pans ? Qt::ClosedHandCursor : Qt::SizeAllCursor; }
    void move(const QMouseEvent& event);
    /// True: it has ended.
    bool release(const QMouseEvent& event);
    /// It has ended where it began: a click. Who comes back there has turned.
    bool clicked() const { return !m_far; }

private:
    CoverNavigation& m_navigation;
    const ShownScene& m_shown;
    Qt::MouseButton m_button = Qt::NoButton;
    bool m_pans = false;
    bool m_far = false; ///< it was farther away than a click
    QPointF m_from, m_last;
    Vec3 m_anchor = Vec3::Zero(); ///< mm
};

} // namespace bolster
