// Turns, pans and zooms the 3D view with the pointer.
#pragma once

#include "CoverNavigation.h"
#include "MouseStyle.h"

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

    /// Without a movement it only waits for the button: it may be a click.
    void start(const QMouseEvent& event, Qt::MouseButton button, ViewMove move);
    bool running() const { return m_button != Qt::NoButton; }
    QCursor cursor() const;
    void move(const QMouseEvent& event);
    /// True: it has ended.
    bool release(const QMouseEvent& event);
    /// It has ended where it began: a click. Who comes back there has turned.
    bool clicked() const { return !m_far; }

private:
    CoverNavigation& m_navigation;
    const ShownScene& m_shown;
    Qt::MouseButton m_button = Qt::NoButton;
    ViewMove m_move = ViewMove::None;
    bool m_far = false; ///< it was farther away than a click
    QPointF m_from, m_last;
    Vec3 m_anchor = Vec3::Zero(); ///< mm
};

} // namespace bolster
