// The files that a design's elements refer to, wherever the design lies at the moment.
#pragma once

#include "Design.h"

#include <QString>
#include <QStringList>

#include <functional>
#include <memory>
#include <vector>

class QLockFile;

namespace bolster {

/// A folder of ours in the user's local state. It is locked, so that other running programs leave it alone; it goes
/// away with this object unless somebody will come back for it.
class OwnFolder {
public:
    /// A new one. Null when it could not be made.
    static std::shared_ptr<OwnFolder> make();
    /// One that a crash has left, or that was kept; made again if it is gone. Null when it is none of ours, or when
    /// a running program has it.
    static std::shared_ptr<OwnFolder> takeOver(const QString& path);
    ~OwnFolder();
    OwnFolder(const OwnFolder&) = delete;
    OwnFolder& operator=(const OwnFolder&) = delete;

    const QString& path() const { return m_path; }
    void keep(bool kept = true) { m_kept = kept; }
    /// Removes all that no running program has, but those in `wanted`: copies of files for work that is over.
    static void removeForgotten(const QStringList& wanted);

private:
    OwnFolder(const QString& path, std::unique_ptr<QLockFile> lock);

    QString m_path;
    std::unique_ptr<QLockFile> m_lock;
    bool m_kept = false;
};

/// A saved design has its files beside it. Until it is saved they lie in a folder of their own in the user's local
/// state, so nothing is lost when the source goes away or the program crashes.
class DesignFolder {
public:
    /// Where relative names are looked up first.
    const QString& folder() const { return m_folder; }
    /// The file that an element means, or "" when it is nowhere, or outside the folder.
    QString find(const QString& name) const;

    /// For another design: the folder of a file on disk or of a sample, or `own`. Those that were made here for the
    /// last design go away; `own` does, too, when it is over.
    void start(const QString& folder, const std::shared_ptr<OwnFolder>& own = {});
    /// Lets go of the folders as they are: somebody will come back for what is in them.
    void leave();
    /// A folder of our own for a design without a file; what `design` refers to is copied there.
    Message makeOwnFolder(const Design& design);
    bool ownFolder() const;

    /// Brings a file into the folder unless it is there, under a free name if its own is taken by another one.
    /// `name` is what an element then refers to. What `taken` says of a name that is free here: other versions of
    /// the design mean another file by it.
    Message add(const QString& source, QString* name, const std::function<bool(const QString& name)>& taken) const;

    /// The design as it must be written into the folder `target`: its elements' files are copied there, renamed
    /// where the name is taken by another file. Files that are missing here are left as they are.
    Message copyTo(const QString& target, const Design& design, Design* moved) const;
    /// The design lies in `folder` from now on. What undo may need is still found where it was.
    void moved(const QString& folder);

private:
    QString m_folder;
    QStringList m_earlier;
    std::vector<std::shared_ptr<OwnFolder>> m_own; // among these
};

} // namespace bolster
