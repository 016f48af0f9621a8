#include "PreferenceChoices.h"

#include "FabricPresets.h"
#include "KeyPresets.h"
#include "MouseStyle.h"
#include "Theme.h"

#include <QDir>
#include <QLocale>

namespace bolster {

namespace {

struct ChoiceWords {
    Q_DECLARE_TR_FUNCTIONS(Preferences)
};

QString themeId(Theme theme)
{
    return QString::number(static_cast<int>(theme)); // as it has always been kept
}

} // namespace

QList<PreferenceChoice> lengthChoices()
{
    return {{QStringLiteral("mm"), ChoiceWords::tr("Millimetres (314 mm)")},
            {QStringLiteral("cm"), ChoiceWords::tr("Centimetres (31.4 cm)")},
            {QStringLiteral("in"), ChoiceWords::tr("Inches (12 3/8\u2033)")}};
}

QList<PreferenceChoice> fractionChoices()
{
    return {{QStringLiteral("8"), ChoiceWords::tr("Up to 1/8")},
            {QStringLiteral("16"), ChoiceWords::tr("Up to 1/16")},
            {QStringLiteral("32"), ChoiceWords::tr("Up to 1/32")},
            {QStringLiteral("64"), ChoiceWords::tr("Up to 1/64")},
            {QStringLiteral("0"), ChoiceWords::tr("Decimals (12.375)")}};
}

QList<PreferenceChoice> decimalChoices()
{
    return {{QStringLiteral("language"), ChoiceWords::tr("Of the language")},
            {QStringLiteral("comma"), ChoiceWords::tr("Comma (1,5)")},
            {QStringLiteral("point"), ChoiceWords::tr("Point (1.5)")}};
}

QList<PreferenceChoice> languageChoices()
{
    QList<PreferenceChoice> choices{{QString(), ChoiceWords::tr("Of the system")}};
    for (QString file : QDir(QStringLiteral(":/translations")).entryList({QStringLiteral("bolster_*.qm")})) {
        const QString id = file.remove(QStringLiteral("bolster_")).remove(QStringLiteral(".qm"));
        const QLocale locale(id);
        QString name = locale.nativeLanguageName();
        if (id.startsWith(QLatin1String("en"))) // of which the locale has a country, too
            name = QStringLiteral("English");
        choices.append({id, name.left(1).toUpper() + name.mid(1)});
    }
    return choices;
}

QList<PreferenceChoice> themeChoices()
{
    return {{themeId(Theme::System), ChoiceWords::tr("As the system")},
            {themeId(Theme::Light), ChoiceWords::tr("Light")},
            {themeId(Theme::Dark), ChoiceWords::tr("Dark")},
            {themeId(Theme::HighContrast), ChoiceWords::tr("High contrast")}};
}

QList<PreferenceChoice> mouseChoices()
{
    QList<PreferenceChoice> choices;
    for (const MousePreset& preset : mousePresets())
        choices.append({QString::fromLatin1(preset.id), QCoreApplication::translate("MouseStyle", preset.name)});
    return choices;
}

QList<PreferenceChoice> keyChoices()
{
    QList<PreferenceChoice> choices;
    for (const KeyPreset& preset : keyPresets())
        choices.append({QString::fromLatin1(preset.id), QCoreApplication::translate("KeyPresets", preset.name)});
    return choices;
}

QList<PreferenceChoice> drawingChoices()
{
    return {{QStringLiteral("full"), ChoiceWords::tr("Full")},
            {QStringLiteral("reduced"), ChoiceWords::tr("Reduced")}};
}

QList<PreferenceChoice> fabricChoices()
{
    QList<PreferenceChoice> choices{{QString(), ChoiceWords::tr("Plain, as it comes")}};
    const QStringList keys = fabricPresetKeys();
    const std::vector<Fabric> presets = fabricPresets();
    for (qsizetype i = 0; i < keys.size(); ++i)
        choices.append({keys[i], QString::fromStdString(presets[static_cast<std::size_t>(i)].name)});
    return choices;
}

} // namespace bolster
