// Numbers that are typed while something is drawn: a small field at the pointer.
#pragma once

#include "Geometry.h"
#include "Units.h"
#include "ViewColors.h"

#include <QLocale>
#include <QString>

#include <optional>

class QKeyEvent;
class QPainter;

namespace bolster {

/// The step to the next point, mm, y up: "500" goes that far towards `towards`, "500<30" or "500;30" as far at
/// that angle (degrees, counter-clockwise from the right), "120,40" to the right and up. Where the comma is the
/// decimal sign, a blank behind it separates: "120, 40". Lengths as parseLength takes them. Nothing when the text
/// is no such thing (yet).
std::optional<Vec2> typedStep(const QString& text, const Vec2& towards, const QLocale& locale = numberLocale());
/// Width and height as a step from the first corner, in the quadrant of `towards`: "300x200", "300;200",
/// "300,200", or one length for both.
std::optional<Vec2> typedSize(const QString& text, const Vec2& towards, const QLocale& locale = numberLocale());

/// A place in space, mm: "250, -250, 40", or with ";" between; of two numbers the third is `height`.
std::optional<Vec3> typedPlace(const QString& text, double height, const QLocale& locale = numberLocale());

/// What has been typed so far. Opens with a digit, sign, bracket or decimal sign; then takes everything.
class TypedEntry {
public:
    bool open() const { return !m_text.isEmpty(); }
    const QString& text() const { return m_text; }
    void clear() { m_text.clear(); }

    /// True: used. Backspace takes back a character, Tab separates two numbers.
    bool keyPress(const QKeyEvent& event);
    /// The key would be used.
    bool wants(int key) const;
    /// Beside the pointer (pixels); `good`: the text can be understood.
    void paint(QPainter& painter, const ViewColors& colors, QPointF beside, bool good) const;

private:
    QString m_text;
};

} // namespace bolster
