#include "FrameForm.h"

#include "InspectorSubject.h"
#include "PlacementFields.h"

namespace bolster {

void FrameForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Frame> frame(m_document, ids, form);
    frame.name();
    frame.info(tr("File"), [](const Design&, const Frame& f) { return QString::fromStdString(f.file); });
    addPlacementFields(form, frame);
    frame.field(&Frame::contact);
    frame.field(&Frame::contactGap);
    addMaterial(form, ids);
    if (frame.several())
        return;
    m_parts.addShown(form, ids.front());
    form.addButton(tr("Choose an&other file \u2026"), [this, id = ids.front()] { m_wishes.chooseFile(id); });
}

void FrameForm::addMaterial(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Frame> frame(m_document, ids, form);
    const DescribedField kind = frame.fieldAt(&Frame::material, &FrameMaterial::kind);
    const DescribedField color = frame.fieldAt(&Frame::material, &FrameMaterial::color);
    form.addChoice(
        kind.label(), kind.choices(),
        [frame] {
            return frame.shared([](const Frame& f) { return static_cast<int>(f.material.kind); }).value_or(-1);
        },
        [frame, verb = kind.field.verb](int chosen) {
            frame.change(verb, [&](Frame& f) {
                const auto material = static_cast<FrameMaterial::Kind>(chosen);
                if (f.material.kind != material)
                    f.material = {material, {}}; // in the colour that it usually has
            });
        });
    form.addColor(
        color.label(), tr("Colour of the frame"),
        [frame] {
            return frame.shared(
                [](const Frame& f) { return QColor(QString::fromStdString(colorShown(f.material))); });
        },
        [frame, verb = color.field.verb](const QColor& chosen) {
            frame.change(verb, [&](Frame& f) { f.material.color = chosen.name().toStdString(); });
        });
}

} // namespace bolster
