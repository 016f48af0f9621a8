#include "PreferenceStore.h"

#include <QDir>
#include <QFileInfo>
#include <QJsonDocument>
#include <QJsonObject>
#include <QSettings>
#include <QStorageInfo>

#include <nlohmann/json.hpp>

#include <algorithm>
#include <optional>
#include <set>
#include <utility>

namespace bolster {

namespace {

const QString kindKey = QStringLiteral("format");
const QString kindWord = QStringLiteral("bolster-preferences");
const QString settingsKey = QStringLiteral("settings");
constexpr qint64 roomForSettings = 64 * 1024; // bytes; they are written beside the old ones

ReadPreferences refusedPreferences(const Preferences& now, Message why)
{
    return {now, std::move(why), {}, {}};
}

/// Qt says only that it was not possible.
Message whyNotKept(const QString& file)
{
    const QFileInfo folder(QFileInfo(file).absolutePath());
    const std::string at = QDir::toNativeSeparators(file).toStdString();
    if (folder.exists() && QStorageInfo(folder.filePath()).bytesAvailable() < roomForSettings)
        return {QT_TRANSLATE_NOOP("Message", "the disk with \"%1\" is full; make room on it, and change a setting "
                                             "once more: all of them are kept then"),
                {at}};
    return {QT_TRANSLATE_NOOP("Message",
                              "\"%1\" could not be written; give yourself the right to write there and in "
                              "its folder, and change a setting once more: all of them are kept then"),
            {at}};
}

/// In the object "settings", as written: of keys that occur twice the parser knows the last one only.
std::optional<std::string> givenTwice(const std::string& text)
{
    std::set<std::string> seen;
    std::optional<std::string> twice;
    std::string part;
    const auto look = [&](int depth, nlohmann::json::parse_event_t event, const nlohmann::json& parsed) {
        if (event != nlohmann::json::parse_event_t::key)
            return true;
        const auto key = parsed.get<std::string>();
        if (depth == 1)
            part = key;
        if (depth <= 2 && !seen.insert(depth == 1 ? key : part + '\n' + key).second && !twice)
            twice = key;
        return true;
    };
    const nlohmann::json read = nlohmann::json::parse(text, look, false);
    return read.is_discarded() ? std::nullopt : twice;
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
    , m_atStart(m_now)
{}

void PreferenceStore::set(const Preferences& preferences)
{
    if (preferences == m_now)
        return;
    const Preferences before = std::exchange(m_now, preferences);
    keep(before);
    emit changed(before);
}

void PreferenceStore::keep(const Preferences& before)
{
    const Preferences usual;
    QSettings settings;
    for (const PreferenceRow& row : preferenceTable()) {
        const QVariant value = valueOf(m_now, row);
        if (value == valueOf(before, row) && !m_notKept)
            continue; // another window may have set it meanwhile
        if (value == valueOf(usual, row))
            settings.remove(QString::fromLatin1(row.key));
        else
            settings.setValue(QString::fromLatin1(row.key), value);
    }
    settings.sync();
    const bool failed = settings.status() != QSettings::NoError;
    if (failed && !m_notKept)
        emit notKept(whyNotKept(settings.fileName()));
    m_notKept = failed;
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
    if (const std::optional<std::string> key = givenTwice(text))
        return refusedPreferences(now, {QT_TRANSLATE_NOOP("Message", "\"%1\" stands there twice; remove one of its "
                                                                     "lines from the file, or export it again"),
                                        {*key}});
    ReadPreferences read{now, {}, {}, {}};
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
        const QString folder = valueOf(*with, *row).toString();
        if (std::holds_alternative<FolderName>(row->form) && !folder.isEmpty() && !QFileInfo(folder).isDir())
            read.noFolder << folder;
        else
            read.preferences = *with;
    }
    return read;
}

} // namespace bolster
