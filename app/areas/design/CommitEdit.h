// What commands do with an edit that may be empty.
#pragma once

#include <QString>

namespace bolster {

class Document;
class Selection;
class StatusLine;
struct Edit;

/// Commits it, or says the problem in the status line when it is empty.
void commitOrTell(Document& document, StatusLine& status, const Edit& edit, const QString& problem);
/// The same; what the edit adds is selected.
void insertOrTell(Document& document, Selection& selection, StatusLine& status, const Edit& edit,
                  const QString& problem);

} // namespace bolster
