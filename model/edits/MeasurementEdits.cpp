#include "MeasurementEdits.h"

#include "EditBuilder.h"
#include "ElementEdits.h"

namespace bolster::edits {

Edit addMeasurement(const Design& design, const PatchPoint& from, const PatchPoint& to, const std::string& name)
{
    if (!design.find<Patch>(from.patch) || !design.find<Patch>(to.patch) || from == to)
        return {};
    return addElement(design, makeElement(Measurement{freeName<Measurement>(design, name), from, to}));
}

} // namespace bolster::edits
