#include "SavedViews.h"

#include <QFileInfo>
#include <QSettings>

#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

const QString group = QStringLiteral("saved-views");
const QString lastViewsKey = QStringLiteral("last-views"); // lines of a view's numbers and its file, newest first
constexpr qsizetype mostLastViews = 50;
constexpr qsizetype numberCount = 8; // of a view

/// Names may have slashes, which would be groups.
QString keyOf(const QString& name)
{
    return group + u'/' + QString::fromLatin1(name.toUtf8().toHex());
}

QStringList numbersOf(const Viewpoint& view)
{
    QStringList numbers;
    for (const double value : {view.target.x(), view.target.y(), view.target.z(), view.distance, view.azimuth,
                               view.elevation, view.fieldOfView, view.perspective ? 1.0 : 0.0})
        numbers << QString::number(value, 'g', 17);
    return numbers;
}

/// Nothing when they make no sense.
std::optional<Viewpoint> viewOf(const QStringList& numbers)
{
    if (numbers.size() != numberCount)
        return std::nullopt;
    std::array<double, numberCount> values{};
    for (qsizetype i = 0; i < numbers.size(); ++i) {
        bool ok = false;
        values[static_cast<std::size_t>(i)] = numbers[i].toDouble(&ok);
        if (!ok || !std::isfinite(values[static_cast<std::size_t>(i)]))
            return std::nullopt;
    }
    Viewpoint view;
    view.target = {values[0], values[1], values[2]};
    view.distance = values[3];
    view.azimuth = values[4];
    view.elevation = values[5];
    view.fieldOfView = values[6];
    view.perspective = values[7] != 0;
    const bool sensible = view.distance > 0 && view.fieldOfView > 0 && view.fieldOfView < 3 &&
                          std::abs(view.elevation) <= std::numbers::pi / 2 + 1e-9;
    return sensible ? std::optional(view) : std::nullopt;
}

/// Links to a file are the file.
QString placeOf(const QString& file)
{
    return QFileInfo(file).canonicalFilePath();
}

QString fileIn(const QString& line)
{
    return line.section(u' ', numberCount);
}

} // namespace

QStringList SavedViews::names()
{
    QSettings settings;
    settings.beginGroup(group);
    QStringList names;
    for (const QString& key : settings.childKeys())
        names << QString::fromUtf8(QByteArray::fromHex(key.toLatin1()));
    names.sort(Qt::CaseInsensitive);
    return names;
}

std::optional<Viewpoint> SavedViews::find(const QString& name)
{
    return viewOf(QSettings().value(keyOf(name)).toStringList());
}

void SavedViews::save(const QString& name, const Viewpoint& view)
{
    QSettings().setValue(keyOf(name), numbersOf(view));
}

void SavedViews::remove(const QString& name)
{
    QSettings().remove(keyOf(name));
}

std::optional<Viewpoint> SavedViews::lastOf(const QString& file)
{
    const QString place = placeOf(file);
    for (const QString& line : QSettings().value(lastViewsKey).toStringList())
        if (!place.isEmpty() && fileIn(line) == place)
            return viewOf(line.section(u' ', 0, numberCount - 1).split(u' '));
    return std::nullopt;
}

void SavedViews::keepLast(const QString& file, const Viewpoint& view)
{
    const QString place = placeOf(file);
    if (place.isEmpty())
        return;
    QSettings settings;
    QStringList lines = settings.value(lastViewsKey).toStringList();
    lines.removeIf([&](const QString& line) { return fileIn(line) == place; });
    lines.prepend(numbersOf(view).join(u' ') + u' ' + place);
    settings.setValue(lastViewsKey, QStringList(lines.mid(0, mostLastViews)));
}

} // namespace bolster
