// What is left of a damaged project.
#pragma once

#include "Message.h"

#include <QString>

#include <vector>

namespace bolster {

struct Salvaged {
    Message problem;              ///< why nothing could be written; `notes` is empty then
    bool readable = false;        ///< false: the damaged file is to blame for the problem
    std::vector<Message> notes{}; ///< first what was saved, then all that is lost
};

/// Writes a new project from all rows of the damaged one that can be trusted: the edits whose hashes are right from
/// the first one on, and the versions kept as snapshots after a gap, as branches. The damaged file is not changed;
/// there must be no file at `out`.
Salvaged salvageProject(const QString& damaged, const QString& out);

} // namespace bolster
