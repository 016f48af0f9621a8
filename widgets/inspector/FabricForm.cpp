#include "FabricForm.h"

#include "FabricColors.h"
#include "Icons.h"
#include "InspectorSubject.h"

namespace bolster {

namespace {

using Kind = FabricLook::Kind;

/// One for all elements of the selection, or nothing where they differ.
template <class Read>
auto sharedLook(const InspectorSubject<Fabric>& fabric, Read read)
{
    return fabric.shared([read](const Fabric& f) { return read(f.look); });
}

QString secondColorLabel(const std::optional<Kind>& kind)
{
    if (kind == Kind::Woven)
        return FabricForm::tr("Weft");
    if (kind == Kind::SmoothLeather || kind == Kind::GrainedLeather)
        return FabricForm::tr("Creases");
    if (kind == Kind::Velvet)
        return FabricForm::tr("Depth of the pile");
    return FabricForm::tr("Other squares");
}

QString scaleLabel(const std::optional<Kind>& kind)
{
    if (!kind)
        return FabricForm::tr("Scale");
    switch (*kind) {
    case Kind::Checker:
        return FabricForm::tr("Squares");
    case Kind::SmoothLeather:
    case Kind::GrainedLeather:
        return FabricForm::tr("Grain size");
    case Kind::Woven:
        return FabricForm::tr("Repeat of the weave");
    case Kind::Velvet:
        return FabricForm::tr("Nap");
    case Kind::Image:
        return FabricForm::tr("Width of the picture");
    case Kind::Plain:
        break;
    }
    return FabricForm::tr("Scale");
}

} // namespace

void FabricForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Fabric> fabric(m_document, ids, form);
    if (!fabric.several())
        addPictures(form, ids.front());
    fabric.name();
    addLook(form, ids);
    form.addHeading(tr("Behaviour"), icon(QStringLiteral("fabric")));
    fabric.field(&Fabric::stiffness);
    fabric.field(&Fabric::poisson);
    fabric.field(&Fabric::bendingLength);
    fabric.field(&Fabric::limits, &StretchLimits::along);
    fabric.field(&Fabric::limits, &StretchLimits::across);
    fabric.field(&Fabric::limits, &StretchLimits::shear);
    form.addHeading(tr("Cutting"), icon(QStringLiteral("notch")));
    fabric.field(&Fabric::cutting, &FabricCutting::width);
    fabric.field(&Fabric::cutting, &FabricCutting::shrinkAlong);
    fabric.field(&Fabric::cutting, &FabricCutting::shrinkAcross);
}

void FabricForm::addPictures(PropertyForm& form, ElementId id) const
{
    form.addPictures(tr("The fabric on a cushion and on a ball"),
                     tr("The fabric on a cushion and on a ball, at its real scale"), [this, id] {
                         const auto found = m_sources.fabricPictures.find(id);
                         const FabricPictures drawn =
                             found == m_sources.fabricPictures.end() ? FabricPictures{} : found->second;
                         return std::vector<QImage>{drawn.cushion, drawn.ball};
                     });
}

void FabricForm::addLook(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Fabric> fabric(m_document, ids, form);
    const std::optional<Kind> kind = sharedLook(fabric, [](const FabricLook& l) { return l.kind; });
    addKind(form, ids);
    fabric.colorField(tr("Colour of the fabric"), &Fabric::color);
    if (kind && kind != Kind::Plain && kind != Kind::Image)
        addSecondColor(form, ids, secondColorLabel(kind));
    fabric.field(&Fabric::look, &FabricLook::roughness);
    if (kind == Kind::Plain)
        return;
    fabric.labelledField(scaleLabel(kind), &Fabric::look, &FabricLook::scale);
    fabric.field(&Fabric::look, &FabricLook::rotation);
    if (kind != Kind::Checker)
        fabric.field(&Fabric::look, &FabricLook::relief);
}

void FabricForm::addSecondColor(PropertyForm& form, const Ids& ids, const QString& label) const
{
    const InspectorSubject<Fabric> fabric(m_document, ids, form);
    const char* const verb = fabric.fieldAt(&Fabric::look, &FabricLook::secondColor).field.verb;
    form.addColor(
        label, tr("Second colour of the fabric"),
        [fabric] {
            return fabric.shared(
                [](const Fabric& f) { return QColor(QString::fromStdString(secondColorShown(f))); });
        },
        [fabric, verb](const QColor& color) {
            fabric.change(verb, [&](Fabric& f) { f.look.secondColor = color.name().toStdString(); });
        });
    form.addCheck(
        tr("From the first colour"),
        [fabric] { return sharedLook(fabric, [](const FabricLook& l) { return l.secondColor.empty(); }); },
        [fabric, verb](bool derived) {
            fabric.change(verb,
                          [&](Fabric& f) { f.look.secondColor = derived ? std::string() : secondColorShown(f); });
        });
}

/// A picture needs a file first: then whoever chooses one changes the kind, too.
void FabricForm::addKind(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Fabric> fabric(m_document, ids, form);
    const DescribedField said = fabric.fieldAt(&Fabric::look, &FabricLook::kind);
    form.addChoice(
        said.label(), said.choices(),
        [fabric] {
            return sharedLook(fabric, [](const FabricLook& l) { return static_cast<int>(l.kind); }).value_or(-1);
        },
        [fabric, ids, verb = said.field.verb, chooseFile = m_wishes.chooseFile](int chosen) {
            const auto kind = static_cast<Kind>(chosen);
            if (kind == Kind::Image) {
                if (ids.size() == 1)
                    chooseFile(ids.front());
                return;
            }
            fabric.change(verb, [&](Fabric& f) {
                if (f.look.kind == kind)
                    return;
                FabricLook look = usualLook(kind);
                look.secondColor = f.look.secondColor;
                look.rotation = f.look.rotation;
                f.look = look;
            });
        });
    if (sharedLook(fabric, [](const FabricLook& l) { return l.kind; }) != Kind::Image)
        return;
    fabric.info(tr("File"), [](const Design&, const Fabric& f) { return QString::fromStdString(f.look.file); });
    if (ids.size() == 1)
        form.addButton(tr("Choose an&other picture \u2026"),
                       [chooseFile = m_wishes.chooseFile, id = ids.front()] { chooseFile(id); });
}

std::vector<int> FabricForm::rowsDependOn(const Ids& ids) const
{
    std::vector<int> kinds;
    for (const ElementId id : ids)
        if (const Fabric* fabric = m_document.design().find<Fabric>(id))
            kinds.push_back(static_cast<int>(fabric->look.kind));
    return kinds;
}

} // namespace bolster
