#include "FieldText.h"

#include "BSpline.h"
#include "ElementText.h"
#include "Units.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <algorithm>
#include <cmath>
#include <limits>
#include <map>
#include <numbers>
#include <set>
#include <vector>

namespace bolster {

namespace {

struct FieldWords {
    Q_DECLARE_TR_FUNCTIONS(bolster::FieldText)
};

constexpr qsizetype longest = 40; // characters of a value

/// "Stitching: twin, Stitch length: 4".
QString objectText(const QJsonObject& object)
{
    QStringList parts;
    for (auto field = object.begin(); field != object.end(); ++field) {
        const QByteArray wrapped = QJsonDocument(QJsonArray{field.value()}).toJson(QJsonDocument::Compact);
        parts << FieldWords::tr("%1: %2").arg(fieldText(field.key().toStdString()),
                                              fieldValueText(wrapped.sliced(1, wrapped.size() - 2).toStdString()));
    }
    return parts.join(QStringLiteral(", "));
}

} // namespace

QString fieldText(const std::string& key)
{
    static const std::map<std::string, const char*> words{
        {"a", QT_TRANSLATE_NOOP("bolster::FieldText", "First stretch")},
        {"across", QT_TRANSLATE_NOOP("bolster::FieldText", "Across the grain")},
        {"allowance_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Seam allowance")},
        {"along", QT_TRANSLATE_NOOP("bolster::FieldText", "Along the grain")},
        {"b", QT_TRANSLATE_NOOP("bolster::FieldText", "Second stretch")},
        {"bending_length", QT_TRANSLATE_NOOP("bolster::FieldText", "Bending length")},
        {"color", QT_TRANSLATE_NOOP("bolster::FieldText", "Colour")},
        {"colourway", QT_TRANSLATE_NOOP("bolster::FieldText", "Colourway shown")},
        {"continuity", QT_TRANSLATE_NOOP("bolster::FieldText", "Continuity")},
        {"curve", QT_TRANSLATE_NOOP("bolster::FieldText", "Curve")},
        {"depth", QT_TRANSLATE_NOOP("bolster::FieldText", "Depth")},
        {"dilation_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Padding")},
        {"distance", QT_TRANSLATE_NOOP("bolster::FieldText", "Slanted faces")},
        {"edge_length", QT_TRANSLATE_NOOP("bolster::FieldText", "Mesh edges")},
        {"enabled", QT_TRANSLATE_NOOP("bolster::FieldText", "Switched on")},
        {"fabric", QT_TRANSLATE_NOOP("bolster::FieldText", "Fabric")},
        {"fabrics", QT_TRANSLATE_NOOP("bolster::FieldText", "Fabrics")},
        {"file", QT_TRANSLATE_NOOP("bolster::FieldText", "File")},
        {"from", QT_TRANSLATE_NOOP("bolster::FieldText", "Begins at")},
        {"grain", QT_TRANSLATE_NOOP("bolster::FieldText", "Grain")},
        {"kind", QT_TRANSLATE_NOOP("bolster::FieldText", "Kind")},
        {"limits", QT_TRANSLATE_NOOP("bolster::FieldText", "Strain limits")},
        {"look", QT_TRANSLATE_NOOP("bolster::FieldText", "Look")},
        {"match", QT_TRANSLATE_NOOP("bolster::FieldText", "Match")},
        {"name", QT_TRANSLATE_NOOP("bolster::FieldText", "Name")},
        {"outline", QT_TRANSLATE_NOOP("bolster::FieldText", "Outline")},
        {"parts", QT_TRANSLATE_NOOP("bolster::FieldText", "Padded parts")},
        {"piping_fabric", QT_TRANSLATE_NOOP("bolster::FieldText", "Piping fabric")},
        {"piping_radius_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Piping radius")},
        {"poisson", QT_TRANSLATE_NOOP("bolster::FieldText", "Poisson parameter")},
        {"position", QT_TRANSLATE_NOOP("bolster::FieldText", "Position")},
        {"pressure", QT_TRANSLATE_NOOP("bolster::FieldText", "Pressure")},
        {"profile", QT_TRANSLATE_NOOP("bolster::FieldText", "Profile")},
        {"relief", QT_TRANSLATE_NOOP("bolster::FieldText", "Relief")},
        {"reversed", QT_TRANSLATE_NOOP("bolster::FieldText", "Runs backwards")},
        {"rotation", QT_TRANSLATE_NOOP("bolster::FieldText", "Rotation")},
        {"roughness", QT_TRANSLATE_NOOP("bolster::FieldText", "Roughness")},
        {"scale", QT_TRANSLATE_NOOP("bolster::FieldText", "Scale")},
        {"scale_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Scale")},
        {"second_color", QT_TRANSLATE_NOOP("bolster::FieldText", "Second colour")},
        {"shear", QT_TRANSLATE_NOOP("bolster::FieldText", "Shear")},
        {"size", QT_TRANSLATE_NOOP("bolster::FieldText", "Size")},
        {"stiffness", QT_TRANSLATE_NOOP("bolster::FieldText", "Stiffness")},
        {"stitch", QT_TRANSLATE_NOOP("bolster::FieldText", "Stitching")},
        {"stitch_distance_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Stitch distance")},
        {"stitch_length_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Stitch length")},
        {"strength", QT_TRANSLATE_NOOP("bolster::FieldText", "Strength")},
        {"symmetry", QT_TRANSLATE_NOOP("bolster::FieldText", "Symmetry")},
        {"target", QT_TRANSLATE_NOOP("bolster::FieldText", "Curve in space")},
        {"thread", QT_TRANSLATE_NOOP("bolster::FieldText", "Thread colour")},
        {"thread_width_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Thread width")},
        {"to", QT_TRANSLATE_NOOP("bolster::FieldText", "Ends at")},
        {"trim", QT_TRANSLATE_NOOP("bolster::FieldText", "Trim")},
        {"twin", QT_TRANSLATE_NOOP("bolster::FieldText", "Mirror twin")},
        {"valley", QT_TRANSLATE_NOOP("bolster::FieldText", "Valley")},
        {"voxel_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Smallest detail")},
        {"width", QT_TRANSLATE_NOOP("bolster::FieldText", "Width")},
        {"wrong_side_out", QT_TRANSLATE_NOOP("bolster::FieldText", "Wrong side out")},
    };
    const auto found = words.find(key);
    return found != words.end() ? FieldWords::tr(found->second) : QString::fromStdString(key).replace(u'_', u' ');
}

