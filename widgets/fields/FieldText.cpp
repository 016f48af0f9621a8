#include "FieldText.h"

#include "DescribedField.h"
#include "ElementText.h"
#include "LengthFigures.h"
#include "Units.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

namespace bolster {

namespace {

struct FieldWords {
    Q_DECLARE_TR_FUNCTIONS(bolster::FieldText)
};

template <int Dim>
BSpline<Dim> jsonCurve(const QJsonObject& object)
{
    std::vector<typename BSpline<Dim>::Point> points;
    for (const QJsonValue& value : object[QStringLiteral("points")].toArray())
        for (int axis = (points.emplace_back(), 0); axis < Dim; ++axis)
            points.back()[axis] = value.toArray().at(axis).toDouble();
    std::vector<int> corners;
    for (const QJsonValue& corner : object[QStringLiteral("corners")].toArray())
        corners.push_back(corner.toInt());
    std::vector<double> knots;
    for (const QJsonValue& knot : object[QStringLiteral("knots")].toArray())
        knots.push_back(knot.toDouble());
    return corners.empty() ? BSpline<Dim>(object[QStringLiteral("degree")].toInt(1),
                                          object[QStringLiteral("closed")].toBool(), points, knots)
                           : BSpline<Dim>::withCorners(points, corners);
}

/// What a curve looks like: how many points, and how large it is, which its control points say too much of.
template <int Dim>
QString jsonCurveText(const QJsonObject& object)
{
    const BSpline<Dim> curve = jsonCurve<Dim>(object);
    const typename BSpline<Dim>::Point size = curve.boundingBox().sizes();
    const QStringList sizes = lengthFigures(std::vector<double>(size.begin(), size.end()), 1);
    return FieldWords::tr("%n points, %1", nullptr, curve.pointCount())
        .arg(sizes.join(QStringLiteral(" \u00d7 ")) + lengthSuffix());
}

QString turnText(const QJsonArray& quaternion)
{
    const double cosine = std::clamp(std::abs(quaternion.at(0).toDouble()), 0.0, 1.0); // w first
    return FieldWords::tr("turned by %1").arg(angleText(360 / std::numbers::pi * std::acos(cosine)));
}

QString numberText(double number, Unit unit)
{
    if (unit == Unit::Millimetres)
        return lengthText(number, 2);
    return unit == Unit::Degrees ? angleText(number) : numberLocale().toString(number, 'g', 4) + unitSuffix(unit);
}

QString joinedNumbers(const QJsonArray& numbers, Unit unit)
{
    std::vector<double> values;
    QStringList parts;
    for (const QJsonValue& number : numbers) {
        values.push_back(number.toDouble());
        parts << numberLocale().toString(values.back(), 'g', 4);
    }
    if (unit == Unit::Millimetres)
        parts = lengthFigures(values, 2);
    return parts.join(QStringLiteral(", ")) + (unit == Unit::Millimetres ? lengthSuffix() : unitSuffix(unit));
}

/// What no description says more of.
QString plainText(const QJsonValue& value)
{
    if (value.isDouble())
        return numberText(value.toDouble(), Unit::None);
    if (value.isString())
        return value.toString();
    if (value.isBool())
        return value.toBool() ? FieldWords::tr("yes") : FieldWords::tr("no");
    if (value.isObject())
        return QString::fromUtf8(QJsonDocument(value.toObject()).toJson(QJsonDocument::Compact));
    QStringList parts;
    for (const QJsonValue& entry : value.toArray())
        parts << plainText(entry);
    return parts.join(QStringLiteral(", "));
}

/// Finds the field of a key among those that it walks over, and says a value of it.
class JsonValueText {
public:
    JsonValueText(const Design& design, const QString& key, const QJsonValue& value)
        : m_design(design)
        , m_key(key)
        , m_value(value)
        , m_label(QString(key).replace(u'_', u' '))
        , m_text(value.isNull() ? FieldWords::tr("usual") : plainText(value))
    {}

    const QString& label() const { return m_label; }
    const QString& text() const { return m_text; }

    /// Of all its members; those of a stretch, and of what has a patch and a fabric, have phrases of their own.
    template <class T>
    static QString partText(const Design& design, const QJsonObject& object)
    {
        const auto member = [&](const QString& key) {
            JsonValueText inner(design, key, object[key]);
            inner.part({}, T{});
            return inner;
        };
        const auto valueOf = [&](const char* key) { return member(QString::fromLatin1(key)).text(); };
        if constexpr (std::is_same_v<T, Stretch>)
            return FieldWords::tr("%1, from %2 to %3").arg(valueOf("patch"), valueOf("from"), valueOf("to"));
        if constexpr (std::is_same_v<T, Colourway::Entry>)
            return FieldWords::tr("%1: %2").arg(valueOf("patch"), valueOf("fabric"));
        QStringList parts;
        for (const QString& key : object.keys()) {
            const JsonValueText said = member(key);
            parts << FieldWords::tr("%1: %2").arg(said.label(), said.text());
        }
        return parts.join(QStringLiteral(", "));
    }

