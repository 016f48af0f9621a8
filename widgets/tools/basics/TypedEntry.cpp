#include "TypedEntry.h"

#include "LengthExpression.h"

#include <QKeyEvent>
#include <QPainter>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

// Pixels.
constexpr double fieldGap = 16;
constexpr double fieldPadding = 5;
constexpr double leastWidth = 64;

constexpr qsizetype longestText = 60;

using Pair = std::optional<std::pair<QString, QString>>;

/// The two texts beside the only separator.
Pair cut(const QString& text, const QString& separator)
{
    if (text.count(separator) != 1)
        return std::nullopt;
    const qsizetype at = text.indexOf(separator);
    return std::pair(text.left(at), text.mid(at + separator.size()));
}

Pair cutAtComma(const QString& text, const QLocale& locale)
{
    if (const Pair pair = cut(text, QStringLiteral(", ")))
        return pair;
    return locale.decimalPoint() == QLatin1String(",") ? std::nullopt : cut(text, QStringLiteral(","));
}

std::optional<Vec2> lengths(const Pair& pair, const QLocale& locale)
{
    const auto x = parseLength(pair->first, locale);
    const auto y = parseLength(pair->second, locale);
    return x && y ? std::optional(Vec2(*x, *y)) : std::nullopt;
}

std::optional<Vec2> polar(const Pair& pair, const QLocale& locale)
{
    QString angle = pair->second;
    const auto length = parseLength(pair->first, locale);
    const auto degrees = parseNumber(angle.remove(u'\u00b0'), locale);
    if (!length || !degrees)
        return std::nullopt;
    const double radians = *degrees * std::numbers::pi / 180;
    return Vec2(*length * std::cos(radians), *length * std::sin(radians));
}

bool opens(const QString& typed)
{
    return typed.size() == 1 && (typed[0].isDigit() || QStringLiteral("-+.,(").contains(typed[0]));
}

} // namespace

std::optional<Vec2> typedStep(const QString& text, const Vec2& towards, const QLocale& locale)
{
    for (const QChar sign : {QChar(u'<'), QChar(u';')})
        if (const Pair pair = cut(text, sign))
            return polar(pair, locale);
    if (const Pair pair = cutAtComma(text, locale))
        return lengths(pair, locale);
    const auto length = parseLength(text, locale);
    if (!length || !(towards.norm() > 0))
        return std::nullopt;
    return Vec2(*length * towards.normalized());
}

std::optional<Vec2> typedSize(const QString& text, const Vec2& towards, const QLocale& locale)
{
    std::optional<Vec2> size;
    QString plain = text;
    plain.replace(u'\u00d7', u'x').replace(u'X', u'x');
    for (const QChar sign : {QChar(u'x'), QChar(u';')})
        if (const Pair pair = cut(plain, sign); pair && !size)
            size = lengths(pair, locale);
    if (const Pair pair = cutAtComma(plain, locale); pair && !size)
        size = lengths(pair, locale);
    if (const auto length = parseLength(plain, locale); length && !size)
        size = Vec2(*length, *length);
    if (!size)
        return size;
    return Vec2(std::copysign(size->x(), towards.x()), std::copysign(size->y(), towards.y()));
}

std::optional<Vec3> typedPlace(const QString& text, double height, const QLocale& locale)
{
    const bool commas = locale.decimalPoint() != QLatin1String(",");
    QStringList parts = text.split(u';');
    if (parts.size() == 1)
        parts = text.split(commas ? QStringLiteral(",") : QStringLiteral(", "));
    if (parts.size() < 2 || parts.size() > 3)
        return std::nullopt;
    Vec3 place(0, 0, height);
    for (qsizetype axis = 0; axis < parts.size(); ++axis) {
        const auto length = parseLength(parts[axis], locale);
        if (!length)
            return std::nullopt;
        place[axis] = *length;
    }
    return place;
}

bool TypedEntry::keyPress(const QKeyEvent& event)
{
    if (event.key() == Qt::Key_Backspace && open()) {
        m_text.chop(1);
        return true;
    }
    const QString typed = event.key() == Qt::Key_Tab && open() ? QStringLiteral(";") : event.text();
    if (typed.isEmpty() || !typed[0].isPrint() || (event.modifiers() & (Qt::ControlModifier | Qt::MetaModifier)) ||
        !(open() || opens(typed)))
        return false;
    if (m_text.size() < longestText)
        m_text += typed;
    return true;
}

bool TypedEntry::wants(int key) const
{
    if (key == Qt::Key_Backspace || key == Qt::Key_Tab)
        return open();
    if (key >= Qt::Key_Space && key <= Qt::Key_ydiaeresis)
        return open() || opens(QString(QChar(static_cast<char16_t>(key))));
    return false;
}

void TypedEntry::paint(QPainter& painter, const ViewColors& colors, QPointF beside, bool good) const
{
    const QFontMetricsF metrics(painter.font());
    const double width = std::max(leastWidth, metrics.horizontalAdvance(m_text) + 2 * fieldPadding + 4);
    QRectF box(beside + QPointF(fieldGap, fieldGap), QSizeF(width, metrics.height() + 2 * fieldPadding));
    const QRectF window = painter.window();
    if (box.right() > window.right())
        box.moveRight(beside.x() - fieldGap);
    if (box.bottom() > window.bottom())
        box.moveBottom(beside.y() - fieldGap);
    painter.setPen(QPen(good ? colors.accent : colors.error, 1.6));
    painter.setBrush(colors.pointFill);
    painter.drawRoundedRect(box, 3, 3);
    const QRectF inside = box.adjusted(fieldPadding, fieldPadding, -fieldPadding, -fieldPadding);
    painter.setPen(good ? colors.label : colors.error);
    painter.drawText(inside, Qt::AlignLeft | Qt::AlignVCenter, m_text);
    const double caret = inside.left() + metrics.horizontalAdvance(m_text) + 1.5;
    painter.setPen(QPen(colors.label, 1));
    painter.drawLine(QPointF(caret, inside.top()), QPointF(caret, inside.bottom()));
}

} // namespace bolster
