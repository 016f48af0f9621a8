// Cuts the 3D view open: by a panel in its corner, and by a handle in the picture.
#pragma once

#include "SectionHandle.h"

#include <QObject>

class QMouseEvent;
class QWidget;

namespace bolster {

class SectionPanel;
class ShownScene;

class SectionControl : public QObject {
    Q_OBJECT

public:
    /// All must outlive it.
    SectionControl(ShownScene& shown, const Camera& camera, QWidget& view);

    /// Cut open, with the panel, or not.
    void setOn(bool on);
    /// The panel to its corner of the view, and above what lies there.
    void place();
    void raise();
    const SectionHandle& handle() const { return m_handle; }

    // The pointer; true: it is the handle's.
    bool press(const QMouseEvent& event);
    bool move(const QMouseEvent& event);
    bool release(const QMouseEvent& event);
    void leave();
    /// True: a drag was taken back.
    bool cancel();

signals:
    /// The pointer has come to the handle.
    void entered();
    /// The handle is to be drawn anew.
    void handleChanged();
    /// By the panel's button.
    void closed();

private:
    void changed();

    ShownScene& m_shown;
    SectionHandle m_handle;
    SectionPanel* m_panel; ///< the view's
};

} // namespace bolster
