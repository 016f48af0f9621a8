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

std::optional<Camera> SavedViews::find(const QString& name)
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
    Camera camera;
    camera.target = {values[0], values[1], values[2]};
    camera.distance = values[3];
    camera.azimuth = values[4];
    camera.elevation = values[5];
    camera.fieldOfView = values[6];
    camera.perspective = values[7] != 0;
    const bool sensible = camera.distance > 0 && camera.fieldOfView > 0 && camera.fieldOfView < 3 &&
                          std::abs(camera.elevation) <= std::numbers::pi / 2 + 1e-9;
    return sensible ? std::optional(camera) : std::nullopt;
}

void SavedViews::save(const QString& name, const Camera& camera)
{
    QStringList numbers;
    for (const double value :
         {camera.target.x(), camera.target.y(), camera.target.z(), camera.distance, camera.azimuth,
          camera.elevation, camera.fieldOfView, camera.perspective ? 1.0 : 0.0})
        numbers << QString::number(value, 'g', 17);
    QSettings().setValue(keyOf(name), numbers);
}

void SavedViews::remove(const QString& name)
{
    QSettings().remove(keyOf(name));
}

} // namespace bolster
