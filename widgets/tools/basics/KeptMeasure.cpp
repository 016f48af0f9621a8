#include "KeptMeasure.h"

#include "Document.h"
#include "MeasurementEdits.h"
#include "Selection.h"
#include "ViewTool.h"

#include <QCoreApplication>

namespace bolster {

void keepMeasure(ViewToolContext& context, const PatchPoint& from, const PatchPoint& to)
{
    Document& document = context.document();
    const ElementId id = document.design().nextId();
    const QString name = QCoreApplication::translate("KeptMeasure", "Measurement %1")
                             .arg(document.design().count<Measurement>() + 1);
    const Edit edit = edits::addMeasurement(document.design(), from, to, name.toStdString());
    if (edit.empty())
        return;
    document.commit(edit);
    context.selection().set({id});
}

} // namespace bolster
