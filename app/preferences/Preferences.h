// What the user may set about the program: each setting is described once, and everything else follows from that -
// how it is kept, found, shown, and taken to another machine.
#pragma once

#include "CutAllowance.h"

#include <QCoreApplication>
#include <QList>
#include <QString>
#include <QVariant>

#include <optional>
#include <variant>
#include <vector>

namespace bolster {

/// The values at first are those of the program.
struct Preferences {
    QString length = QStringLiteral("mm");   ///< "mm", "cm" or "in"
    QString fraction = QStringLiteral("16"); ///< of an inch; "0": decimals
    QString decimal = QStringLiteral("language");
    QString language;                    ///< "": the system's
    QString theme = QStringLiteral("0"); ///< number of a Theme
    int fontPercent = 100;
    QString mouse = QStringLiteral("bolster"); ///< id of a MousePreset
    bool invertZoom = false;
    QString keys = QStringLiteral("bolster"); ///< id of a KeyPreset
    bool snapping = true;
    bool rulers = true;
    bool guides = true;
    QString drawing = QStringLiteral("full"); ///< or "reduced"
    bool reducedMotion = false;
    int daysInBin = 30;
    QString fabric; ///< key of a preset; "": Bolster's plain one
    double allowance = CutAllowance{}.width;
    QString fabricFolder; ///< "": where the design lies

    friend bool operator==(const Preferences&, const Preferences&) = default;
};

enum class PreferencePage { Units, Looks, Mouse, Keys, Pattern, Drawing, Work, Designs };
constexpr PreferencePage preferencePages[] = {
    PreferencePage::Units,   PreferencePage::Looks,   PreferencePage::Mouse, PreferencePage::Keys,
    PreferencePage::Pattern, PreferencePage::Drawing, PreferencePage::Work,  PreferencePage::Designs};
QString pageTitle(PreferencePage page);

struct PreferenceChoice {
    QString id; ///< for good: settings have it
    QString label;
};

/// How a setting is shown, and what it may be.
struct OneOf {
    QList<PreferenceChoice> (*choices)();
};
struct OnOff {};
struct WholeNumber {
    int least, most, step;
    const char* suffix; ///< to be translated
};
struct LengthNumber {
    double least, most; ///< mm
};
struct FolderName {};

/// A row of the table. Texts are to be translated in the context Preferences.
struct PreferenceRow {
    const char* key; ///< in the settings, and in files
    PreferencePage page;
    std::variant<QString Preferences::*, bool Preferences::*, int Preferences::*, double Preferences::*> member;
    std::variant<OneOf, OnOff, WholeNumber, LengthNumber, FolderName> form;
    const char* label;
    const char* words; ///< by which it is found, beside its label
    const char* note = "";
    bool atNextStart = false; ///< what is set holds only then

    QString labelText() const { return QCoreApplication::translate("Preferences", label); }
    QString noteText() const { return *note ? QCoreApplication::translate("Preferences", note) : QString(); }
    /// All words of the search are in label, further words, note, choices or the page's title.
    bool found(const QString& search) const;
};
const std::vector<PreferenceRow>& preferenceTable();

QVariant valueOf(const Preferences& preferences, const PreferenceRow& row);
/// Nothing when the value is not one that the setting may have.
std::optional<Preferences> withValue(Preferences preferences, const PreferenceRow& row, const QVariant& value);
/// All settings of the page as they are at first.
Preferences withDefaults(Preferences preferences, PreferencePage page);

} // namespace bolster
