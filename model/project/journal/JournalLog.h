// SQLite's log of a journal ("-wal"). Private to the library.
#pragma once

#include <QString>

namespace bolster {

/// SQLite takes the first piece that is damaged for the end of the log, and what was stored after it is lost
/// without a word. Whether there is more behind: a step is only begun when the one before it is on the disk, so a
/// power cut leaves at most one step in pieces, and nothing behind it. Damage in the last step cannot be told from
/// that. Format: https://www.sqlite.org/fileformat2.html, section 4. False when there is no log.
bool logBreaksOff(const QString& log);

} // namespace bolster
