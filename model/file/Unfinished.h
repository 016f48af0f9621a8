// What is on the disk only until a job is done.
#pragma once

#include <QString>
#include <QTemporaryDir>

#include <memory>

namespace bolster {

class Descriptor;

/// Whoever has made a file or folder for a while says so with one of these, and removes it in the usual way.
class Unfinished {
public:
    explicit Unfinished(QString path);
    ~Unfinished();
    Unfinished(const Unfinished&) = delete;
    Unfinished& operator=(const Unfinished&) = delete;

private:
    QString m_path;
};

/// Removes all of this process, for whoever ends it in the middle of that. From any thread.
void removeUnfinished();

/// A folder of the system's for temporary files, which goes with this. It is locked meanwhile: what a program that
/// was killed has left goes with the next one, a day later.
class WorkFolder {
public:
    WorkFolder();
    ~WorkFolder();

    bool isValid() const { return m_folder.isValid(); }
    QString path() const { return m_folder.path(); }
    QString filePath(const QString& name) const { return m_folder.filePath(name); }
    QString errorString() const { return m_folder.errorString(); }

private:
    QTemporaryDir m_folder;
    Unfinished m_unfinished;
    std::unique_ptr<Descriptor> m_lock;
};

} // namespace bolster
