#include "SavedViews.h"

#include <QSettings>

#include <array>
#include <cmath>
#include <numbers>

namespace bolster {

namespace {

const QString group = QStringLiteral("saved-views");

/// Names may have slashes, which would be groups.
QString keyOf(const QString& name)
{
    return group + u'/' + QString::fromLatin1(name.toUtf8().toHex());
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
    const QStringList numbers = QSettings().value(keyOf(name)).toStringList();
    if (numbers.size() != 8)
        return std::nullopt;
    std::array<double, 8> values{};
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

void SavedViews::save(const QString& name, const Viewpoint& view)
{
    QStringList numbers;
    for (const double value : {view.target.x(), view.target.y(), view.target.z(), view.distance, view.azimuth,
                               view.elevation, view.fieldOfView, view.perspective ? 1.0 : 0.0})
        numbers << QString::number(value, 'g', 17);
    QSettings().setValue(keyOf(name), numbers);
}

void SavedViews::remove(const QString& name)
{
    QSettings().remove(keyOf(name));
}

} // namespace bolster
