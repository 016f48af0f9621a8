#include "FeelScript.h"

#include <array>

namespace bolster {

namespace {

const std::array<QString, 6> words = {QStringLiteral("gesture"), QStringLiteral("press"), QStringLiteral("move"),
                                      QStringLiteral("release"), QStringLiteral("wheel"), QStringLiteral("key")};

} // namespace

QString FeelEvent::line() const
{
    const QString& word = words[static_cast<std::size_t>(kind)];
    if (kind == Kind::Gesture)
        return QStringLiteral("%1 %2").arg(word, text);
    if (kind == Kind::Key)
        return QStringLiteral("%1 %2 %3").arg(word, widget, text);
    QString result = QStringLiteral("%1 %2 %3 %4").arg(word, widget).arg(at.x(), 0, 'f', 5).arg(at.y(), 0, 'f', 5);
    if (kind == Kind::Wheel)
        result += QStringLiteral(" %1").arg(steps);
    else if (button == Qt::MiddleButton)
        result += QStringLiteral(" middle");
    return result;
}

std::optional<FeelEvent> FeelEvent::read(const QString& line)
{
    const QStringList parts = line.section(u'#', 0, 0).split(u' ', Qt::SkipEmptyParts);
    const auto word = parts.isEmpty() ? words.end() : std::find(words.begin(), words.end(), parts[0]);
    if (word == words.end() || parts.size() < 2)
        return std::nullopt;
    FeelEvent event;
    event.kind = static_cast<Kind>(word - words.begin());
    if (event.kind == Kind::Gesture) {
        event.text = parts[1];
        return event;
    }
    event.widget = parts[1];
    if (event.kind == Kind::Key) {
        event.text = parts.value(2);
        return event;
    }
    event.at = {parts.value(2).toDouble(), parts.value(3).toDouble()};
    if (event.kind == Kind::Wheel)
        event.steps = parts.value(4).toDouble();
    else if (parts.value(4) == QLatin1String("middle"))
        event.button = Qt::MiddleButton;
    return event;
}

} // namespace bolster
