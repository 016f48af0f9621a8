// What the inspector shows of a fabric: its look, then how it behaves.
#include "InspectorForms.h"

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
        return InspectorForms::tr("Weft");
    if (kind == Kind::SmoothLeather || kind == Kind::GrainedLeather)
        return InspectorForms::tr("Creases");
    if (kind == Kind::Velvet)
        return InspectorForms::tr("Depth of the pile");
    return InspectorForms::tr("Other squares");
}

QString scaleLabel(const std::optional<Kind>& kind)
{
    if (!kind)
        return InspectorForms::tr("Scale");
    switch (*kind) {
    case Kind::Checker:
        return InspectorForms::tr("Squares");
    case Kind::SmoothLeather:
    case Kind::GrainedLeather:
        return InspectorForms::tr("Grain size");
    case Kind::Woven:
        return InspectorForms::tr("Repeat of the weave");
    case Kind::Velvet:
        return InspectorForms::tr("Nap");
    case Kind::Image:
        return InspectorForms::tr("Width of the picture");
    case Kind::Plain:
        break;
    }
    return InspectorForms::tr("Scale");
}

} // namespace

void InspectorForms::addFabric(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Fabric> fabric(m_document, ids, form);
    if (!fabric.several())
        addFabricPictures(form, ids.front());
    fabric.name(tr("Name"));
    addFabricLook(form, ids);
    form.addHeading(tr("Behaviour"), icon(QStringLiteral("fabric")));
    fabric.field(&Fabric::stiffness);
    fabric.field(&Fabric::poisson);
    fabric.field(&Fabric::bendingLength);
    fabric.field(&Fabric::limits, &StretchLimits::along);
    fabric.field(&Fabric::limits, &StretchLimits::across);
    fabric.field(&Fabric::limits, &StretchLimits::shear);
}

void InspectorForms::addFabricPictures(PropertyForm& form, ElementId id) const
{
    form.addPictures(tr("The fabric on a cushion and on a ball"),
                     tr("The fabric on a cushion and on a ball, at its real scale"), [this, id] {
                         const auto found = m_fabricPictures.find(id);
                         const FabricPictures drawn =
                             found == m_fabricPictures.end() ? FabricPictures{} : found->second;
                         return std::vector<QImage>{drawn.cushion, drawn.ball};
                     });
}

void InspectorForms::addFabricLook(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Fabric> fabric(m_document, ids, form);
    const std::optional<Kind> kind = sharedLook(fabric, [](const FabricLook& l) { return l.kind; });
    addFabricKind(form, ids);
    form.addColor(
        tr("Colour"), tr("Colour of the fabric"),
        [fabric] { return fabric.shared([](const Fabric& f) { return QColor(QString::fromStdString(f.color)); }); },
        [fabric](const QColor& color) {
            fabric.change(QT_TRANSLATE_NOOP("Message", "Change the colour of %1"),
                          [&](Fabric& f) { f.color = color.name().toStdString(); });
        });
    if (kind && kind != Kind::Plain && kind != Kind::Image) {
        form.addColor(
            secondColorLabel(kind), tr("Second colour of the fabric"),
            [fabric] {
                return fabric.shared(
                    [](const Fabric& f) { return QColor(QString::fromStdString(secondColorShown(f))); });
            },
            [fabric](const QColor& color) {
                fabric.change(QT_TRANSLATE_NOOP("Message", "Change the second colour of %1"),
                              [&](Fabric& f) { f.look.secondColor = color.name().toStdString(); });
            });
        form.addCheck(
            tr("From the first colour"),
            [fabric] { return sharedLook(fabric, [](const FabricLook& l) { return l.secondColor.empty(); }); },
            [fabric](bool derived) {
                fabric.change(QT_TRANSLATE_NOOP("Message", "Change the second colour of %1"), [&](Fabric& f) {
                    f.look.secondColor = derived ? std::string() : secondColorShown(f);
                });
            });
    }
    fabric.field(&Fabric::look, &FabricLook::roughness);
    if (kind == Kind::Plain)
        return;
    fabric.labelledField(scaleLabel(kind), &Fabric::look, &FabricLook::scale);
    fabric.field(&Fabric::look, &FabricLook::rotation);
    if (kind != Kind::Checker)
        fabric.field(&Fabric::look, &FabricLook::relief);
}

/// A picture needs a file first: then whoever chooses one changes the kind, too.
void InspectorForms::addFabricKind(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Fabric> fabric(m_document, ids, form);
    form.addChoice(
        tr("Kind"),
        {tr("Plain"), tr("Checker"), tr("Smooth leather"), tr("Grained leather"), tr("Woven"), tr("Velvet"),
         tr("Picture \u2026")},
        [fabric] {
            return sharedLook(fabric, [](const FabricLook& l) { return static_cast<int>(l.kind); }).value_or(-1);
        },
        [fabric, ids, chooseFile = m_chooseFile](int chosen) {
            const auto kind = static_cast<Kind>(chosen);
            if (kind == Kind::Image) {
                if (ids.size() == 1)
                    chooseFile(ids.front());
                return;
            }
            fabric.change(QT_TRANSLATE_NOOP("Message", "Change the kind of %1"), [&](Fabric& f) {
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
                       [chooseFile = m_chooseFile, id = ids.front()] { chooseFile(id); });
}

} // namespace bolster