QString fieldValueText(const std::string& json)
{
    if (json.empty())
        return FieldWords::tr("usual");
    const QJsonDocument wrapped = QJsonDocument::fromJson("[" + QByteArray::fromStdString(json) + "]");
    const QJsonValue value = wrapped.array().at(0);
    if (value.isDouble())
        return QLocale().toString(value.toDouble(), 'g', 6);
    if (value.isString())
        return value.toString();
    if (value.isBool())
        return value.toBool() ? FieldWords::tr("yes") : FieldWords::tr("no");
    if (const QJsonArray points = value[QStringLiteral("points")].toArray(); !points.isEmpty())
        return FieldWords::tr("%n points", nullptr, static_cast<int>(points.size()));
    if (value.isObject()) // a part of an element: what differs from the usual
        return objectText(value.toObject());
    const QString text = QString::fromStdString(json);
    return text.size() > longest ? text.left(longest - 1) + u'\u2026' : text;
}

namespace {

const std::set<std::string> keysOfElements{"colourway", "curve", "cushion", "fabric",       "frame",
                                           "of",        "patch", "patches", "piping_fabric"};
const std::set<std::string> keysOfLengths{"bending_length", "contact_gap", "depth", "edge_length",
                                          "position",       "size",        "width"};
const std::set<std::string> keysOfAngles{"grain", "rotation"};

class ValueWords {
public:
    ValueWords(const Design& design, std::string key)
        : m_design(design)
        , m_key(std::move(key))
        , m_length(keysOfLengths.contains(m_key) || m_key.ends_with("_mm"))
    {}

