// Which page of the manual says what: from places.tsv and warnings.tsv beside its pages.
#pragma once

#include <QHash>
#include <QString>

class QWidget;

namespace bolster {

/// A place is "page.md#heading", or "" where nothing is known.
class ManualPlaces {
public:
    /// Of a folder with the manual; without one nothing is known.
    explicit ManualPlaces(const QString& folder);

    static QString first() { return QStringLiteral("index.md"); }
    /// By the id of a command.
    QString ofCommand(const QString& id) const { return m_places.value(id); }
    /// By the key of a Message, which is its English sentence.
    QString ofMessage(const QString& key) const { return m_messages.value(key); }
    /// What the widget, or what it lies in, is for: by its object's name, which may be the key of a Message, or by
    /// its class.
    QString ofWidget(const QWidget* widget) const;

private:
    QHash<QString, QString> m_places;
    QHash<QString, QString> m_messages;
};

} // namespace bolster
