#include "FieldText.h"

#include <QCoreApplication>
#include <QJsonArray>
#include <QJsonDocument>
#include <QJsonObject>
#include <QLocale>

#include <map>

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
        {"dilation_mm", QT_TRANSLATE_NOOP("bolster::FieldText", "Thickness")},
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

} // namespace bolster
