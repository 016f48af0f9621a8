// Makes gestures up that a designer of the sample car seat would make.
#pragma once

#include "FeelPlayer.h"

#include <random>

namespace bolster {

/// The same seed in a window of the same size makes the same gestures. Each is made for the window as it stands,
/// and handed to the player at once.
class FeelRecorder {
public:
    FeelRecorder(MainWindow& window, FeelPlayer& player, unsigned seed)
        : m_window(window)
        , m_player(player)
        , m_random(seed)
    {}

    void makeGestures(int count);
    /// Everything so far.
    const FeelScript& script() const { return m_script; }

private:
    bool dragOutline();
    bool dragFixation();
    bool dragPatch();
    void orbit();
    void zoom();
    void undo();

    void begin(const char* kind);
    void add(FeelEvent event);
    void pointer(FeelEvent::Kind kind, const QString& widget, QPointF pixel,
                 Qt::MouseButton button = Qt::LeftButton);
    void wheel(const QString& widget, QPointF pixel, double steps);
    void key(const QString& widget, const QString& keys);
    void click(const QString& widget, QPointF pixel);
    /// From `from` by `by` in a slightly bent line; now and then taken back with Escape.
    void drag(const QString& widget, QPointF from, QPointF by, Qt::MouseButton button = Qt::LeftButton);
    QWidget& view(const QString& widget) const;
    int below(int count) { return static_cast<int>(m_random() % static_cast<unsigned>(count)); }
    QPointF way(int most);

    MainWindow& m_window;
    FeelPlayer& m_player;
    std::mt19937 m_random;
    FeelScript m_script;
};

} // namespace bolster
