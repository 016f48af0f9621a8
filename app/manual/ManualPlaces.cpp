#include "ManualPlaces.h"

#include <QDir>
#include <QFile>
#include <QWidget>

namespace bolster {

namespace {

QHash<QString, QString> readTable(const QString& path)
{
    QHash<QString, QString> table;
    QFile file(path);
    if (!file.open(QIODevice::ReadOnly))
        return table;
    for (const QString& line : QString::fromUtf8(file.readAll()).split(u'\n')) {
        const qsizetype tab = line.lastIndexOf(u'\t');
        if (tab > 0 && !line.startsWith(u'#'))
            table.insert(line.left(tab), line.mid(tab + 1));
    }
    return table;
}

} // namespace

ManualPlaces::ManualPlaces(const QString& folder)
    : m_places(readTable(QDir(folder).filePath(QStringLiteral("places.tsv"))))
    , m_messages(readTable(QDir(folder).filePath(QStringLiteral("warnings.tsv"))))
{}

QString ManualPlaces::ofWidget(const QWidget* widget) const
{
    for (; widget; widget = widget->parentWidget()) {
        if (const QString name = widget->objectName(); !name.isEmpty())
            for (const auto* table : {&m_places, &m_messages})
                if (const QString place = table->value(name); !place.isEmpty())
                    return place;
        for (const QMetaObject* kind = widget->metaObject(); kind; kind = kind->superClass())
            if (const QString place =
                    m_places.value(QString::fromLatin1(kind->className()).section(QStringLiteral("::"), -1));
                !place.isEmpty())
                return place;
    }
    return {};
}

} // namespace bolster
