#include "DescribedField.h"

#include <QCoreApplication>

#include <algorithm>

namespace bolster {

namespace {

QString suffixOf(Unit unit)
{
    switch (unit) {
    case Unit::Millimetres:
        return QStringLiteral(" mm");
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

NumberBox::Range rangeOf(double least, double most, Unit unit, const NumberBoxing& box)
{
    return {suffixOf(unit), box.decimals, std::max(least, box.least), std::min(most, box.most), box.step};
}

} // namespace

QString DescribedField::label() const
{
    return QCoreApplication::translate("Field", field.label);
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

} // namespace bolster
