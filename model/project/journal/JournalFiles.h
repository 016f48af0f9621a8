// Where the journals of work in progress lie, and what stands beside each.
#pragma once

#include "WorkJournal.h"

#include <chrono>
#include <optional>

/// A base is the path of a journal without its ending.
namespace bolster::journalFiles {

inline const QString journalEnding = QStringLiteral(".bolster");
inline const QString damagedEnding = QStringLiteral(".damaged");
inline const QString logEnding = QStringLiteral("-wal"); // after the other one
inline const QString aboutEnding = QStringLiteral(".about");

/// The folders of all journals, and of those that were thrown away.
QString journals();
QString bin();

QString newBase();
/// Only the lock of a program that has ended can be had: no age makes a lock invalid. Null when another one has it
/// for longer than `patience`.
std::shared_ptr<QLockFile> lockOf(const QString& base, std::chrono::milliseconds patience = {});

/// What stands in UUID.about, a line each.
struct About {
    WorkJournal::Place place;
    bool kept = false;
    std::optional<HeldHistory> held;
};

About readAbout(const QString& base);
Message writeAboutFile(const QString& base, const About& about);
/// What a file holds of the history of its project; where nobody could say it before the program was killed, as
/// little as may be.
HeldHistory heldOf(const About& about, const OpenedProject& project);

void removeJournal(const QString& base);
void moveToBin(const QString& base);
/// Of a project without unsaved work: nobody has made it, but whoever comes back wants to be there.
void keepPlace(const Journal& journal, const HeldHistory& held, NodeId current);

} // namespace bolster::journalFiles
