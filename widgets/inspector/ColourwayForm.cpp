#include "ColourwayForm.h"

#include "InspectorSubject.h"

namespace bolster {

void ColourwayForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Colourway> colourway(m_document, ids, form);
    colourway.name();
    colourway.info(tr("Fabrics"), [](const Design& design, const Colourway& c) {
        QStringList lines;
        for (const Colourway::Entry& entry : c.fabrics)
            lines << tr("%1: %2").arg(displayName(design, entry.patch), displayName(design, entry.fabric));
        return lines.isEmpty() ? tr("those of the patches") : lines.join(u'\n');
    });
}

} // namespace bolster
