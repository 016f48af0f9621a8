// What the mouse does to the views: one table for both of them, by what the user is used to.
#pragma once

#include <QObject>
#include <QPointF>
#include <QString>

#include <vector>

class QWheelEvent;

namespace bolster {

enum class ViewMove { None, Turn, Pan, Zoom };
enum class MouseView { Cover, Pattern };

/// A drag with this button while at least these keys are down.
struct MouseBinding {
    ViewMove move;
    Qt::MouseButton button;
    Qt::KeyboardModifiers keys = {};
};

/// Where several bindings fit, that with the most keys counts. The first one of a movement is that which is told.
/// What holds in all of them is not in the tables: the left button turns where the cover has nothing to drag, and
/// pans the pattern while Space is down.
struct MousePreset {
    const char* id;   ///< for good: settings have it
    const char* name; ///< to be translated in the context MouseStyle
    std::vector<MouseBinding> cover;
    std::vector<MouseBinding> pattern;
    bool scrollPans = false; ///< else the wheel zooms; with Ctrl it always does
};
/// Bolster's own comes first.
const std::vector<MousePreset>& mousePresets();

struct MouseStyle {
    const MousePreset* preset = &mousePresets().front();
    bool invertZoom = false;

    friend bool operator==(const MouseStyle&, const MouseStyle&) = default;
};

class MouseStyles : public QObject {
    Q_OBJECT

public:
    static MouseStyles& instance();
    static const MouseStyle& now() { return instance().m_now; }
    void set(const MouseStyle& style);

signals:
    /// What tells of the mouse has to tell it anew.
    void changed();

private:
    MouseStyle m_now;
};

/// What a drag with this button does.
ViewMove moveOf(const MousePreset& preset, MouseView view, Qt::MouseButton button, Qt::KeyboardModifiers keys);
ViewMove moveOf(MouseView view, Qt::MouseButton button, Qt::KeyboardModifiers keys);

/// What a turn of the wheel, or two fingers on a touchpad, do.
struct WheelMove {
    double notches = 0; ///< to come closer by
    QPointF pan;        ///< pixels by which what is shown moves
};
WheelMove moveOf(const QWheelEvent& event);
/// Notches to come closer by when a drag that zooms goes this far down, pixels.
double zoomOfDrag(double down);

/// "middle button", "Shift+middle button", "wheel": what makes this movement, first of all or all that do.
QString mouseText(MouseView view, ViewMove move);
QString allMouseTexts(MouseView view, ViewMove move);

} // namespace bolster