    QString text(const QJsonValue& value) const
    {
        if (value.isDouble())
            return numberText(value.toDouble());
        if (value.isString() && m_key == "distance")
            return value.toString() == QLatin1String("euclidean") ? FieldWords::tr("press like straight ones")
                                                                  : FieldWords::tr("press harder");
        if (value.isString())
            return value.toString().replace(u'_', u' ');
        if (value.isBool())
            return value.toBool() ? FieldWords::tr("yes") : FieldWords::tr("no");
        return value.isArray() ? listText(value.toArray()) : objectText(value.toObject());
    }

private:
    QString numberText(double number) const
    {
        if (keysOfElements.contains(m_key))
            return displayName(m_design, static_cast<ElementId>(static_cast<int>(number)));
        if (keysOfAngles.contains(m_key))
            return angleText(number);
        return m_length ? lengthText(number, 2) : QLocale().toString(number, 'g', 4);
    }

    QString listText(const QJsonArray& values) const
    {
        if (m_key == "rotation" && values.size() == 4) // a quaternion, w first
            return FieldWords::tr("turned by %1").arg(angleText(turn(values.at(0).toDouble())));
        QStringList parts;
        for (const QJsonValue& value : values)
            parts << (m_length && value.isDouble() ? decimalText(value.toDouble(), 2, false) : text(value));
        const QString all = parts.join(QStringLiteral(", "));
        return m_length ? FieldWords::tr("%1 mm").arg(all) : all;
    }

    static double turn(double w) { return 360 / std::numbers::pi * std::acos(std::clamp(std::abs(w), 0.0, 1.0)); }

    template <int Dim>
    static BSpline<Dim> curveOf(const QJsonObject& object)
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
    static QString curveText(const QJsonObject& object)
    {
        const BSpline<Dim> curve = curveOf<Dim>(object);
        const typename BSpline<Dim>::Point size = curve.boundingBox().sizes();
        QStringList sizes;
        for (int axis = 0; axis < Dim; ++axis)
            sizes << decimalText(size[axis], 1, false);
        return FieldWords::tr("%n points, %1 mm", nullptr, curve.pointCount())
            .arg(sizes.join(QStringLiteral(" \u00d7 ")));
    }

    QString objectText(const QJsonObject& object) const
    {
        if (const QJsonArray points = object[QStringLiteral("points")].toArray(); !points.isEmpty())
            return points.first().toArray().size() == 3 ? curveText<3>(object) : curveText<2>(object);
        const auto part = [&](const char* key) {
            return ValueWords(m_design, key).text(object[QLatin1String(key)]);
        };
        if (object.contains(QLatin1String("patch")) && object.contains(QLatin1String("from")))
            return FieldWords::tr("%1, from %2 to %3").arg(part("patch"), part("from"), part("to"));
        if (object.contains(QLatin1String("patch")) && object.contains(QLatin1String("fabric")))
            return FieldWords::tr("%1: %2").arg(part("patch"), part("fabric"));
        QStringList parts;
        for (auto field = object.begin(); field != object.end(); ++field) {
            const std::string key = field.key().toStdString();
            parts << FieldWords::tr("%1: %2").arg(fieldText(key), ValueWords(m_design, key).text(field.value()));
        }
        return parts.join(QStringLiteral(", "));
    }

    const Design& m_design;
    std::string m_key;
    bool m_length;
};

} // namespace

QString fieldValueText(const Design& design, const std::string& key, const std::string& json)
{
    if (json.empty())
        return key == "colourway" ? FieldWords::tr("as made")
               : key == "twin"    ? FieldWords::tr("none")
                                  : FieldWords::tr("usual");
    const QJsonDocument wrapped = QJsonDocument::fromJson("[" + QByteArray::fromStdString(json) + "]");
    const QString text = ValueWords(design, key).text(wrapped.array().at(0));
    constexpr qsizetype most = 80; // characters
    return text.size() > most ? text.left(most - 1) + u'\u2026' : text;
}

} // namespace bolster
