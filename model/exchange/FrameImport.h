// The parts of a frame's file, of any format: which there are, and some of them as one mesh.
#pragma once

#include "AssemblyImport.h"

#include <set>

namespace bolster {

/// Reads any file that a frame can be read from. Formats without a tree have a part for each group.
ImportedAssembly importFrameParts(const QString& path, const ImportWatch& watch = {},
                                  const AssemblyOrder& order = {});

/// Of each part, whether it or something that it belongs to has one of the names. Removes from `names` what was
/// found.
std::vector<bool> partsNamed(const Assembly& assembly, std::set<std::string>& names);

/// How deep each part lies in the tree: 0 for those that belong to nothing.
std::vector<std::size_t> depthsOf(const Assembly& assembly);

} // namespace bolster