    template <class Form, class Value>
    void field(const Field& f, const Form& form, const Value& usual)
    {
        if (isIt(f))
            m_text = m_value.isNull() ? usualText(f, form, usual) : valueText(form, Value{});
    }
    template <class T>
    void group(const Field& f, const T&)
    {
        if (isIt(f))
            m_text = m_value.isNull() ? withoutText(f) : partText<T>(m_design, m_value.toObject());
    }
    template <class T>
    void group(const Field& f, const std::optional<T>&)
    {
        group(f, T{});
    }
    template <class T>
    void part(const Field&, const T& value)
    {
        Description<T>::of(*this, value);
    }
    template <class Walk>
    void within(const Field& f, Walk walk)
    {
        if (!isIt(f))
            return;
        QStringList parts;
        const QJsonObject object = m_value.toObject();
        for (const QString& key : object.keys()) {
            JsonValueText inner(m_design, key, object[key]);
            walk(inner);
            parts << FieldWords::tr("%1: %2").arg(inner.label(), inner.text());
        }
        m_text = parts.join(QStringLiteral(", "));
    }
    template <class T>
    void list(const Field& f, const Entries&, const std::vector<T>&)
    {
        if (!isIt(f))
            return;
        QStringList parts;
        for (const QJsonValue& entry : m_value.toArray())
            parts << partText<T>(m_design, entry.toObject());
        m_text = m_value.isNull() ? withoutText(f) : parts.join(QStringLiteral(", "));
    }
    template <class T>
    void usual(const T&)
    {}

private:
    bool isIt(const Field& f)
    {
        if (m_key != QLatin1String(f.key))
            return false;
        if (const char* label = *f.alone ? f.alone : f.label; *label)
            m_label = QCoreApplication::translate("Field", label);
        return true;
    }
    static QString withoutText(const Field& f)
    {
        return *f.without ? QCoreApplication::translate("Field", f.without) : FieldWords::tr("usual");
    }

    /// What is not in the text is as it usually is, which is a value as any other.
    template <class Form, class Value>
    QString usualText(const Field& f, const Form& form, const Value& usual)
    {
        if constexpr (std::is_same_v<Form, Words>) {
            if (const auto word = static_cast<std::size_t>(usual); !*f.without && word < form.labels.size())
                return QCoreApplication::translate("Field", form.labels[word]);
        } else if constexpr (std::is_arithmetic_v<Value>) {
            if (!*f.without) {
                m_value = usual;
                return valueText(form, usual);
            }
        }
        return withoutText(f);
    }

    template <class Form, class Value>
    QString valueText(const Form&, const Value&) const
    {
        return plainText(m_value);
    }
    template <class Value>
    QString valueText(const Number& form, const Value&) const
    {
        return numberText(m_value.toDouble(), form.unit);
    }
    template <class Value>
    QString valueText(const Coordinates& form, const Value&) const
    {
        return joinedNumbers(m_value.toArray(), form.unit);
    }
    template <class Value>
    QString valueText(const Turn&, const Value&) const
    {
        return turnText(m_value.toArray());
    }
    template <int Dim>
    QString valueText(const Curve&, const BSpline<Dim>&) const
    {
        return jsonCurveText<Dim>(m_value.toObject());
    }
    template <class Value>
    QString valueText(const Words& words, const Value&) const
    {
        const std::string key = m_value.toString().toStdString();
        for (std::size_t i = 0; i < words.keys.size(); ++i)
            if (key == words.keys[i])
                return QCoreApplication::translate("Field", words.labels[i]);
        return plainText(m_value);
    }
    template <class T, class Value>
    QString valueText(const Refers<T>&, const Value&) const
    {
        QStringList names;
        for (const QJsonValue& id : m_value.isArray() ? m_value.toArray() : QJsonArray{m_value})
            names << displayName(m_design, static_cast<ElementId>(id.toInt()));
        return names.join(QStringLiteral(", "));
    }

    const Design& m_design;
    QString m_key;
    QJsonValue m_value;
    QString m_label;
    QString m_text;
};

JsonValueText textOfField(const Design& design, const Element& element, const std::string& key,
                          const QJsonValue& value)
{
    JsonValueText text(design, QString::fromStdString(key), value);
    std::visit([&]<class T>(const T&) { text.part({}, T{}); }, element);
    return text;
}

} // namespace

QString fieldText(const Element& element, const std::string& key)
{
    return textOfField(Design(), element, key, {}).label();
}

QString fieldValueText(const Design& design, const Element& element, const std::string& key,
                       const std::string& json)
{
    const QJsonArray wrapped = QJsonDocument::fromJson("[" + QByteArray::fromStdString(json) + "]").array();
    const QString text = textOfField(design, element, key, wrapped.isEmpty() ? QJsonValue() : wrapped.at(0)).text();
    constexpr qsizetype most = 80; // characters
    return text.size() > most ? text.left(most - 1) + u'\u2026' : text;
}

} // namespace bolster
