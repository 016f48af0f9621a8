// What is left of a damaged project.
#pragma once

#include "Message.h"

#include <QString>

#include <stop_token>
#include <vector>

namespace bolster {

struct Salvaged {
    Message problem;              ///< why nothing could be written; `notes` is empty then
    bool readable = false;        ///< false: the damaged file is to blame for the problem
    std::vector<Message> notes{}; ///< first what was saved, then all that is lost
};

/// Writes a new project from all that can be trusted of the damaged one: the edits from the first one on whose
/// hashes are right and that lead to the designs that were kept with them, and the versions kept as snapshots after
/// a gap, as branches. A process of its own does it (bolster-salvage), with limits on memory and time that grow
/// with the file. The damaged file is not changed; there must be no file at `out`. Any thread may call it; `stop`
/// ends it within 50 ms, and then there is none either.
Salvaged salvageProject(const QString& damaged, const QString& out, const std::stop_token& stop = {});

/// The same of a journal, with what is whole of its log ("-wal").
Salvaged salvageJournal(const QString& damaged, const QString& out, const std::stop_token& stop = {});

} // namespace bolster
