// The files that a design's elements refer to, wherever the design lies at the moment.
#pragma once

#include "Design.h"

#include <QString>
#include <QStringList>

#include <functional>

namespace bolster {

/// A saved design has its files beside it. Until it is saved they lie in a folder of their own in the user's local
/// state, so nothing is lost when the source goes away or the program crashes.
class DesignFolder {
public:
    /// Where relative names are looked up first.
    const QString& folder() const { return m_folder; }
    /// The file that an element means, or "" when it is nowhere, or outside the folder.
    QString find(const QString& name) const;

    /// For another design: the folder of a file on disk, of a sample, or of a copy that a crash has left. Folders
    /// that were made here for the last design are removed.
    void start(const QString& folder);
    /// Lets go of the folders as they are: somebody will come back for what is in them.
    void leave();
    /// A new folder of our own. Empty when it could not be made.
    static QString newOwnFolder();
    /// The same, for a design without a file; what `design` refers to is copied there.
    Message makeOwnFolder(const Design& design);
    bool ownFolder() const { return isOwnFolder(m_folder); }
    /// Removes folders of new designs that nobody has come back for in a month; `wanted` are kept.
    static void removeForgotten(const QStringList& wanted);
    static bool isOwnFolder(const QString& folder);

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
};

} // namespace bolster
