// The rows of a project, as they are written. Private to the library; ProjectContents reads them.
#pragma once

#include "SealedRows.h"

#include "History.h"

#include <optional>
#include <vector>

namespace bolster {

struct NewNode {
    NodeId id = 0;
    std::string uid;     ///< 16 bytes
    NodeId parent = -1;  ///< -1 for the root
    std::int64_t at = 0; ///< ms since 1970, UTC
    std::int64_t run = 0;
    Message verb;
    std::string patch; ///< packChanges
    Hash designHash{};
};

/// The root of a project that begins with this design.
NewNode firstNode(const Design& design);
/// `chain` is the hash of the parent's row. Returns that of this row.
Hash putNode(SealedRows& rows, const NewNode& node, const Hash& chain);
void putProject(SealedRows& rows, const std::string& uuid, const std::optional<Hash>& base);
void putSnapshot(SealedRows& rows, NodeId node, const Design& design);
void putSavePoint(Database& database, SealedRows& rows, NodeId node);
/// No row when there is neither name.
void putLabel(SealedRows& rows, NodeId node, const std::string& version, const std::string& branch);
void putAsset(Database& database, SealedRows& rows, const std::string& name, std::int64_t blob);

/// 16 bytes, never the same again.
std::string newUid();

/// An empty file, or one that nobody else knows yet: not durable until it is synced as a whole, and at rest then.
void prepareUnshared(Database& database);

} // namespace bolster
