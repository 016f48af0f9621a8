#include "ElementText.h"

#include "ArcLength.h"
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
    const QString name = QString::fromStdString(elementName(*element));
    return name.isEmpty() ? QStringLiteral("%1 %2").arg(kindWord(kindOf(*element))).arg(number(id)) : name;
}

struct KindTexts {
    const char* word;
    const char* title;
    const char* icon;
};

constexpr KindTexts kindTexts[] = {
    {QT_TRANSLATE_NOOP("ElementText", "Patch"), QT_TRANSLATE_NOOP("ElementText", "Patches"), "patch"},
    {QT_TRANSLATE_NOOP("ElementText", "Seam"), QT_TRANSLATE_NOOP("ElementText", "Seams"), "seam"},
    {QT_TRANSLATE_NOOP("ElementText", "Fixation curve"), QT_TRANSLATE_NOOP("ElementText", "Fixation curves"),
     "fixation-curve"},
    {QT_TRANSLATE_NOOP("ElementText", "Fixation"), QT_TRANSLATE_NOOP("ElementText", "Fixations"), "fixation-seam"},
    {QT_TRANSLATE_NOOP("ElementText", "Handle curve"), QT_TRANSLATE_NOOP("ElementText", "Handle curves"),
     "handle-curve"},
    {QT_TRANSLATE_NOOP("ElementText", "Fancy seam"), QT_TRANSLATE_NOOP("ElementText", "Fancy seams"), "fancy-seam"},
    {QT_TRANSLATE_NOOP("ElementText", "Trimmed edge"), QT_TRANSLATE_NOOP("ElementText", "Trimmed edges"),
     "outline-trim"},
    {QT_TRANSLATE_NOOP("ElementText", "Frame"), QT_TRANSLATE_NOOP("ElementText", "Frames"), "frame"},
    {QT_TRANSLATE_NOOP("ElementText", "Cushion"), QT_TRANSLATE_NOOP("ElementText", "Cushions"), "cushion"},
    {QT_TRANSLATE_NOOP("ElementText", "Foam"), QT_TRANSLATE_NOOP("ElementText", "Foam"), "foam"},
    {QT_TRANSLATE_NOOP("ElementText", "Scan"), QT_TRANSLATE_NOOP("ElementText", "Scans"), "scan"},
    {QT_TRANSLATE_NOOP("ElementText", "Fabric"), QT_TRANSLATE_NOOP("ElementText", "Fabrics"), "fabric"},
    {QT_TRANSLATE_NOOP("ElementText", "Colourway"), QT_TRANSLATE_NOOP("ElementText", "Colourways"), "colourway"},
    {QT_TRANSLATE_NOOP("ElementText", "Unusable element"), QT_TRANSLATE_NOOP("ElementText", "Unusable elements"),
     "warning"},
    {QT_TRANSLATE_NOOP("ElementText", "Design"), QT_TRANSLATE_NOOP("ElementText", "Design"), "settings"},
};

/// Of several, in the order of the kinds.
constexpr const char* countedTexts[] = {
    QT_TRANSLATE_NOOP("ElementText", "%1 patches"),
    QT_TRANSLATE_NOOP("ElementText", "%1 seams"),
    QT_TRANSLATE_NOOP("ElementText", "%1 fixation curves"),
    QT_TRANSLATE_NOOP("ElementText", "%1 fixations"),
    QT_TRANSLATE_NOOP("ElementText", "%1 handle curves"),
    QT_TRANSLATE_NOOP("ElementText", "%1 fancy seams"),
    QT_TRANSLATE_NOOP("ElementText", "%1 trimmed edges"),
    QT_TRANSLATE_NOOP("ElementText", "%1 frames"),
    QT_TRANSLATE_NOOP("ElementText", "%1 cushions"),
    QT_TRANSLATE_NOOP("ElementText", "%1 pieces of foam"),
    QT_TRANSLATE_NOOP("ElementText", "%1 scans"),
    QT_TRANSLATE_NOOP("ElementText", "%1 fabrics"),
    QT_TRANSLATE_NOOP("ElementText", "%1 colourways"),
    QT_TRANSLATE_NOOP("ElementText", "%1 unusable elements"),
    QT_TRANSLATE_NOOP("ElementText", "%1 elements"),
};

const KindTexts& textsOf(ElementKind kind)
{
    return kindTexts[static_cast<std::size_t>(kind)];
}

} // namespace

ElementKind kindOf(const Element& element)
{
    struct Visitor {
        ElementKind operator()(const Settings&) const { return ElementKind::Settings; }
        ElementKind operator()(const Fabric&) const { return ElementKind::Fabric; }
        ElementKind operator()(const Patch&) const { return ElementKind::Patch; }
        ElementKind operator()(const Seam&) const { return ElementKind::Seam; }
        ElementKind operator()(const FixationCurve&) const { return ElementKind::FixationCurve; }
        ElementKind operator()(const FixationSeam&) const { return ElementKind::FixationSeam; }
        ElementKind operator()(const Frame&) const { return ElementKind::Frame; }
        ElementKind operator()(const HandleCurve&) const { return ElementKind::HandleCurve; }
        ElementKind operator()(const FancySeam&) const { return ElementKind::FancySeam; }
        ElementKind operator()(const Cushion&) const { return ElementKind::Cushion; }
        ElementKind operator()(const Foam&) const { return ElementKind::Foam; }
        ElementKind operator()(const Scan&) const { return ElementKind::Scan; }
        ElementKind operator()(const Colourway&) const { return ElementKind::Colourway; }
        ElementKind operator()(const OutlineTrim&) const { return ElementKind::OutlineTrim; }
        ElementKind operator()(const Quarantined&) const { return ElementKind::Unusable; }
    };
    return std::visit(Visitor{}, element);
}

QString kindTitle(ElementKind kind)
{
    return inWords(textsOf(kind).title);
}

QString kindWord(ElementKind kind)
{
    return inWords(textsOf(kind).word);
}

QString kindIcon(ElementKind kind)
{
    return QString::fromLatin1(textsOf(kind).icon);
}

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
    if (const Quarantined* bad = design.find<Quarantined>(id))
        if (!bad->problems.empty() && !bad->problems.front().label.empty())
            return QString::fromStdString(bad->problems.front().label);
    return nameOrNumber(design, id);
}

QString countedText(const Design& design, std::span<const ElementId> ids)
{
    if (ids.size() == 1)
        return displayName(design, ids.front());
    std::optional<ElementKind> kind;
    for (const ElementId id : ids)
        if (const ElementPtr element = design.element(id))
            kind = !kind || *kind == kindOf(*element) ? kindOf(*element) : ElementKind::Settings;
    const auto place = static_cast<std::size_t>(kind.value_or(ElementKind::Settings));
    return inWords(countedTexts[place]).arg(ids.size());
}

double stretchLength(const Design& design, const Stretch& stretch)
{
    const Patch* patch = design.find<Patch>(stretch.patch);
    if (!patch || patch->outline.empty())
        return 0;
    const double to =
        unwrappedEnd(stretch.from, stretch.to, patch->outline.domainStart(), patch->outline.domainEnd());
    return ArcLength2(patch->outline).between(stretch.from, to);
}

double sewnLength(const Design& design, ElementId id)
{
    if (const Seam* seam = design.find<Seam>(id))
        return stretchLength(design, seam->a);
    if (const OutlineTrim* trimmed = design.find<OutlineTrim>(id))
        return stretchLength(design, trimmed->stretch);
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
        .arg(lengthText(a), lengthText(b), percentText(std::max(a, b) / std::min(a, b) - 1));
}

} // namespace bolster
