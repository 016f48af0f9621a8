#include "DescribedField.h"

#include "ElementText.h"
#include "Units.h"

#include <QCoreApplication>

#include <algorithm>

namespace bolster {

QString unitSuffix(Unit unit)
{
    switch (unit) {
    case Unit::Millimetres:
        return millimetreSuffix;
    case Unit::Degrees:
        return QStringLiteral("\u00b0");
    case Unit::Percent:
        return QStringLiteral(" %");
    case Unit::MillimetresPerUnit:
        return QCoreApplication::translate("Field", " mm per unit");
    case Unit::None:
        break;
    }
    return {};
}

namespace {

NumberBox::Range rangeOf(double least, double most, Unit unit, const NumberBoxing& box)
{
    return {unitSuffix(unit), box.decimals, std::max(least, box.least), std::min(most, box.most), box.step};
}

} // namespace

QString DescribedField::label() const
{
    return QCoreApplication::translate("Field", field.label);
}

QString DescribedField::tip() const
{
    return *field.tip ? QCoreApplication::translate("Field", field.tip) : QString();
}

QStringList DescribedField::choices() const
{
    QStringList list;
    if (words)
        for (const char* word : words->labels)
            list << QCoreApplication::translate("Field", word);
    return list;
}

NumberBox::Range DescribedField::range() const
{
    if (number)
        return rangeOf(number->least, number->most, number->unit, number->box);
    return coordinates ? rangeOf(coordinates->least, coordinates->most, coordinates->unit, coordinates->box)
                       : NumberBox::Range{};
}

QString DescribedField::noneText()
{
    return QCoreApplication::translate("DescribedField", "none");
}

ElementChoice elementsToChoose(const Design& design, std::size_t kind, const QString& none)
{
    ElementChoice choice;
    if (!none.isEmpty()) {
        choice.ids.emplace_back();
        choice.names << none;
    }
    for (const auto& [id, element] : design.elements())
        if (element->index() == kind) {
            choice.ids.push_back(id);
            choice.names << displayName(design, id);
        }
    return choice;
}

int placeOf(const std::vector<ElementId>& ids, std::optional<ElementId> id)
{
    const auto found = id ? std::ranges::find(ids, *id) : ids.end();
    return found == ids.end() ? -1 : static_cast<int>(found - ids.begin());
}

} // namespace bolster
