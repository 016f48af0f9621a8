// A recording of gestures as text, one event a line.
#pragma once

#include <QPointF>
#include <QString>
#include <QStringList>

#include <optional>
#include <vector>

namespace bolster {

/// `gesture KIND`, then `press|move|release WIDGET X Y [left|middle]`, `wheel WIDGET X Y STEPS` and `key WIDGET
/// KEYS`. WIDGET is pattern or cover; X and Y are parts of its width and height, so that a recording fits any
/// window. Empty lines and what follows "#" say nothing.
struct FeelEvent {
    enum class Kind { Gesture, Press, Move, Release, Wheel, Key };

    Kind kind = Kind::Gesture;
    QString widget;
    QPointF at; ///< 0 to 1
    Qt::MouseButton button = Qt::LeftButton;
    double steps = 0; ///< of the wheel
    QString text;     ///< kind of gesture, or keys as "Ctrl+Z"

    QString line() const;
    /// Nothing when the line is no event.
    static std::optional<FeelEvent> read(const QString& line);
};

using FeelScript = std::vector<FeelEvent>;

} // namespace bolster
