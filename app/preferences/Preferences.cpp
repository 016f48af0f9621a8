#include "Preferences.h"

#include "AllowanceFields.h"
#include "PreferenceChoices.h"

#include <algorithm>
#include <cmath>

namespace bolster {

namespace {

struct PreferenceWords {
    Q_DECLARE_TR_FUNCTIONS(Preferences)
};

// As settings keep numbers: text, too.
std::optional<QString> valid(const OneOf& form, const QVariant& value, QString)
{
    const QString id = value.toString();
    const QList<PreferenceChoice> choices = form.choices();
    const auto same = [&](const PreferenceChoice& choice) { return choice.id == id; };
    return std::ranges::any_of(choices, same) ? std::optional(id) : std::nullopt;
}

std::optional<QString> valid(const FolderName&, const QVariant& value, QString)
{
    return value.typeId() == QMetaType::QString ? std::optional(value.toString()) : std::nullopt;
}

std::optional<bool> valid(const OnOff&, const QVariant& value, bool)
{
    const QString text = value.toString();
    if (text != QLatin1String("true") && text != QLatin1String("false"))
        return std::nullopt;
    return value.toBool();
}

std::optional<int> valid(const WholeNumber& form, const QVariant& value, int)
{
    bool good = false;
    const double number = value.toDouble(&good);
    if (!good || number != std::round(number) || number < form.least || number > form.most)
        return std::nullopt;
    return static_cast<int>(number);
}

std::optional<double> valid(const LengthNumber& form, const QVariant& value, double)
{
    bool good = false;
    const double number = value.toDouble(&good);
    return good && number >= form.least && number <= form.most ? std::optional(number) : std::nullopt;
}

/// The table gives no member a form for another type.
template <class Form, class Value>
std::optional<Value> valid(const Form&, const QVariant&, Value)
{
    return std::nullopt;
}

QStringList wordsOf(const PreferenceRow& row)
{
    QStringList words{row.labelText(), PreferenceWords::tr(row.words), row.noteText(), pageTitle(row.page)};
    if (const auto* form = std::get_if<OneOf>(&row.form))
        for (const PreferenceChoice& choice : form->choices())
            words << choice.label;
    return words;
}

} // namespace

QString pageTitle(PreferencePage page)
{
    switch (page) {
    case PreferencePage::Units:
        return PreferenceWords::tr("Units and numbers");
    case PreferencePage::Looks:
        return PreferenceWords::tr("Language and looks");
    case PreferencePage::Mouse:
        return PreferenceWords::tr("Mouse");
    case PreferencePage::Keys:
        return PreferenceWords::tr("Keyboard");
    case PreferencePage::Pattern:
        return PreferenceWords::tr("Pattern view");
    case PreferencePage::Drawing:
        return PreferenceWords::tr("3D view");
    case PreferencePage::Work:
        return PreferenceWords::tr("Unsaved work");
    case PreferencePage::Designs:
        return PreferenceWords::tr("New designs");
    }
    return {};
}

const std::vector<PreferenceRow>& preferenceTable()
{
    using P = Preferences;
    using Page = PreferencePage;
    static const std::vector<PreferenceRow> table{
        {"units/length", Page::Units, &P::length, OneOf{&lengthChoices},
         QT_TRANSLATE_NOOP("Preferences", "Lengths in"),
         QT_TRANSLATE_NOOP("Preferences", "unit measure metric imperial millimetre centimetre inch"),
         QT_TRANSLATE_NOOP("Preferences", "How lengths are shown. Whatever it is, you may type others: 3 in, "
                                          "2.5 cm, 1' 2 3/8\". Designs keep millimetres, and so do printed "
                                          "sheets and files.")},
        {"units/inch-fraction", Page::Units, &P::fraction, OneOf{&fractionChoices},
         QT_TRANSLATE_NOOP("Preferences", "Parts of an inch"),
         QT_TRANSLATE_NOOP("Preferences", "fraction imperial 1/16 decimals"),
         QT_TRANSLATE_NOOP("Preferences",
                           "Lengths are kept as they are, and shown to the nearest part; what is shorter than "
                           "one has decimals.")},
        {"units/decimal", Page::Units, &P::decimal, OneOf{&decimalChoices},
         QT_TRANSLATE_NOOP("Preferences", "Decimal sign"),
         QT_TRANSLATE_NOOP("Preferences", "comma point dot separator numbers")},
        {"language", Page::Looks, &P::language, OneOf{&languageChoices},
         QT_TRANSLATE_NOOP("Preferences", "Language"),
         QT_TRANSLATE_NOOP("Preferences", "translation words english german deutsch"),
         QT_TRANSLATE_NOOP("Preferences", "Bolster speaks it when it is started the next time."), true},
        {"window/theme", Page::Looks, &P::theme, OneOf{&themeChoices}, QT_TRANSLATE_NOOP("Preferences", "Theme"),
         QT_TRANSLATE_NOOP("Preferences", "colours dark light contrast night appearance accessibility")},
        {"window/font-percent", Page::Looks, &P::fontPercent,
         WholeNumber{80, 200, 10, QT_TRANSLATE_NOOP("Preferences", " %")},
         QT_TRANSLATE_NOOP("Preferences", "Size of the letters"),
         QT_TRANSLATE_NOOP("Preferences", "font text large small zoom scale accessibility")},
        {"mouse/preset", Page::Mouse, &P::mouse, OneOf{&mouseChoices},
         QT_TRANSLATE_NOOP("Preferences", "Move the views as in"),
         QT_TRANSLATE_NOOP("Preferences", "navigation rotate turn pan zoom buttons trackpad orbit preset")},
        {"mouse/invert-zoom", Page::Mouse, &P::invertZoom, OnOff{},
         QT_TRANSLATE_NOOP("Preferences", "Zoom the other way round"),
         QT_TRANSLATE_NOOP("Preferences", "invert wheel scroll reverse direction")},
        {"keys/preset", Page::Keys, &P::keys, OneOf{&keyChoices}, QT_TRANSLATE_NOOP("Preferences", "Keys as in"),
         QT_TRANSLATE_NOOP("Preferences", "shortcuts hotkeys preset"),
         QT_TRANSLATE_NOOP("Preferences",
                           "Some commands get the keys that you know from there. Keys that you have chosen "
                           "yourself stay.")},
        {"drawing/snapping", Page::Pattern, &P::snapping, OnOff{},
         QT_TRANSLATE_NOOP("Preferences", "Snap to points, edges, guides and the grid"),
         QT_TRANSLATE_NOOP("Preferences", "magnet catch align"),
         QT_TRANSLATE_NOOP("Preferences", "Ctrl or Alt lets go while you drag.")},
        {"drawing/rulers", Page::Pattern, &P::rulers, OnOff{}, QT_TRANSLATE_NOOP("Preferences", "Show rulers"),
         QT_TRANSLATE_NOOP("Preferences", "scale measure")},
        {"drawing/guides", Page::Pattern, &P::guides, OnOff{}, QT_TRANSLATE_NOOP("Preferences", "Show guides"),
         QT_TRANSLATE_NOOP("Preferences", "lines help")},
        {"view/drawing", Page::Drawing, &P::drawing, OneOf{&drawingChoices},
         QT_TRANSLATE_NOOP("Preferences", "Quality of the picture"),
         QT_TRANSLATE_NOOP("Preferences", "performance slow fast remote desktop graphics opengl"),
         QT_TRANSLATE_NOOP("Preferences",
                           "Reduced: fewer pixels and triangles, no soft shadows. For slow machines and "
                           "for screens that are far away. Pictures that you export stay fine.")},
        {"view/reduced-motion", Page::Drawing, &P::reducedMotion, OnOff{},
         QT_TRANSLATE_NOOP("Preferences", "Go to other views at once, without a flight"),
         QT_TRANSLATE_NOOP("Preferences", "reduced motion animation camera accessibility remote")},
        {"work/days-in-bin", Page::Work, &P::daysInBin,
         WholeNumber{30, 3650, 30, QT_TRANSLATE_NOOP("Preferences", " days")},
         QT_TRANSLATE_NOOP("Preferences", "Keep work that was thrown away for"),
         QT_TRANSLATE_NOOP("Preferences", "autosave backup recovery crash journal bin unsaved delete"),
         QT_TRANSLATE_NOOP("Preferences",
                           "Every step is on the disk as soon as it is done, so there is no interval to "
                           "set. Unsaved work stays until you open it again or throw it away; after "
                           "that it lies in the bin for at least 30 days.")},
        {"designs/fabric", Page::Designs, &P::fabric, OneOf{&fabricChoices},
         QT_TRANSLATE_NOOP("Preferences", "Fabric of new patches"),
         QT_TRANSLATE_NOOP("Preferences", "default material leather weave colour"),
         QT_TRANSLATE_NOOP("Preferences",
                           "A new design begins with it, and patches are made of a design's first fabric.")},
        {"designs/allowance", Page::Designs, &P::allowance, LengthNumber{allowanceWidth.least, allowanceWidth.most},
         QT_TRANSLATE_NOOP("Preferences", "Seam allowance"),
         QT_TRANSLATE_NOOP("Preferences", "default cutting margin hem width"),
         QT_TRANSLATE_NOOP("Preferences",
                           "New designs begin with it; in a design it is changed in its properties.")},
        {"designs/fabric-folder", Page::Designs, &P::fabricFolder, FolderName{},
         QT_TRANSLATE_NOOP("Preferences", "Folder of your fabrics"),
         QT_TRANSLATE_NOOP("Preferences", "library directory path import export picture swatch"),
         QT_TRANSLATE_NOOP("Preferences",
                           "Where fabrics and their pictures are looked for first. Without one it is the "
                           "folder of the design.")},
    };
    return table;
}

bool PreferenceRow::found(const QString& search) const
{
    const QString all = wordsOf(*this).join(u'\n');
    return std::ranges::all_of(search.split(u' ', Qt::SkipEmptyParts),
                               [&](const QString& word) { return all.contains(word, Qt::CaseInsensitive); });
}

QVariant valueOf(const Preferences& preferences, const PreferenceRow& row)
{
    return std::visit([&](auto member) { return QVariant(preferences.*member); }, row.member);
}

std::optional<Preferences> withValue(Preferences preferences, const PreferenceRow& row, const QVariant& value)
{
    const bool good = std::visit(
        [&](auto member, const auto& form) {
            const auto found = valid(form, value, preferences.*member);
            if (found)
                preferences.*member = *found;
            return found.has_value();
        },
        row.member, row.form);
    return good ? std::optional(preferences) : std::nullopt;
}

Preferences withDefaults(Preferences preferences, PreferencePage page)
{
    const Preferences usual;
    for (const PreferenceRow& row : preferenceTable())
        if (row.page == page)
            std::visit([&](auto member) { preferences.*member = usual.*member; }, row.member);
    return preferences;
}

} // namespace bolster
