// Where somebody stood in the history of a project, when that is not where its file stands. Private to the library.
#pragma once

#include "Hash.h"
#include "History.h"

#include <optional>
#include <string>

namespace bolster::lastPlaces {

/// A hundred are kept, each for one state of a project's file: nobody has asked for that file to be written.
void keep(const std::string& uuid, const Hash& seal, NodeId node);
void forget(const std::string& uuid);
std::optional<NodeId> find(const std::string& uuid, const Hash& seal);

} // namespace bolster::lastPlaces
