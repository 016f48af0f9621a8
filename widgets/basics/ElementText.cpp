#include "ElementText.h"

#include "StretchLength.h"
#include "Translated.h"
#include "Units.h"

#include <QCoreApplication>

#include <optional>

namespace bolster {

namespace {

QString inWords(const char* text)
{
    return QCoreApplication::translate("ElementText", text);
}

QString nameOrNumber(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    if (!element)
        return QCoreApplication::translate("ElementText", "missing element %1").arg(number(id));
    if (id == settingsId) // there is only one
        return kindWord(kindOf(*element));
    const QString name = QString::fromStdString(shortened(elementName(*element)));
    return name.isEmpty() ? QStringLiteral("%1 %2").arg(kindWord(kindOf(*element))).arg(number(id))
                          : isolated(name);
}

/// That of the settings, which stands for any, if they are of different ones.
ElementKind commonKind(const Design& design, std::span<const ElementId> ids)
{
    std::optional<ElementKind> kind;
    for (const ElementId id : ids)
        if (const ElementPtr element = design.element(id))
            kind = !kind || *kind == kindOf(*element) ? kindOf(*element) : kindOf<Settings>();
    return kind.value_or(kindOf<Settings>());
}

} // namespace

ElementKind kindOf(const Element& element)
{
    return std::visit([]<class T>(const T&) { return kindOf<T>(); }, element);
}

QString kindTitle(ElementKind kind)
{
    return inWords(kind.names().many);
}

QString kindWord(ElementKind kind)
{
    return inWords(kind.names().one);
}

QString kindIcon(ElementKind kind)
{
    return QString::fromLatin1(kind.names().icon);
}

namespace {

/// Of marks for the cutter that have no name of their own.
QString markText(const Design& design, const Element& element)
{
    if (const auto* edge = std::get_if<EdgeAllowance>(&element))
        return QCoreApplication::translate("ElementText", "%1, allowance %2")
            .arg(nameOrNumber(design, edge->stretch.patch), lengthText(edge->width));
    if (const auto* notch = std::get_if<Notch>(&element))
        return QCoreApplication::translate("ElementText", "Notch of %1")
            .arg(nameOrNumber(design, notch->place.patch));
    if (const auto* corner = std::get_if<CutCorner>(&element))
        return QCoreApplication::translate("ElementText", "Corner of %1")
            .arg(nameOrNumber(design, corner->place.patch));
    return {};
}

} // namespace

QString displayName(const Design& design, ElementId id)
{
    if (const Seam* seam = design.find<Seam>(id))
        return QStringLiteral("%1 \u2013 %2")
            .arg(nameOrNumber(design, seam->a.patch), nameOrNumber(design, seam->b.patch));
    if (const FixationSeam* fixation = design.find<FixationSeam>(id); fixation && !fixation->hasCurve())
        return QCoreApplication::translate("ElementText", "%1, normal held")
            .arg(nameOrNumber(design, fixation->stretch.patch));
    if (const FixationSeam* fixation = design.find<FixationSeam>(id))
        return QStringLiteral("%1 \u2192 %2")
            .arg(nameOrNumber(design, fixation->stretch.patch), nameOrNumber(design, fixation->curve));
    if (const OutlineTrim* trimmed = design.find<OutlineTrim>(id))
        return QCoreApplication::translate("ElementText", "Edge of %1")
            .arg(nameOrNumber(design, trimmed->stretch.patch));
    if (const ElementPtr element = design.element(id))
        if (const QString text = markText(design, *element); !text.isEmpty())
            return text;
    if (const Quarantined* bad = design.find<Quarantined>(id))
        if (!bad->problems.empty() && !bad->problems.front().label.empty())
            return QString::fromStdString(bad->problems.front().label);
    return nameOrNumber(design, id);
}

QString listName(const Design& design, ElementId id)
{
    const ElementPtr element = design.element(id);
    const QString name = element ? QString::fromStdString(elementName(*element)) : QString();
    return name.isEmpty() ? displayName(design, id) : isolated(name);
}

QString inShortLines(const QString& text)
{
    constexpr qsizetype longest = 90;
    QStringList lines;
    for (QString rest : text.split(u'\n')) {
        while (rest.size() > longest) {
            const qsizetype space = rest.lastIndexOf(u' ', longest);
            const qsizetype end = space > 0 ? space : longest;
            lines << rest.left(end);
            rest = rest.mid(space > 0 ? end + 1 : end);
        }
        lines << rest;
    }
    return lines.join(u'\n');
}

QString countedText(const Design& design, std::span<const ElementId> ids)
{
    if (ids.size() == 1)
        return displayName(design, ids.front());
    return inWords(commonKind(design, ids).names().counted).arg(ids.size());
}

std::string countedWords(const Design& design, std::span<const ElementId> ids)
{
    if (ids.size() == 1)
        return displayName(design, ids.front()).toStdString();
    return filledIn(commonKind(design, ids).names().counted, {std::to_string(ids.size())});
}

double sewnLength(const Design& design, ElementId id)
{
    if (const Seam* seam = design.find<Seam>(id))
        return stretchLength(design, seam->a);
    if (const OutlineTrim* trimmed = design.find<OutlineTrim>(id))
        return stretchLength(design, trimmed->stretch);
    if (const EdgeAllowance* edge = design.find<EdgeAllowance>(id))
        return stretchLength(design, edge->stretch);
    const FixationSeam* fixation = design.find<FixationSeam>(id);
    return fixation ? stretchLength(design, fixation->stretch) : 0;
}

QString seamSummary(const Design& design, const Seam& seam)
{
    const double a = stretchLength(design, seam.a);
    const double b = stretchLength(design, seam.b);
    if (!(a > 0) || !(b > 0))
        return {};
    return QCoreApplication::translate("ElementText", "%1 and %2, ease %3")
        .arg(lengthText(a), lengthText(b), percentText((b - a) / std::min(a, b)));
}

} // namespace bolster
