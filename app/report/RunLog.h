// What the program says while it runs, and where it ended if it did so by a crash. Nothing of it is sent anywhere.
#pragma once

#include <QString>

namespace bolster {

/// From now on messages (qDebug to qFatal) are kept: the last 400 in memory, and those of the run in a file of
/// `folder`, up to a megabyte. They still go where they went before. A crash writes the last messages and its stack
/// to a file, with nothing but what a signal handler may use. Files of the last runs are kept, older ones go. To be
/// called once, by the program.
void beginRunLog(const QString& folder);
/// Of the user's local state.
QString runLogFolder();
/// The last messages of this run, a line each.
QString runLogText();
/// What the last crash has left, with its time; "" when there was none.
QString lastCrashText(const QString& folder = runLogFolder());

} // namespace bolster
