#include "PreferenceStore.h"

#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>

#include <algorithm>
#include <utility>

namespace bolster {

namespace {

const QString kindKey = QStringLiteral("format");
const QString kindWord = QStringLiteral("bolster-preferences");
const QString settingsKey = QStringLiteral("settings");

ReadPreferences refusedPreferences(const Preferences& now, Message why)
{
    return {now, std::move(why), {}};
}

} // namespace

Preferences storedPreferences()
{
    const QSettings settings;
    Preferences stored;
    for (const PreferenceRow& row : preferenceTable())
        if (const QString key = QString::fromLatin1(row.key); settings.contains(key))
            stored = withValue(stored, row, settings.value(key)).value_or(stored);
    return stored;
}

PreferenceStore::PreferenceStore(QObject* parent)
    : QObject(parent)
    , m_now(storedPreferences())
{}

void PreferenceStore::set(const Preferences& preferences)
{
    if (preferences == m_now)
        return;
    const Preferences before = std::exchange(m_now, preferences), usual;
    QSettings settings;
    for (const PreferenceRow& row : preferenceTable()) {
        const QVariant value = valueOf(m_now, row);
        if (value == valueOf(before, row))
            continue; // another window may have set it meanwhile
        if (value == valueOf(usual, row))
            settings.remove(QString::fromLatin1(row.key));
        else
            settings.setValue(QString::fromLatin1(row.key), value);
    }
    emit changed(before);
}

std::string preferencesText(const Preferences& preferences)
{
    QJsonObject settings;
    for (const PreferenceRow& row : preferenceTable())
        settings.insert(QString::fromLatin1(row.key), QJsonValue::fromVariant(valueOf(preferences, row)));
    return QJsonDocument(QJsonObject{{kindKey, kindWord}, {settingsKey, settings}}).toJson().toStdString();
}

ReadPreferences readPreferences(const std::string& text, const Preferences& now)
{
    QJsonParseError error;
    const QJsonDocument document = QJsonDocument::fromJson(QByteArray::fromStdString(text), &error);
    if (document.isNull())
        return refusedPreferences(
            now, {QT_TRANSLATE_NOOP("Message", "it is no file of preferences: it breaks off or has a mistake at "
                                               "character %1; choose one that Bolster has exported"),
                  {std::to_string(error.offset + 1)}});
    if (document[kindKey].toString() != kindWord || !document[settingsKey].isObject())
        return refusedPreferences(now,
                                  {QT_TRANSLATE_NOOP("Message", "it is no file of preferences; choose one that "
                                                                "Bolster has exported"),
                                   {}});
    ReadPreferences read{now, {}, {}};
    const QJsonObject settings = document[settingsKey].toObject();
    const std::vector<PreferenceRow>& table = preferenceTable();
    for (const QString& key : settings.keys()) {
        const auto row =
            std::ranges::find_if(table, [&](const PreferenceRow& r) { return key == QLatin1String(r.key); });
        if (row == table.end()) {
            read.unknown << key;
            continue;
        }
        const auto with = withValue(read.preferences, *row, settings[key].toVariant());
        if (!with)
            return refusedPreferences(
                now,
                {QT_TRANSLATE_NOOP("Message", "\"%1\" cannot be what it is there; remove that line from the file, "
                                              "or export it again"),
                 {key.toStdString()}});
        read.preferences = *with;
    }
    return read;
}

} // namespace bolster
