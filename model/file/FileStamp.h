// What tells a file from whatever is put in its place later.
#pragma once

#include <QByteArray>
#include <QString>

namespace bolster {

/// Of a file that was read or written. Neither inode nor time are asked: sync services and editors that write a
/// file anew leave it what it is.
struct FileStamp {
    bool known = false;
    QString link;       ///< where the file leads, when it is a link itself
    QByteArray content; ///< a hash; empty for projects, which have a seal

    friend bool operator==(const FileStamp&, const FileStamp&) = default;
};

/// Of what is there now; any thread may call it.
FileStamp stampOf(const QString& path, bool withContent);

/// Something is in that place, be it a link that leads nowhere.
bool isTaken(const QString& path);

/// In a line, and back; a stamp that is not known for any other line.
QString textOf(const FileStamp& stamp);
FileStamp stampFrom(const QString& text);

} // namespace bolster
