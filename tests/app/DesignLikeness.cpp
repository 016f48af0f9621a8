#include "DesignLikeness.h"

#include "DesignJson.h"

#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QMap>
#include <QSet>

#include <cmath>

namespace bolster {

namespace {

/// What refers to other elements.
const QSet<QString> references = {QStringLiteral("id"),    QStringLiteral("fabric"),   QStringLiteral("patch"),
                                  QStringLiteral("curve"), QStringLiteral("frame"),    QStringLiteral("cushion"),
                                  QStringLiteral("of"),    QStringLiteral("follower"), QStringLiteral("original")};

/// What is set by eye.
const QSet<QString> places = {QStringLiteral("points"), QStringLiteral("position")};

constexpr double exact = 1e-6;

class Comparison {
public:
    explicit Comparison(double tolerance)
        : m_tolerance(tolerance)
    {}

    QStringList compare(const Design& design, const Design& expected)
    {
        const QJsonObject a = parsed(design), b = parsed(expected);
        const QJsonArray as = a[QStringLiteral("elements")].toArray(), bs = b[QStringLiteral("elements")].toArray();
        m_a = order(as);
        m_b = order(bs);
        if (as.size() != bs.size())
            m_found << QStringLiteral("%1 elements, not %2").arg(as.size()).arg(bs.size());
        for (qsizetype i = 0; i < std::min(as.size(), bs.size()); ++i)
            values(as[i], bs[i], QStringLiteral("element %1").arg(i + 1), {});
        values(a[QStringLiteral("settings")], b[QStringLiteral("settings")], QStringLiteral("settings"), {});
        return m_found;
    }

private:
    static QJsonObject parsed(const Design& design)
    {
        return QJsonDocument::fromJson(QByteArray::fromStdString(writeDesign(design))).object();
    }
    static QMap<int, int> order(const QJsonArray& elements)
    {
        QMap<int, int> order;
        for (qsizetype i = 0; i < elements.size(); ++i)
            order[elements[i][QStringLiteral("id")].toInt()] = static_cast<int>(i);
        return order;
    }

    void values(const QJsonValue& a, const QJsonValue& b, const QString& where, const QString& key)
    {
        bool same = true;
        if (a.isObject() && b.isObject()) {
            objects(a.toObject(), b.toObject(), where);
        } else if (a.isArray() && b.isArray() && a.toArray().size() == b.toArray().size()) {
            for (qsizetype i = 0; i < a.toArray().size(); ++i)
                values(a.toArray()[i], b.toArray()[i], QStringLiteral("%1[%2]").arg(where).arg(i), key);
        } else if (a.isDouble() && b.isDouble()) {
            same = references.contains(key)
                       ? m_a.value(a.toInt(), -1) == m_b.value(b.toInt(), -1)
                       : std::abs(a.toDouble() - b.toDouble()) <= (places.contains(key) ? m_tolerance : exact);
        } else if (key == QLatin1String("file")) { // wherever it is
            same = a.toString().section(u'/', -1) == b.toString().section(u'/', -1);
        } else {
            same = a == b;
        }
        if (!same)
            m_found << QStringLiteral("%1: %2, not %3").arg(where, text(a), text(b));
    }

    void objects(const QJsonObject& a, const QJsonObject& b, const QString& where)
    {
        QStringList keys = a.keys();
        for (const QString& key : b.keys())
            if (!keys.contains(key))
                keys << key;
        for (const QString& key : keys)
            values(a[key], b[key], where + u' ' + key, key);
    }

    static QString text(const QJsonValue& value)
    {
        return value.isUndefined()
                   ? QStringLiteral("nothing")
                   : QString::fromUtf8(QJsonDocument(QJsonArray{value}).toJson(QJsonDocument::Compact));
    }

    double m_tolerance;
    QMap<int, int> m_a, m_b;
    QStringList m_found;
};

} // namespace

QStringList differences(const Design& design, const Design& expected, double tolerance)
{
    return Comparison(tolerance).compare(design, expected);
}

} // namespace bolster
