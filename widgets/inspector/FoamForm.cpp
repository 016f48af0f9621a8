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
    form.explain(tr("Takes this shape out of the cushion instead of adding it"));
    foam.field(&Foam::dilation);
    form.explain(tr("How thick the padding around this foam is"));
    foam.field(&Foam::strength);
    form.explain(tr("How hard this foam presses the cover outwards; from about 2 on it gives no more"));
}

} // namespace bolster
