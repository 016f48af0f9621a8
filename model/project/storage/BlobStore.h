// The files that a design uses, by content. Private to the library.
#pragma once

#include "SealedRows.h"

#include <QIODevice>

namespace bolster {

/// A content on its way into a project. What is large comes in pieces of their own, so that other threads can use
/// the database in between; it counts only with finish().
class NewBlob {
public:
    /// Stores the content of `source`, from its beginning, unless it is there already.
    NewBlob(Database& database, QIODevice& source);
    /// Takes the pieces back without finish().
    ~NewBlob();
    NewBlob(const NewBlob&) = delete;
    NewBlob& operator=(const NewBlob&) = delete;

    /// Within a transaction, the last thing done with it. Returns the number of the content.
    std::int64_t finish(SealedRows& rows);

private:
    void store(QIODevice& source);

    Database& m_database;
    std::int64_t m_number = 0; // of its pieces, if there are any
    std::int64_t m_size = 0;
    Hash m_hash{};
};

/// Takes back pieces that a crash has left without their content. Nobody may be adding one.
void removeUnfinishedBlobs(Database& database);

/// Writes a content to the device, or only checks it without one. Throws when it is not whole.
void readBlob(Database& database, std::int64_t blob, QIODevice* target);

enum class FileThere { Replace, Refuse };

/// As a whole file. Throws, too.
void extractBlob(Database& database, std::int64_t blob, const QString& path, FileThere there = FileThere::Replace);

void removeBlob(Database& database, SealedRows& rows, std::int64_t blob);

/// "frames/chair.obj", "./chair.obj" and so on: a name below a folder, not beside or above, in UTF-8.
bool isAssetName(const std::string& name);
/// Where the file of this name comes to lie below a folder: "a/b" and "a/./b" are one place.
std::string assetPlace(const std::string& name);

/// Whether its pieces can have numbers.
bool isBlobNumber(std::int64_t blob);
/// Pieces that belong to no content.
bool hasForeignChunks(Database& database);

} // namespace bolster
