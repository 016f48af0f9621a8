// A new file until it takes the place of another one.
#pragma once

#include "Message.h"

#include <QString>

#include <memory>
#include <string_view>

namespace bolster {

/// Lies hidden in the folder of the file that it is to replace, so that a rename is all it takes. It is locked as
/// long as this lives: others can tell it from what a program that was killed has left.
class TemporaryFile {
public:
    /// An empty file. Links in `target` are followed; permissions are those of a new file.
    explicit TemporaryFile(const QString& target);
    /// Removes it unless it has taken its place.
    ~TemporaryFile();
    TemporaryFile(const TemporaryFile&) = delete;
    TemporaryFile& operator=(const TemporaryFile&) = delete;

    /// Why there is none.
    const Message& problem() const { return m_problem; }
    /// For whoever writes to it by its name.
    const QString& path() const { return m_path; }
    Message write(std::string_view bytes);
    Message copyFrom(const QString& file);
    /// Syncs it, gives it the permissions of the file that it replaces, if there is one, renames it over that and
    /// syncs the folder: after a power cut the place holds the old bytes or the new ones, never a mixture.
    enum class Place { MayBeTaken, MustBeFree };
    Message moveIntoPlace(Place place = Place::MayBeTaken);

private:
    struct File;

    Message failed(int error);

    QString m_target;
    QString m_path;
    std::unique_ptr<File> m_file;
    Message m_problem;
};

/// Removes temporary files in this folder that no running program has: of other machines, which share the folder by
/// some sync service, those that are a day old.
void removeLeftTemporaryFiles(const QString& folder);

} // namespace bolster
