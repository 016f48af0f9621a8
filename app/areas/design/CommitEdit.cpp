#include "CommitEdit.h"

#include "Document.h"
#include "Selection.h"
#include "StatusLine.h"

namespace bolster {

void commitOrTell(Document& document, StatusLine& status, const Edit& edit, const QString& problem)
{
    if (edit.empty())
        status.flash(problem);
    else
        document.commit(edit);
}

void insertOrTell(Document& document, Selection& selection, StatusLine& status, const Edit& edit,
                  const QString& problem)
{
    commitOrTell(document, status, edit, problem);
    if (!edit.empty())
        selection.set({edit.changes.front().id});
}

} // namespace bolster
