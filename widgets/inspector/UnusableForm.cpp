#include "UnusableForm.h"

#include "InspectorSubject.h"
#include "Translated.h"

namespace bolster {

void UnusableForm::add(PropertyForm& form, const Ids& ids) const
{
    const InspectorSubject<Quarantined> bad(m_document, ids, form);
    bad.info(tr("Problems"), [](const Design&, const Quarantined& q) {
        QStringList lines;
        for (const Problem& problem : q.problems)
            lines << translated(problem);
        return lines.join(u'\n');
    });
    form.addNote([] { return tr("It keeps its text and is saved as it is."); });
}

} // namespace bolster
