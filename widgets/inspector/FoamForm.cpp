#include "FoamForm.h"

#include "InspectorSubject.h"
#include "PlacementFields.h"

namespace bolster {

void FoamForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Foam> foam(m_document, ids, form);
    foam.name();
    foam.reference({}, &Foam::cushion);
    if (foam.shared([](const Foam& f) { return f.shape == Foam::Shape::Mesh; }) != false) {
        foam.info(tr("File"), [](const Design&, const Foam& f) { return QString::fromStdString(f.file); });
    } else {
        foam.choiceBut(Foam::Shape::Mesh, &Foam::shape); // that is another file, not another shape
        foam.field(&Foam::size);
    }
    addPlacementFields(form, foam);
    foam.field(&Foam::cut);
    foam.field(&Foam::dilation);
    foam.field(&Foam::strength);
}

} // namespace bolster
