// What the inspector shows of a frame beside its place: what it looks like.
#include "InspectorForms.h"
#include "InspectorSubject.h"

namespace bolster {

void InspectorForms::addFrameMaterial(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Frame> frame(m_document, ids, form);
    form.addChoice(
        tr("Material"), {tr("Plain"), tr("Wood"), tr("Metal"), tr("Plastic"), tr("Foam")},
        [frame] {
            return frame.shared([](const Frame& f) { return static_cast<int>(f.material.kind); }).value_or(-1);
        },
        [frame](int chosen) {
            frame.change(QT_TRANSLATE_NOOP("Message", "Change the material of %1"), [&](Frame& f) {
                const auto kind = static_cast<FrameMaterial::Kind>(chosen);
                if (f.material.kind != kind)
                    f.material = {kind, {}}; // in the colour that it usually has
            });
        });
    form.addColor(
        tr("Colour"), tr("Colour of the frame"),
        [frame] {
            return frame.shared(
                [](const Frame& f) { return QColor(QString::fromStdString(colorShown(f.material))); });
        },
        [frame](const QColor& color) {
            frame.change(QT_TRANSLATE_NOOP("Message", "Change the colour of %1"),
                         [&](Frame& f) { f.material.color = color.name().toStdString(); });
        });
}

} // namespace bolster
